"""Runs of the virtual robot for diagnoses: no more is planned, moved or estimated than a recording needs, and each once in a process."""

from __future__ import annotations

from functools import cache

import numpy as np

from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.events import drive
from core.planning.plan import Plan
from core.planning.search import plan_stops
from core.planning.settings import Timing
from core.planning.stops import Stops
from core.plant.faults import Setting, variants
from core.plant.imperfections import Imperfections
from core.plant.mechanics import Drives
from core.procedure.record import record
from core.recording.recording import Recording
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.sessions.simulated import SimulatedSession

STOPS = Stops.of_procedure(timing=Timing(robot_s=45.0))
"""Two thirds of the robot time that it takes by itself."""


@cache
def plan_of(name: str, payload: str) -> tuple[Cell, Plan]:
    """A cell of the product, and a plan of the procedure with that payload in it."""
    cell = load_cell(find_cell(name))
    robot, box = RobotModel.of_cell(cell), cell.payloads[payload].box
    home = np.array(cell.robot.home_rad)
    planning = plan_stops(cell, robot, CollisionModel(cell, robot, box), box, STOPS.stops, start=home, timing=STOPS.timing)
    return cell, drive(planning)


@cache
def recorded(
    name: str = "lwr4_bench", *, seed: int = 4, tilt_rad: float = 0.0, delay_s: float = 0.0, drives: Drives | None = None, magnet: float = 0
) -> Recording:
    """The cylinder's run on the default robot, or on one with a tilted base, a late wrench or other drives, or past a magnet.

    Args:
        magnet: its size; no effect describes it.
    """
    cell, plan = plan_of(name, "cylinder")
    carried = cell.payloads["cylinder"].parameters
    field = next(fault for fault in variants("unknown") if fault.variant == "magnetic_field")
    faults = (field.draw(np.random.default_rng(1), magnet, Setting(cell, carried, plan.robot_s)),) if magnet else ()
    imperfections = Imperfections(base_tilt_rad=(tilt_rad, 0.0), wrench_delay_s=delay_s)
    session = SimulatedSession(cell, carried, seed=seed, drives=drives, imperfections=imperfections, faults=faults)
    return drive(record(cell, session, cell.payloads["cylinder"].box, plan, payload="cylinder"))
