"""How long the search of start configurations takes, against as many bare distance queries.

10 000 candidates are configurations for which the inverse kinematics has been solved (failed attempts count as time, not as candidates)
and Eq. (6) evaluated with the exact distance. Beside them `pin.computeDistances` alone, on the same configurations, in turn in one process:
with all pairs of the cell, as the guard needs them, and with those of Eq. (6) alone, robot and payload against obstacles and zones.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from statistics import median

import numpy as np
import pinocchio as pin

from core.array import Array
from core.cell.folder import load_cell
from core.planning.candidates import CandidateSearch, Weights
from core.planning.grid import draw_postures, first_grid
from core.planning.start_configuration import LIMIT_MARGIN_RAD
from core.robot.collision import Body, CollisionModel
from core.robot.model import RobotModel

CELLS = Path(__file__).parents[1] / "cells"
CANDIDATES = 10_000
REPETITIONS = 3


def search(robot: RobotModel, collision: CollisionModel, vertices: int) -> Array:
    """Joint positions of all candidates of one grid with sensor axis x along gravity; the best is found, nothing else is checked of it."""
    home = np.array(collision.cell.robot.home_rad)
    limits = robot.lower + LIMIT_MARGIN_RAD, robot.upper - LIMIT_MARGIN_RAD
    axis, down = np.array([1.0, 0.0, 0.0]), collision.cell.gravity / np.linalg.norm(collision.cell.gravity)
    rng = np.random.default_rng(0)
    postures = draw_postures(robot, rng, 20_000, limits=limits, near=home, axis=axis, gravity=down)
    evaluation = CandidateSearch(
        collision.cell, robot, collision, limits=limits, near=home, diameter=2.0 * float(collision.reach[0]), weights=Weights()
    )
    candidates = evaluation.at(first_grid(postures, vertices)[0], postures, 10)
    next(candidates.rank(), None)
    return candidates.q


def bare_queries(robot: RobotModel, pairs: list[tuple[Body, Body]], q: Array) -> None:
    """`pin.computeDistances` and nothing else."""
    geometry, ids = pin.GeometryModel(), {}
    for pair in pairs:
        for body in pair:
            if id(body) not in ids:
                thing = pin.GeometryObject(str(id(body)), body.joint, body.placement, body.geometry)
                ids[id(body)] = geometry.addGeometryObject(thing)
        geometry.addCollisionPair(pin.CollisionPair(*[ids[id(body)] for body in pair]))
    data, results = robot.model.createData(), geometry.createData()
    for row in q:
        pin.computeDistances(robot.model, data, geometry, results, row)


def seconds(action: Callable[[], object]) -> float:
    """Wall-clock time of one call."""
    start = time.perf_counter()
    action()
    return time.perf_counter() - start


def measure(cell_name: str) -> None:
    """Prints one line for a cell."""
    cell = load_cell(CELLS / cell_name)
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, cell.payload_box)
    vertices = round(200 * CANDIDATES / len(search(robot, collision, 200)))
    q = search(robot, collision, vertices)
    environment, links = collision.pairs
    times = np.array(
        [
            (
                seconds(lambda: search(robot, collision, vertices)),
                seconds(lambda: bare_queries(robot, environment + links, q)),
                seconds(lambda: bare_queries(robot, environment, q)),
            )
            for _ in range(REPETITIONS)
        ]
    )
    searching, bare, bare_environment = (median(column) for column in times.T)
    print(
        f"{cell_name:12s} {len(q)} candidates: search {searching:.2f} s, bare distances {bare:.2f} s ({len(environment + links)} pairs), "
        f"ratio {searching / bare:.2f}; to obstacles and zones alone {bare_environment:.2f} s ({len(environment)} pairs), "
        f"ratio {searching / bare_environment:.2f}"
    )


if __name__ == "__main__":
    for name in ("lwr4_bench", "ur5e_line"):
        measure(name)
