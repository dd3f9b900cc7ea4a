"""Random cells through planning and simulated motion, judged by an independent checker; what was refused goes through a brute-force search.

    python -m bench.random_cells [--count N] [--first N] [--processes N]

Counts violations (none is allowed), cells solved of those that can be solved, refusals whose reason the brute-force search confirms, and
the seconds of planning.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass, field
from multiprocessing import get_context

import numpy as np

from bench.brute_force import CANDIDATES, BruteForce
from core.array import Array
from core.cell.cell import Cell
from core.errors import NoStartConfiguration, Refused
from core.events import Event, RobotStopped, StartConfigurationFound, drive
from core.payload.inertia import InertialParameters
from core.planning.plan import Plan
from core.planning.search import plan_stops
from core.planning.stops import PROCEDURE
from core.procedure.record import record
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.trajectory import JointTrajectory
from core.sessions.session import RobotState
from core.sessions.simulated import SimulatedSession
from tests.independent_checker import IndependentChecker
from tests.random_cells import RandomCell, random_cell

ALIGNED_RAD = 1e-3


@dataclass(frozen=True)
class Judgement:
    """What became of one cell.

    Args:
        refusal: the engine's sentence, empty where the cell was solved.
        solvable: whether it was solved or the brute-force search says that it could be.
        confirmed: whether the brute-force search found nothing either where the refusal was.
        planning_s, robot_s: of the planner and of the plan (0 where refused).
        least_margin_m: of all transfers, by the checker.
    """

    seed: int
    refusal: str = ""
    solvable: bool = True
    confirmed: bool = True
    planning_s: float = 0.0
    robot_s: float = 0.0
    least_margin_m: float = np.inf
    violations: tuple[str, ...] = field(default=())

    @property
    def line(self) -> str:
        """For the screen."""
        if self.refusal:
            what = ("solvable! " if self.solvable else "") + ("" if self.confirmed else "wrong reason! ") + self.refusal
        else:
            what = f"robot {self.robot_s:.1f} s, least margin {1000 * self.least_margin_m:.1f} mm"
        return " ".join([f"{self.seed:4d}", f"planned {self.planning_s:5.1f} s", what, *(f"VIOLATION {v}" for v in self.violations)])


def judge(seed: int) -> Judgement:
    """Plans one random cell and has the outcome checked."""
    drawn = random_cell(seed)
    robot = RobotModel.of_cell(drawn.cell)
    collision = CollisionModel(drawn.cell, robot, drawn.payload_box)
    home = np.array(drawn.cell.robot.home_rad)
    mass = drawn.cell.payloads["random"].mass_kg
    planning = plan_stops(drawn.cell, robot, collision, drawn.payload_box, PROCEDURE.stops, start=home, mass_guess_kg=mass, seed=seed)
    began = time.perf_counter()
    axis = PROCEDURE.labels[0]

    def note_axis(event: Event) -> None:
        nonlocal axis
        if isinstance(event, StartConfigurationFound):
            axis = event.axis

    try:
        plan = drive(planning, note_axis)
    except Refused as refusal:
        blamed = (refusal.axis,) if isinstance(refusal, NoStartConfiguration) else (f"{axis[0]}-", f"{axis[0]}+")
        return judge_refusal(drawn, f"{', '.join(blamed)}: {refusal}", blamed, time.perf_counter() - began)
    return judge_plan(drawn, plan, time.perf_counter() - began)


def judge_plan(drawn: RandomCell, plan: Plan, planning_s: float) -> Judgement:
    """Checks every commanded sample of every transfer, that they join, and that the sensor axes lie as they should."""
    checker = IndependentChecker(drawn.cell, drawn.payload_box)
    violations: list[str] = []
    least = np.inf
    here = np.array(drawn.cell.robot.home_rad)
    for name, trajectory in legs(plan):
        if not np.allclose(trajectory.q[0], here, atol=1e-12):
            violations.append(f"{name}: starts {np.abs(trajectory.q[0] - here).max():.2e} rad from where the robot is")
        findings = checker.check(trajectory.q, trajectory.period)
        violations += [f"{name}: {violation}" for violation in findings.violations]
        least = min(least, findings.least_margin_m)
        here = trajectory.q[-1]
    down = drawn.cell.gravity / np.linalg.norm(drawn.cell.gravity)
    for leg in plan.legs:
        direction = checker.axis_direction(leg.start.q, "xyz".index(leg.axis[0])) * (1.0 if leg.axis[1] == "+" else -1.0)
        if np.linalg.norm(direction - down) > ALIGNED_RAD:
            violations.append(f"{leg.axis}: sensor axis {np.linalg.norm(direction - down):.2e} rad from gravity")
    violations += simulated(drawn, plan, checker)
    return Judgement(drawn.seed, planning_s=planning_s, robot_s=plan.robot_s, least_margin_m=float(least), violations=tuple(violations))


class Witness(SimulatedSession):
    """The virtual robot with its true joint positions written down, ms by ms."""

    def __init__(self, cell: Cell, payload: InertialParameters, seed: int) -> None:
        super().__init__(cell, payload, seed=seed)
        self.true_q: list[Array] = []

    def state(self) -> RobotState:
        """See `RobotSession.state`."""
        state = super().state()
        self.true_q.append(self.plant.truth.q.copy())
        return state


def simulated(drawn: RandomCell, plan: Plan, checker: IndependentChecker) -> list[str]:
    """Violations of the whole run on the virtual robot: of what was commanded, and of where the arm truly was."""
    carried = drawn.cell.payloads["random"].parameters
    session = Witness(drawn.cell, carried, drawn.seed)
    violations: list[str] = []

    def note_stop(event: Event) -> None:
        if isinstance(event, RobotStopped):
            violations.append(f"stopped by the guard: {event.message}")

    commanded = drive(record(drawn.cell, session, drawn.payload_box, plan, seed=drawn.seed), note_stop).q_cmd
    assert commanded is not None
    violations += [f"commanded: {violation}" for violation in checker.check(commanded, session.period).violations]
    true = checker.check(np.array(session.true_q), session.period)
    places = [f"{pair} {-1000 * margin:.3f} mm closer than allowed" for margin, pair in true.margins_m.values() if margin < 0.0]
    fast = [f"a corner moves at {true.speed_m_s:.4f} m/s"] if true.speed_m_s > true.speed_limit_m_s else []
    return violations + [f"simulated: {violation}" for violation in places + fast]


def judge_refusal(drawn: RandomCell, refusal: str, blamed: tuple[str, ...], planning_s: float, candidates: int = CANDIDATES) -> Judgement:
    """Asks the brute-force search whether the cell could have been solved, and whether the axis of the refusal is to blame."""
    search = BruteForce(drawn.cell, drawn.payload_box, candidates=candidates, seed=drawn.seed)
    confirmed = not all(search.answer(axis).reachable for axis in blamed)
    solvable = not confirmed and all(answer.reachable for answer in search.answers())
    return Judgement(drawn.seed, refusal, solvable, confirmed, planning_s)


def legs(plan: Plan) -> Iterator[tuple[str, JointTrajectory]]:
    """The transfers of a plan in order, with names."""
    for leg in plan.legs:
        yield f"to {leg.axis}", leg.transfer.trajectory
    yield "home", plan.home.trajectory


def summary(judgements: list[Judgement]) -> str:
    """The figures of the README."""
    solved = [j for j in judgements if not j.refusal]
    solvable = [j for j in judgements if j.solvable]
    refused = [j for j in judgements if j.refusal]
    seconds = np.array([j.planning_s for j in judgements])
    robot_s = [j.robot_s for j in solved] or [np.nan]
    margins = [j.least_margin_m for j in solved] or [np.nan]
    return "\n".join(
        [
            f"violations              {sum(len(j.violations) for j in judgements)} in {len(solved)} solved cells",
            f"solved / solvable       {len(solved)} / {len(solvable)} = {len(solved) / max(len(solvable), 1):.1%}",
            f"refused, reason held    {sum(j.confirmed for j in refused)} / {len(refused)}",
            f"planning, s             median {np.median(seconds):.1f}, 95 % {np.percentile(seconds, 95):.1f}, worst {seconds.max():.1f}",
            f"robot time, s           median {np.median(robot_s):.1f}, worst {np.max(robot_s):.1f}",
            f"least margin, mm        {1000 * np.min(margins):.2f}",
        ]
    )


def main() -> None:
    """Runs the bench."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--processes", type=int, default=2)
    options = parser.parse_args()
    judgements: list[Judgement] = []
    with ProcessPoolExecutor(options.processes, mp_context=get_context("spawn")) as pool:
        seeds = range(options.first, options.first + options.count)
        for done in as_completed([pool.submit(judge, seed) for seed in seeds]):
            judgements.append(done.result())
            print(f"[{len(judgements)}/{options.count}] {judgements[-1].line}", flush=True)
    print(summary(judgements))


if __name__ == "__main__":
    main()
