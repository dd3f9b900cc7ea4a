"""A robot and a sensor that share one true clock of the test's own, so that a session with both runs without waiting."""

from __future__ import annotations

from collections.abc import Callable
from types import TracebackType
from typing import Self

import numpy as np

from core.array import Array
from core.sensors.sensor import ForceSensor, Reading
from core.sensors.sequence import Tally
from core.sessions.session import RobotSession, RobotState


class TrueTime:
    """Goes on when the robot's period or somebody's wait is over."""

    def __init__(self) -> None:
        self.now = 1000.0

    def __call__(self) -> float:
        return self.now


class LockstepRobot(RobotSession):
    """Stands still; its state arrives with jitter, its clock is another.

    Args:
        jitter_s: uniform, from 0.
    """

    period = 0.002

    def __init__(self, time: TrueTime, *, offset_s: float, drift: float, jitter_s: float, seed: int = 0) -> None:
        self.time, self.stopped, self.entered = time, 0, 0
        self._offset_s, self._drift, self._jitter_s = offset_s, drift, jitter_s
        self._rng = np.random.default_rng(seed)
        self._tick = 0
        self._zero = time.now
        self.taken_at = 0.0

    def find_start(self) -> Array:
        return np.zeros(6)

    def __enter__(self) -> Self:
        self.entered += 1
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self.entered -= 1

    def state(self) -> RobotState:
        self._tick += 1
        self.taken_at = self._zero + self._tick * self.period
        self.time.now = max(self.time.now, self.taken_at + self._rng.uniform(0.0, self._jitter_s))
        still = np.zeros(6)
        return RobotState(self.shown(self.taken_at), still, still, still, np.full(6, np.nan))

    def shown(self, true_s: float) -> float:
        return (true_s - 1000.0) * (1.0 + self._drift) + self._offset_s

    def true(self, shown_s: float) -> float:
        return (shown_s - self._offset_s) / (1.0 + self._drift) + 1000.0

    def command(self, q: Array) -> None:
        del q

    def stop(self) -> None:
        self.stopped += 1

    def release(self) -> None:
        self.stopped = 0


class LockstepSensor(ForceSensor):
    """Its wrench is a function of the true time; samples take `delay_s` and up to `jitter_s` more, and some are lost.

    Args:
        silent: whether a sample taken at a true time gets lost for sure.
        change: what becomes of a reading.
    """

    name = "sensor"

    def __init__(
        self,
        time: TrueTime,
        wrench: Callable[[float], Array],
        *,
        rate_hz: float = 1000.0,
        offset_s: float = 0.0,
        drift: float = 0.0,
        delay_s: float = 0.0,
        jitter_s: float = 0.0,
        jitter: Callable[[np.random.Generator], float] | None = None,
        lost: float = 0.0,
        silent: Callable[[float], bool] = lambda _: False,
        change: Callable[[Reading, float], Reading] = lambda reading, _: reading,
        seed: int = 0,
    ) -> None:
        self.time, self.tally = time, Tally()
        self._wrench, self._rate_hz, self._offset_s, self._drift = wrench, rate_hz, offset_s, drift
        self._delay_s, self._lost, self._silent, self._change = delay_s, lost, silent, change
        self._rng = np.random.default_rng(seed)
        self._jitter = jitter or (lambda rng: rng.uniform(0.0, jitter_s))
        self._taken = time.now
        self._on_the_way: list[tuple[float, float]] = []
        self.entered = 0

    def __enter__(self) -> Self:
        self.entered += 1
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self.entered -= 1

    def shown(self, true_s: float) -> float:
        return (true_s - 1000.0) * (1.0 + self._drift) + self._offset_s

    def read(self, wait_s: float = 0.0) -> list[Reading]:
        self._send()
        if wait_s > 0.0 and not any(arrival <= self.time.now for arrival, _ in self._on_the_way):
            self.time.now += wait_s
            self._send()
        here = sorted(sent for sent in self._on_the_way if sent[0] <= self.time.now)
        self._on_the_way = [sent for sent in self._on_the_way if sent[0] > self.time.now]
        self.tally.received += len(here)
        readings = [Reading(self.shown(taken), arrival, self._wrench(taken)) for arrival, taken in here]
        return [self._change(reading, taken) for reading, (_, taken) in zip(readings, here, strict=True)]

    def _send(self) -> None:
        while self._taken + 1.0 / self._rate_hz <= self.time.now:
            self._taken += 1.0 / self._rate_hz
            if self._silent(self._taken) or self._rng.random() < self._lost:
                self.tally.lost += 1
                continue
            self._on_the_way.append((self._taken + self._delay_s + self._jitter(self._rng), self._taken))
