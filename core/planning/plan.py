"""The plan of a whole run: its stops, the transfers between them, and what is done at each.

Planning moves nothing. The plan is data: it can be shown, checked and released before the robot does anything.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from hashlib import sha256

from core.cell.cell import Cell
from core.planning.commanded_path import PlanPart
from core.planning.settings import Timing
from core.planning.start_configuration import StartConfiguration
from core.planning.stop import Stop
from core.planning.summary import (
    ClosestPair,
    FastestCorner,
    LeftOutPair,
    NearestFlight,
    PlannedPose,
    PlanSummary,
    PlanTorques,
    SecondOpinion,
)
from core.planning.transfer import Transfer
from core.robot.trajectory import AngularProfile, JointTrajectory
from core.second_opinion.opinion import JointPath, Opinion


@dataclass(frozen=True)
class WayHome:
    """A way home of its own, for a run that ends at a stop.

    Args:
        opinion: the second one, which it has passed.
    """

    transfer: Transfer
    opinion: Opinion


@dataclass(frozen=True)
class Leg:
    """The way to one stop and what is done there: a hold, and one movement between two holds at most.

    Args:
        profile: of the stop's rotation, None where there is none.
        wave: the stop's wave as a joint trajectory from standstill to standstill, checked at every tick; None where there is none.
        home: from the stop, where a run may end there; None where that goes home along the rest of the plan.
    """

    stop: Stop
    start: StartConfiguration
    transfer: Transfer
    profile: AngularProfile | None = None
    wave: JointTrajectory | None = None
    home: WayHome | None = None

    @property
    def axis(self) -> str:
        """What points down in the hold: `x+`, or `free`."""
        return self.stop.label

    @property
    def about(self) -> str:
        """Sensor axis of the rotation; empty where there is none."""
        return "" if self.stop.swings is None else self.stop.swings.about

    @property
    def trajectories(self) -> tuple[JointTrajectory, ...]:
        """Its motions that are joint trajectories, all but a rotation."""
        return (self.transfer.trajectory,) if self.wave is None else (self.transfer.trajectory, self.wave)

    @property
    def moving_s(self) -> float:
        """Time of the movement at its end, s."""
        return sum(motion.duration for motion in (self.profile, self.wave) if motion is not None)


@dataclass(frozen=True)
class Plan:
    """What the robot is going to do, from where it stands back to home.

    Args:
        opinion: of the check that shares no code with the planner, which the plan has passed.
        torques: what it asks of the joints, which they have.
        commanded: every motion as joint positions, period by period, holds left out.
    """

    legs: tuple[Leg, ...]
    home: Transfer
    timing: Timing
    plan_s: float
    opinion: Opinion
    torques: PlanTorques
    commanded: tuple[JointPath, ...]

    @property
    def robot_s(self) -> float:
        """Time that the robot will need, s."""
        moving = self.home.trajectory.duration + sum(leg.transfer.trajectory.duration for leg in self.legs)
        turning = sum(leg.moving_s + self.timing.settle_s for leg in self.legs if leg.moving_s > 0.0)
        return moving + turning + self.timing.hold_s * len(self.legs)

    @property
    def least_margin_m(self) -> float:
        """Smallest distance beyond what is required, of everything that moves, m.

        The planner's own on the transfers, and on all of the plan what the second opinion found: it measures links that only the first
        joint moves as well, which the planner leaves out where they cannot come too close.
        """
        ways = [leg.home for leg in self.legs if leg.home is not None]
        opinions = (self.opinion, *(way.opinion for way in ways))
        seen = [each.distance_m - each.required_m for opinion in opinions for each in opinion.approaches if not each.kind.is_close]
        transfers = (self.home, *(leg.transfer for leg in self.legs), *(way.transfer for way in ways))
        return min(*seen, *(transfer.least_margin_m for transfer in transfers), math.inf)


def motions_of(legs: Sequence[Leg], home: Transfer) -> list[PlanPart]:
    """Everything that moves, in order."""
    motions: list[PlanPart] = []
    for leg in legs:
        motions.append(PlanPart(f"transfer {leg.axis}", leg.transfer.trajectory))
        motions += [] if leg.profile is None else [PlanPart(f"rotation {leg.about}", leg.profile, leg.about)]
        motions += [] if leg.wave is None else [PlanPart(f"wave {leg.axis}", leg.wave)]
    return [*motions, PlanPart("home", home.trajectory)]


def plan_digest(plan: Plan) -> str:
    """SHA-256 of every set point and of all times of a plan, hexadecimal."""
    digest = sha256(repr((plan.timing, [(leg.axis, leg.about) for leg in plan.legs])).encode())
    for leg in plan.legs:
        digest.update(leg.transfer.trajectory.q.tobytes())
        if leg.profile is not None:
            digest.update(leg.profile.angle.tobytes())
            digest.update(leg.profile.rate.tobytes())
        if leg.wave is not None:
            digest.update(leg.wave.q.tobytes())
        if leg.home is not None:
            digest.update(leg.home.transfer.trajectory.q.tobytes())
    digest.update(plan.home.trajectory.q.tobytes())
    return digest.hexdigest()


def plan_summary(cell: Cell, plan: Plan) -> PlanSummary:
    """The plan without its trajectories."""
    poses = [
        PlannedPose(
            axis=leg.axis,
            q_rad=leg.start.q.tolist(),
            clearance_m=leg.start.clearance_m,
            least_clearance_m=leg.start.least_clearance_m,
            nearest=leg.start.nearest,
            manipulability=leg.start.manipulability,
            transfer_s=leg.transfer.trajectory.duration,
            transfer_least_margin_m=leg.transfer.least_margin_m,
            rotation_s=None if leg.profile is None else leg.profile.duration,
            home_s=None if leg.home is None else leg.home.transfer.trajectory.duration,
        )
        for leg in plan.legs
    ]
    nearest = plan.opinion.nearest_thing
    return PlanSummary(
        cell=cell.name,
        poses=poses,
        home_s=plan.home.trajectory.duration,
        robot_s=plan.robot_s,
        plan_s=plan.plan_s,
        least_margin_m=plan.least_margin_m,
        second_opinion=_opinion_summary(plan.opinion),
        torques=plan.torques,
        least_distance_m=None if nearest is None else nearest.distance_m,
        left_out=[LeftOutPair(first=pair.first, second=pair.second, why=pair.why) for pair in plan.opinion.left_out],
    )


def _opinion_summary(opinion: Opinion) -> SecondOpinion:
    fast, lost = opinion.fastest, opinion.lost_load
    return SecondOpinion(
        closest=[
            ClosestPair(
                kind=each.kind,
                first=each.first,
                second=each.second,
                distance_m=each.distance_m,
                required_m=each.required_m,
                part=each.part,
                time_s=each.time_s,
            )
            for each in opinion.approaches
        ],
        fastest=FastestCorner(body=fast.body, speed_m_s=fast.speed_m_s, limit_m_s=fast.limit_m_s, part=fast.part, time_s=fast.time_s),
        samples=opinion.samples,
        lost_load=None if lost is None else NearestFlight(**vars(lost)),
    )
