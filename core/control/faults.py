"""The guard's findings as errors: what, where, the value against the limit, what to do next."""

from __future__ import annotations

from collections.abc import Sequence

from core.cell.body_name import name_body
from core.cell.cell import Cell
from core.control.checks import GuardStop, Numbers
from core.errors import BadState, OutOfLimits, OverLoad, RobotStateLate, SensorFrozen, Stopped, TooClose, TooFast
from core.payload.channels import CHANNELS
from core.robot.model import RobotModel
from core.robot.pair_group import Nearest
from core.sessions.session import RobotState

IS_TOO_CLOSE = {
    "body-zone": "guard-too-close-to-zone",
    "body-obstacle": "guard-too-close-to-obstacle",
    "body-link": "guard-too-close",
}
COMES_TOO_CLOSE = {
    "body-zone": "guard-would-stop-too-close-to-zone",
    "body-obstacle": "guard-would-stop-too-close-to-obstacle",
    "body-link": "guard-would-stop-too-close",
}
"""Codes by what it is that is near; each has its own advice."""


def make_stop_error(  # noqa: PLR0911, PLR0912 - one return per fault
    fault: GuardStop,
    index: int,
    value: float,
    *,
    cell: Cell,
    robot: RobotModel,
    owner: str,
    numbers: Numbers,
    samples: Sequence[RobotState],
) -> Stopped:
    """The error for what `checks` found.

    Args:
        fault, index, value: what, the joint or wrench channel, and its value.
        owner: link of the point that was too fast, or "payload".
        numbers: the limits that the checks were given.
        samples: the last states, the offending one at the end.
    """
    joint = robot.description.joints[index] if index < robot.n else ""
    match fault:
        case GuardStop.NOT_FINITE:
            return BadState("guard-state-not-finite", value=value, limit=0.0, samples=samples)
        case GuardStop.TARGET_NOT_FINITE:
            return BadState("guard-command-not-finite", value=value, limit=0.0, samples=samples)
        case GuardStop.STALE:
            return BadState("guard-state-stale", value=value, limit=numbers.period, samples=samples)
        case GuardStop.LATE:
            return RobotStateLate("guard-state-late", value=value, limit=numbers.late, samples=samples)
        case GuardStop.POSITION | GuardStop.TARGET_POSITION:
            limit = float(robot.upper[index] if value > robot.upper[index] else robot.lower[index])
            if fault == GuardStop.POSITION:
                return OutOfLimits("guard-joint-position", joint=joint, value=value, limit=limit, samples=samples)
            return OutOfLimits("guard-joint-position-commanded", joint=joint, value=value, limit=limit, samples=samples)
        case GuardStop.JOINT_SPEED | GuardStop.COMMANDED_JOINT_SPEED:
            limit = float(numbers.velocity[index])
            if fault == GuardStop.JOINT_SPEED:
                return TooFast("guard-joint-speed", joint=joint, value=value, limit=limit, samples=samples)
            return TooFast("guard-joint-speed-commanded", joint=joint, value=value, limit=limit, samples=samples)
        case GuardStop.SPEED:
            return TooFast("guard-speed", body=name_body(cell, owner), value=value, limit=numbers.speed, samples=samples)
        case GuardStop.COMMANDED_SPEED:
            return TooFast("guard-speed-commanded", body=name_body(cell, owner), value=value, limit=numbers.speed, samples=samples)
        case GuardStop.WRENCH:
            channel, sensor, limit = CHANNELS[index], cell.sensor.name, cell.sensor.range[index]
            if index < 3:
                return OverLoad("guard-force", channel=channel, sensor=sensor, value=value, limit=limit, samples=samples)
            return OverLoad("guard-torque", channel=channel, sensor=sensor, value=value, limit=limit, samples=samples)
        case _:
            return BadState("guard-joint-off-command", joint=joint, value=value, limit=numbers.tracking, samples=samples)


def make_distance_error(nearest: Nearest, cell: Cell, *, predicted: bool, samples: Sequence[RobotState]) -> TooClose:
    """The error for a distance below what is required, today's or that of the predicted stop."""
    first, second = name_body(cell, nearest.first), name_body(cell, nearest.second)
    value, limit = nearest.distance_m, nearest.required_m
    codes = COMES_TOO_CLOSE if predicted else IS_TOO_CLOSE
    return TooClose(codes.get(second.code, codes["body-link"]), first=first, second=second, value=value, limit=limit, samples=samples)


def make_frozen_error(seconds: float, limit: float, samples: Sequence[RobotState]) -> SensorFrozen:
    """The error for a wrench that does not change any more."""
    return SensorFrozen("guard-wrench-frozen", value=seconds, limit=limit, samples=samples)
