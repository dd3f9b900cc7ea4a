"""The wrist sensor answers to a load in another way than it should, whatever the load was before."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.draws import channels, draw_log_uniform, draw_signed_log_uniform, moment, sign, six
from core.plant.faults.fault import Channel, Fault, Machine, Setting, Six

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
        coupled[shown, source] = sign(rng) * draw_log_uniform(rng, low, high) * full[shown] / full[source]
    return matrix_of(coupled)


@dataclass(frozen=True)
class Gain(Fault):
    """Channels read too much or too little by 1 to 5 %."""

    id = "sensor_gain"
    variant = "linear"

    gain_share: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 5 % with either sign in one channel or several."""
        return cls(six(size * channels(rng) * draw_signed_log_uniform(rng, 0.01, 0.05, 6)))

    def sense(self, machine: Machine) -> Channel | None:
        """Multiplies each channel by `1 + gain_share`."""
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
        """1 to 5 % with either sign where loads are positive, 0.2 to 0.8 of that where negative, in one channel or several."""
        chosen = size * channels(rng) * draw_signed_log_uniform(rng, 0.01, 0.05, 6)
        return cls(six(chosen), six(chosen * rng.uniform(0.2, 0.8, 6)))

    def sense(self, machine: Machine) -> Channel | None:
        """Multiplies each channel by one plus the share of its load's sign."""
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
        """Each of one channel or several shows in another one, by 1 to 3 % of the ranges."""
        return cls(matrix_of(size * np.array(coupling(rng, 0.01, 0.03, setting))))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `coupling W`."""
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
        """Each of one channel or several shows in another one, by 1 to 3 % of the ranges."""
        return cls(matrix_of(size * np.array(coupling(rng, 0.01, 0.03, setting))))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `coupling |W|`."""
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
        """0.5 to 2 % at full range with either sign, in one channel or several."""
        return cls(six(size * channels(rng) * draw_signed_log_uniform(rng, 0.005, 0.02, 6)))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `e W |W| / range`."""
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
        """Slope off by 1 to 4 % with either sign in one channel or several, beyond 30 to 60 % of the nominal load."""
        return cls(six(rng.uniform(0.3, 0.6) * setting.load), six(size * channels(rng) * draw_signed_log_uniform(rng, 0.01, 0.04, 6)))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `slope` times what is beyond the knee, on either side."""
        knee, slope = np.array(self.knee_wrench), np.array(self.slope_share)
        return lambda _, W: W + slope * (W - np.minimum(np.maximum(W, -knee), knee))


@dataclass(frozen=True)
class WanderingSupply(Fault):
    """The bridge's supply is off, and goes up and down with a slow cycle (a charger, a heater on the same line): gains are off by
    `gain (1 + swing sin(2 pi t / cycle + phase))`, and the offset takes part in it."""

    id = "sensor_gain"
    variant = "wandering_supply"

    gain_share: Six
    swing_share: float
    cycle_s: float
    phase_rad: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 5 % with either sign in one channel or several, swinging by 40 to 80 % of it every 15 to 60 s."""
        gain = six(size * channels(rng) * draw_signed_log_uniform(rng, 0.01, 0.05, 6))
        return cls(gain, float(rng.uniform(0.4, 0.8)), draw_log_uniform(rng, 15.0, 60.0), float(rng.uniform(0, 2 * np.pi)))

    def amplify(self, machine: Machine) -> Channel | None:
        """Multiplies each channel by `1 + gain (1 + swing sin(2 pi t / cycle + phase))`, offset and noise included."""
        gain, omega = np.array(self.gain_share), 2 * math.pi / self.cycle_s
        return lambda t, W: W + gain * (1 + self.swing_share * math.sin(omega * t + self.phase_rad)) * W


@dataclass(frozen=True)
class WarmingSupply(Fault):
    """The supply of the bridge sags as it warms up: all channels lose the same share with time, offset or not."""

    id = "sensor_gain"
    variant = "warming_supply"

    share: float
    time_constant_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 5 % with either sign, time constant of 0.2 to 1 of the run."""
        return cls(size * sign(rng) * draw_log_uniform(rng, 0.01, 0.05), setting.seconds * draw_log_uniform(rng, 0.2, 1.0))

    def amplify(self, machine: Machine) -> Channel | None:
        """Multiplies all channels by `1 - share (1 - exp(-t / tau))`, offset and noise included."""
        return lambda t, W: (1 + self.share * math.expm1(-t / self.time_constant_s)) * W


@dataclass(frozen=True)
class ProductCrosstalk(Fault):
    """The product of two channels shows in a third, as beams do that bend so far that their lever changes: the cross products in the
    calibration matrices of wind tunnel balances (AIAA R-091). 1 to 3 % of the range, with the nominal load in the second channel."""

    id = "sensor_crosstalk"
    variant = "product"

    shown: tuple[int, ...]
    first: tuple[int, ...]
    second: tuple[int, ...]
    per_product: tuple[float, ...]
    """Units of the channel where it shows per unit of the first and of the second."""

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """One to three products of two channels in a third: 1 to 3 % of its range at the first's range and the second's nominal load."""
        full, load = setting.full_scale, np.maximum(setting.load, 1e-3 * setting.full_scale)
        triples = [rng.permutation(6)[:3] for _ in range(int(rng.integers(1, 4)))]
        products = [sign(rng) * size * draw_log_uniform(rng, 0.01, 0.03) * full[i] / full[j] / load[k] for i, j, k in triples]
        shown, first, second = (tuple(int(triple[place]) for triple in triples) for place in range(3))
        return cls(shown, first, second, tuple(map(float, products)))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds each product, times `per_product`, to the channel where it shows."""
        first, second = list(self.first), list(self.second)
        rows = np.zeros((6, len(self.shown)))
        rows[list(self.shown), range(len(self.shown))] = self.per_product
        return lambda _, W: W + rows @ (W[first] * W[second])


@dataclass(frozen=True)
class Bow(Fault):
    """Right without load and at the weight that it was calibrated with, off in between, and the other way beyond:
    `W + e w sin(pi W / w)`, w near the nominal load."""

    id = "sensor_nonlinearity"
    variant = "bow"

    bow_share: Six
    calibrated_wrench: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.5 to 2 % with either sign in one channel or several, right at 0.7 to 1.5 times the nominal load."""
        weight = rng.uniform(0.7, 1.5) * np.maximum(setting.load, 1e-3 * setting.full_scale)
        return cls(six(size * channels(rng) * draw_signed_log_uniform(rng, 0.005, 0.02, 6)), six(weight))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `e w sin(pi W / w)`."""
        weight = np.array(self.calibrated_wrench)
        height = np.array(self.bow_share) * weight
        return lambda _, W: W + height * np.sin(np.pi * W / weight)


@dataclass(frozen=True)
class LostGauge(Fault):
    """One of the gauges of a bridge comes off its beam in the middle of the run: right before, and too little by 1 to 5 % from then on."""

    id = "sensor_gain"
    variant = "lost_gauge"

    gain_share: Six
    at_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """1 to 5 % less in one channel or several, from a time on that is well inside the run."""
        return cls(six(-size * channels(rng) * np.abs(draw_signed_log_uniform(rng, 0.01, 0.05, 6))), moment(rng, setting))

    def sense(self, machine: Machine) -> Channel | None:
        """Multiplies each channel by `1 + gain_share` from `at_s` on."""
        gain = 1 + np.array(self.gain_share)
        return lambda t, W: gain * W if t >= self.at_s else W


@dataclass(frozen=True)
class FadingCrosstalk(Fault):
    """What changes in a channel shows in others and fades there, as charge does on piezo plates that stand askew: a load that stays shows
    in none but its own."""

    id = "sensor_crosstalk"
    variant = "fading"

    coupling: SixBySix
    time_constant_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Each of one channel or several shows in another one, by 1 to 3 % of the ranges, and fades within 2 to 20 s."""
        return cls(matrix_of(size * np.array(coupling(rng, 0.01, 0.03, setting))), draw_log_uniform(rng, 2.0, 20.0))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `coupling (W - faded)`, `faded` following W with the time constant; loaded for long before the start."""
        coupled, forget = np.array(self.coupling), -math.expm1(-machine.period / self.time_constant_s)
        faded: Array | None = None

        def show(_: float, W: Array) -> Array:
            nonlocal faded
            faded = W if faded is None else faded + forget * (W - faded)
            return np.asarray(W + coupled @ (W - faded))

        return show


@dataclass(frozen=True)
class Shunt(Fault):
    """A cover beside the beams carries a share of small loads, and no more than so much of large ones: `W - h tanh(W / w)`."""

    id = "sensor_nonlinearity"
    variant = "shunt"

    height_wrench: Six
    width_wrench: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.5 to 2 % of the nominal load in one channel or several, nearly reached at 10 to 30 % of that load."""
        load = np.maximum(setting.load, 1e-3 * setting.full_scale)
        height = size * channels(rng) * np.abs(draw_signed_log_uniform(rng, 0.005, 0.02, 6)) * load
        return cls(six(height), six(rng.uniform(0.1, 0.3) * load))

    def sense(self, machine: Machine) -> Channel | None:
        """Takes `h tanh(W / w)` off each channel."""
        height, width = np.array(self.height_wrench), np.array(self.width_wrench)
        return lambda _, W: W - height * np.tanh(W / width)


SENSOR_RESPONSE: tuple[type[Fault], ...] = (
    Gain,
    TwoSidedGain,
    Crosstalk,
    RectifiedCrosstalk,
    Quadratic,
    Knee,
    WanderingSupply,
    WarmingSupply,
    ProductCrosstalk,
    Bow,
    LostGauge,
    FadingCrosstalk,
    Shunt,
)
