"""What one execution of the procedure leaves behind, in memory. The folder on disk is `recording_folder`."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.errors import BadRecording
from core.payload.calibration import NOT_STATED, SensorCalibration
from core.payload.inertia import InertialParameters
from core.payload.known_tool import KnownTool, add_tools
from core.payload.site import Site
from core.recording.order_reference import NO_ORDER, OrderReference
from core.words.message import Message


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
    """What is known of the wrist sensor; six values each, force (N) then torque (N m), None where unknown.

    Args:
        calibration: what its certificate states.
        name: make and model; None where nobody has said.
        mount_std_rad: standard uncertainty of its orientation on the flange about each axis; None where nobody has said.
    """

    noise_std: Array | None = None
    range: Array | None = None
    resolution: Array | None = None
    calibration: SensorCalibration = NOT_STATED
    mount_std_rad: float | None = None
    name: str | None = None


@dataclass(frozen=True)
class FrictionDescription:
    """Friction that the joints are known to have, one value for each: `coulomb` (n,) N m and `viscous` (n,) N m s/rad."""

    coulomb: Array
    viscous: Array


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
        zero_std_rad: standard uncertainty of each joint's zero; None where nobody has said.
        encoder_std_rad: noise of one reading of a joint's position, standard deviation; None where nobody has said.
        torque_gain_std, link_mass_std: relative standard uncertainties of `tau` (sensor or motor constant) and of the masses in the URDF;
            None where nobody has said.
        site: where the cell stands, from which the strength of `gravity` is; None where nobody has said.
        friction: of the joints, as the cell states it; None where nobody has said. It may be stated later of the same robot.
        reference: the payload as somebody else knows it, with `reference_source`; without the tools.
        tools: known bodies between sensor and payload, which the wrench contains.
        order: that it was made for.
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
    friction: FrictionDescription | None = None
    sensor: SensorDescription = field(default_factory=SensorDescription)
    zero_std_rad: float | None = None
    encoder_std_rad: float | None = None
    torque_gain_std: float | None = None
    link_mass_std: float | None = None
    site: Site | None = None
    reference: InertialParameters | None = None
    reference_source: str | None = None
    source: str | None = None
    cell: str | None = None
    payload: str | None = None
    tools: tuple[KnownTool, ...] = ()
    order: OrderReference = NO_ORDER

    def __len__(self) -> int:
        return len(self.t)

    @property
    def reference_of_whole(self) -> InertialParameters | None:
        """What the sensor feels if the reference is right: tools and payload."""
        return None if self.reference is None else add_tools(self.tools, self.reference)

    @property
    def source_of_whole(self) -> str | None:
        """Where `reference_of_whole` comes from."""
        if self.reference_source is None or not self.tools:
            return self.reference_source
        return f"{self.reference_source}; with {', '.join(tool.name for tool in self.tools)}"


PAUSE_S = 1.0
"""A longer gap in time is a pause between two runs, not a loss of samples."""
BETWEEN_RUNS_S = 60.0
"""Put between two recordings whose clocks do not say how long after the first the second was made."""
COLUMNS = ("wrench", "q", "dq", "q_cmd", "tau", "orientation", "position", "temperature", "phase")


def take_rows(recording: Recording, rows: NDArray[np.bool_]) -> Recording:
    """A recording of some of its rows (N,) alone."""
    columns: dict[str, Any] = {name: x[rows] for name in COLUMNS if (x := getattr(recording, name)) is not None}
    return replace(recording, t=recording.t[rows], **columns)


def check_same_robot(first: Recording, robot: RobotDescription | None, gravity: Array) -> None:
    """A recording can be continued by such a robot with gravity (3,) in its base frame.

    Raises:
        BadRecording: another robot, or another direction of gravity.
    """
    if first.robot != robot:
        raise BadRecording(Message.of("recording-appended"), "recording-other-robot")
    if not np.allclose(first.gravity, gravity, atol=1e-6):
        where = Message.of("recording-appended-gravity")
        raise BadRecording(where, "recording-other-gravity", gravity_m_s2=gravity.tolist(), before_m_s2=first.gravity.tolist())


def check_arm_alone(empty: Recording, robot: RobotDescription | None, gravity: Array) -> None:
    """A recording without payload can be compared, joint by joint, with such a robot's that carries one; gravity (3,) in its base frame.

    Raises:
        BadRecording: another robot, another direction of gravity, or no torques in it.
    """
    where = Message.of("torques-of-empty")
    if empty.robot != robot:
        raise BadRecording(where, "recording-other-robot")
    if not np.allclose(empty.gravity, gravity, atol=1e-6):
        raise BadRecording(where, "recording-other-gravity", gravity_m_s2=empty.gravity.tolist(), before_m_s2=gravity.tolist())
    if empty.tau is None or empty.q is None:
        raise BadRecording(where, "torques-none-in-empty")


def append_recording(first: Recording, then: Recording) -> Recording:
    """Both as one recording with a gap in time; columns that one of them lacks are left out.

    Args:
        first, then: of the same robot and sensor with the same payload. Where the clock of the second began anew, it goes on
            `BETWEEN_RUNS_S` after the first.

    Raises:
        BadRecording: another robot, or another direction of gravity.
    """
    check_same_robot(first, then.robot, then.gravity)
    late = 0.0 if then.t[0] > first.t[-1] + PAUSE_S else first.t[-1] + BETWEEN_RUNS_S - then.t[0]
    pairs = {name: (getattr(first, name), getattr(then, name)) for name in COLUMNS}
    columns: dict[str, Any] = {name: None if a is None or b is None else np.concatenate((a, b)) for name, (a, b) in pairs.items()}
    return replace(first, t=np.concatenate((first.t, then.t + late)), order=then.order or first.order, **columns)
