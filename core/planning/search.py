"""Finds the plan of the procedure: start configurations, the transfers between them, the way home; each confirmed by a second opinion."""

from __future__ import annotations

import time
from collections.abc import Generator, Sequence
from dataclasses import replace
from itertools import groupby
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell
from core.cell.tools import widest_box
from core.errors import NoPath
from core.events import Event, Planned, StartConfigurationFound, TransferPlanned
from core.planning.commanded_path import compute_joint_paths
from core.planning.effort import PATH_ITERATIONS, grid_rounds, path_iterations
from core.planning.joint_torques import JointTorques, Load, guess_load, refuse_too_heavy
from core.planning.path import START, check_end, one_turn_away
from core.planning.plan import POSES, Leg, Plan, motions_of
from core.planning.settings import Planner, Timing
from core.planning.start_configuration import Grid, StartConfiguration, find_start_configuration
from core.planning.summary import (
    PlanTorques,
)
from core.planning.throw import ThrowCheck
from core.planning.transfer import Transfer, plan_transfer
from core.robot.collision import CollisionModel
from core.robot.decoupling import decoupling_profile, predict_inertia, repetitions_for
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile
from core.second_opinion.opinion import JointPath, Opinion, second_opinion
from core.second_opinion.refusal import refuse_disputed


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
    check_end(START, start, robot, collision, ThrowCheck(cell))
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
    refuse_disputed(cell, opinion)
    return Confirmation(opinion, asked)


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
