"""How long planning takes over robots as they come, one plan at a time: `python -m bench.planning_time --count 33`.

The random cells are those of `bench.real_robots`, which judges the plans; here nothing is judged. A refusal counts with the time that it
takes to be said.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from pathlib import Path

import numpy as np

from bench.real_robots import MEDIAN_S, P95_S, cell_of
from core.cell.cell import Cell
from core.cell.folder import check_robot
from core.cell.urdf import check_urdf
from core.errors import BadInput, Refused
from core.events import drive
from core.planning.search import plan_stops
from core.planning.stops import PROCEDURE
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from tests.random_cells import ARMS
from tests.real_robots import ROBOTS


def plan(cell: Cell, seed: int) -> str:
    """Plans as `heft plan` does; what came of it."""
    try:
        check_robot(cell, check_urdf(cell.urdf, "robot.urdf"))
        model = RobotModel.of_cell(cell)
        collision = CollisionModel(cell, model, cell.payload_box)
        home, mass = np.array(cell.robot.home_rad), cell.payloads["random"].mass_kg
        drive(plan_stops(cell, model, collision, cell.payload_box, PROCEDURE.stops, start=home, mass_guess_kg=mass, seed=seed))
    except (BadInput, Refused) as error:
        return f"refused: {error}"[:150]
    return "planned"


def main() -> None:
    """Prints one line for each cell, then the figures."""
    names = [*ROBOTS, *ARMS]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--count", type=int, default=3 * len(names))
    parser.add_argument("--seed", type=int, default=0, help="number of the first cell")
    options = parser.parse_args()
    seconds = []
    for k in range(options.count):
        robot, seed = names[k % len(names)], options.seed + k // len(names)
        with tempfile.TemporaryDirectory() as folder:
            cell = cell_of(robot, seed, Path(folder))
            began, used = time.perf_counter(), time.process_time()
            said = plan(cell, seed)
        seconds.append(time.perf_counter() - began)
        print(f"{robot} {seed}: {seconds[-1]:.1f} s, {time.process_time() - used:.1f} s of its own; {said}", flush=True)
    median, p95 = np.percentile(seconds, [50, 95])
    print(f"planning, median {median:.1f} s (at most {MEDIAN_S:g}), 95 % {p95:.1f} s (at most {P95_S:g}), most {max(seconds):.1f} s")


if __name__ == "__main__":
    main()
