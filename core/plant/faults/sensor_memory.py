"""What the wrist sensor reads depends on the loads before."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.draws import channels, draw_log_uniform, draw_signed_log_uniform, sign, six
from core.plant.faults.fault import Channel, Fault, Machine, Setting, Six

CONTACTS = 16
"""Enough for a smooth loop."""


@dataclass(frozen=True)
class PlayHysteresis(Fault):
    """Comes back on another line than it went: what is lost in a play of 0.1 to 0.4 % of the range to either side."""

    id = "sensor_hysteresis"
    variant = "play"

    half_width_wrench: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.1 to 0.4 % of the range in one channel or several."""
        return cls(six(size * channels(rng) * np.abs(draw_signed_log_uniform(rng, 0.001, 0.004, 6)) * setting.full_scale))

    def sense(self, machine: Machine) -> Channel | None:
        """The play operator in each channel, `half_width_wrench` to either side; starts at the first wrench."""
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
        """0.1 to 0.4 % of the range with either sign in one channel or several, yielding at 5 to 30 % of the nominal load."""
        height = size * channels(rng) * draw_signed_log_uniform(rng, 0.001, 0.004, 6) * setting.full_scale
        width = rng.uniform(0.05, 0.3) * np.maximum(setting.load, 1e-3 * setting.full_scale)
        return cls(six(height), six(width), float(rng.uniform(0.5, 0.9)), float(rng.uniform(1.0, 2.0)))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `h z`, with z summed up from sample to sample and kept between -1 and 1; zero at the start."""
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
        """0.2 to 1 % with either sign, one time constant of 3 to 30 s."""
        return cls(size * sign(rng) * draw_log_uniform(rng, 0.002, 0.01), (draw_log_uniform(rng, 3.0, 30.0),))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `creep_share` times the mean of what the time constants' low-passes make of the wrench."""
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
        """0.2 to 1 % with either sign; time constants of 0.3 to 1 s and of ten and a hundred times that."""
        first = draw_log_uniform(rng, 0.3, 1.0)
        return cls(size * sign(rng) * draw_log_uniform(rng, 0.002, 0.01), (first, 10 * first, 100 * first))


@dataclass(frozen=True)
class StickAndSnap(Fault):
    """A clamped joint beside the beams sticks and holds back a share of each change of the load, until that is `half_width`; then it
    slips as a whole, and nothing is left of it (the slip jump of sticking valves, Choudhury et al. 2005): a sawtooth, no loop."""

    id = "sensor_hysteresis"
    variant = "stick_and_snap"

    half_width_wrench: Six
    stuck_share: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.1 to 0.4 % of the range in one channel or several, of which 10 to 40 % of each change is held back."""
        half = size * channels(rng) * np.abs(draw_signed_log_uniform(rng, 0.001, 0.004, 6)) * setting.full_scale
        return cls(six(half), float(rng.uniform(0.1, 0.4)))

    def sense(self, machine: Machine) -> Channel | None:
        """Takes `stuck_share (W - W_stuck)` off; a channel slips, W_stuck = W, where that is above `half_width_wrench`."""
        half, share = np.array(self.half_width_wrench), self.stuck_share
        stuck_at: Array | None = None

        def stick(_: float, W: Array) -> Array:
            nonlocal stuck_at
            stuck_at = W if stuck_at is None else np.where(share * np.abs(W - stuck_at) > half, W, stuck_at)
            return W - share * (W - stuck_at)

        return stick


@dataclass(frozen=True)
class Microslip(Fault):
    """Many small dry contacts in the sensor's bolted faces, each of which slips at a load of its own (Iwan 1966): no width for small
    changes, and one that grows with the square of larger ones, until all slip."""

    id = "sensor_hysteresis"
    variant = "microslip"

    height_wrench: Six
    widest_wrench: Six
    """The change, from the middle, after which the last contact slips."""

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.1 to 0.4 % of the range in one channel or several, all slipping after 50 to 100 % of the nominal load."""
        height = size * channels(rng) * np.abs(draw_signed_log_uniform(rng, 0.001, 0.004, 6)) * setting.full_scale
        widest = rng.uniform(0.5, 1.0) * np.maximum(setting.load, 1e-3 * setting.full_scale)
        return cls(six(height), six(np.maximum(widest, 4 * height)))

    def sense(self, machine: Machine) -> Channel | None:
        """Takes `2 h / w` times the mean of what plays of all widths up to w hold back off each channel; starts at the first wrench."""
        widest = np.array(self.widest_wrench)
        half = np.outer((np.arange(CONTACTS) + 0.5) / CONTACTS, widest)
        held_back = 2 * np.array(self.height_wrench) / widest
        behind: Array | None = None

        def slip(_: float, W: Array) -> Array:
            nonlocal behind
            behind = np.tile(W, (CONTACTS, 1)) if behind is None else np.minimum(np.maximum(behind, W - half), W + half)
            return np.asarray(W - held_back * (W - behind.mean(0)))

        return slip


@dataclass(frozen=True)
class SlowRecovery(Fault):
    """An adhesive that flows under load and comes back more slowly when it is taken off: creep with one time constant where it grows, and
    with another where it goes back."""

    id = "sensor_creep"
    variant = "slow_recovery"

    creep_share: float
    time_constant_s: float
    recovery_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.2 to 1 % with either sign, time constant of 2 to 12 s, three to eight times as long for the way back."""
        flow = draw_log_uniform(rng, 2.0, 12.0)
        return cls(size * sign(rng) * draw_log_uniform(rng, 0.002, 0.01), flow, flow * float(rng.uniform(3.0, 8.0)))

    def sense(self, machine: Machine) -> Channel | None:
        """Adds `creep_share` times what follows the wrench, away from zero with one time constant and towards it with the other."""
        flow, recover = (-np.expm1(-machine.period / tau) for tau in (self.time_constant_s, self.recovery_s))
        crept: Array | None = None

        def creep(_: float, W: Array) -> Array:
            nonlocal crept
            crept = W if crept is None else crept + np.where(crept * (W - crept) >= 0, flow, recover) * (W - crept)
            return np.asarray(W + self.creep_share * crept)

        return creep


SENSOR_MEMORY: tuple[type[Fault], ...] = (
    PlayHysteresis,
    BoucWen,
    Creep,
    LogarithmicCreep,
    StickAndSnap,
    Microslip,
    SlowRecovery,
)
