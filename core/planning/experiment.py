"""The plan of an experiment: its stops, the transfers between them, and what is done at each, from where the robot stands back to home.

The same `Plan` as that of the procedure, so that it is shown, released, guarded and recorded like one.
"""

from __future__ import annotations

import time
from collections.abc import Generator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell
from core.cell.tools import widest_box
from core.errors import NoPath
from core.events import Event, Planned, StartConfigurationFound, TransferPlanned
from core.planning.effort import grid_rounds, path_iterations
from core.planning.joint_torques import JointTorques, Load, guess_load
from core.planning.path import one_turn_away
from core.planning.plan import Leg, Plan
from core.planning.search import check_standing, confirm_plan, way_home
from core.planning.settings import Planner, Timing
from core.planning.start_configuration import Attitude, Grid, StartConfiguration, find_attitude
from core.planning.stop import HOLD_S, Stop, Swings, wave_shape
from core.planning.transfer import plan_transfer
from core.planning.wave import fit_wave
from core.robot.collision import CollisionModel
from core.robot.decoupling import decoupling_profile
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile

MASS_GUESS_KG = 1.0

POSTURES = 4
"""Searches among which the posture farthest from another one is taken."""


def plan_experiment(
    cell: Cell,
    robot: RobotModel,
    collision: CollisionModel,
    payload_box: Box,
    stops: Sequence[Stop],
    *,
    start: Array,
    period: float = 0.001,
    planner: Planner = "rrt_connect",
    seed: int = 0,
    load: Load | None = None,
    effort: int = 1,
) -> Generator[Event, None, Plan]:
    """Plans from joint positions `start` (n,) through all stops back to home.

    Args:
        effort: how much is searched before a plan is refused, see `core.planning.effort`.

    Raises:
        NoStartConfiguration, NoPath: the cell leaves no safe way.
        TooHeavy: the joints have not the torque, with the load or else with a guessed one.
        PlanDisputed: the second opinion does not confirm the plan, or a motion of it cannot be carried out.
    """
    began = time.perf_counter()
    torques = check_standing(cell, robot, collision, start, load or guess_load(cell, payload_box, MASS_GUESS_KG), period)
    search = _Search(cell, robot, collision, payload_box, period, planner, seed, torques, effort)
    legs: list[Leg] = []
    here = start
    for stop in stops:
        legs.append((yield from search.leg(stop, here)))
        here = legs[-1].transfer.goal
    back = way_home(cell, robot, collision, here, period=period, planner=planner, seed=seed, effort=effort)
    yield TransferPlanned(axis="home", robot_s=back.trajectory.duration, least_margin_m=back.least_margin_m)
    found = confirm_plan(cell, robot, collision, payload_box, legs, back, torques)
    plan = Plan(tuple(legs), back, Timing(hold_s=HOLD_S), time.perf_counter() - began, found.opinion, found.torques)
    yield Planned(robot_s=plan.robot_s, plan_s=plan.plan_s, least_margin_m=plan.least_margin_m)
    return plan


@dataclass(frozen=True)
class _Search:
    """Finds each stop together with the way to it."""

    cell: Cell
    robot: RobotModel
    collision: CollisionModel
    payload_box: Box
    period: float
    planner: Planner
    seed: int
    torques: JointTorques
    effort: int

    def leg(self, stop: Stop, here: Array) -> Generator[Event, None, Leg]:
        """A stop that can be reached from joint positions `here`, and left room for its movement; others where one cannot."""
        for attempt, iterations in enumerate(path_iterations(self.effort)):
            seed = self.seed + 101 * attempt
            start = self._start(stop, here, seed)
            yield StartConfigurationFound(
                axis=stop.label,
                clearance_m=start.clearance_m,
                nearest=start.nearest,
                manipulability=start.manipulability,
                candidates=start.candidates,
            )
            try:
                leg = self._connect(stop, start, here, iterations)
            except NoPath as error:
                failure = error
                continue
            transfer = leg.transfer
            yield TransferPlanned(axis=stop.label, robot_s=transfer.trajectory.duration, least_margin_m=transfer.least_margin_m)
            return leg
        raise failure

    def _start(self, stop: Stop, here: Array, seed: int) -> StartConfiguration:
        """Where to stop; where the posture is to be another one, the farthest of several."""
        about = np.eye(3)["xyz".index(stop.swings.about)] if stop.swings else np.eye(3)[0]
        rotation = None if stop.swings is None else self._profile(stop.swings, 1)
        grid = Grid(rounds=grid_rounds(self.effort))
        attitude = Attitude(stop.label, np.array(stop.down), about, rotation)
        if stop.away_from_rad is None:
            return find_attitude(self.cell, self.robot, self.collision, attitude, seed=seed, near=here, grid=grid, torques=self.torques)
        avoided = np.array(stop.away_from_rad)
        found = [
            find_attitude(self.cell, self.robot, self.collision, attitude, seed=seed + k, grid=grid, torques=self.torques)
            for k in range(POSTURES)
        ]
        return max(found, key=lambda start: float(np.abs(start.q - avoided).max()))

    def _connect(self, stop: Stop, start: StartConfiguration, here: Array, iterations: int) -> Leg:
        """The way there, and the movement at its end."""
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
        start = replace(start, q=transfer.goal, about="" if stop.swings is None else stop.swings.about)
        if stop.swings is not None:
            return Leg(stop.label, start, transfer, self._profile(stop.swings, stop.swings.repetitions), stop.swings.about)
        if stop.wave is None:
            return Leg(stop.label, start, transfer)
        shape = wave_shape(stop.wave, self.robot.n, self.period)
        wave = fit_wave(self.cell, self.robot, self.collision, start.q, shape, self.period)
        return Leg(stop.label, start, transfer, wave=wave)

    def _profile(self, swings: Swings, repetitions: int) -> AngularProfile:
        return decoupling_profile(
            widest_box(self.cell, self.payload_box),
            cartesian_speed=self.cell.limits.cartesian_speed_m_s,
            period=self.period,
            repetitions=repetitions,
            excursion=swings.excursion_rad,
        )
