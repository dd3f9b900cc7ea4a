"""Wrench and joints do not belong to the same instant."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.draws import draw_log_uniform, seed_of
from core.plant.faults.fault import Channel, Fault, Joints, Machine, Setting
from core.plant.faults.history import History


@dataclass(frozen=True)
class Delay(Fault):
    """The wrench comes late by 4 to 40 ms."""

    id = "time_delay"
    variant = "constant"

    delay_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """4 to 40 ms."""
        return cls(size * draw_log_uniform(rng, 0.004, 0.04))

    def sense(self, machine: Machine) -> Channel | None:
        """The wrench of `delay_s` before, straight between samples."""
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
        """4 to 40 ms, jitter of 10 to 30 % with a memory of 10 to 300 ms."""
        return cls(size * draw_log_uniform(rng, 0.004, 0.04), float(rng.uniform(0.1, 0.3)), draw_log_uniform(rng, 0.01, 0.3), seed_of(rng))

    def sense(self, machine: Machine) -> Channel | None:
        """The wrench of `delay (1 + jitter x)` before, x autoregressive noise of first order cut at 3."""
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
class MotionLag(Fault):
    """Reported joint positions and velocities lag behind by a low-pass of first order, or of several equal ones; 5 to 30 ms in all."""

    id = "kinematic_lag"
    variant = "first_order"
    stages = 1

    lag_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """5 to 30 ms."""
        return cls(size * draw_log_uniform(rng, 0.005, 0.03))

    def encode(self, machine: Machine) -> Joints | None:
        """Positions and velocities behind `stages` equal low-passes that lag by `lag_s` in all."""
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
class SlippingBuffer(Fault):
    """Comes through a buffer that is filled faster than it is emptied: the delay grows steadily by `swing` to either side of its mean,
    then the buffer is cleared and it begins anew, every few seconds."""

    id = "time_delay"
    variant = "slipping_buffer"

    delay_s: float
    swing_share: float
    cycle_s: float
    phase_share: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """4 to 40 ms, swing of 20 to 60 % with a cycle of 2 to 15 s."""
        return cls(
            size * draw_log_uniform(rng, 0.004, 0.04), float(rng.uniform(0.2, 0.6)), draw_log_uniform(rng, 2.0, 15.0), float(rng.uniform())
        )

    def sense(self, machine: Machine) -> Channel | None:
        """The wrench of `delay (1 + swing x)` before, x a sawtooth from -1 to 1 in each cycle."""
        history = History(2 * self.delay_s, machine.period)

        def late(t: float, W: Array) -> Array:
            history.push(W)
            filled = (t / self.cycle_s + self.phase_share) % 1.0
            return history.ago(self.delay_s * (1 + self.swing_share * (2 * filled - 1)))

        return late


@dataclass(frozen=True)
class DriftingClock(Fault):
    """The sensor's clock runs slow against the robot's: its samples come later and later."""

    id = "time_delay"
    variant = "drifting_clock"

    slow_share: float
    longest_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """10 to 60 ms late in the end."""
        late = size * draw_log_uniform(rng, 0.01, 0.06)
        return cls(late / setting.seconds, 2 * late)

    def sense(self, machine: Machine) -> Channel | None:
        """The wrench of `slow_share t` before, at most of `longest_s` before."""
        history = History(self.longest_s, machine.period)

        def late(t: float, W: Array) -> Array:
            history.push(W)
            return history.ago(self.slow_share * t)

        return late


@dataclass(frozen=True)
class PolledDrives(Fault):
    """The drives are asked one after the other, and reported together when the last has answered: each joint is late by a pure delay of
    its own, from `lag` down to `lag (1 - skew)`, along the arm or against it."""

    id = "kinematic_lag"
    variant = "polled"

    lag_s: float
    skew_share: float
    from_base: bool

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """5 to 30 ms, skew of 40 to 90 %, from the base or from the wrist on."""
        return cls(size * draw_log_uniform(rng, 0.005, 0.03), float(rng.uniform(0.4, 0.9)), bool(rng.random() < 0.5))

    def encode(self, machine: Machine) -> Joints | None:
        """Each joint's position and velocity of its own delay before, from `lag` to `lag (1 - skew)` in equal steps."""
        n = machine.setting.n
        late = self.lag_s * (1 - self.skew_share * np.linspace(0.0, 1.0, n))
        if not self.from_base:
            late = late[::-1]
        history = History(self.lag_s, machine.period)

        def ask(_: float, q: Array, dq: Array) -> tuple[Array, Array]:
            history.push(np.stack((q, dq)))
            answers = np.column_stack([history.ago(float(late[j]))[:, j] for j in range(n)])
            return answers[0], answers[1]

        return ask


@dataclass(frozen=True)
class Reconnecting(Fault):
    """Comes over a connection that breaks now and then, and has another backlog each time it is there again: the delay stays for some ten
    seconds and then is another one. A longer one begins with a reading that waits, a shorter one with readings that are skipped."""

    id = "time_delay"
    variant = "reconnecting"

    delay_s: float
    swing_share: float
    mean_s: float
    """How long a connection holds, on average."""
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """4 to 40 ms, swing of 30 to 80 % to either side, connections of 6 to 20 s on average."""
        delay, swing = size * draw_log_uniform(rng, 0.004, 0.04), float(rng.uniform(0.3, 0.8))
        return cls(delay, swing, draw_log_uniform(rng, 6.0, 20.0), seed_of(rng))

    def sense(self, machine: Machine) -> Channel | None:
        """The wrench of `delay (1 + swing x)` before, x between -1 and 1 for each connection."""
        rng = np.random.default_rng(self.seed)
        history = History((1 + self.swing_share) * self.delay_s, machine.period)
        age, backlog, until = math.inf, 0.0, 0.0

        def late(t: float, W: Array) -> Array:
            nonlocal age, backlog, until
            history.push(W)
            while t >= until:
                backlog = self.delay_s * (1 + self.swing_share * rng.uniform(-1.0, 1.0))
                until += rng.exponential(self.mean_s)
            age = min(age + machine.period, backlog)  # nothing is read that is older than what was read before
            return history.ago(age)

        return late


TIMING: tuple[type[Fault], ...] = (
    Delay,
    JitteryDelay,
    MotionLag,
    MotionLagThirdOrder,
    SlippingBuffer,
    DriftingClock,
    PolledDrives,
    Reconnecting,
)
