"""The wrist sensor's signal ends before its range does."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.payload.rotations import skew
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


def load_beams(arm_m: float) -> Array:
    """(6, 6), from a wrench to the loads at the ends of three beams that carry the sensor's face, a third of a turn apart and `arm_m` from
    its axis: those along the axis first, then those round it, N."""
    angle = 2 * np.pi / 3 * np.arange(3)
    c, s, zero, one = np.cos(angle), np.sin(angle), np.zeros(3), np.ones(3)
    along = np.column_stack((zero, zero, one, 2 * s / arm_m, -2 * c / arm_m, zero))
    around = np.column_stack((-2 * s, 2 * c, zero, zero, zero, one / arm_m))
    return np.vstack((along, around)) / 3


@dataclass(frozen=True)
class GaugeClipping(Fault):
    """Not a channel ends early but a gauge. The six channels are computed from the bridges on three beams: where one of these is at its
    end, all channels in which it counts are wrong together."""

    id = "sensor_saturation"
    variant = "gauge"

    level_n: Six
    """Of the beams' loads, as `load_beams` has them."""
    arm_m: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Levels that cut 10 to 30 % off the largest static load of one gauge or two; beams 2 to 4 cm from the axis."""
        arm = float(rng.uniform(0.02, 0.04))
        beams = load_beams(arm)
        weight = setting.load[0] * np.vstack((np.eye(3), skew(setting.payload.com)))
        largest = np.linalg.norm(beams @ weight, axis=1)
        chosen = channels(rng, 2) * (largest > 0)
        cut = (1 - min(size * draw_log_uniform(rng, 0.1, 0.3), 0.9)) * largest
        return cls(six(np.where(chosen > 0, cut, np.abs(beams) @ setting.full_scale)), arm)

    def amplify(self, machine: Machine) -> Channel | None:
        """Clips the loads of the beams at their levels, on either side, and computes the channels from what is left."""
        level, beams = np.array(self.level_n), load_beams(self.arm_m)
        back = np.linalg.inv(beams)

        def clip(_: float, W: Array) -> Array:
            load = beams @ W
            return np.asarray(W - back @ (load - np.minimum(np.maximum(load, -level), level)))

        return clip


SENSOR_SATURATION: tuple[type[Fault], ...] = (
    Clipping,
    Compression,
    GaugeClipping,
)
