"""Whether a UFACTORY arm can be moved as it is, and why it moves no longer, from what its controller reports."""

from __future__ import annotations

from core.errors import ControllerStopped, NotConnected
from core.sessions.xarm_reports import FastReport, SlowReport
from core.words.message import Message

MOVING, READY, PAUSED, STOPPED, RESET = 1, 2, 3, 4, 5
"""Motion states that a controller reports."""
GO = 0
"""What it is told to go on; it is told `STOPPED` to stop."""
POSITION, SERVO = 0, 1
"""Modes."""
ERRORS = {
    **dict.fromkeys((1, 2, 3), "xarm-emergency"),
    **dict.fromkeys(range(10, 18), "xarm-motor"),
    **dict.fromkeys((18, 50, 51, 52, 53), "xarm-sensor"),
    22: "xarm-self-collision",
    23: "xarm-joint-limit",
    **dict.fromkeys((24, 30, 60), "xarm-speed"),
    31: "xarm-collision",
    35: "xarm-boundary",
}
"""Error codes by the maker's list, and the message that says so; the others are told by their number."""


def obeys(sample: FastReport) -> bool:
    """Whether servo motion is on."""
    return sample.mode == SERVO and sample.state in {GO, MOVING, READY}


def explain_error(error: int) -> ControllerStopped:
    """What an error code of the controller means."""
    return ControllerStopped(ERRORS.get(error, "xarm-error"), value=error, limit=0.0)


def check_obeys(sample: FastReport) -> None:
    """Nothing where servo motion is on.

    Raises:
        ControllerStopped: somebody else has paused or stopped it, or has chosen another mode.
    """
    if obeys(sample):
        return
    if sample.mode != SERVO:
        raise ControllerStopped("xarm-mode", value=sample.mode, limit=SERVO)
    code = {PAUSED: "xarm-paused", RESET: "xarm-reset"}.get(sample.state, "xarm-stopped")
    raise ControllerStopped(code, value=sample.state, limit=READY)


def check_kept(before: SlowReport, now: SlowReport, *, sensor: bool) -> None:
    """Nothing where nobody has changed what a recording relies on.

    Args:
        sensor: whether the controller's own force/torque sensor is used.

    Raises:
        ControllerStopped: somebody has: the payload, the tool centre point, the sensor.
    """
    if now.payload != before.payload:
        raise ControllerStopped("xarm-payload-changed", value=now.payload[0], limit=before.payload[0])
    if any(abs(a - b).max() > 0.0 for a, b in zip(now.offset, before.offset, strict=True)):
        raise ControllerStopped("xarm-tool-changed", value=1.0, limit=0.0)
    if sensor and not now.sensor_on:
        raise ControllerStopped("xarm-sensor-went-off", value=0.0, limit=1.0)


def check_ready(slow: SlowReport, host: str) -> None:
    """Nothing where the robot can be moved as it is.

    Raises:
        NotConnected: it cannot.
    """
    why: Message | None = None
    if slow.error:
        why = explain_error(slow.error).message
    elif not all(slow.motors):
        why = Message.of("xarm-motors-off")
    elif slow.simulation:
        why = Message.of("xarm-simulation")
    if why is not None:
        raise NotConnected("session-not-ready", host=host, why=why)
