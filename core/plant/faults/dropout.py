"""Not every sample is fresh."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import count
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.draws import draw_log_uniform, seed_of
from core.plant.faults.fault import Channel, Fault, Joints, Machine, Setting

LONGEST_BURST_S = 0.025
"""A robot whose joints are not heard of for longer would be stopped."""


@dataclass(frozen=True)
class HeldWrench(Fault):
    """Each reading is lost with a probability of 10 to 60 %, and the last one reported again."""

    id = "sample_dropout"
    variant = "held"

    lost_share: float
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """10 to 60 % of the readings, never more than 95 %."""
        return cls(min(size * draw_log_uniform(rng, 0.1, 0.6), 0.95), seed_of(rng))

    def digitize(self, machine: Machine) -> Channel | None:
        """Repeats the last reading with a probability of `lost_share`."""
        rng = np.random.default_rng(self.seed)
        last: Array | None = None

        def hold(_: float, W: Array) -> Array:
            nonlocal last
            if last is None or rng.random() >= self.lost_share:
                last = W
            return last

        return hold


@dataclass(frozen=True)
class LostBursts(Fault):
    """Everything that the robot measures is lost for 3 to 12 ms at a time (Gilbert's channel, never for longer than 25 ms), `lost_share` of
    all samples; joints and wrench repeat their last value."""

    id = "sample_dropout"
    variant = "bursts"

    lost_share: float
    burst_s: float
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """10 to 60 % of the samples, never more than 80 %, in bursts of 3 to 12 ms."""
        return cls(min(size * draw_log_uniform(rng, 0.1, 0.6), 0.8), draw_log_uniform(rng, 0.003, 0.012), seed_of(rng))

    def _schedule(self, period: float) -> LossSchedule:
        return LossSchedule(self.lost_share, self.burst_s / period, self.seed, round(LONGEST_BURST_S / period))

    def encode(self, machine: Machine) -> Joints | None:
        """Repeats positions and velocities while samples are lost."""
        schedule = self._schedule(machine.period)
        last: tuple[Array, Array] | None = None

        def hold(_: float, q: Array, dq: Array) -> tuple[Array, Array]:
            nonlocal last
            if not schedule.lose_next() or last is None:
                last = (q, dq)
            return last

        return hold

    def digitize(self, machine: Machine) -> Channel | None:
        """Repeats the wrench while samples are lost, at the same instants as the joints."""
        schedule = self._schedule(machine.period)
        last: Array | None = None

        def hold(_: float, W: Array) -> Array:
            nonlocal last
            if not schedule.lose_next() or last is None:
                last = W
            return last

        return hold


class LossSchedule:
    """Which samples are lost: two states with geometric durations, the lost one's at most `longest`; the same for all who ask once per
    sample."""

    def __init__(self, lost_share: float, burst_samples: float, seed: int, longest: int) -> None:
        self._rng = np.random.default_rng(seed)
        self._end = min(1.0 / burst_samples, 1.0)
        self._begin = self._end * lost_share / (1 - lost_share)
        self._longest, self._left = longest, longest
        self._lost = False

    def lose_next(self) -> bool:
        """Whether the next sample is lost."""
        change = self._end if self._lost else self._begin
        if self._rng.random() < change or self._left == 0:
            self._lost = not self._lost
        self._left = self._left - 1 if self._lost else self._longest
        return self._lost


@dataclass(frozen=True)
class SlowSensor(Fault):
    """The sensor is slower than the robot: a fresh reading only every 2 to 20 ms."""

    id = "sample_dropout"
    variant = "slow_rate"

    every: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """A fresh reading every 2 to 20 samples."""
        return cls(1 + round(size * (draw_log_uniform(rng, 2.0, 20.0) - 1)))

    def digitize(self, machine: Machine) -> Channel | None:
        """Takes one reading of `every` and repeats it for the others."""
        tick = count()
        last = np.zeros(6)

        def hold(_: float, W: Array) -> Array:
            nonlocal last
            if next(tick) % self.every == 0:
                last = W
            return last

        return hold


@dataclass(frozen=True)
class PreemptedBus(Fault):
    """The sensor's bus serves something else first, in step with a cycle of 6 to 40 ms: during a share of every cycle the wrench stands
    still, then it goes on with fresh readings."""

    id = "sample_dropout"
    variant = "preempted"

    lost_share: float
    cycle_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """10 to 60 % of each cycle, never more than 90 %, with cycles of 6 to 40 ms."""
        return cls(min(size * draw_log_uniform(rng, 0.1, 0.6), 0.9), draw_log_uniform(rng, 0.006, 0.04))

    def digitize(self, machine: Machine) -> Channel | None:
        """Repeats the last reading in the last `lost_share` of each cycle."""
        tick = count()
        last: Array | None = None

        def hold(_: float, W: Array) -> Array:
            nonlocal last
            if last is None or next(tick) * machine.period / self.cycle_s % 1.0 < 1 - self.lost_share:
                last = W
            return last

        return hold


DROPOUT: tuple[type[Fault], ...] = (
    HeldWrench,
    LostBursts,
    SlowSensor,
    PreemptedBus,
)
