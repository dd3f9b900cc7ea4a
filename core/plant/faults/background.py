"""The small imperfections that every real cell has."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import mujoco
import numpy as np

from core.array import Array
from core.plant.faults.base import tilt_gravity, tilt_of
from core.plant.faults.draws import seed_of, six
from core.plant.faults.fault import Channel, Fault, Machine, Setting, Six


@dataclass(frozen=True)
class Background(Fault):
    """A tilt of the base of 0.02 deg, gains off by 0.03 %, and a clock that jitters by 0.1 ms: for trials, in which "nothing wrong" is
    never perfectly so. The jitter is that of the wrench's instant, standard deviation; the time of a sample is exact."""

    id = "none"
    variant = "background"

    tilt_rad: tuple[float, float]
    gain_share: Six
    jitter_s: float
    seed: int

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """0.02 deg of tilt in any direction, normal gains of 0.03 % and a jitter of 0.1 ms, each times `size`."""
        return cls(tilt_of(rng, 0.02 * size), six(3e-4 * size * rng.standard_normal(6)), 1e-4 * size, seed_of(rng))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Turns gravity by `tilt_rad` in the base frame."""
        spec.option.gravity = tilt_gravity(np.array(spec.option.gravity), setting, self.tilt_rad)

    def sense(self, machine: Machine) -> Channel | None:
        """Scales each channel by its gain and shifts the wrench's instant at random, along its last change."""
        rng = np.random.default_rng(self.seed)
        gain, early = 1 + np.array(self.gain_share), self.jitter_s / machine.period
        chance: list[float] = []
        last: Array | None = None

        def jitter(_: float, W: Array) -> Array:
            nonlocal last
            if not chance:
                chance.extend((early * rng.standard_normal(512)).tolist())
            change = 0.0 if last is None else W - last
            last = W
            return gain * (W + chance.pop() * change)

        return jitter


BACKGROUND: tuple[type[Fault], ...] = (Background,)
