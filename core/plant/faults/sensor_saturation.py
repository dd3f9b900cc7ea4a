"""The wrist sensor's signal ends before its range does."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.draws import channels, draw_log_uniform, six
from core.plant.faults.fault import Channel, Fault, Machine, Setting, Six


def draw_clipping_level(rng: np.random.Generator, size: float, setting: Setting) -> Six:
    """Levels that cut 10 to 30 % off the largest static load in one channel or two; the range in the others."""
    chosen = channels(rng, 2) * (setting.load > 0)
    cut = (1 - min(size * draw_log_uniform(rng, 0.1, 0.3), 0.9)) * setting.load
    return six(np.where(chosen > 0, cut, setting.full_scale))


@dataclass(frozen=True)
class Clipping(Fault):
    """The signal, offset included, ends at a level far inside the range."""

    id = "sensor_saturation"
    variant = "clip"

    level_wrench: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Levels that cut 10 to 30 % off the largest static load in one channel or two."""
        return cls(draw_clipping_level(rng, size, setting))

    def amplify(self, machine: Machine) -> Channel | None:
        """Clips each channel at its level, on either side."""
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
        """Levels that cut 10 to 30 % off the largest static load in one channel or two, linear up to 60 to 90 % of them."""
        return cls(draw_clipping_level(rng, size, setting), float(rng.uniform(0.6, 0.9)))

    def amplify(self, machine: Machine) -> Channel | None:
        """Bends what is beyond `linear_share` of the level by a tanh, so that it stays below the level."""
        level = np.array(self.level_wrench)
        straight, rest = self.linear_share * level, (1 - self.linear_share) * level

        def compress(_: float, W: Array) -> Array:
            inside = np.minimum(np.maximum(W, -straight), straight)
            return inside + rest * np.tanh((W - inside) / rest)

        return compress


SENSOR_SATURATION: tuple[type[Fault], ...] = (
    Clipping,
    Compression,
)
