"""Whether a Universal Robots arm can be moved as it is, and why it moves no longer, from what its controller reports."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.errors import ControllerStopped, NotConnected
from core.sessions.rtde import Value
from core.sessions.ur_controller import (
    MODE_RUNNING,
    PAUSED,
    PAUSING,
    PLAYING,
    SAFETY_NORMAL,
    SAFETY_REDUCED,
    STOPS,
    ControllerFound,
    Dashboard,
)  # fmt: skip
from core.sessions.ur_servo import read_number, read_vector

FULL_SPEED = 0.99
"""Share of the speed slider below which a robot cannot keep to its path."""


def check_safety(sample: dict[str, Value], *, braking: bool = False) -> None:
    """Nothing where the robot may move; while it brakes the slider does not matter.

    Raises:
        ControllerStopped: it stands still, or is slowed down.
    """
    safety, mode = read_number(sample, "safety_mode"), read_number(sample, "robot_mode")
    if safety not in {SAFETY_NORMAL, SAFETY_REDUCED}:
        raise ControllerStopped(STOPS.get(int(safety), "session-ur-fault"), value=safety, limit=SAFETY_NORMAL)
    if mode != MODE_RUNNING:
        raise ControllerStopped("session-ur-not-running", value=mode, limit=MODE_RUNNING)
    scaling = read_number(sample, "speed_scaling")
    if scaling < FULL_SPEED and not braking:
        raise ControllerStopped("session-ur-slider", value=scaling, limit=1.0)


def check_ready(sample: dict[str, Value], found: ControllerFound, host: str, *, slider: bool = True) -> None:
    """Nothing where the robot can be moved as it is.

    Args:
        slider: whether the speed slider has to be up, too.

    Raises:
        NotConnected: it cannot.
    """
    if not found.remote:
        raise NotConnected("session-ur-not-remote", host=host)
    try:
        check_safety(sample, braking=not slider)
    except ControllerStopped as stopped:
        raise NotConnected("session-not-ready", host=host, why=stopped.message) from stopped


def explain_end(sample: dict[str, Value], host: str) -> ControllerStopped:
    """Why the program runs no longer."""
    state = read_number(sample, "runtime_state")
    if state in {PAUSING, PAUSED}:
        return ControllerStopped("session-ur-paused", value=state, limit=PLAYING)
    try:
        dashboard = Dashboard(host, 0.5)
        remote = dashboard.ask("is in remote control").casefold() == "true"
        dashboard.close()
    except OSError:
        remote = True
    return ControllerStopped("session-ur-program-ended" if remote else "session-ur-remote-lost", value=state, limit=PLAYING)


def flange_of(sample: dict[str, Value]) -> tuple[Array, Array]:
    """Position (3,), m, and rotation (3, 3) of the flange in the controller's base frame: its tool centre point without its offset."""
    pose, offset = np.array(read_vector(sample, "actual_TCP_pose")), np.array(read_vector(sample, "tcp_offset"))
    rotation = Rotation.from_rotvec(pose[3:]).as_matrix() @ Rotation.from_rotvec(offset[3:]).as_matrix().T
    return pose[:3] - rotation @ offset[:3], rotation


def payload_set(sample: dict[str, Value]) -> tuple[float, ...]:
    """Mass (kg) and centre of mass (m) that the controller is set to."""
    return (read_number(sample, "payload"), *read_vector(sample, "payload_cog"))


def check_payload_kept(before: tuple[float, ...], sample: dict[str, Value]) -> None:
    """Nothing where the controller still has this payload.

    Raises:
        ControllerStopped: somebody has set another one; the controller zeroes its force/torque sensor by that.
    """
    now = payload_set(sample)
    if now != before:
        raise ControllerStopped("session-ur-payload-changed", value=now[0], limit=before[0])
