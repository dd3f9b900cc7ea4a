"""Finds the plan through a list of stops: start configurations, the transfers between them, what is done at each, the way home; all of it
confirmed by a second opinion."""

from __future__ import annotations

import time
from collections.abc import Generator, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from threading import Thread
from typing import NamedTuple

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell
from core.cell.tools import widest_box
from core.errors import BadRobot, NoPath, Refused
from core.events import Event, Planned, StartConfigurationFound, TransferPlanned, drive
from core.planning.commanded_path import compute_joint_paths
from core.planning.effort import PATH_ITERATIONS, grid_rounds, path_iterations
from core.planning.information import Worth, find_information, find_seconds
from core.planning.joint_torques import JointTorques, Load, guess_load, refuse_too_heavy
from core.planning.path import START, check_end, one_turn_away
from core.planning.plan import Leg, Plan, motions_of
from core.planning.settings import Planner, Timing
from core.planning.start_configuration import Attitude, Grid, StartConfiguration, find_start_configuration
from core.planning.stop import Stop, Swings, wave_shape
from core.planning.summary import PlanTorques
from core.planning.throw import ThrowCheck
from core.planning.torque_wave import choose_wave
from core.planning.transfer import Transfer, plan_transfer
from core.planning.wave import fit_wave
from core.planning.ways_home import add_ways_home
from core.requirement.target import Target
from core.robot.collision import CollisionModel
from core.robot.decoupling import decoupling_profile, predict_inertia, repetitions_for
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile
from core.second_opinion.arm import build_solid_arm
from core.second_opinion.opinion import JointPath, Opinion, second_opinion
from core.second_opinion.refusal import refuse_disputed

ALTERNATIVES = 3
"""Ways to the same stops among which the most telling one is taken."""
POSTURES = 4
"""Searches among which the posture farthest from another one is taken."""


def plan_stops(
    cell: Cell,
    robot: RobotModel,
    collision: CollisionModel,
    payload_box: Box,
    stops: Sequence[Stop],
    *,
    start: Array,
    timing: Timing | None = None,
    mass_guess_kg: float = 1.0,
    period: float = 0.001,
    planner: Planner = "rrt_connect",
    seed: int = 0,
    load: Load | None = None,
    effort: int = 1,
    target: Target | None = None,
) -> Generator[Event, None, Plan]:
    """Plans from joint positions `start` (n,) through all stops back to home.

    Args:
        timing: how long the robot stands still, and what rotations without a number of repetitions are to tell in the time there is.
        mass_guess_kg: what those repetitions are planned for.
        load: what the joints' torques are judged with; `guess_load` where nothing is known of it.
        effort: how much is searched before a plan is refused, see `core.planning.effort`.
        target: of a run that ends where it is reached: of several ways to each pair of stops the one is taken that tells most for each
            second of robot time, and a way home is wanted from every stop. The paper's plan where None.

    Raises:
        NoStartConfiguration, NoPath: the cell leaves no safe way.
        TooHeavy: the joints have not the torque, with the load or else with a guessed one.
        PlanDisputed: the second opinion does not confirm the plan, or a motion of it cannot be carried out.
    """
    began = time.perf_counter()
    Thread(target=_read_ahead, args=(cell, payload_box), daemon=True).start()
    timing = timing or Timing()
    torques = check_standing(cell, robot, collision, start, load or guess_load(cell, payload_box, mass_guess_kg), period)
    search = _Search(cell, robot, collision, payload_box, period, planner, seed, torques, effort)
    legs: list[Leg] = []
    here = start
    worth = None if target is None else Worth(target, torques.load.parameters)
    for group in _group_opposites(stops):
        legs += yield from search.reach(group, here, legs) if worth is None else search.reach_most_telling(group, here, legs, worth, timing)
        here = legs[-1].transfer.goal
    back = way_home(cell, robot, collision, here, period=period, planner=planner, seed=seed, effort=effort)
    yield TransferPlanned(axis="home", robot_s=back.trajectory.duration, least_margin_m=back.least_margin_m)
    legs = _repeat_rotations(legs, back, timing, search, mass_guess_kg)
    found = confirm_plan(cell, robot, collision, payload_box, legs, back, torques)
    if target is not None:
        legs = add_ways_home(cell, robot, collision, payload_box, legs, back, torques, planner=planner, seed=seed)
    plan = Plan(tuple(legs), back, timing, time.perf_counter() - began, found.opinion, found.torques, found.commanded)
    yield Planned(robot_s=plan.robot_s, plan_s=plan.plan_s, least_margin_m=plan.least_margin_m)
    return plan


def _read_ahead(cell: Cell, payload_box: Box) -> None:
    """The second opinion's own reader reads the robot's meshes while the plan is sought; what it refuses is refused when it is asked."""
    with suppress(BadRobot):
        build_solid_arm(cell, payload_box)


def _group_opposites(stops: Sequence[Stop]) -> Iterator[tuple[Stop, ...]]:
    """Neighbours that point opposite sides down in one group: the way between them is short where they are sought together."""
    rest = tuple(stops)
    while rest:
        opposite = len(rest) > 1 and np.array_equal(rest[0].down, np.negative(rest[1].down))
        size = 2 if opposite else 1
        yield rest[:size]
        rest = rest[size:]


def _repeat_rotations(legs: list[Leg], home: Transfer, timing: Timing, search: _Search, mass_guess_kg: float) -> list[Leg]:
    """The legs with their rotations as often as the wanted uncertainty needs, in the robot time, where the stops leave that open."""
    count = sum(leg.stop.repeats_as_needed for leg in legs)
    if not count:
        return legs
    moving = home.trajectory.duration + sum(leg.transfer.trajectory.duration for leg in legs)
    settled = sum(leg.moving_s + timing.settle_s for leg in legs if leg.moving_s > 0.0 and not leg.stop.repeats_as_needed)
    budget = (timing.robot_s - moving - settled - timing.hold_s * len(legs)) / count - timing.settle_s
    return [search.repeat_as_needed(leg, budget, mass_guess_kg, timing.inertia_std) for leg in legs]


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
    commanded: tuple[JointPath, ...]


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
    return Confirmation(opinion, asked, tuple(paths))


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


@dataclass(frozen=True)
class _Search:
    """Finds stops together with the ways to them."""

    cell: Cell
    robot: RobotModel
    collision: CollisionModel
    payload_box: Box
    period: float
    planner: Planner
    seed: int
    torques: JointTorques
    effort: int

    def reach(self, group: tuple[Stop, ...], here: Array, before: Sequence[Leg]) -> Generator[Event, None, list[Leg]]:
        """Stops that can be reached from joint positions `here`, and leave room for what is done there; others where these cannot.

        A rotation that the stop does not say how often to repeat is made once.

        Args:
            before: the legs up to there: a wave that is for planning to choose tells what these leave open.
        """
        for attempt, iterations in enumerate(path_iterations(self.effort)):
            starts = yield from self._find(group, here, self.seed + 101 * attempt)
            try:
                return (yield from self._connect(group, starts, here, iterations, before))
            except NoPath as error:
                failure = error
        failure.axis = group[0].label
        raise failure

    def reach_most_telling(
        self, group: tuple[Stop, ...], here: Array, before: Sequence[Leg], worth: Worth, timing: Timing
    ) -> Generator[Event, None, list[Leg]]:
        """Of several ways to the same stops that which gains most for each second of robot time, after what the legs before have told."""
        found = [(yield from self.reach(group, here, before))]
        for k in range(1, ALTERNATIVES):
            with suppress(Refused):
                found.append(drive(replace(self, seed=self.seed + 1009 * k).reach(group, here, before)))
        known = find_information(self.cell, self.robot, before, timing)
        size = worth.find_size(known)

        def find_gain_per_second(legs: list[Leg]) -> float:
            told = find_information(self.cell, self.robot, legs, timing)
            return (size - worth.find_size(known + told)) / find_seconds(legs, timing)

        return max(found, key=find_gain_per_second)

    def repeat_as_needed(self, leg: Leg, budget: float, mass_guess_kg: float, inertia_std: float) -> Leg:
        """A leg with its rotation as often as the wanted relative uncertainty needs in `budget` s, if its stop leaves that open."""
        swings = leg.stop.swings
        if swings is None or not leg.stop.repeats_as_needed:
            return leg
        k = "xyz".index(swings.about)
        once = self._profile(swings)
        repetitions = repetitions_for(
            once,
            torque_std=self.cell.sensor.noise_std[3 + k],
            inertia_std=inertia_std * predict_inertia(self.payload_box, mass_guess_kg, k),
            budget=max(budget, once.duration),
        )
        return replace(leg, profile=self._profile(swings, repetitions))

    def _find(self, group: tuple[Stop, ...], here: Array, seed: int) -> Generator[Event, None, list[StartConfiguration]]:
        """The harder one of two opposite stops first, which is the one with a rotation; the other then near it."""
        starts: dict[Stop, StartConfiguration] = {}
        for stop in sorted(group, key=lambda stop: (stop.swings is None, stop.label)):
            found = self._choose(stop, here, seed)
            yield StartConfigurationFound(
                axis=stop.label,
                clearance_m=found.clearance_m,
                nearest=found.nearest,
                manipulability=found.manipulability,
                candidates=found.candidates,
            )
            starts[stop] = found
            here = found.q
        return [starts[stop] for stop in group]

    def _choose(self, stop: Stop, here: Array, seed: int) -> StartConfiguration:
        """Where to stop, near joint positions `here`; where the posture is to be another one, the farthest of several."""
        if stop.away_from_rad is None:
            return self._start(stop, here, seed)
        avoided = np.array(stop.away_from_rad)
        found = [self._start(stop, None, seed + k) for k in range(POSTURES)]
        return max(found, key=lambda start: float(np.abs(start.q - avoided).max()))

    def _start(self, stop: Stop, near: Array | None, seed: int) -> StartConfiguration:
        about = "x" if stop.swings is None else stop.swings.about
        rotation = None if stop.swings is None else self._profile(stop.swings)
        attitude = Attitude(stop.label, np.array(stop.down), np.eye(3)["xyz".index(about)], rotation)
        grid = Grid(rounds=grid_rounds(self.effort))
        found = find_start_configuration(
            self.cell, self.robot, self.collision, attitude, seed=seed, near=near, grid=grid, torques=self.torques
        )
        return replace(found, about="" if stop.swings is None else about)

    def _connect(
        self, group: tuple[Stop, ...], starts: list[StartConfiguration], here: Array, iterations: int, before: Sequence[Leg]
    ) -> Generator[Event, None, list[Leg]]:
        """Transfers from one stop to the next, and what is done at their ends."""
        legs: list[Leg] = []
        for stop, start in zip(group, starts, strict=True):
            goals = one_turn_away(self.robot, start.q, here)
            transfer = plan_transfer(
                self.cell,
                self.robot,
                self.collision,
                here,
                goals,
                period=self.period,
                planner=self.planner,
                seed=self.seed,
                iterations=iterations,
            )
            legs.append(self._make_leg(stop, replace(start, q=transfer.goal), transfer, [*before, *legs]))
            yield TransferPlanned(axis=stop.label, robot_s=transfer.trajectory.duration, least_margin_m=transfer.least_margin_m)
            here = transfer.goal
        return legs

    def _make_leg(self, stop: Stop, start: StartConfiguration, transfer: Transfer, before: Sequence[Leg]) -> Leg:
        if stop.swings is not None:
            return Leg(stop, start, transfer, profile=self._profile(stop.swings, stop.swings.repetitions or 1))
        if stop.wave is not None and stop.wave.wrist is None:
            made = [*(each for leg in before for each in leg.trajectories), transfer.trajectory]
            load = self.torques.load.parameters
            chosen, wave = choose_wave(self.cell, self.robot, self.collision, load, start.q, stop.wave, made)
            return Leg(stop.model_copy(update={"wave": chosen}), start, transfer, wave=wave)
        if stop.wave is not None:
            shape = wave_shape(stop.wave, self.robot.n, self.period)
            return Leg(stop, start, transfer, wave=fit_wave(self.cell, self.robot, self.collision, start.q, shape, self.period))
        return Leg(stop, start, transfer)

    def _profile(self, swings: Swings, repetitions: int = 1) -> AngularProfile:
        return decoupling_profile(
            widest_box(self.cell, self.payload_box),
            cartesian_speed=self.cell.limits.cartesian_speed_m_s,
            period=self.period,
            repetitions=repetitions,
            excursion=swings.excursion_rad,
        )
