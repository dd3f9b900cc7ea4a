"""Every target at hand, and the payload of a result as they want it: in the frame of the flange."""

from __future__ import annotations

import numpy as np

from core.cell.cell import Cell
from core.errors import BadInput, BadPayload
from core.estimation.result import Result
from core.export.abb import Abb
from core.export.flexiv import Flexiv
from core.export.franka import Franka
from core.export.kuka_krl import KukaKrl
from core.export.kuka_sunrise import KukaSunrise
from core.export.mujoco import MuJoCo
from core.export.opc_ua import OpcUa
from core.export.target import ExportTarget
from core.export.universal_robots import UniversalRobots
from core.export.urdf import Urdf
from core.export.xarm import XArm
from core.payload.shapes import Pose
from core.payload.uncertain_parameters import UncertainParameters

TARGETS: tuple[ExportTarget, ...] = (
    UniversalRobots(), KukaKrl(), KukaSunrise(), Abb(), Franka(), Flexiv(), XArm(), OpcUa(), MuJoCo(), Urdf(),
)  # fmt: skip


def target_of(name: str) -> ExportTarget:
    """The target of that name.

    Raises:
        BadInput: there is none.
    """
    for target in TARGETS:
        if target.name == name:
            return target
    raise BadInput("target", "export-unknown-target", name=name[:40], known=[target.name for target in TARGETS])


def require_mount(cell: Cell | None) -> Pose:
    """The sensor's frame in the flange's, from which every target counts.

    Raises:
        BadInput: nobody has said how the sensor is mounted.
    """
    if cell is None:
        raise BadInput("sensor.mount", "export-no-cell")
    if cell.sensor.mount is None:
        raise BadInput("sensor.mount", "export-no-mount", cell=cell.name)
    return cell.sensor.mount


def payload_of(result: Result, mount: Pose | None) -> UncertainParameters:
    """What was identified, in the frame in which `mount` is the pose of the sensor; in the sensor's own where there is none.

    Raises:
        BadPayload: nothing was identified.
    """
    if result.estimate is None:
        raise BadPayload("estimate", "export-nothing-identified", verdict=result.verdict)
    phi = np.array(result.estimate.phi, dtype=float)
    covariance = np.array(result.estimate.covariance, dtype=float)
    found = UncertainParameters(phi, covariance)
    return found if mount is None else found.in_frame(mount.rotation, mount.translation)
