"""The wrist sensor is noisier or coarser than its figures say."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np

from core.plant.faults.draws import seed_of, six, spread
from core.plant.faults.fault import Array, Channel, Fault, Machine, Setting, Six


def noise_factor(rng: np.random.Generator, size: float) -> float:
    """1.5 to 5 times the stated noise; 1 is none."""
    return 1 + size * (spread(rng, 1.5, 5.0) - 1)


@dataclass(frozen=True)
class LoudNoise(Fault):
    """White noise, `factor` times as large as stated."""

    id = "sensor_noise"
    variant = "white"

    factor: float
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(noise_factor(rng, size), seed_of(rng))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
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
        """See `Fault.draw`."""
        return cls(noise_factor(rng, size), spread(rng, 0.005, 0.1), seed_of(rng))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
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
        """See `Fault.draw`."""
        return cls(spread(rng, 0.01, 0.1), size * spread(rng, 5.0, 20.0), seed_of(rng))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
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
    return six(size * spread(rng, 1.0, 5.0) * share * setting.noise_std)


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
        """See `Fault.draw`."""
        return cls(line_amplitude(rng, size, setting), float(rng.choice([50.0, 60.0, 100.0])), float(rng.uniform(0, 2 * np.pi)))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
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
        """See `Fault.draw`."""
        frequency = float(rng.choice([50.0, 60.0, 100.0]) * rng.uniform(0.99, 1.01))
        amplitude = line_amplitude(rng, size, setting)
        return cls(amplitude, frequency, float(rng.uniform(0.1, 0.5)), spread(rng, 0.1, 1.0), seed_of(rng))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
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


def coarse_step(rng: np.random.Generator, size: float, setting: Setting) -> Six:
    """4 to 20 times the stated resolution."""
    return six((1 + size * (spread(rng, 4.0, 20.0) - 1)) * np.array(setting.cell.sensor.resolution))


@dataclass(frozen=True)
class CoarseSteps(Fault):
    """Rounded to steps coarser than stated."""

    id = "sensor_quantization"
    variant = "rounded"

    step_wrench: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(coarse_step(rng, size, setting))

    def digitize(self, machine: Machine) -> Channel | None:
        """See `Fault.digitize`."""
        step = np.array(self.step_wrench)
        return lambda _, W: np.rint(W / step) * step


@dataclass(frozen=True)
class SendOnDelta(Fault):
    """A bus that sends a channel only when it has changed by a step since it was sent last; ten times a second it is sent anyway."""

    id = "sensor_quantization"
    variant = "send_on_delta"

    step_wrench: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(coarse_step(rng, size, setting))

    def digitize(self, machine: Machine) -> Channel | None:
        """See `Fault.digitize`."""
        nearly = (1 - 1e-4) * np.array(self.step_wrench)  # the change by one step, whatever its rounding
        every = round(0.1 / machine.period)  # a sensor that is silent for longer counts as dead
        sent: Array | None = None
        tick = 0

        def send(_: float, W: Array) -> Array:
            nonlocal sent, tick
            tick += 1
            sent = W if sent is None or tick % every == 0 else np.where(np.abs(W - sent) >= nearly, W, sent)
            return sent

        return send


@dataclass(frozen=True)
class MissingCodes(Fault):
    """A converter whose middle bit sticks: every other gap is unreachable and reads as its nearer end."""

    id = "sensor_quantization"
    variant = "missing_codes"

    gap_wrench: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(coarse_step(rng, size, setting))

    def digitize(self, machine: Machine) -> Channel | None:
        """See `Fault.digitize`."""
        gap = np.array(self.gap_wrench)

        def skip(_: float, W: Array) -> Array:
            place = W / gap
            whole = np.floor(place)
            odd = whole % 2 == 1
            return np.where(odd, np.rint(place) * gap, W)

        return skip


SENSOR_NOISE: tuple[type[Fault], ...] = (
    LoudNoise,
    ColouredNoise,
    Spikes,
    Hum,
    WanderingHum,
    CoarseSteps,
    SendOnDelta,
    MissingCodes,
)
