"""Whether a KUKA LBR can be moved as it is, and why it moves no longer, from what its controller tells."""

from __future__ import annotations

from core.errors import ControllerStopped, NotConnected
from core.sessions.kuka_messages import (
    ACTIVE_DRIVE,
    JOINT_OVERLAY,
    JOINT_POSITION,
    POSITION_CONTROL,
    Operation,
    Quality,
    Safety,
    Sample,
    State,
)
from core.words.message import Message

STOPS: dict[int, str] = {Safety.STOP_0: "kuka-stop-0", Safety.STOP_1: "kuka-stop-1", Safety.STOP_2: "kuka-stop-2"}
T1_M_S = 0.25
"""What the safety controller allows in T1, at the tool centre point and elsewhere on the arm."""
UNBEGUN: dict[int, str] = {
    State.IDLE: "kuka-closed-yet",
    State.MONITORING_WAIT: "kuka-line-too-slow",
    State.MONITORING_READY: "kuka-no-motion-yet",
    State.COMMANDING_WAIT: "kuka-not-begun",
}
"""What keeps a session from commanding, by the state that it does not leave."""


def check_ready(sample: Sample, host: str, speed_m_s: float) -> None:
    """Nothing where the robot can be moved as it is.

    Args:
        speed_m_s: of any point, as the cell allows it.

    Raises:
        NotConnected: it cannot.
    """
    why: Message | None = None
    if sample.safety != Safety.NORMAL:
        why = _explain_stop(sample).message
    elif sample.operation == Operation.T1 and speed_m_s > T1_M_S:
        why = Message.of("kuka-too-fast-for-t1", value=speed_m_s, limit=T1_M_S)
    if why is not None:
        raise NotConnected("session-not-ready", host=host, why=why)


def check_overlay(sample: Sample, host: str) -> None:
    """Nothing where the motion that the Sunrise application has begun follows joint positions.

    Raises:
        NotConnected: it takes something else.
    """
    why: Message | None = None
    if sample.command_mode != JOINT_POSITION or sample.overlay != JOINT_OVERLAY or sample.ipo is None:
        why = Message.of("kuka-other-commands", mode=sample.command_mode, overlay=sample.overlay)
    elif sample.control != POSITION_CONTROL:
        why = Message.of("kuka-other-control", mode=sample.control)
    if why is not None:
        raise NotConnected("session-not-ready", host=host, why=why)


def explain_end(sample: Sample, operation: int) -> ControllerStopped | None:
    """Why the robot obeys no longer, or will not in a moment; None where it does.

    Args:
        operation: mode of operation in which the motion was begun.
    """
    if sample.safety != Safety.NORMAL:
        return _explain_stop(sample)
    active = State.COMMANDING_ACTIVE
    reasons = (
        ("kuka-closed", sample.state == State.IDLE, sample.state, active),
        ("kuka-operation", sample.operation != operation, sample.operation, operation),
        ("kuka-quality", sample.quality < Quality.GOOD, sample.quality, Quality.GOOD),
        ("kuka-ended", sample.state != active, sample.state, active),
        ("kuka-control", sample.control != POSITION_CONTROL, sample.control, POSITION_CONTROL),
    )
    for code, holds, found, needed in reasons:
        if holds:
            return ControllerStopped(code, value=float(found), limit=float(needed))
    for k, drive in enumerate(sample.drives):
        if drive != ACTIVE_DRIVE:
            return ControllerStopped("kuka-drives", value=float(drive), limit=float(ACTIVE_DRIVE), axis=k + 1)
    return None


def _explain_stop(sample: Sample) -> ControllerStopped:
    return ControllerStopped(STOPS.get(sample.safety, "kuka-stop-0"), value=float(sample.safety), limit=0.0)
