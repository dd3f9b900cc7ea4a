"""At which gear ratio a residual is periodic in the angle of a joint."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple, Self

import numpy as np

from core.array import Array
from core.effects.scene import Scene
from core.effects.window_search import weights
from core.payload.rotations import cross

COARSEST, FINEST = 10.0, 200.0
"""Gear ratios looked for."""
BANDS = np.geomspace(COARSEST, FINEST, 9)
"""Of the ratio, in each of which the same rows are slow enough to show a ripple."""
PER_CYCLE = 8
"""Bins of the angle in the shortest wave, which is half a turn of the wave generator long."""
LEAST_BINS = 1024
"""Zeros are appended up to here, so that each band has ratios of its own where a joint hardly turns."""


class Peak(NamedTuple):
    """Highest point of a periodogram: what it explains of the residual's power, and the gear ratio."""

    power: float
    ratio: float


@dataclass(frozen=True)
class RippleSearch:
    """The periodogram of a residual over one joint's angle.

    Args:
        angle, speed: (N,), rad and rad/s.
        response: (N, 6), what a ripple of 1 rad with one wave per rad does to the wrench, in deviations of the noise up to a factor.
        fastest: angular frequency above which the residual's windows show nothing, rad/s.
    """

    angle: Array
    speed: Array
    response: Array
    fastest: float

    @classmethod
    def of(cls, scene: Scene, j: int) -> Self:
        """Of joint j, as far as its acceleration shows."""
        if scene.q is None or scene.dq is None or scene.jacobian is None:
            raise ValueError("a search for gear ripple needs a scene with joints (see Effect.explain_lack)")
        linear, angular = scene.jacobian[:, :3, j], scene.jacobian[:, 3:, j]
        m, mc = scene.phi[0], scene.phi[1:4]
        torque = cross(mc, linear) + angular * np.abs(scene.phi[[4, 7, 9]])
        response = -np.hstack([m * linear + cross(angular, mc), torque]) * scene.dq[:, j, None] ** 2
        fastest = min(0.5 * np.pi / max(scene.window, 1e-9), 0.8 * np.pi / scene.period)
        return cls(scene.q[:, j], scene.dq[:, j], response * weights(scene), fastest)

    @property
    def moves(self) -> bool:
        """Whether the joint does anything to the wrench."""
        return bool(np.any(self.response))

    @cached_property
    def power(self) -> Array:
        """(N,), of the response in each row."""
        return np.asarray(np.einsum("ni,ni->n", self.response, self.response))

    def peak(self, residual: Array) -> Peak:
        """The highest peak for a residual (N, 6)."""
        per_rad = PER_CYCLE * FINEST / np.pi
        bins = ((self.angle - self.angle.min()) * per_rad).astype(int)
        size = max(LEAST_BINS, 1 << int(np.ceil(np.log2(2.0 * bins.max() + 2.0))))
        ratio = np.fft.rfftfreq(size, 1.0 / per_rad) * np.pi  # from cycles per rad: 2 N = 2 pi f
        seen = np.einsum("ni,ni->n", self.response, residual)
        best = Peak(0.0, BANDS[0])
        for low, high in pairwise(BANDS):
            visible = self._visible(float(np.sqrt(low * high)))
            inside = np.flatnonzero((ratio >= low) & (ratio < high))
            wave = np.abs(np.fft.rfft(np.bincount(bins, seen * visible, minlength=size))[inside]) ** 2
            k = int(wave.argmax())
            found = Peak(float(wave[k]) / max(float(self.power @ visible), 1e-300), float(ratio[inside[k]]))
            best = max(best, found)
        return best

    def wave(self, ratio: float, residual: Array) -> tuple[Array, Array]:
        """What of a residual (N, 6) a ripple of this ratio explains, (N, 6), and its cosine and sine (2,), scaled to 1."""
        turns = 2.0 * ratio * self.angle
        columns = np.stack([np.cos(turns), np.sin(turns)]) * self._visible(ratio)
        seen = np.einsum("ni,ni->n", self.response, residual)
        size = np.linalg.pinv((columns * self.power) @ columns.T, hermitian=True) @ (columns @ seen)
        return (size @ columns)[:, None] * self.response, np.asarray(size / max(float(np.linalg.norm(size)), 1e-300))

    def _visible(self, ratio: float) -> Array:
        """(N,), 1 where the joint turns slowly enough for its ripple to show, else 0."""
        return (np.abs(2.0 * ratio * self.speed) < self.fastest).astype(float)
