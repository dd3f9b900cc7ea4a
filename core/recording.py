"""What one execution of the procedure leaves behind, in memory. The folder on disk is `recording_folder`."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from core.inertia import InertialParameters

Array = NDArray[np.float64]


@dataclass(frozen=True)
class RobotDescription:
    """Nominal kinematics that a recording's joints refer to.

    Args:
        urdf: the URDF's text.
        joints: names in the order of the columns of `q`.
        base_frame: frame in which gravity is given.
        sensor_frame: frame of the wrench.
    """

    urdf: str
    joints: tuple[str, ...]
    base_frame: str
    sensor_frame: str


@dataclass(frozen=True)
class SensorDescription:
    """What is known of the wrist sensor; six values each, force (N) then torque (N m), None where unknown."""

    noise_std: Array | None = None
    range: Array | None = None
    resolution: Array | None = None


@dataclass(frozen=True)
class Recording:
    """Samples of one run, one row per sample, SI. Gravity in the base frame, the wrench in sensor axes about the sensor origin.

    Args:
        t: (N,), s, strictly increasing.
        gravity: (3,), nominal, base frame, m/s2.
        wrench: (N, 6) raw, in the paper's sign (what the sensor exerts on the payload), offsets included.
        q, dq, q_cmd, tau: (N, n), joint side.
        orientation: (N, 3, 3), sensor axes in the base frame, for a log without joints; `position`: (N, 3), m.
        temperature: (N,), degC.
        phase: (N,), text: `transfer`, `hold:<axis><sign>`, `hold:free`, `rotate:<axis>`.
        reference: the payload as somebody else knows it, with `reference_source`.
    """

    t: Array
    gravity: Array
    wrench: Array | None = None
    q: Array | None = None
    dq: Array | None = None
    q_cmd: Array | None = None
    tau: Array | None = None
    orientation: Array | None = None
    position: Array | None = None
    temperature: Array | None = None
    phase: NDArray[np.str_] | None = None
    robot: RobotDescription | None = None
    sensor: SensorDescription = field(default_factory=SensorDescription)
    reference: InertialParameters | None = None
    reference_source: str | None = None
    source: str | None = None
    cell: str | None = None
    payload: str | None = None

    def __len__(self) -> int:
        return len(self.t)
