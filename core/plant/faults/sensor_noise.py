"""The wrist sensor is noisier than its figures say."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.draws import draw_log_uniform, seed_of, six
from core.plant.faults.fault import Channel, Fault, Machine, Setting, Six
from core.plant.faults.switching import RandomSwitch


def noise_factor(rng: np.random.Generator, size: float) -> float:
    """1.5 to 5 times the stated noise; 1 is none."""
    return 1 + size * (draw_log_uniform(rng, 1.5, 5.0) - 1)


@dataclass(frozen=True)
class LoudNoise(Fault):
    """White noise, `factor` times as large as stated."""

    id = "sensor_noise"
    variant = "white"

    factor: float
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1.5 to 5 times the stated noise."""
        return cls(noise_factor(rng, size), seed_of(rng))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds white noise of `sqrt(factor^2 - 1)` times the stated one."""
        rng = np.random.default_rng(self.seed)
        std = math.sqrt(self.factor**2 - 1) * machine.setting.noise_std
        return lambda _, W: W + std * rng.standard_normal(6)


@dataclass(frozen=True)
class ColouredNoise(Fault):
    """Noise that remembers: beside the stated noise an autoregressive one of first order; both together are `factor` times the stated."""

    id = "sensor_noise"
    variant = "coloured"

    factor: float
    correlation_s: float
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1.5 to 5 times the stated noise, correlated over 5 to 100 ms."""
        return cls(noise_factor(rng, size), draw_log_uniform(rng, 0.005, 0.1), seed_of(rng))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds autoregressive noise of first order, `sqrt(factor^2 - 1)` times the stated one."""
        rng = np.random.default_rng(self.seed)
        std = math.sqrt(self.factor**2 - 1) * machine.setting.noise_std
        keep = math.exp(-machine.period / self.correlation_s)
        fresh = math.sqrt(1 - keep**2) * std
        now = std * rng.standard_normal(6)

        def add(_: float, W: Array) -> Array:
            nonlocal now
            now = keep * now + fresh * rng.standard_normal(6)
            return W + now

        return add


@dataclass(frozen=True)
class Spikes(Fault):
    """Single readings are far off: with `probability_share` per reading a spike in one channel, of `factor` times its noise on average
    (Laplace's distribution)."""

    id = "sensor_noise"
    variant = "spikes"

    probability_share: float
    factor: float
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """A spike in 1 to 10 % of the readings, of 5 to 20 times the noise."""
        return cls(draw_log_uniform(rng, 0.01, 0.1), size * draw_log_uniform(rng, 5.0, 20.0), seed_of(rng))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds a spike to one random channel with a probability of `probability_share`."""
        rng = np.random.default_rng(self.seed)
        scale = self.factor * machine.setting.noise_std

        def strike(_: float, W: Array) -> Array:
            if rng.random() < self.probability_share:
                c = int(rng.integers(6))
                W = W.copy()
                W[c] += rng.laplace(0.0, scale[c])
            return W

        return strike


def line_amplitude(rng: np.random.Generator, size: float, setting: Setting) -> Six:
    """One to five times the noise in one channel, less in the others."""
    share = rng.uniform(0.1, 1.0, 6)
    share[rng.integers(6)] = 1.0
    return six(size * draw_log_uniform(rng, 1.0, 5.0) * share * setting.noise_std)


@dataclass(frozen=True)
class Hum(Fault):
    """A sine of the mains, the lamps or a motor: 50, 60 or 100 Hz."""

    id = "sensor_interference"
    variant = "sine"

    amplitude_wrench: Six
    frequency_hz: float
    phase_rad: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """50, 60 or 100 Hz in any phase, with 1 to 5 times the noise in the channel that has most of it."""
        return cls(line_amplitude(rng, size, setting), float(rng.choice([50.0, 60.0, 100.0])), float(rng.uniform(0, 2 * np.pi)))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `A sin(2 pi f t + phase)`."""
        A, omega = np.array(self.amplitude_wrench), 2 * math.pi * self.frequency_hz
        return lambda t, W: W + A * math.sin(omega * t + self.phase_rad)


@dataclass(frozen=True)
class WanderingHum(Fault):
    """A line with its third harmonic, whose phase wanders as that of a motor that is not quite in step."""

    id = "sensor_interference"
    variant = "wandering"

    amplitude_wrench: Six
    frequency_hz: float
    third_share: float
    wander_rad_per_root_s: float
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """50, 60 or 100 Hz to 1 %, 10 to 50 % of the third harmonic, a phase that wanders by 0.1 to 1 rad in a second."""
        frequency = float(rng.choice([50.0, 60.0, 100.0]) * rng.uniform(0.99, 1.01))
        amplitude = line_amplitude(rng, size, setting)
        return cls(amplitude, frequency, float(rng.uniform(0.1, 0.5)), draw_log_uniform(rng, 0.1, 1.0), seed_of(rng))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `A (sin(phase) + third sin(3 phase))`, the phase a random walk beside its steady growth."""
        rng = np.random.default_rng(self.seed)
        A = np.array(self.amplitude_wrench)
        turn = 2 * math.pi * self.frequency_hz * machine.period
        wander = self.wander_rad_per_root_s * math.sqrt(machine.period)
        phase = rng.uniform(0, 2 * math.pi)

        def add(_: float, W: Array) -> Array:
            nonlocal phase
            phase += turn + wander * rng.standard_normal()
            return W + A * (math.sin(phase) + self.third_share * math.sin(3 * phase))

        return add


@dataclass(frozen=True)
class GatedHum(Fault):
    """A line that is there only while something else runs, a welder or a heater: on and off at random moments, some seconds each."""

    id = "sensor_interference"
    variant = "gated"

    amplitude_wrench: Six
    frequency_hz: float
    mean_on_s: float
    mean_off_s: float
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """50, 60 or 100 Hz, on for 1 to 6 s and off for 0.5 to 3 s on average."""
        frequency = float(rng.choice([50.0, 60.0, 100.0]))
        return cls(
            line_amplitude(rng, size, setting), frequency, draw_log_uniform(rng, 1.0, 6.0), draw_log_uniform(rng, 0.5, 3.0), seed_of(rng)
        )

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `A sin(2 pi f t)` while a random switch is on, as it is at the start."""
        switch = RandomSwitch((self.mean_off_s, self.mean_on_s), self.seed, on=True)
        A, omega = np.array(self.amplitude_wrench), 2 * math.pi * self.frequency_hz
        return lambda t, W: W + A * math.sin(omega * t) if switch.is_on(t) else W


SENSOR_NOISE: tuple[type[Fault], ...] = (
    LoudNoise,
    ColouredNoise,
    Spikes,
    Hum,
    WanderingHum,
    GatedHum,
)
