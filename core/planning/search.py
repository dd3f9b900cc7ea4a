"""Finds the plan through a list of stops: start configurations, the transfers between them, what is done at each, the way home; all of it
confirmed by a second opinion."""

from __future__ import annotations

import time
from collections.abc import Generator, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from threading import Thread

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell
from core.cell.tools import widest_box
from core.errors import BadRobot, NoPath, PlanDisputed, Refused
from core.events import Event, Planned, StartConfigurationFound, TransferPlanned, drive
from core.planning.candidate_checks import Attitude
from core.planning.confirmation import Confirmation, check_standing, confirm_plan
from core.planning.effort import PATH_ITERATIONS, grid_rounds, path_iterations
from core.planning.information import Worth, choose_holds, find_information, find_seconds
from core.planning.joint_torques import JointTorques, Load, guess_load
from core.planning.path import SPARE_M, TIGHT_SPARE_M, one_turn_away
from core.planning.plan import Leg, Plan
from core.planning.settings import Planner, Timing
from core.planning.start_configuration import Grid, StartConfiguration, find_start_configuration
from core.planning.stop import Stop, wave_shape
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

SMALLER_SWINGS = (0.5, 0.25)
"""Parts of a rotation's angle that will do where there is no room for all of it, at a speed that is lower by their root; repeated as often
as the wanted accuracy needs, small swings tell as much as wide ones."""
ALTERNATIVES = 3
"""Ways to the same stops among which the most telling one is taken."""
ANOTHER_SEED = 3
"""Plans that are made, each from a seed of its own, before it is said that the second opinion confirms none."""
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
            second of robot time, holds are as short as is worth it, and a way home is wanted from every stop. The paper's plan where None.

    Raises:
        NoStartConfiguration, NoPath: the cell leaves no safe way.
        TooHeavy: the joints have not the torque, with the load or else with a guessed one.
        PlanDisputed: the second opinion does not confirm the plan, or a motion of it cannot be carried out.
    """
    began = time.perf_counter()
    Thread(target=_read_ahead, args=(cell, payload_box), daemon=True).start()
    timing = timing or Timing()
    torques = check_standing(cell, robot, collision, start, load or guess_load(cell, payload_box, mass_guess_kg), period)
    for attempt in range(ANOTHER_SEED):
        search = _Search(cell, robot, collision, payload_box, period, planner, seed + 7919 * attempt, torques, effort)
        try:
            legs, back, holds, found = yield from search.plan_once(stops, start, timing, mass_guess_kg, target)
            break
        except PlanDisputed as error:
            disputed = error
    else:
        raise disputed
    plan = Plan(tuple(legs), back, holds, time.perf_counter() - began, found.opinion, found.torques, found.commanded)
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


def _path_searches(iterations: Sequence[int]) -> list[tuple[int, float]]:
    """Iterations and wanted margins (m) of one search after the other: where none finds a path the last two are made with less margin."""
    return [*((each, SPARE_M) for each in iterations), *((each, TIGHT_SPARE_M) for each in iterations[-2:])]


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

    def plan_once(
        self, stops: Sequence[Stop], start: Array, timing: Timing, mass_guess_kg: float, target: Target | None
    ) -> Generator[Event, None, tuple[list[Leg], Transfer, Timing, Confirmation]]:
        """Legs through all stops, the way home, how long it stands still, and what the second opinion finds of them; see `plan_stops`."""
        legs: list[Leg] = []
        here = start
        worth = None if target is None else Worth(target, self.torques.load.parameters)
        for group in _group_opposites(stops):
            legs += yield from self.reach(group, here, legs) if worth is None else self.reach_most_telling(group, here, legs, worth, timing)
            here = legs[-1].transfer.goal
        back = self.way_home(here)
        yield TransferPlanned(axis="home", robot_s=back.trajectory.duration, least_margin_m=back.least_margin_m)
        legs = _repeat_rotations(legs, back, timing, self, mass_guess_kg)
        timing = timing if worth is None else choose_holds(self.cell, self.robot, legs, timing, worth)
        what = self.cell, self.robot, self.collision, self.payload_box
        found = confirm_plan(*what, legs, back, self.torques)
        if target is not None:
            legs = add_ways_home(*what, legs, back, self.torques, planner=self.planner, seed=self.seed)
        return legs, back, timing, found

    def way_home(self, here: Array) -> Transfer:
        """From joint positions `here` (n,) to home, which no other place can stand in for: the longest searches only.

        Raises:
            NoPath: with the reason of the last of them.
        """
        home = np.array(self.cell.robot.home_rad)
        for attempt, search in enumerate(_path_searches(path_iterations(self.effort)[len(PATH_ITERATIONS) - 1 :])):
            try:
                return self._transfer(here, home, *search, seed=self.seed + 101 * attempt)
            except NoPath as error:
                failure = error
        raise failure

    def reach(self, group: tuple[Stop, ...], here: Array, before: Sequence[Leg]) -> Generator[Event, None, list[Leg]]:
        """Stops that can be reached from joint positions `here`, and leave room for what is done there; others where these cannot.

        A rotation that the stop does not say how often to repeat is made once.

        Args:
            before: the legs up to there: a wave that is for planning to choose tells what these leave open.
        """
        for attempt, (iterations, spare_m) in enumerate(_path_searches(path_iterations(self.effort))):
            starts = yield from self._find(group, here, self.seed + 101 * attempt)
            try:
                return (yield from self._connect(group, starts, here, iterations, spare_m, before))
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
        if swings is None or leg.start.rotation is None or not leg.stop.repeats_as_needed:
            return leg
        k = "xyz".index(swings.about)
        once = leg.start.rotation
        repetitions = repetitions_for(
            once,
            torque_std=self.cell.sensor.noise_std[3 + k],
            inertia_std=inertia_std * predict_inertia(self.payload_box, mass_guess_kg, k),
            budget=max(budget, once.duration),
        )
        return replace(leg, profile=once.repeat(repetitions))

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
        rotation = None if stop.swings is None else self._profile(stop.swings.excursion_rad)
        smaller: tuple[AngularProfile, ...] = ()
        if rotation is not None and stop.repeats_as_needed:
            smaller = tuple(self._profile(share * float(rotation.angle.max())) for share in SMALLER_SWINGS)
        attitude = Attitude(stop.label, np.array(stop.down), np.eye(3)["xyz".index(about)], rotation, smaller)
        grid = Grid(rounds=grid_rounds(self.effort))
        found = find_start_configuration(
            self.cell, self.robot, self.collision, attitude, seed=seed, near=near, grid=grid, torques=self.torques
        )
        return replace(found, about="" if stop.swings is None else about)

    def _connect(
        self,
        group: tuple[Stop, ...],
        starts: list[StartConfiguration],
        here: Array,
        iterations: int,
        spare_m: float,
        before: Sequence[Leg],
    ) -> Generator[Event, None, list[Leg]]:
        """Transfers from one stop to the next, and what is done at their ends."""
        legs: list[Leg] = []
        for stop, start in zip(group, starts, strict=True):
            goals = one_turn_away(self.robot, start.q, here)
            transfer = self._transfer(here, goals, iterations, spare_m, seed=self.seed)
            legs.append(self._make_leg(stop, replace(start, q=transfer.goal), transfer, [*before, *legs]))
            yield TransferPlanned(axis=stop.label, robot_s=transfer.trajectory.duration, least_margin_m=transfer.least_margin_m)
            here = transfer.goal
        return legs

    def _transfer(self, here: Array, goals: Array, iterations: int, spare_m: float, *, seed: int) -> Transfer:
        return plan_transfer(
            self.cell,
            self.robot,
            self.collision,
            here,
            goals,
            period=self.period,
            planner=self.planner,
            seed=seed,
            iterations=iterations,
            torques=self.torques,
            spare_m=spare_m,
        )

    def _make_leg(self, stop: Stop, start: StartConfiguration, transfer: Transfer, before: Sequence[Leg]) -> Leg:
        if stop.swings is not None and start.rotation is not None:
            return Leg(stop, start, transfer, profile=start.rotation.repeat(stop.swings.repetitions or 1))
        if stop.wave is not None and stop.wave.wrist is None:
            made = [*(each for leg in before for each in leg.trajectories), transfer.trajectory]
            load = self.torques.load.parameters
            chosen, wave = choose_wave(self.cell, self.robot, self.collision, load, start.q, stop.wave, made)
            return Leg(stop.model_copy(update={"wave": chosen}), start, transfer, wave=wave)
        if stop.wave is not None:
            shape = wave_shape(stop.wave, self.robot.n, self.period)
            return Leg(stop, start, transfer, wave=fit_wave(self.cell, self.robot, self.collision, start.q, shape, self.period))
        return Leg(stop, start, transfer)

    def _profile(self, excursion_rad: float) -> AngularProfile:
        """A rotation out and back once, that far at most."""
        return decoupling_profile(
            widest_box(self.cell, self.payload_box),
            cartesian_speed=self.cell.limits.cartesian_speed_m_s,
            period=self.period,
            excursion=excursion_rad,
        )
