"""The wrist sensor's offset does not stay."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.draws import draw_log_uniform, moment, seed_of, six, wrench_of
from core.plant.faults.fault import Channel, Fault, Machine, Setting, Six


@dataclass(frozen=True)
class ExponentialDrift(Fault):
    """Warms up: `drift (1 - exp(-t / time_constant))`, 0.3 to 4 N in five to ten minutes."""

    id = "sensor_drift"
    variant = "exponential"

    drift_wrench: Six
    time_constant_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.3 to 4 N, with torques of the same share of their range, time constant of 60 to 200 s."""
        return cls(wrench_of(rng, size * draw_log_uniform(rng, 0.3, 4.0), setting), draw_log_uniform(rng, 60.0, 200.0))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `drift (1 - exp(-t / tau))`."""
        drift, tau = np.array(self.drift_wrench), self.time_constant_s
        return lambda t, W: W - drift * math.expm1(-t / tau)


@dataclass(frozen=True)
class LinearDrift(Fault):
    """Creeps away steadily."""

    id = "sensor_drift"
    variant = "linear"

    drift_wrench: Six
    duration_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.3 to 4 N, with torques of the same share of their range, in 300 to 600 s."""
        return cls(wrench_of(rng, size * draw_log_uniform(rng, 0.3, 4.0), setting), draw_log_uniform(rng, 300.0, 600.0))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `drift t / duration`."""
        rate = np.array(self.drift_wrench) / self.duration_s
        return lambda t, W: W + rate * t


@dataclass(frozen=True)
class TwoTimeConstantDrift(Fault):
    """Warms up as sensors do: first the strain gauges, soon, then the body that they are glued to, which partly
    compensates them."""

    id = "sensor_drift"
    variant = "two_time_constants"

    fast_wrench: Six
    fast_s: float
    slow_wrench: Six
    slow_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Of 0.3 to 4 N, 30 to 70 % with a time constant of 8 to 20 s and -80 to 100 % with one of 100 to 400 s; torques by their range."""
        drift = np.array(wrench_of(rng, size * draw_log_uniform(rng, 0.3, 4.0), setting))
        share = rng.uniform(0.3, 0.7)
        fast, slow = share * drift, rng.uniform(-0.8, 1.0) * drift
        return cls(six(fast), draw_log_uniform(rng, 8.0, 20.0), six(slow), draw_log_uniform(rng, 100.0, 400.0))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `fast (1 - exp(-t / fast_s)) + slow (1 - exp(-t / slow_s))`."""
        fast, slow = np.array(self.fast_wrench), np.array(self.slow_wrench)
        return lambda t, W: W - fast * math.expm1(-t / self.fast_s) - slow * math.expm1(-t / self.slow_s)


@dataclass(frozen=True)
class RandomWalk(Fault):
    """Wanders: a random walk in each channel, with standard deviation `std` after `duration`."""

    id = "sensor_drift"
    variant = "random_walk"

    std_wrench: Six
    duration_s: float
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.3 to 4 N, with torques of the same share of their range, in 300 to 600 s."""
        return cls(wrench_of(rng, size * draw_log_uniform(rng, 0.3, 4.0), setting), draw_log_uniform(rng, 300.0, 600.0), seed_of(rng))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds a random walk in each channel, one step of `std sqrt(period / duration)` a sample."""
        rng = np.random.default_rng(self.seed)
        step = np.array(self.std_wrench) * math.sqrt(machine.period / self.duration_s)
        now = np.zeros(6)

        def wander(_: float, W: Array) -> Array:
            nonlocal now
            now = now + step * rng.standard_normal(6)
            return W + now

        return wander


@dataclass(frozen=True)
class OffsetStep(Fault):
    """Jumps once, from one sample to the next: 1 to 2 N."""

    id = "sensor_offset_step"
    variant = "step"

    step_wrench: Six
    at_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 2 N, with torques of the same share of their range, at a time well inside the run."""
        return cls(wrench_of(rng, size * draw_log_uniform(rng, 1.0, 2.0), setting), moment(rng, setting))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds the step from `at_s` on."""
        step = np.array(self.step_wrench)
        return lambda t, W: W + step if t >= self.at_s else W


@dataclass(frozen=True)
class OffsetRamp(Fault):
    """Moves to another value within a second or so: a connector that gives way."""

    id = "sensor_offset_step"
    variant = "fast_ramp"

    step_wrench: Six
    at_s: float
    rise_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 2 N, with torques of the same share of their range, within 0.2 to 2 s, well inside the run."""
        return cls(wrench_of(rng, size * draw_log_uniform(rng, 1.0, 2.0), setting), moment(rng, setting), draw_log_uniform(rng, 0.2, 2.0))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds a share of the step that grows evenly from 0 at `at_s` to 1 at `at_s + rise_s`."""
        step = np.array(self.step_wrench)
        return lambda t, W: W + step * min(max((t - self.at_s) / self.rise_s, 0.0), 1.0)


@dataclass(frozen=True)
class OffsetKnock(Fault):
    """Jumps as after a knock, and comes back in part: `step (kept + (1 - kept) exp(-(t - t0) / recovery))`."""

    id = "sensor_offset_step"
    variant = "knock"

    step_wrench: Six
    at_s: float
    kept_share: float
    recovery_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 2 N, with torques of the same share of their range, of which 50 to 90 % stays, recovery in 1 to 8 s."""
        step = wrench_of(rng, size * draw_log_uniform(rng, 1.0, 2.0), setting)
        return cls(step, moment(rng, setting), float(rng.uniform(0.5, 0.9)), draw_log_uniform(rng, 1.0, 8.0))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `step (kept + (1 - kept) exp(-(t - t0) / recovery))` from t0 on."""
        step, kept = np.array(self.step_wrench), self.kept_share

        def knock(t: float, W: Array) -> Array:
            if t < self.at_s:
                return W
            return W + step * (kept + (1 - kept) * math.exp((self.at_s - t) / self.recovery_s))

        return knock


@dataclass(frozen=True)
class Thermostat(Fault):
    """Follows the air of a hall whose heating is switched on and off: towards `drift` for half a cycle, back for the other half, and so
    on, with the sensor's time constant; at the start it has long been off."""

    id = "sensor_drift"
    variant = "thermostat"

    drift_wrench: Six
    time_constant_s: float
    half_cycle_s: float
    first_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.3 to 4 N, with torques of the same share of their range, time constant of 20 to 60 s, half a cycle of 8 to 25 s."""
        half = draw_log_uniform(rng, 8.0, 25.0)
        return cls(
            wrench_of(rng, size * draw_log_uniform(rng, 0.3, 4.0), setting),
            draw_log_uniform(rng, 20.0, 60.0),
            half,
            float(rng.uniform(0, half)),
        )

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `drift` times a warmth that follows the heating, 0 or 1, with the time constant."""
        drift, follow = np.array(self.drift_wrench), -math.expm1(-machine.period / self.time_constant_s)
        warmth = 0.0

        def warm(t: float, W: Array) -> Array:
            nonlocal warmth
            heating = t >= self.first_s and (t - self.first_s) % (2 * self.half_cycle_s) < self.half_cycle_s
            warmth += follow * (heating - warmth)
            return W + warmth * drift

        return warm


@dataclass(frozen=True)
class HeatFront(Fault):
    """A drive under the flange is hot from the start, and its heat comes through the metal in between: nothing at first, then ever more
    and without an end to be seen, as it goes behind a thick wall (Carslaw and Jaeger): `drift erfc(sqrt(through / t))`."""

    id = "sensor_drift"
    variant = "heat_front"

    drift_wrench: Six
    through_s: float
    """The wall's thickness squared by four times its diffusivity."""

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.3 to 4 N, with torques of the same share of their range; 5 to 40 s, as of 4 cm of aluminium to 3 cm of steel."""
        return cls(wrench_of(rng, size * draw_log_uniform(rng, 0.3, 4.0), setting), draw_log_uniform(rng, 5.0, 40.0))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `drift erfc(sqrt(through / t))`, nothing at the start."""
        drift = np.array(self.drift_wrench)
        return lambda t, W: W + drift * math.erfc(math.sqrt(self.through_s / t)) if t > 0 else W


@dataclass(frozen=True)
class Clicks(Fault):
    """A clamp inside the sensor settles in clicks: several jumps in the same direction, of different size, within some seconds."""

    id = "sensor_offset_step"
    variant = "clicks"

    step_wrench: Six
    """All of them together."""
    at_s: tuple[float, ...]
    step_share: tuple[float, ...]

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 2 N in all, with torques of the same share of their range, in two to four clicks within 5 to 20 % of the run."""
        step = wrench_of(rng, size * draw_log_uniform(rng, 1.0, 2.0), setting)
        count = int(rng.integers(2, 5))
        begin, span = rng.uniform(0.15, 0.75), draw_log_uniform(rng, 0.05, 0.2)
        at = setting.seconds * (begin + span * np.sort(np.append(rng.uniform(0, 1, count - 1), 0.0)))
        share = rng.uniform(0.4, 1.0, count)
        return cls(step, tuple(at.tolist()), tuple((share / share.sum()).tolist()))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `step_share` of the step for each of `at_s` that is over."""
        step, at, share = np.array(self.step_wrench), np.array(self.at_s), np.array(self.step_share)
        return lambda t, W: W + step * float(share[at <= t].sum())


SENSOR_OFFSET: tuple[type[Fault], ...] = (
    ExponentialDrift,
    LinearDrift,
    TwoTimeConstantDrift,
    RandomWalk,
    OffsetStep,
    OffsetRamp,
    OffsetKnock,
    Thermostat,
    HeatFront,
    Clicks,
)
