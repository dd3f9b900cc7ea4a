"""The wrist sensor smooths what it reports."""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.draws import draw_log_uniform, six
from core.plant.faults.fault import Channel, Fault, Machine, Setting, Six


@dataclass(frozen=True)
class FirstOrderFilter(Fault):
    """An analogue low-pass of first order before the noise of the converter; 2 to 20 Hz."""

    id = "sensor_lowpass"
    variant = "first_order"

    cut_off_hz: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Cut-off of 2 to 20 Hz; a larger size is a lower one."""
        return cls(draw_log_uniform(rng, 2.0, 20.0) / size)

    def sense(self, machine: Machine) -> Channel | None:
        """Low-pass of first order, at rest with the first wrench."""
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
        """Cut-off of 2 to 20 Hz; a larger size is a lower one."""
        return cls(draw_log_uniform(rng, 2.0, 20.0) / size)

    def sense(self, machine: Machine) -> Channel | None:
        """The bilinear transform with its cut-off prewarped; None where that is above 0.45 of the sample rate."""
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
        """Window that has a cut-off of 2 to 20 Hz, s."""
        return cls(size * 0.443 / draw_log_uniform(rng, 2.0, 20.0))

    def amplify(self, machine: Machine) -> Channel | None:
        """Mean over the window, whole samples, full of the first reading to begin with."""
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
class WeighingFilter(Fault):
    """The digital filter of scales: heavy while the reading is nearly still, and the faster the farther the signal has gone away, a first
    order with the cut-off `f (1 + |W - y| / opening)` in each channel, noise included; f 2 to 20 Hz."""

    id = "sensor_lowpass"
    variant = "weighing"

    cut_off_hz: float
    opening_wrench: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Cut-off of 2 to 20 Hz, lower for a larger size; opens over 3 to 20 % of the nominal load."""
        opening = rng.uniform(0.03, 0.2) * np.maximum(setting.load, 1e-3 * setting.full_scale)
        return cls(draw_log_uniform(rng, 2.0, 20.0) / size, six(opening))

    def amplify(self, machine: Machine) -> Channel | None:
        """Low-pass of first order with the cut-off `f (1 + |W - y| / opening)` in each channel, y its last output."""
        opening, per_hz = np.array(self.opening_wrench), -2 * math.pi * machine.period
        y: Array | None = None

        def smooth(_: float, W: Array) -> Array:
            nonlocal y
            if y is None:
                y = W
            away = W - y
            y = y - np.expm1(per_hz * self.cut_off_hz * (1 + np.abs(away) / opening)) * away
            return y

        return smooth


@dataclass(frozen=True)
class AgedCapacitor(Fault):
    """An analogue low-pass whose capacitor has dried out: its own resistance lets a share of what is fast pass, and the rest comes behind
    as through a first order; 2 to 20 Hz."""

    id = "sensor_lowpass"
    variant = "aged_capacitor"

    cut_off_hz: float
    direct_share: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Cut-off of 2 to 20 Hz, lower for a larger size; 20 to 50 % pass at once."""
        return cls(draw_log_uniform(rng, 2.0, 20.0) / size, float(rng.uniform(0.2, 0.5)))

    def sense(self, machine: Machine) -> Channel | None:
        """`direct W + (1 - direct) y`, y a low-pass of first order, at rest with the first wrench."""
        gain, direct = -math.expm1(-2 * math.pi * self.cut_off_hz * machine.period), self.direct_share
        y: Array | None = None

        def smooth(_: float, W: Array) -> Array:
            nonlocal y
            y = W if y is None else y + gain * (W - y)
            return direct * W + (1 - direct) * y

        return smooth


LOWPASS: tuple[type[Fault], ...] = (
    FirstOrderFilter,
    Butterworth,
    MovingAverage,
    WeighingFilter,
    AgedCapacitor,
)
