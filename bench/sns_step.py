"""One step of the control loop's SNS: Jacobian, bounds of Eq. (7), Algorithms 7 and 8; compiled against numpy, both arms, side by side.

    python -m bench.sns_step [--rounds N]

Both versions get the same states, in turns, so that what else the machine does falls on both. Half of the tasks saturate joints.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from core.array import Array
from core.cell.folder import load_cell
from core.control.bounds import JointLimits, velocity_bounds
from core.control.sns import sns_reference
from core.control.sns_kernel import sns_step
from core.robot.model import RobotModel

CELLS = ("lwr4_bench", "ur5e_line")
PERIOD = 0.001
STATES = 60


def states(robot: RobotModel, limits: JointLimits, home: Array, rows: int) -> list[tuple[Array, Array, Array]]:
    """Positions, velocities and tasks near home; a task is what the arm does already plus a change, small or too large for it."""
    rng = np.random.default_rng(0)
    drawn = []
    for k in range(STATES):
        q = np.clip(home + rng.uniform(-0.4, 0.4, robot.n), robot.lower + 0.01, robot.upper - 0.01)
        dq = 0.2 * rng.uniform(-1, 1, robot.n) * limits.velocity
        J = robot.sensor_jacobian(q)[6 - rows :]
        dq = np.linalg.pinv(J) @ (J @ dq)
        change = (0.3 if k % 2 else 1.5) * limits.acceleration * PERIOD * rng.uniform(-1, 1, robot.n)
        drawn.append((q, dq, J @ (dq + change)))
    return drawn


def numpy_step(robot: RobotModel, limits: JointLimits, q: Array, dq: Array, x: Array) -> object:
    """The same step with the paper's SNS in numpy; Jacobian and bounds are the compiled ones here too."""
    return sns_reference(robot.sensor_jacobian(q)[6 - len(x) :], x, *velocity_bounds(q, dq, limits, PERIOD))


def seconds_per_call(step: Callable[[], object]) -> float:
    """Of one call, s."""
    began = time.perf_counter()
    step()
    return time.perf_counter() - began


def compare(name: str, rows: int, rounds: int) -> None:
    """Prints medians and their ratio for one arm and one task dimension."""
    cell = load_cell(Path(__file__).parents[1] / "cells" / name)
    robot = RobotModel.of_cell(cell)
    limits = JointLimits.of(cell, robot)
    drawn = states(robot, limits, np.array(cell.robot.home_rad), rows)
    fast: list[float] = []
    slow: list[float] = []
    scaled = 0
    for k in range(rounds + 1):
        for q, dq, x in drawn:
            slow_s = seconds_per_call(lambda: numpy_step(robot, limits, q, dq, x))  # noqa: B023 - called at once
            fast_s = seconds_per_call(lambda: sns_step(robot.chain, q, dq, x, limits, PERIOD))  # noqa: B023 - the same
            if k > 0:  # the first round compiles
                slow.append(slow_s)
                fast.append(fast_s)
            else:
                scaled += sns_step(robot.chain, q, dq, x, limits, PERIOD).scale < 1.0
    quick, numpy_version = 1e6 * np.median(fast), 1e6 * np.median(slow)
    worst = 1e6 * np.percentile(fast, 99)
    print(
        f"{name:12s} {robot.n:6d} {rows:5d} {scaled:4d}/{STATES} {quick:10.1f} {worst:10.1f} {numpy_version:10.1f} "
        f"{numpy_version / quick:8.1f}x"
    )


def main() -> None:
    """The table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=20, help="how often each of the states is solved (default %(default)s)")
    rounds = parser.parse_args().rounds
    print("cell         joints  rows  scaled  us, median  us, 99 %  numpy, us     ratio   (to reach: <= 25 us, >= 10x)")
    for name in CELLS:
        for rows in (3, 6):
            compare(name, rows, rounds)


if __name__ == "__main__":
    main()
