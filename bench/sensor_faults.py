"""A sensor on a line of its own under what happens to lines, 20 times each: `python -m bench.sensor_faults`.

The generator (`tests.core.sessions.lockstep`) gives the sensor a wrench that tells of which moment it is, so that every row that a
recording would keep can be held against the truth. Printed: rows kept, by how much their wrench is of another moment at most, how often the
sensor was too late, and how soon the robot was stopped where it was silent for long or said that it is saturated.
"""

from __future__ import annotations

import argparse
import sys
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from core.array import Array
from core.errors import BadState, SensorLate
from core.sensors.sensor import Reading
from core.sessions.external_sensor import ExternalSensorSession
from core.sessions.sample_log import PATIENCE_S
from core.sessions.session import RobotState
from core.words.message import Message
from tests.core.sessions.lockstep import LockstepRobot, LockstepSensor, TrueTime

SLOPE = np.array([10.0, -20.0, 5.0, 1.0, 0.5, -0.25])
SATURATED = Message.of("sensors-fault-saturated", status="0x80020000")


@dataclass
class Seen:
    """Of the runs of one kind."""

    rows: int = 0
    kept: int = 0
    at_once: int = 0
    late: int = 0
    worst_s: float = 0.0
    stops_s: list[float] = field(default_factory=list)
    unstopped: int = 0
    spoilt: int = 0


def watch(seen: Seen, *, seconds: float, seed: int, at_s: float | None, **line: Any) -> None:
    """One run; `at_s` is the true time from which the robot has to be stopped, None where it may go on."""
    rng = np.random.default_rng(seed)
    offsets, drifts = rng.uniform(-86_400.0, 86_400.0, 2), rng.uniform(-100e-6, 100e-6, 2)
    time = TrueTime()

    def ramp(true_s: float) -> Array:
        return SLOPE * (true_s - 1000.0)

    robot = LockstepRobot(time, offset_s=offsets[0], drift=drifts[0], jitter_s=0.0005, seed=seed)
    sensor = LockstepSensor(time, ramp, rate_hz=1000.0, offset_s=offsets[1], drift=drifts[1], seed=seed + 1, **line)
    session = ExternalSensorSession(robot, sensor, clock=time)
    waiting: deque[RobotState] = deque()

    def keep(until_s: float) -> None:
        while waiting and waiting[0].t <= until_s:
            state = session.complete(waiting.popleft())
            if state.wrench_measured:
                seen.kept += 1
                moment = 1000.0 + float((-state.wrench / SLOPE)[0])
                seen.worst_s = max(seen.worst_s, abs(moment - robot.true(state.t)))
                seen.spoilt += at_s is not None and moment > at_s

    with session:
        for _ in range(int(seconds / robot.period)):
            seen.rows += 1
            try:
                state = session.state()
            except BadState as error:
                if at_s is not None and time.now >= at_s:
                    seen.stops_s.append(time.now - at_s)
                    keep(np.inf)
                    return
                if not isinstance(error, SensorLate):
                    raise
                seen.late += 1
                continue
            seen.at_once += state.wrench_measured
            waiting.append(state)
            keep(state.t - PATIENCE_S)
    keep(np.inf)
    seen.unstopped += at_s is not None


def main() -> None:
    """Prints a line for each kind of trouble."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--times", type=int, default=20)
    parser.add_argument("--seconds", type=float, default=6.0)
    given = parser.parse_args()
    moments = np.random.default_rng(0).uniform(1002.0, 1001.0 + given.seconds - 1.5, given.times)

    def saturate(at_s: float) -> Callable[[Reading, float], Reading]:
        return lambda reading, true_s: replace(reading, fault=SATURATED) if true_s >= at_s else reading

    cable = {"jitter_s": 0.0003}
    troubles: dict[str, Callable[[float], dict[str, Any]]] = {
        "a cable": lambda _: {**cable, "at_s": None},
        "5 % lost": lambda _: {**cable, "lost": 0.05, "at_s": None},
        "jitter of 20 ms": lambda _: {"jitter_s": 0.02, "at_s": None},
        "jitter of 20 ms, 5 % lost": lambda _: {"jitter_s": 0.02, "lost": 0.05, "at_s": None},
        "silent for 1 s": lambda at_s: {**cable, "silent": lambda true_s: at_s <= true_s < at_s + 1.0, "at_s": at_s},
        "silent for good": lambda at_s: {**cable, "silent": lambda true_s: true_s >= at_s, "at_s": at_s},
        "saturated": lambda at_s: {**cable, "change": saturate(at_s), "at_s": at_s},
    }
    for name, line in troubles.items():
        seen = Seen()
        for seed, at_s in enumerate(moments):
            watch(seen, seconds=given.seconds, seed=seed, **line(at_s))
        stops = (
            f"; stopped after {1e3 * max(seen.stops_s):.0f} ms at most, {seen.unstopped} times not"
            if seen.stops_s or seen.unstopped
            else ""
        )
        print(
            f"{name}: {100 * seen.kept / seen.rows:.1f} % of {seen.rows} rows kept ({100 * seen.at_once / seen.rows:.1f} % with their "
            f"wrench at once), by {1e3 * seen.worst_s:.2f} ms of another moment at most, {seen.spoilt} from after the fault; "
            f"{100 * seen.late / seen.rows:.1f} % of the states refused as too late{stops}",
            flush=True,
        )


if __name__ == "__main__":
    main()
