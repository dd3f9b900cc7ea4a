"""Identification on arms that swing on their gears, as every arm does: MuJoCo's springs in every joint, on both cells.

python -m bench.swinging_arms [--count N] [--processes N]

Prints the error of the mass, how many of the ten parameters lie outside their 95 % intervals, and the softest gear.
"""

from __future__ import annotations

import argparse
from concurrent.futures import ProcessPoolExecutor
from functools import cache

import numpy as np
from threadpoolctl import threadpool_limits

from bench.conditions import INTERVAL
from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.estimation.identification import identify_recording
from core.events import drive
from core.planning.plan import Plan
from core.plant.faults.joint_springs import ElasticJoints
from core.plant.mechanics import Drives
from core.procedure.record import record
from core.sessions.simulated import SimulatedSession
from core.trial import plan_each_payload
from core.trial.draw import CELLS

SOFTEST, STIFFEST = 22e3, 60e3
"""N m/rad."""


@cache
def planned(name: str) -> tuple[Cell, dict[str, Plan]]:
    """A cell, and a plan for each payload; once in a process."""
    return load_cell(find_cell(name)), plan_each_payload(name)[1]


def run(seed: int) -> tuple[str, float, int, float]:
    """Cell and payload, error of the mass as a share of it, parameters outside their intervals, softest gear in N m/rad."""
    rng = np.random.default_rng(seed)
    name = str(rng.choice(CELLS))
    cell, plans = planned(name)
    payload = str(rng.choice(sorted(plans)))
    springs = np.exp(rng.uniform(np.log(SOFTEST), np.log(STIFFEST), len(cell.robot.home_rad)))
    carried = cell.payloads[payload]
    faults, smooth = (ElasticJoints(tuple(springs.tolist())),), Drives(damping_s=0.0, friction=0.0)
    session = SimulatedSession(cell, carried.parameters, seed=seed, faults=faults, drives=smooth)
    with threadpool_limits(1):
        found = identify_recording(drive(record(cell, session, carried.box, plans[payload], payload=payload))).estimate
    if found is None:
        raise RuntimeError(f"seed {seed}: nothing identified")
    away = np.abs(found.phi - carried.parameters.phi) / found.std
    outside = int((away > INTERVAL).sum())  # what is not determined has no interval
    return f"{name} {payload}", float(found.phi[0] / carried.parameters.mass - 1.0), outside, float(springs.min())


def main() -> None:
    """Counts."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--processes", type=int)
    given = parser.parse_args()
    errors, outside = [], 0
    with ProcessPoolExecutor(given.processes) as pool:
        for seed, (what, error, beyond, softest) in enumerate(pool.map(run, range(given.count))):
            errors.append(abs(error))
            outside += beyond
            print(f"{seed:3d} {what:24s} mass {100 * error:+.3f} %, {beyond} outside, softest {softest / 1e3:.0f} kN m/rad", flush=True)
    percent = 100.0 * np.array([np.median(errors), max(errors)])
    print(f"mass off by {percent[0]:.3f} % in the median, {percent[1]:.3f} % at most; {outside} of {10 * given.count} outside")


if __name__ == "__main__":
    main()
