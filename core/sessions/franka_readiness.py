"""Whether a robot of Franka can be moved as it is, and why it moves no longer, from what its controller tells."""

from __future__ import annotations

from core.errors import ControllerStopped, NotConnected
from core.sessions.franka_messages import JOINT_IMPEDANCE, JOINT_POSITION, Mode, Sample
from core.words.message import Message

MODES: dict[int, str] = {
    Mode.OTHER: "franka-not-ready",
    Mode.MOVE: "franka-moves-already",
    Mode.GUIDING: "franka-guiding",
    Mode.USER_STOPPED: "franka-user-stop",
    Mode.RECOVERING: "franka-recovering",
}
"""Message of every mode in which nobody may command, but for a reflex."""
REFLEXES = (
    ("franka-line", {"communication_constraints_violation"}),
    ("franka-collision", {"joint_reflex", "cartesian_reflex"}),
    (
        "franka-path",
        {
            "joint_position_motion_generator_start_pose_invalid", "joint_motion_generator_position_limits_violation",
            "joint_motion_generator_velocity_limits_violation", "joint_motion_generator_velocity_discontinuity",
            "joint_motion_generator_acceleration_discontinuity",
        },
    ),
    (
        "franka-limits",
        {
            "joint_position_limits_violation", "cartesian_position_limits_violation", "self_collision_avoidance_violation",
            "joint_velocity_violation", "cartesian_velocity_violation",
        },
    ),
)  # fmt: skip
"""Message of the errors that say what to do; the others are told by their names."""
OUTCOMES = {
    "preempted": "franka-preempted",
    "preempted-safety": "franka-safety-function",
    "rejected-safety": "franka-safety-function",
    "emergency": "franka-user-stop",
    "not-possible": "franka-not-possible",
}
"""Message of what has become of a move, where it says more than that it has ended."""


def runs(sample: Sample) -> bool:
    """Whether the controller follows joint positions."""
    return sample.mode == Mode.MOVE and sample.motion == JOINT_POSITION and sample.controller == JOINT_IMPEDANCE


def check_ready(sample: Sample, host: str) -> None:
    """Nothing where the robot can be moved as it is.

    Raises:
        NotConnected: it cannot.
    """
    if sample.mode != Mode.IDLE:
        raise NotConnected("session-not-ready", host=host, why=_explain_mode(sample).message)


def explain_refusal(outcome: str) -> Message:
    """Why a move was not begun."""
    code = OUTCOMES.get(outcome)
    return Message.of("franka-refused", outcome=outcome) if code is None else Message.of(code)


def explain_end(sample: Sample, outcome: str | None) -> ControllerStopped:
    """Why the robot obeys no longer.

    Args:
        outcome: what the controller says has become of the move; None where it says nothing.
    """
    if sample.mode not in {Mode.MOVE, Mode.IDLE}:
        return _explain_mode(sample)
    if outcome in OUTCOMES:
        return ControllerStopped(OUTCOMES[outcome], value=float(sample.mode), limit=float(Mode.MOVE))
    return ControllerStopped("franka-ended", value=float(sample.mode), limit=float(Mode.MOVE), outcome=outcome or "-")


def _explain_mode(sample: Sample) -> ControllerStopped:
    errors = sample.error_names()
    code = MODES.get(sample.mode)
    if code is None:
        code = "franka-reflex"
        for reflex, names in REFLEXES:
            if names & set(errors):
                code = reflex
                break
    return ControllerStopped(code, value=float(sample.mode), limit=float(Mode.IDLE), errors=", ".join(errors) or "-")
