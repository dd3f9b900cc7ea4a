"""Seconds that the second opinion on a finished plan takes, beside the planning of it: `python -m bench.second_opinion`."""

from __future__ import annotations

import argparse
from time import perf_counter

import numpy as np

from core.cell.folder import find_cell, load_cell
from core.events import drive
from core.planning.confirmation import confirm_plan
from core.planning.joint_torques import JointTorques, guess_load
from core.planning.search import plan_stops
from core.planning.stops import PROCEDURE
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel


def main() -> None:
    """Prints the median for each cell, set points included."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=7)
    parser.add_argument("cells", nargs="*", default=["lwr4_bench", "ur5e_line"])
    arguments = parser.parse_args()
    for name in arguments.cells:
        cell = load_cell(find_cell(name))
        robot = RobotModel.of_cell(cell)
        collision = CollisionModel(cell, robot, cell.payload_box)
        torques = JointTorques(cell, robot, guess_load(cell, cell.payload_box, 1.0))
        plan = drive(plan_stops(cell, robot, collision, cell.payload_box, PROCEDURE.stops, start=np.array(cell.robot.home_rad)))
        seconds = []
        for _ in range(arguments.count):
            began = perf_counter()
            opinion = confirm_plan(cell, robot, collision, cell.payload_box, plan.legs, plan.home, torques).opinion
            seconds.append(perf_counter() - began)
        taken = float(np.median(seconds))
        checked = f"{opinion.samples} points checked in {taken:.2f} s (median), {max(seconds):.2f} s at most"
        print(f"{name}: {checked}; planned in {plan.plan_s:.1f} s")


if __name__ == "__main__":
    main()
