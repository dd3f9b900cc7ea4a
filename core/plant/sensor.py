"""What the virtual robot measures: wrist wrench and joint positions, with the errors that instruments have."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.cell.cell import Sensor
from core.plant.faults.fault import Channel
from core.plant.imperfections import Drift

OFFSET_FORCE_STD = 3.0
"""N; wrist sensors come with offsets of several newtons."""
OFFSET_TORQUE_STD = 0.2
"""N m."""


class WhiteNoise:
    """Rows of independent standard normal numbers, drawn in blocks (one call of the generator costs more than a row).

    Args:
        width: numbers in a row.
    """

    def __init__(self, rng: np.random.Generator, width: int, block: int = 512) -> None:
        self._rng = rng
        self._shape = (block, width)
        self._rows: Iterator[Array] = iter(())

    def row(self) -> Array:
        """(width,)."""
        row = next(self._rows, None)
        if row is None:
            self._rows = iter(self._rng.standard_normal(self._shape))
            row = next(self._rows)
        return row


class WristSensor:
    """Force/torque sensor: `reading = digitize(round(clip(amplify(sense(W)(t - delay) + offset + drift(t) + noise))))`.

    Args:
        sensor: noise, range and resolution.
        rng: draws the offset.
        delay: s.
        drift: changes of the offset.
        period: between two readings, s.
        sense, amplify, digitize: what faults make of the signal at these places, one after the other.
    """

    def __init__(
        self,
        sensor: Sensor,
        rng: np.random.Generator,
        *,
        period: float,
        delay: float = 0.0,
        drift: tuple[Drift, ...] = (),
        sense: Sequence[Channel] = (),
        amplify: Sequence[Channel] = (),
        digitize: Sequence[Channel] = (),
    ) -> None:
        self._noise_std = np.array(sensor.noise_std)
        self._range = np.array(sensor.range)
        self._resolution = np.array(sensor.resolution)
        self.offset = rng.standard_normal(6) * np.repeat([OFFSET_FORCE_STD, OFFSET_TORQUE_STD], 3)
        """(6,), N and N m."""
        self._drift = drift
        self._delay_line = DelayLine(delay / period)
        self._sense, self._amplify, self._digitize = sense, amplify, digitize

    def read(self, t: float, wrench: Array, noise: Array) -> Array:
        """One reading (6,).

        Args:
            t: s since the start.
            wrench: (6,), true, at t.
            noise: (6,), standard normal.
        """
        for felt in self._sense:
            wrench = felt(t, wrench)
        value = self._delay_line.push(wrench) + self.offset + self._noise_std * noise
        for drift in self._drift:
            value = value + drift.offset(t)
        for amplified in self._amplify:
            value = amplified(t, value)
        reading = quantize(np.minimum(np.maximum(value, -self._range), self._range), self._resolution)
        for digitized in self._digitize:
            reading = digitized(t, reading)
        return reading


class DelayLine:
    """Delays a signal by a number of samples that need not be whole; before its start the signal was constant."""

    def __init__(self, samples: float) -> None:
        if not 0 <= samples < math.inf:
            raise ValueError(f"a delay of {samples} samples; expected a finite number that is not negative")
        whole = math.floor(samples)
        self._fraction = samples - whole
        self._length = whole + 2
        self._line: deque[Array] = deque(maxlen=self._length)

    def push(self, value: Array) -> Array:
        """Takes the newest sample and gives the delayed one."""
        line = self._line
        line.append(value)
        while len(line) < self._length:
            line.append(value)
        return (1 - self._fraction) * line[1] + self._fraction * line[0]


@dataclass(frozen=True)
class EncoderReading:
    """Joint positions and velocities (n,) as the robot reports them."""

    q: Array
    dq: Array


class Encoders:
    """Joint encoders; the velocity is the difference of readings behind a first-order low-pass, as drives derive it.

    Args:
        q: (n,), position at the start, at rest.
        period: s.
        noise_std: rad.
        resolution: rad; 22 bits on the joint side.
        cut_off: of the velocity's low-pass, Hz.
    """

    def __init__(
        self,
        q: Array,
        *,
        period: float,
        noise_std: float,
        resolution: float = 2 * math.pi / 2**22,
        cut_off: float = 50.0,
    ) -> None:
        self._noise_std = noise_std
        self._resolution = resolution
        self._last = quantize(q, resolution)
        self._dq = np.zeros_like(q)
        self._gain = -math.expm1(-2 * math.pi * cut_off * period)
        self._period = period

    def read(self, q: Array, noise: Array) -> EncoderReading:
        """One reading.

        Args:
            q: (n,), true position.
            noise: (n,), standard normal.
        """
        reading = quantize(q + self._noise_std * noise, self._resolution)
        self._dq = self._dq + self._gain * ((reading - self._last) / self._period - self._dq)
        self._last = reading
        return EncoderReading(reading, self._dq)


def quantize(value: Array, step: Array | float) -> Array:
    """The nearest multiple of `step`."""
    return np.asarray(np.rint(value / step) * step)
