"""The joint path of a plan, so that what it will tell can be predicted before it is released."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from core.array import Array, interpolate
from core.planning.plan import Leg, Plan
from core.planning.rotation_room import Turn, rotation_path
from core.recording.recording import Recording
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile


def path_of(plan: Plan, robot: RobotModel, like: Recording) -> Recording:
    """The plan as a recording without a wrench (zeros), of the same robot and sensor as another one and with its columns."""
    pieces = [piece for leg in plan.legs for piece in _leg(leg, plan, robot)]
    pieces.append((plan.home.trajectory.q, "transfer"))
    q = np.concatenate([path for path, _ in pieces])
    phase = np.concatenate([np.full(len(path), label) for path, label in pieces])
    period = plan.home.trajectory.period
    every = max(1, round(float(np.median(np.diff(like.t))) / period))
    t = np.arange(len(q), dtype=np.float64)[::every] * period
    temperature = None if like.temperature is None else np.full(len(t), like.temperature[-1])
    return Recording(
        t=t,
        gravity=like.gravity,
        wrench=np.zeros((len(t), 6)),
        q=q[::every],
        temperature=temperature,
        phase=phase[::every],
        robot=like.robot,
        sensor=like.sensor,
    )


def _leg(leg: Leg, plan: Plan, robot: RobotModel) -> Iterator[tuple[Array, str]]:
    """Stretches of the path (K, n) with their labels, in the order in which they are carried out."""
    period, hold = leg.transfer.trajectory.period, f"hold:{leg.axis}"

    def still(seconds: float) -> Array:
        return np.repeat(leg.start.q[None], round(seconds / period), axis=0)

    yield leg.transfer.trajectory.q, "transfer"
    yield still(plan.timing.hold_s), hold
    if leg.profile is not None:
        yield _trace_rotation(leg.start.q, leg.profile, leg.about, robot), f"rotate:{leg.about}"
    if leg.wave is not None:
        yield leg.wave.q, "transfer"
    if leg.moving_s > 0.0:
        yield still(plan.timing.settle_s), hold


def _trace_rotation(q: Array, profile: AngularProfile, about: str, robot: RobotModel) -> Array:
    """(K, n), along a rotation that runs unscaled, as planning has checked that it can."""
    turn = Turn.of(profile, np.eye(3)["xyz".index(about)])
    found = rotation_path(robot.chain, q, turn)
    if found is None:
        raise ValueError("a planned rotation has a path")
    return interpolate(profile.angle, turn.angle, found[0])
