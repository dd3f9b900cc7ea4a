"""Wrench and joints do not belong to the same instant, or not every sample is fresh."""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass
from itertools import count
from typing import Self

import numpy as np

from core.plant.faults.draws import seed_of, spread
from core.plant.faults.fault import Array, Channel, Fault, Joints, Machine, Setting
from core.plant.faults.history import History

LONGEST_BURST_S = 0.025
"""A robot whose joints are not heard of for longer would be stopped."""


@dataclass(frozen=True)
class Delay(Fault):
    """The wrench comes late by 4 to 40 ms."""

    id = "time_delay"
    variant = "constant"

    delay_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(size * spread(rng, 0.004, 0.04))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
        history = History(self.delay_s, machine.period)

        def late(_: float, W: Array) -> Array:
            history.push(W)
            return history.ago(self.delay_s)

        return late


@dataclass(frozen=True)
class JitteryDelay(Fault):
    """Comes late by a delay that wanders as on a busy network: `delay (1 + jitter x)`, x with standard deviation 1 and a memory of
    `memory_s`, cut at 3."""

    id = "time_delay"
    variant = "jitter"

    delay_s: float
    jitter_share: float
    memory_s: float
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(size * spread(rng, 0.004, 0.04), float(rng.uniform(0.1, 0.3)), spread(rng, 0.01, 0.3), seed_of(rng))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
        rng = np.random.default_rng(self.seed)
        history = History(2 * self.delay_s, machine.period)
        keep = math.exp(-machine.period / self.memory_s)
        fresh = math.sqrt(1 - keep**2)
        x = rng.standard_normal()

        def late(_: float, W: Array) -> Array:
            nonlocal x
            x = keep * x + fresh * rng.standard_normal()
            history.push(W)
            return history.ago(self.delay_s * (1 + self.jitter_share * min(max(x, -3.0), 3.0)))

        return late


@dataclass(frozen=True)
class FirstOrderFilter(Fault):
    """An analogue low-pass of first order before the noise of the converter; 2 to 20 Hz."""

    id = "sensor_lowpass"
    variant = "first_order"

    cut_off_hz: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(spread(rng, 2.0, 20.0) / size)

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
        gain = -math.expm1(-2 * math.pi * self.cut_off_hz * machine.period)
        y: Array | None = None

        def smooth(_: float, W: Array) -> Array:
            nonlocal y
            y = W if y is None else y + gain * (W - y)
            return y

        return smooth


@dataclass(frozen=True)
class Butterworth(Fault):
    """An analogue low-pass of second order, Butterworth's, before the noise of the converter."""

    id = "sensor_lowpass"
    variant = "second_order"

    cut_off_hz: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(spread(rng, 2.0, 20.0) / size)

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`. The bilinear transform with the cut-off where it should be; none where that is beyond what is sampled."""
        if self.cut_off_hz * machine.period > 0.45:
            return None
        k = math.tan(math.pi * self.cut_off_hz * machine.period)
        norm = 1 + math.sqrt(2) * k + k * k
        b, a1, a2 = k * k / norm, 2 * (k * k - 1) / norm, (1 - math.sqrt(2) * k + k * k) / norm
        u1 = u2 = y1 = y2 = np.zeros(6)
        started = False

        def smooth(_: float, W: Array) -> Array:
            nonlocal u1, u2, y1, y2, started
            if not started:
                u1 = u2 = y1 = y2 = W
                started = True
            y = b * (W + 2 * u1 + u2) - a1 * y1 - a2 * y2
            u1, u2, y1, y2 = W, u1, y, y1
            return y

        return smooth


@dataclass(frozen=True)
class MovingAverage(Fault):
    """A digital mean over a window, noise included; 0.443 by the window is the cut-off, again 2 to 20 Hz."""

    id = "sensor_lowpass"
    variant = "moving_average"

    window_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(size * 0.443 / spread(rng, 2.0, 20.0))

    def amplify(self, machine: Machine) -> Channel | None:
        """See `Fault.amplify`."""
        N = max(1, round(self.window_s / machine.period))
        window: deque[Array] = deque(maxlen=N)
        total = np.zeros(6)

        def mean(_: float, W: Array) -> Array:
            nonlocal total
            if not window:
                window.extend([W] * N)
                total = N * W
            total = total + W - window[0]
            window.append(W)
            return total / N

        return mean


@dataclass(frozen=True)
class MotionLag(Fault):
    """Reported joint positions and velocities lag behind by a low-pass of first order, or of several equal ones; 5 to 30 ms in all."""

    id = "kinematic_lag"
    variant = "first_order"
    stages = 1

    lag_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(size * spread(rng, 0.005, 0.03))

    def encode(self, machine: Machine) -> Joints | None:
        """See `Fault.encode`."""
        gain = -math.expm1(-machine.period * self.stages / self.lag_s)
        stages: list[Array] = []

        def lag(_: float, q: Array, dq: Array) -> tuple[Array, Array]:
            newest = np.stack((q, dq))
            if not stages:
                stages.extend([newest] * self.stages)
            for k in range(self.stages):
                newest = stages[k] = stages[k] + gain * (newest - stages[k])
            return newest[0], newest[1]

        return lag


@dataclass(frozen=True)
class MotionLagThirdOrder(MotionLag):
    """Lags nearly as a pure delay does: three equal low-passes."""

    variant = "third_order"
    stages = 3


@dataclass(frozen=True)
class HeldWrench(Fault):
    """Each reading is lost with a probability of 10 to 60 %, and the last one reported again."""

    id = "sample_dropout"
    variant = "held"

    lost_share: float
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(min(size * spread(rng, 0.1, 0.6), 0.95), seed_of(rng))

    def digitize(self, machine: Machine) -> Channel | None:
        """See `Fault.digitize`."""
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
        """See `Fault.draw`."""
        return cls(min(size * spread(rng, 0.1, 0.6), 0.8), spread(rng, 0.003, 0.012), seed_of(rng))

    def _schedule(self, period: float) -> LossSchedule:
        return LossSchedule(self.lost_share, self.burst_s / period, self.seed, round(LONGEST_BURST_S / period))

    def encode(self, machine: Machine) -> Joints | None:
        """See `Fault.encode`."""
        schedule = self._schedule(machine.period)
        last: tuple[Array, Array] | None = None

        def hold(_: float, q: Array, dq: Array) -> tuple[Array, Array]:
            nonlocal last
            if not schedule.lost() or last is None:
                last = (q, dq)
            return last

        return hold

    def digitize(self, machine: Machine) -> Channel | None:
        """See `Fault.digitize`."""
        schedule = self._schedule(machine.period)
        last: Array | None = None

        def hold(_: float, W: Array) -> Array:
            nonlocal last
            if not schedule.lost() or last is None:
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

    def lost(self) -> bool:
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
        """See `Fault.draw`."""
        return cls(1 + round(size * (spread(rng, 2.0, 20.0) - 1)))

    def digitize(self, machine: Machine) -> Channel | None:
        """See `Fault.digitize`."""
        tick = count()
        last = np.zeros(6)

        def hold(_: float, W: Array) -> Array:
            nonlocal last
            if next(tick) % self.every == 0:
                last = W
            return last

        return hold


TIMING: tuple[type[Fault], ...] = (
    Delay,
    JitteryDelay,
    FirstOrderFilter,
    Butterworth,
    MovingAverage,
    MotionLag,
    MotionLagThirdOrder,
    HeldWrench,
    LostBursts,
    SlowSensor,
)
