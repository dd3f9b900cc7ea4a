"""The wrist sensor is coarser than its figures say."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.draws import draw_log_uniform, six
from core.plant.faults.fault import Channel, Fault, Machine, Setting, Six


def coarse_step(rng: np.random.Generator, size: float, setting: Setting) -> Six:
    """4 to 20 times the stated resolution."""
    return six((1 + size * (draw_log_uniform(rng, 4.0, 20.0) - 1)) * np.array(setting.cell.sensor.resolution))


@dataclass(frozen=True)
class CoarseSteps(Fault):
    """Rounded to steps coarser than stated."""

    id = "sensor_quantization"
    variant = "rounded"

    step_wrench: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Steps of 4 to 20 times the stated resolution."""
        return cls(coarse_step(rng, size, setting))

    def digitize(self, machine: Machine) -> Channel | None:
        """Rounds each channel to its step."""
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
        """Steps of 4 to 20 times the stated resolution."""
        return cls(coarse_step(rng, size, setting))

    def digitize(self, machine: Machine) -> Channel | None:
        """Repeats a channel until it has changed by its step; all are fresh every 0.1 s."""
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
        """Gaps of 4 to 20 times the stated resolution."""
        return cls(coarse_step(rng, size, setting))

    def digitize(self, machine: Machine) -> Channel | None:
        """Moves what is in every other gap to the gap's nearer end."""
        gap = np.array(self.gap_wrench)

        def skip(_: float, W: Array) -> Array:
            place = W / gap
            whole = np.floor(place)
            odd = whole % 2 == 1
            return np.where(odd, np.rint(place) * gap, W)

        return skip


@dataclass(frozen=True)
class ShortFloat(Fault):
    """Sent as a number with few binary digits and an exponent, as half precision is: the step is a share of the power of two below the
    reading, coarse for large readings and fine for small ones."""

    id = "sensor_quantization"
    variant = "short_float"

    step_share: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Step of 1 to 6 % of the power of two below the reading."""
        return cls(size * draw_log_uniform(rng, 0.01, 0.06))

    def digitize(self, machine: Machine) -> Channel | None:
        """Rounds each channel to `step_share` times the power of two at or below its magnitude."""

        def shorten(_: float, W: Array) -> Array:
            step = np.ldexp(self.step_share, np.frexp(W)[1] - 1)
            return np.asarray(np.rint(W / step) * step)

        return shorten


SENSOR_STEPS: tuple[type[Fault], ...] = (
    CoarseSteps,
    SendOnDelta,
    MissingCodes,
    ShortFloat,
)
