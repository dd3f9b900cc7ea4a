"""Offset between the clocks of a sensor and a robot under jitter and loss: `python -m bench.clocks --runs 20`.

Robot, sensor and lines are a generator of their own (`tests.core.sessions.lockstep`) that knows the true times; the session sees stamps and
arrivals alone. Each run draws offsets of up to a day and drifts of up to 100 ppm for both. Printed is by how much a robot's stamp is put
beside a wrench of another moment: the largest in the run from `--settle` seconds on, median and worst over the runs.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from core.array import Array
from core.errors import SensorLate
from core.sessions.external_sensor import ExternalSensorSession
from tests.core.sessions.lockstep import LockstepRobot, LockstepSensor, TrueTime

Jitter = Callable[[np.random.Generator], float]
JITTERS: dict[str, Jitter] = {
    "uniform, 0-20 ms": lambda rng: rng.uniform(0.0, 0.020),
    "exponential, mean 20 ms": lambda rng: rng.exponential(0.020),
    "half a normal one, 20 ms": lambda rng: abs(rng.normal(0.0, 0.020)),
}
LINE_S = 0.0002
"""What the sensor's line takes at least; nobody who only listens can know it, and it counts as an error here."""


def run_once(jitter: Jitter, *, seconds: float, settle: float, rate_hz: float, lost: float, seed: int) -> float:
    """The largest error of the mapping, s."""
    rng = np.random.default_rng(seed)
    offsets, drifts = rng.uniform(-86_400.0, 86_400.0, 2), rng.uniform(-100e-6, 100e-6, 2)
    time = TrueTime()

    def wrench(true_s: float) -> Array:
        return np.full(6, np.sin(true_s))

    robot = LockstepRobot(time, offset_s=offsets[0], drift=drifts[0], jitter_s=0.001, seed=seed)
    sensor = LockstepSensor(
        time, wrench, rate_hz=rate_hz, offset_s=offsets[1], drift=drifts[1], delay_s=LINE_S, jitter=jitter, lost=lost, seed=seed + 1
    )  # fmt: skip
    session = ExternalSensorSession(robot, sensor, clock=time)
    worst = 0.0
    with session:
        for k in range(int(seconds / robot.period)):
            try:
                session.state()
            except SensorLate:
                robot.stopped = 0
            if k * robot.period >= settle:
                shown = robot.shown(robot.taken_at)
                worst = max(worst, abs(session.to_sensor(shown) - sensor.shown(robot.taken_at)))
    return worst


def main() -> None:
    """Prints the error by kind of jitter."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=20)
    parser.add_argument("--seconds", type=float, default=20.0)
    parser.add_argument("--settle", type=float, default=0.0, help="after the second that the session listens before anything moves")
    parser.add_argument("--rate", type=float, default=1000.0, help="of the sensor, Hz")
    parser.add_argument("--lost", type=float, default=0.05)
    given = parser.parse_args()
    for name, jitter in JITTERS.items():
        errors = [
            run_once(jitter, seconds=given.seconds, settle=given.settle, rate_hz=given.rate, lost=given.lost, seed=seed)
            for seed in range(given.runs)
        ]
        below = sum(error <= 0.5e-3 for error in errors)
        print(
            f"{name}, {100 * given.lost:.0f} % lost, {given.rate:.0f} Hz: off by {1e3 * np.median(errors):.3f} ms in the median, "
            f"{1e3 * max(errors):.3f} ms at most; {below} of {given.runs} runs within 0.5 ms",
            flush=True,
        )


if __name__ == "__main__":
    main()
