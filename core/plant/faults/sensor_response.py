"""The wrist sensor answers to a load in another way than it should."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from core.plant.faults.draws import channels, scattered, sign, six, spread
from core.plant.faults.fault import Array, Channel, Fault, Machine, Setting, Six

SixBySix = tuple[Six, Six, Six, Six, Six, Six]


def matrix_of(rows: Array) -> SixBySix:
    """As plain numbers."""
    a, b, c, d, e, f = (six(row) for row in rows)
    return a, b, c, d, e, f


def coupling(rng: np.random.Generator, low: float, high: float, setting: Setting) -> SixBySix:
    """From one to all channels show in another one each, by shares of the ranges; units of row per column."""
    full = setting.full_scale
    coupled = np.zeros((6, 6))
    for source in np.flatnonzero(channels(rng)):
        shown = int(rng.choice([c for c in range(6) if c != source]))
        coupled[shown, source] = sign(rng) * spread(rng, low, high) * full[shown] / full[source]
    return matrix_of(coupled)


@dataclass(frozen=True)
class Gain(Fault):
    """Channels read too much or too little by 1 to 5 %."""

    id = "sensor_gain"
    variant = "linear"

    gain_share: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(six(size * channels(rng) * scattered(rng, 0.01, 0.05, 6)))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
        gain = 1 + np.array(self.gain_share)
        return lambda _, W: gain * W


@dataclass(frozen=True)
class TwoSidedGain(Fault):
    """Another gain for pull than for push."""

    id = "sensor_gain"
    variant = "by_load_direction"

    positive_share: Six
    negative_share: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        chosen = size * channels(rng) * scattered(rng, 0.01, 0.05, 6)
        return cls(six(chosen), six(chosen * rng.uniform(0.2, 0.8, 6)))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
        up, down = np.array(self.positive_share), np.array(self.negative_share)
        return lambda _, W: W + np.where(W > 0, up, down) * W


@dataclass(frozen=True)
class Crosstalk(Fault):
    """Channels show in others: 1 to 3 % of the range."""

    id = "sensor_crosstalk"
    variant = "linear"

    coupling: SixBySix
    """Row: where it shows; units of the row's channel per unit of the column's."""

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(matrix_of(size * np.array(coupling(rng, 0.01, 0.03, setting))))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
        coupled = np.eye(6) + np.array(self.coupling)
        return lambda _, W: coupled @ W


@dataclass(frozen=True)
class RectifiedCrosstalk(Fault):
    """Loads in either direction show in another channel with the same sign: a bolted joint that opens and closes."""

    id = "sensor_crosstalk"
    variant = "rectified"

    coupling: SixBySix

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(matrix_of(size * np.array(coupling(rng, 0.01, 0.03, setting))))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
        coupled = np.array(self.coupling)
        return lambda _, W: W + coupled @ np.abs(W)


@dataclass(frozen=True)
class Quadratic(Fault):
    """Grows faster than the load: `W + e W |W| / range`, e about 1 %."""

    id = "sensor_nonlinearity"
    variant = "quadratic"

    share_of_range: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(six(size * channels(rng) * scattered(rng, 0.005, 0.02, 6)))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
        e = np.array(self.share_of_range) / machine.setting.full_scale
        return lambda _, W: W + e * W * np.abs(W)


@dataclass(frozen=True)
class Knee(Fault):
    """Another slope above a certain load: something gets into contact inside the sensor."""

    id = "sensor_nonlinearity"
    variant = "knee"

    knee_wrench: Six
    slope_share: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(six(rng.uniform(0.3, 0.6) * setting.load), six(size * channels(rng) * scattered(rng, 0.01, 0.04, 6)))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
        knee, slope = np.array(self.knee_wrench), np.array(self.slope_share)
        return lambda _, W: W + slope * (W - np.minimum(np.maximum(W, -knee), knee))


@dataclass(frozen=True)
class PlayHysteresis(Fault):
    """Comes back on another line than it went: what is lost in a play of 0.1 to 0.4 % of the range to either side."""

    id = "sensor_hysteresis"
    variant = "play"

    half_width_wrench: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(six(size * channels(rng) * np.abs(scattered(rng, 0.001, 0.004, 6)) * setting.full_scale))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
        half = np.array(self.half_width_wrench)
        behind: Array | None = None

        def follow(_: float, W: Array) -> Array:
            nonlocal behind
            behind = W if behind is None else np.minimum(np.maximum(behind, W - half), W + half)
            return behind

        return follow


@dataclass(frozen=True)
class BoucWen(Fault):
    """Smooth hysteresis (Wen 1976, without rate): `W + h z`, `dz = du (1 - |z|^n (beta sign(z du) + 1 - beta))`, u = W
    by `yield`."""

    id = "sensor_hysteresis"
    variant = "bouc_wen"

    height_wrench: Six
    yield_wrench: Six
    beta_share: float
    exponent: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        height = size * channels(rng) * scattered(rng, 0.001, 0.004, 6) * setting.full_scale
        width = rng.uniform(0.05, 0.3) * np.maximum(setting.load, 1e-3 * setting.full_scale)
        return cls(six(height), six(width), float(rng.uniform(0.5, 0.9)), float(rng.uniform(1.0, 2.0)))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
        h, width, beta, n = np.array(self.height_wrench), np.array(self.yield_wrench), self.beta_share, self.exponent
        last: Array | None = None
        z = np.zeros(6)

        def follow(_: float, W: Array) -> Array:
            nonlocal last, z
            du = np.zeros(6) if last is None else (W - last) / width
            z = z + du * (1 - np.abs(z) ** n * (beta * np.sign(z * du) + 1 - beta))
            z = np.minimum(np.maximum(z, -1.0), 1.0)
            last = W
            return W + h * z

        return follow


@dataclass(frozen=True)
class Creep(Fault):
    """After a load step the reading creeps on by a share of it (about 0.3 %, to 1 % on plain sensors) with time constants that
    have their shares each; loaded for long before the start."""

    id = "sensor_creep"
    variant = "exponential"

    creep_share: float
    time_constant_s: tuple[float, ...]

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(size * sign(rng) * spread(rng, 0.002, 0.01), (spread(rng, 3.0, 30.0),))

    def sense(self, machine: Machine) -> Channel | None:
        """See `Fault.sense`."""
        forget = -np.expm1(-machine.period / np.array(self.time_constant_s))[:, None]
        share = self.creep_share / len(self.time_constant_s)
        crept: Array | None = None

        def creep(_: float, W: Array) -> Array:
            nonlocal crept
            crept = np.tile(W, (len(forget), 1)) if crept is None else crept + forget * (W - crept)
            return np.asarray(W + share * crept.sum(0))

        return creep


@dataclass(frozen=True)
class LogarithmicCreep(Creep):
    """Creeps on with the logarithm of time: as much in each of three decades of time constants."""

    variant = "logarithmic"

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        first = spread(rng, 0.3, 1.0)
        return cls(size * sign(rng) * spread(rng, 0.002, 0.01), (first, 10 * first, 100 * first))


def clipped_level(rng: np.random.Generator, size: float, setting: Setting) -> Six:
    """Levels that cut 10 to 30 % off the largest static load in one channel or two; the range in the others."""
    chosen = channels(rng, 2) * (setting.load > 0)
    cut = (1 - min(size * spread(rng, 0.1, 0.3), 0.9)) * setting.load
    return six(np.where(chosen > 0, cut, setting.full_scale))


@dataclass(frozen=True)
class Clipping(Fault):
    """The signal, offset included, ends at a level far inside the range."""

    id = "sensor_saturation"
    variant = "clip"

    level_wrench: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(clipped_level(rng, size, setting))

    def amplify(self, machine: Machine) -> Channel | None:
        """See `Fault.amplify`."""
        level = np.array(self.level_wrench)
        return lambda _, W: np.minimum(np.maximum(W, -level), level)


@dataclass(frozen=True)
class Compression(Fault):
    """An amplifier near its end: linear up to `linear_share` of the level, from there on it approaches the level without reaching it."""

    id = "sensor_saturation"
    variant = "soft"

    level_wrench: Six
    linear_share: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """See `Fault.draw`."""
        return cls(clipped_level(rng, size, setting), float(rng.uniform(0.6, 0.9)))

    def amplify(self, machine: Machine) -> Channel | None:
        """See `Fault.amplify`."""
        level = np.array(self.level_wrench)
        straight, rest = self.linear_share * level, (1 - self.linear_share) * level

        def compress(_: float, W: Array) -> Array:
            inside = np.minimum(np.maximum(W, -straight), straight)
            return inside + rest * np.tanh((W - inside) / rest)

        return compress


SENSOR_RESPONSE: tuple[type[Fault], ...] = (
    Gain,
    TwoSidedGain,
    Crosstalk,
    RectifiedCrosstalk,
    Quadratic,
    Knee,
    PlayHysteresis,
    BoucWen,
    Creep,
    LogarithmicCreep,
    Clipping,
    Compression,
)
