"""Random cells of robots as they come, planned and judged by the independent checker; what is refused goes through an independent search.

    python -m bench.real_robots [--count N] [--seed N] [--robots NAME,...] [--processes N] [--candidates N] [--results FILE]

Prints one line for each cell, then violations (none is allowed), the share solved of what can be solved (at least 95 %), and the seconds of
planning (median at most 5, 95 % at most 15). Each cell is told by its robot and its number: `--robots NAME --seed N --count 1` repeats it.
300 cells take hours: with a file for the results those that stand in it are not judged again, and the bench goes on where it was stopped.
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import asdict, dataclass
from multiprocessing import get_context
from pathlib import Path

import numpy as np

from bench.independent_search import CANDIDATES, IndependentSearch
from core.array import Array
from core.cell.cell import Cell
from core.cell.folder import check_robot
from core.cell.urdf import check_urdf
from core.errors import BadInput, Refused
from core.events import drive
from core.planning.commanded_path import PlanPart, compute_joint_paths
from core.planning.joint_torques import find_known_load
from core.planning.plan import Plan
from core.planning.search import plan_stops
from core.planning.stops import PROCEDURE
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from tests.independent_checker import IndependentChecker
from tests.random_cells import ARMS, random_cell
from tests.real_robots import ROBOTS, random_real_cell

SOLVED_SHARE = 0.95
MEDIAN_S, P95_S = 5.0, 15.0
_HOLD = 3  # samples that say that the arm stands still


@dataclass(frozen=True)
class Judgement:
    """What became of one cell.

    Args:
        refusal: the engine's sentence, empty where a plan was made.
        solvable: a plan was made, or the independent search says that one could be; only of the poses where it gave up.
        violations: of the plan, one sentence each.
        least_margin_m: of the whole plan.
    """

    robot: str
    seed: int
    planning_s: float = 0.0
    refusal: str = ""
    solvable: bool = True
    violations: tuple[str, ...] = ()
    least_margin_m: float = np.inf

    @property
    def line(self) -> str:
        """For the screen."""
        said = f"least margin {1000 * self.least_margin_m:.1f} mm"
        if self.refusal:
            said = ("SOLVABLE, " if self.solvable else "") + f"refused: {self.refusal[:200]}"
        return "; ".join([f"{self.robot} {self.seed}: {self.planning_s:.1f} s, {said}", *(f"VIOLATION {v}" for v in self.violations)])


def cell_of(robot: str, seed: int, folder: Path) -> Cell:
    """The random cell of that robot and number; `payload_box` and `payloads["random"]` are what it carries."""
    if robot in ARMS:
        return random_cell(2 * seed + ARMS.index(robot)).cell
    return random_real_cell(robot, seed, folder)


def judge(robot: str, seed: int, candidates: int = CANDIDATES) -> Judgement:
    """Plans one cell and has the outcome checked."""
    with tempfile.TemporaryDirectory() as folder:
        cell = cell_of(robot, seed, Path(folder))
        began = time.perf_counter()
        try:
            plan, violations, least = _planned(cell, seed)
        except (BadInput, Refused) as error:
            seconds = time.perf_counter() - began
            search = IndependentSearch(cell, cell.payload_box, cell.payloads["random"], candidates=candidates, seed=seed)
            solvable = all(answer.reachable for answer in search.answers())
            return Judgement(robot, seed, seconds, f"{type(error).__name__}: {error}", solvable)
        return Judgement(robot, seed, plan.plan_s, violations=tuple(violations), least_margin_m=least)


def _planned(cell: Cell, seed: int) -> tuple[Plan, list[str], float]:
    check_robot(cell, check_urdf(cell.urdf, "robot.urdf"))
    model = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, model, cell.payload_box)
    home, load = np.array(cell.robot.home_rad), find_known_load(cell, "random")
    plan = drive(plan_stops(cell, model, collision, cell.payload_box, PROCEDURE.stops, start=home, load=load, seed=seed))
    checker = IndependentChecker(cell, cell.payload_box, cell.payloads["random"])
    violations, least = [], np.inf
    here = home
    for name, q in set_points(cell, model, collision, plan):
        if np.abs(q[0] - here).max() > 1e-9:
            violations.append(f"{name}: starts {np.abs(q[0] - here).max():.2e} rad from where the robot is")
        findings = checker.check(q, plan.home.trajectory.period)
        violations += [f"{name}: {violation}" for violation in findings.violations]
        least, here = min(least, findings.least_margin_m), q[-1]
    return plan, violations, least


def set_points(cell: Cell, robot: RobotModel, collision: CollisionModel, plan: Plan) -> Iterator[tuple[str, Array]]:
    """Every set point (N, n) of a plan, motion by motion: transfers, holds, rotations, waves, and the way home."""
    motions: list[PlanPart] = []
    for leg in plan.legs:
        motions.append(PlanPart(f"transfer {leg.axis}", leg.transfer.trajectory))
        motions += [] if leg.profile is None else [PlanPart(f"rotation {leg.about}", leg.profile, leg.about)]
        motions += [] if leg.wave is None else [PlanPart(f"wave {leg.axis}", leg.wave)]
    motions.append(PlanPart("home", plan.home.trajectory))
    for path in compute_joint_paths(cell, robot, collision, motions, motions[0].along.q[0]):  # type: ignore[union-attr]  # a transfer
        yield path.name, path.q
        yield f"hold after {path.name}", np.tile(path.q[-1], (_HOLD, 1))


def summary(judgements: list[Judgement]) -> str:
    """The figures, in lines."""
    solved = [j for j in judgements if not j.refusal]
    solvable = [j for j in judgements if j.solvable]
    seconds = np.array([j.planning_s for j in judgements])
    kinds = Counter((j.robot, j.refusal.split(":")[0]) for j in judgements if j.refusal)
    return "\n".join(
        [
            f"violations         {sum(len(j.violations) for j in judgements)} in {len(solved)} plans (0 allowed)",
            f"solved / solvable  {len(solved)} / {len(solvable)} = {len(solved) / max(len(solvable), 1):.1%} (at least {SOLVED_SHARE:.0%})",
            f"planning, median   {np.median(seconds):.1f} s (at most {MEDIAN_S:g})",
            f"planning, 95 %     {np.percentile(seconds, 95):.1f} s (at most {P95_S:g})",
            *(f"refused            {robot}: {kind} {count}" for (robot, kind), count in sorted(kinds.items())),
        ]
    )


def main() -> None:
    """Runs the bench."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=30)
    parser.add_argument("--seed", type=int, default=0, help="number of the first cell")
    parser.add_argument("--robots", default=",".join([*ROBOTS, *ARMS]))
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--candidates", type=int, default=CANDIDATES, help="of the independent search, per pose")
    parser.add_argument("--results", type=Path, help="JSON lines, one for each cell; goes on behind what is there")
    options = parser.parse_args()
    names = options.robots.split(",")
    jobs = [(names[k % len(names)], options.seed + k // len(names)) for k in range(options.count)]
    judged = {(j.robot, j.seed): j for j in read(options.results)}
    judgements = [judged[job] for job in jobs if job in judged]
    with ProcessPoolExecutor(options.processes, mp_context=get_context("spawn")) as pool:
        for done in as_completed([pool.submit(judge, *job, options.candidates) for job in jobs if job not in judged]):
            judgements.append(done.result())
            keep(options.results, judgements[-1])
            print(f"[{len(judgements)}/{options.count}] {judgements[-1].line}", flush=True)
    print(summary(judgements))


def read(results: Path | None) -> list[Judgement]:
    """What a bench that was stopped has judged."""
    if results is None or not results.exists():
        return []
    return [Judgement(**found | {"violations": tuple(found["violations"])}) for found in map(json.loads, results.read_text().splitlines())]


def keep(results: Path | None, judgement: Judgement) -> None:
    """Adds what became of one cell."""
    if results is not None:
        with results.open("a") as file:
            file.write(json.dumps(asdict(judgement)) + "\n")


if __name__ == "__main__":
    main()
