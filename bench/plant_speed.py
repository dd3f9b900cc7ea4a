"""How many times faster than real time the virtual robot runs, and what share of a tick is MuJoCo's own step.

Both are measured in turn in one process, in blocks of one simulated second; printed are medians over the blocks.
"""

from __future__ import annotations

import time
from pathlib import Path
from statistics import median

import mujoco
import numpy as np

from core.cell.folder import load_cell
from core.plant.arm import arm_of_cell
from core.plant.mechanics import PERIOD, Drives, build_model
from core.sessions.simulated import SimulatedSession

CELLS = Path(__file__).parents[1] / "cells"
BLOCK = round(1.0 / PERIOD)


def measure(cell_name: str, blocks: int = 8) -> None:
    """Prints one line for a cell."""
    cell = load_cell(CELLS / cell_name)
    payload = cell.payloads["steel_block"].parameters
    bare = build_model(arm_of_cell(cell), payload, cell.gravity, Drives())
    data = mujoco.MjData(bare)
    swing = 0.2 * (1 - np.cos(2 * np.pi * np.arange(1, BLOCK + 1) / BLOCK))
    session_us, step_us = [], []
    with SimulatedSession(cell, payload, seed=0) as session:
        home = session.state().q_cmd
        path = home + np.outer(swing, np.where(home > 0, -1.0, 1.0))
        for _ in range(blocks):
            start = time.perf_counter()
            for q in path:
                session.command(q)
                session.state()
            middle = time.perf_counter()
            for _ in range(BLOCK):
                mujoco.mj_step(bare, data)
            end = time.perf_counter()
            session_us.append((middle - start) / BLOCK * 1e6)
            step_us.append((end - middle) / BLOCK * 1e6)
    tick, step = median(session_us), median(step_us)
    print(
        f"{cell_name:12s} {PERIOD * 1e6 / tick:5.1f} x real time ({tick:.1f} us per 1 ms tick, "
        f"command and state; bare mj_step {step:.1f} us, ratio {tick / step:.1f})"
    )


if __name__ == "__main__":
    for folder in sorted(CELLS.iterdir()):
        measure(folder.name)
