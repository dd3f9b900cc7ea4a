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
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message

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


def payload_of(result: Result, cell: Cell | None) -> UncertainParameters:
    """What was identified, in the flange's frame where the cell says how the sensor is mounted on it, else in the sensor's.

    Raises:
        BadPayload: nothing was identified.
    """
    if result.estimate is None:
        raise BadPayload("estimate", "export-nothing-identified", verdict=result.verdict)
    phi = np.array(result.estimate.phi, dtype=float)
    covariance = np.array(result.estimate.covariance, dtype=float)
    found = UncertainParameters(phi, covariance)
    mount = None if cell is None else cell.sensor.mount
    return found if mount is None else found.in_frame(mount.rotation, mount.translation)


def frame_of(cell: Cell | None) -> Message:
    """In which frame `payload_of` gives it."""
    if cell is None or cell.sensor.mount is None:
        return Message.of("export-sensor-frame")
    return Message.of("export-flange-frame")
