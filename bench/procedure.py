"""The whole procedure on the virtual robot over many seeds: the errors of Table 1, without and with imperfections unknown to the estimator.

python -m bench.procedure [--seeds 20] [--cell lwr4_bench]
"""

from __future__ import annotations

import argparse
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.events import drive
from core.payload.inertia import PHI_NAMES
from core.planning.plan import Plan
from core.planning.search import plan_stops
from core.planning.stops import PROCEDURE
from core.plant.imperfections import ExponentialOffsetDrift, Imperfections, LinearOffsetDrift
from core.procedure.identify import carry_out
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.sessions.simulated import SimulatedSession

TARGETS = {"as in Table 2": (0.03, 0.1, 1.0, 1.0), "tilt, delay and drift": (0.1, 0.5, 4.0, 4.0)}
"""Median errors to reach, per cent: mass; first moment; each of Ixx, Iyy, Izz; products (of the largest moment)."""


@dataclass(frozen=True)
class Job:
    """One run."""

    cell: str
    payload: str
    condition: str
    seed: int


@dataclass(frozen=True)
class Errors:
    """Of one run: per cent of the reference for mass and moments, of the norm for the first moment, of the largest moment for products."""

    job: Job
    ours: Array
    paper: Array
    covered: NDArray[np.bool_]
    plan_s: float
    robot_s: float


def planted(condition: str, seed: int) -> Imperfections:
    """Nothing; or 0.5 deg of tilt in some direction, 4 ms of delay, 0.3 N of drift over the run, linear or exponential in turn."""
    if condition == "as in Table 2":
        return Imperfections()
    rng = np.random.default_rng(1000 + seed)
    direction = rng.uniform(0, 2 * np.pi)
    x, y, z = 0.3 * rng.choice([-1.0, 1.0], 3)
    size = (x, y, z, 0.0, 0.0, 0.0)
    drift = LinearOffsetDrift(size, duration_s=60.0) if seed % 2 else ExponentialOffsetDrift(size, time_constant_s=20.0)
    tilt = np.radians(0.5) * np.array([np.cos(direction), np.sin(direction)])
    return Imperfections(base_tilt_rad=(float(tilt[0]), float(tilt[1])), wrench_delay_s=0.004, offset_drift=(drift,))


@cache
def planned(name: str, payload: str) -> tuple[Cell, Plan]:
    """The plan that all seeds of a payload share."""
    cell = load_cell(find_cell(name))
    robot = RobotModel.of_cell(cell)
    box = cell.payloads[payload].box
    home = np.array(cell.robot.home_rad)
    return cell, drive(plan_stops(cell, robot, CollisionModel(cell, robot, box), box, PROCEDURE.stops, start=home))


def run(job: Job) -> Errors:
    """One run on the virtual robot."""
    cell, plan = planned(job.cell, job.payload)
    carried = cell.payloads[job.payload]
    session = SimulatedSession(cell, carried.parameters, seed=job.seed, imperfections=planted(job.condition, job.seed))
    outcome = drive(carry_out(cell, session, carried.box, plan))
    estimate, truth = outcome.identification.estimate, carried.parameters.phi
    if estimate is None:
        raise RuntimeError(f"{job}: {outcome.identification.verdict}")
    covered = np.abs(estimate.phi - truth) <= 1.96 * estimate.repeatability.std
    return Errors(job, errors(estimate.phi, truth), errors(outcome.identification.paper.phi, truth), covered, plan.plan_s, outcome.robot_s)


def errors(phi: Array, truth: Array) -> Array:
    """(6,): mass, first moment, Ixx, Iyy, Izz, worst product; per cent."""
    moments = truth[[4, 7, 9]]
    first = np.linalg.norm(phi[1:4] - truth[1:4]) / np.linalg.norm(truth[1:4])
    products = np.abs(phi[[5, 6, 8]] - truth[[5, 6, 8]]).max() / moments.max()
    return 100 * np.concatenate(([abs(phi[0] / truth[0] - 1), first], np.abs(phi[[4, 7, 9]] / moments - 1), [products]))


def main() -> None:
    """Prints the median errors."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--cell", default="lwr4_bench")
    arguments = parser.parse_args()
    jobs = [
        Job(arguments.cell, payload, condition, seed)
        for condition in TARGETS
        for payload in ("steel_block", "cylinder")
        for seed in range(arguments.seeds)
    ]
    with ProcessPoolExecutor(2) as pool:
        results = list(pool.map(run, jobs))
    header = ("mass", "first moment", "Ixx", "Iyy", "Izz", "products")
    print(f"{'median error, %':44}" + "".join(f"{name:>14}" for name in header))
    for condition, (mass, first, moment, product) in TARGETS.items():
        for payload in ("steel_block", "cylinder"):
            chosen = [r for r in results if (r.job.condition, r.job.payload) == (condition, payload)]
            for who in ("ours", "paper"):
                median = np.median([getattr(r, who) for r in chosen], axis=0)
                print(f"{payload}, {condition}, {who:8}".ljust(44) + "".join(f"{v:14.4f}" for v in median))
        print(f"{'wanted':44}" + "".join(f"{v:14.2f}" for v in (mass, first, moment, moment, moment, product)))
    covered = np.mean([r.covered for r in results], axis=0)
    print("95 % intervals that contain the truth: " + ", ".join(f"{n} {c:.2f}" for n, c in zip(PHI_NAMES, covered, strict=True)))
    print(f"planning {max(r.plan_s for r in results):.1f} s at most, robot time {max(r.robot_s for r in results):.0f} s at most")


if __name__ == "__main__":
    main()
