"""The guard's findings as errors: what, where, the value against the limit, what to do next."""

from __future__ import annotations

from collections.abc import Sequence

from core.cell.cell import Cell
from core.control.checks import GuardStop, Numbers
from core.errors import BadState, OutOfLimits, OverLoad, RobotStateLate, SensorFrozen, Stopped, TooClose, TooFast
from core.robot.model import RobotModel
from core.robot.pair_group import Nearest
from core.sessions.session import RobotState

CHANNELS = ("fx", "fy", "fz", "tx", "ty", "tz")


def make_stop_error(
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
    joint = f"joint {robot.description.joints[index]}" if index < robot.n else ""
    kind: type[Stopped]
    match fault:
        case GuardStop.NOT_FINITE | GuardStop.TARGET_NOT_FINITE:
            what = "the robot's state" if fault == GuardStop.NOT_FINITE else "the commanded position"
            kind, limit = BadState, 0.0
            message = f"{what} is not finite"
            advice = "Check the connection to robot and sensor and start again."
        case GuardStop.STALE:
            kind, limit = BadState, numbers.period
            message = f"the robot's clock went on by {1e3 * value:.2f} ms in one period (expected {1e3 * limit:.2f} ms), its state is stale"
            advice = "Check the connection to the robot and start again."
        case GuardStop.LATE:
            kind, limit = RobotStateLate, numbers.late
            message = f"the robot's state came after {1e3 * value:.1f} ms (limit {1e3 * limit:.1f} ms)"
            advice = "Take load off the computer or its network and start again."
        case GuardStop.POSITION | GuardStop.TARGET_POSITION:
            kind = OutOfLimits
            limit = float(robot.upper[index] if value > robot.upper[index] else robot.lower[index])
            message = f"{joint} {'is' if fault == GuardStop.POSITION else 'was commanded'} at {value:.4f} rad (limit {limit:.4f} rad)"
            advice = "Move it back by hand guiding and plan again."
        case GuardStop.JOINT_SPEED | GuardStop.COMMANDED_JOINT_SPEED:
            kind, limit = TooFast, numbers.velocity[index]
            message = (
                f"{joint} {'moves' if fault == GuardStop.JOINT_SPEED else 'was commanded'} at {value:.3f} rad/s (limit {limit:.3f} rad/s)"
            )
            advice = "Plan again."
        case GuardStop.SPEED | GuardStop.COMMANDED_SPEED:
            kind, limit = TooFast, numbers.speed
            message = f"{owner} {'moves' if fault == GuardStop.SPEED else 'was commanded'} at {value:.3f} m/s (limit {limit:.3f} m/s)"
            advice = "Plan again."
        case GuardStop.WRENCH:
            unit = "N" if index < 3 else "N m"
            kind, limit = OverLoad, cell.sensor.range[index]
            message = f"{CHANNELS[index]} of {cell.sensor.name} is {value:.2f} {unit} (range {limit:.2f} {unit})"
            advice = "Check for contact, or take a lighter payload or a larger sensor."
        case _:
            kind, limit = BadState, numbers.tracking
            message = f"{joint} is {value:.4f} rad from its command (limit {limit:.4f} rad)"
            advice = "Check the joint's controller and the load settings and start again."
    return kind(f"{message}; the robot was stopped. {advice}", value=value, limit=limit, samples=samples)


def make_distance_error(nearest: Nearest, cell: Cell, *, predicted: bool, samples: Sequence[RobotState]) -> TooClose:
    """The error for a distance below what is required, today's or that of the predicted stop."""
    if any(zone.name == nearest.second for zone in cell.zones):
        what, advice = f'zone "{nearest.second}"', "Clear the zone and start again."
    elif any(obstacle.name == nearest.second for obstacle in cell.obstacles):
        what, advice = f'obstacle "{nearest.second}"', "Check where it stands and plan again."
    else:
        what, advice = nearest.second, "Plan again."
    verb = "would stop" if predicted else "is"
    digits = 3 if nearest.margin_m < -1e-3 else 5
    return TooClose(
        f"{nearest.first} {verb} {nearest.distance_m:.{digits}f} m from {what} (limit {nearest.required_m:.{digits}f} m); "
        f"the robot was stopped. {advice}",
        value=nearest.distance_m,
        limit=nearest.required_m,
        samples=samples,
    )


def make_frozen_error(seconds: float, limit: float, samples: Sequence[RobotState]) -> SensorFrozen:
    """The error for a wrench that does not change any more."""
    return SensorFrozen(
        f"the wrench has not changed for {seconds:.3f} s (limit {limit:.3f} s), a live sensor shows its noise; "
        "the robot was stopped. Check the sensor's connection and start again.",
        value=seconds,
        limit=limit,
        samples=samples,
    )
