"""The plan of a whole run: for each sensor axis the pose against and along gravity, the transfers between them, the rotations.

Planning moves nothing. The plan is data: it can be shown, checked and released before the robot does anything.
"""

from __future__ import annotations

import math
import time
from collections.abc import Generator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from core.cell.cell import Box, Cell
from core.cell.tools import widest_box
from core.errors import NoPath
from core.events import Event, Planned, StartConfigurationFound, TransferPlanned
from core.planning.commanded_path import PlanPart, compute_joint_paths
from core.planning.effort import PATH_ITERATIONS, grid_rounds, path_iterations
from core.planning.joint_torques import JointTorques, Load, guess_load, refuse_too_heavy
from core.planning.path import check_end, one_turn_away
from core.planning.settings import WHOLE, Planner, Timing
from core.planning.start_configuration import Grid, StartConfiguration, find_start_configuration
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
from core.planning.throw import ThrowCheck
from core.planning.transfer import Transfer, plan_transfer
from core.robot.collision import CollisionModel
from core.robot.decoupling import decoupling_profile, predict_inertia, repetitions_for
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile, JointTrajectory
from core.second_opinion.opinion import JointPath, Opinion, second_opinion
from core.second_opinion.refusal import refuse_disputed

Array = NDArray[np.float64]

POSES = WHOLE.poses


@dataclass(frozen=True)
class Leg:
    """One transfer and what is done at its end: a hold, and one movement between two holds at most.

    Args:
        axis: `x+`, or `free`: what points down in the hold.
        profile: of a rotation, None where there is none.
        about: sensor axis of that rotation.
        wave: joint trajectory from standstill to standstill, checked at every tick.
    """

    axis: str
    start: StartConfiguration
    transfer: Transfer
    profile: AngularProfile | None = None
    about: str = ""
    wave: JointTrajectory | None = None

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
    """

    legs: tuple[Leg, ...]
    home: Transfer
    timing: Timing
    plan_s: float
    opinion: Opinion
    torques: PlanTorques

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
        seen = [each.distance_m - each.required_m for each in self.opinion.approaches if not each.kind.is_close]
        return min(*seen, *(transfer.least_margin_m for transfer in (self.home, *(leg.transfer for leg in self.legs))), math.inf)


def plan_procedure(
    cell: Cell,
    robot: RobotModel,
    collision: CollisionModel,
    payload_box: Box,
    *,
    start: Array,
    poses: Sequence[str] = POSES,
    rotations: bool = True,
    period: float = 0.001,
    timing: Timing | None = None,
    mass_guess_kg: float = 1.0,
    planner: Planner = "rrt_connect",
    seed: int = 0,
    load: Load | None = None,
    effort: int = 1,
) -> Generator[Event, None, Plan]:
    """Plans from joint positions `start` through all `poses` back to home.

    Args:
        rotations: whether there are any at the poses along gravity.
        load: what the joints' torques are judged with; `guessed_load` where nothing is known of it.
        effort: how much is searched before a plan is refused, see `core.planning.effort`.

    Raises:
        NoStartConfiguration, NoPath: the cell leaves no safe way.
        TooHeavy: the joints have not the torque.
        PlanDisputed: the second opinion does not confirm the plan, or a motion of it cannot be carried out.
    """
    began = time.perf_counter()
    timing = timing or Timing()
    speed = cell.limits.cartesian_speed_m_s
    once = decoupling_profile(widest_box(cell, payload_box), cartesian_speed=speed, period=period, excursion=timing.swing_rad)
    torques = check_standing(cell, robot, collision, start, load or guess_load(cell, payload_box, mass_guess_kg), period)
    search = _Search(cell, robot, collision, once, rotations, planner, seed, torques, effort)
    reached: list[Reached] = []
    for _, group in groupby(poses, key=lambda pose: pose[0]):
        here = reached[-1].start.q if reached else start
        reached += yield from search.reach(tuple(group), here)
    last = reached[-1].start.q if reached else start
    back = way_home(cell, robot, collision, last, period=period, planner=planner, seed=seed, effort=effort)
    yield TransferPlanned(axis="home", robot_s=back.trajectory.duration, least_margin_m=back.least_margin_m)
    moving = back.trajectory.duration + sum(pose.transfer.trajectory.duration for pose in reached)
    turns = sum(axis.endswith("+") for axis in poses)
    budget = (timing.robot_s - moving - timing.hold_s * len(poses)) / max(turns, 1) - timing.settle_s
    legs = tuple(
        Leg(
            axis,
            start,
            transfer,
            _repeat_rotation(cell, payload_box, axis, once, budget, mass_guess_kg, timing) if rotations else None,
            axis[0],
        )
        for axis, start, transfer in reached
    )
    found = confirm_plan(cell, robot, collision, payload_box, legs, back, torques)
    plan = Plan(legs, back, timing, time.perf_counter() - began, found.opinion, found.torques)
    yield Planned(robot_s=plan.robot_s, plan_s=plan.plan_s, least_margin_m=plan.least_margin_m)
    return plan


def check_standing(cell: Cell, robot: RobotModel, collision: CollisionModel, start: Array, load: Load, period: float) -> JointTorques:
    """The torques of the joints with a load, for a robot that may be at joint positions `start` (n,) and holds it there and at home.

    Raises:
        NoPath: it may not be there.
        TooHeavy: it cannot.
    """
    check_end("start", start, robot, collision, ThrowCheck(cell))
    torques = JointTorques(cell, robot, load)
    home = np.array(cell.robot.home_rad)
    refuse_too_heavy(torques.of([JointPath("start", start[None]), JointPath("home", home[None])], period))
    return torques


class Confirmation(NamedTuple):
    """What was found of a finished plan, set point by set point."""

    opinion: Opinion
    torques: PlanTorques


def confirm_plan(
    cell: Cell,
    robot: RobotModel,
    collision: CollisionModel,
    payload_box: Box,
    legs: Sequence[Leg],
    home: Transfer,
    torques: JointTorques,
) -> Confirmation:
    """Torques and the second opinion on legs and the way home, every set point as it will be commanded.

    Raises:
        TooHeavy: a joint has not the torque.
        PlanDisputed: the second opinion does not confirm them, or one of their motions cannot be carried out.
    """
    first = legs[0].transfer if legs else home
    paths = compute_joint_paths(cell, robot, collision, motions_of(legs, home), first.trajectory.q[0])
    asked = torques.of(paths, home.trajectory.period)
    refuse_too_heavy(asked)
    opinion = second_opinion(cell, payload_box, paths, home.trajectory.period)
    refuse_disputed(opinion)
    return Confirmation(opinion, asked)


def motions_of(legs: Sequence[Leg], home: Transfer) -> list[PlanPart]:
    """Everything that moves, in order."""
    motions: list[PlanPart] = []
    for leg in legs:
        motions.append(PlanPart(f"transfer {leg.axis}", leg.transfer.trajectory))
        motions += [] if leg.profile is None else [PlanPart(f"rotation {leg.about}", leg.profile, leg.about)]
        motions += [] if leg.wave is None else [PlanPart(f"wave {leg.axis}", leg.wave)]
    return [*motions, PlanPart("home", home.trajectory)]


def way_home(
    cell: Cell, robot: RobotModel, collision: CollisionModel, here: Array, *, period: float, planner: Planner, seed: int, effort: int
) -> Transfer:
    """From joint positions `here` (n,) to home, which no other place can stand in for: the longest searches only.

    Raises:
        NoPath: with the reason of the last of them.
    """
    home = np.array(cell.robot.home_rad)
    for attempt, iterations in enumerate(path_iterations(effort)[len(PATH_ITERATIONS) - 1 :]):
        try:
            return plan_transfer(
                cell, robot, collision, here, home, period=period, planner=planner, seed=seed + 101 * attempt, iterations=iterations
            )
        except NoPath as error:
            failure = error
    raise failure


class Reached(NamedTuple):
    """A pose with the way to it."""

    axis: str
    start: StartConfiguration
    transfer: Transfer


class _Search(NamedTuple):
    """Finds the poses of one axis together with the ways to them."""

    cell: Cell
    robot: RobotModel
    collision: CollisionModel
    rotation: AngularProfile
    rotations: bool
    planner: Planner
    seed: int
    torques: JointTorques
    effort: int

    def reach(self, poses: tuple[str, ...], here: Array) -> Generator[Event, None, list[Reached]]:
        """Start configurations that can be reached from joint positions `here`, other ones where there is no way to the first."""
        for attempt, iterations in enumerate(path_iterations(self.effort)):
            starts = yield from self._find(poses, here, self.seed + 101 * attempt)
            try:
                return (yield from self._connect(poses, starts, here, iterations))
            except NoPath as error:
                failure = error
        failure.axis = poses[0]
        raise failure

    def _find(self, poses: tuple[str, ...], here: Array, seed: int) -> Generator[Event, None, dict[str, StartConfiguration]]:
        """The axis along gravity first, which is the harder one; its opposite then near it."""
        starts: dict[str, StartConfiguration] = {}
        for axis in sorted(poses):
            rotation = self.rotation if self.rotations and axis.endswith("+") else None
            grid = Grid(rounds=grid_rounds(self.effort))
            found = find_start_configuration(
                self.cell, self.robot, self.collision, axis, rotation, seed=seed, near=here, grid=grid, torques=self.torques
            )
            yield StartConfigurationFound(
                axis=axis,
                clearance_m=found.clearance_m,
                nearest=found.nearest,
                manipulability=found.manipulability,
                candidates=found.candidates,
            )
            starts[axis] = found
            here = found.q
        return starts

    def _connect(
        self, poses: tuple[str, ...], starts: dict[str, StartConfiguration], here: Array, iterations: int
    ) -> Generator[Event, None, list[Reached]]:
        """Transfers from one pose to the next."""
        reached: list[Reached] = []
        for axis in poses:
            goals = one_turn_away(self.robot, starts[axis].q, here)
            transfer = plan_transfer(
                self.cell,
                self.robot,
                self.collision,
                here,
                goals,
                period=self.rotation.period,
                planner=self.planner,
                seed=self.seed,
                iterations=iterations,
            )
            yield TransferPlanned(axis=axis, robot_s=transfer.trajectory.duration, least_margin_m=transfer.least_margin_m)
            reached.append(Reached(axis, replace(starts[axis], q=transfer.goal), transfer))
            here = transfer.goal
        return reached


def _repeat_rotation(
    cell: Cell, payload_box: Box, axis: str, once: AngularProfile, budget: float, mass_guess_kg: float, timing: Timing
) -> AngularProfile | None:
    """The rotation as often as the wanted uncertainty needs; None for a pose that is only held."""
    if axis.endswith("-"):
        return None
    k = "xyz".index(axis[0])
    repetitions = repetitions_for(
        once,
        torque_std=cell.sensor.noise_std[3 + k],
        inertia_std=timing.inertia_std * predict_inertia(payload_box, mass_guess_kg, k),
        budget=max(budget, once.duration),
    )
    return decoupling_profile(
        widest_box(cell, payload_box),
        cartesian_speed=cell.limits.cartesian_speed_m_s,
        period=once.period,
        repetitions=repetitions,
        excursion=timing.swing_rad,
    )


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
