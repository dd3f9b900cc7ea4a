"""Channels that do not run together, in a way that has no name in the table of effects."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.draws import channels, draw_log_uniform, draw_signed_log_uniform, six
from core.plant.faults.fault import Channel, Fault, Machine, Setting, Six, Unknown
from core.plant.faults.grip import cross_vectors
from core.plant.faults.history import History


@dataclass(frozen=True)
class SkewedChannels(Unknown):
    """The sensor's channels are converted one after the other by a slow multiplexer: one to three of them are late by 10 to 50 ms each, the
    others are not."""

    variant = "skewed_channels"

    late_s: Six

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """10 to 50 ms in one to three channels."""
        return cls(six(size * channels(rng, 3) * np.abs(draw_signed_log_uniform(rng, 0.01, 0.05, 6))))

    def sense(self, machine: Machine) -> Channel | None:
        """Each channel of its own delay before."""
        history = History(max(self.late_s), machine.period)
        late = [c for c in range(6) if self.late_s[c] > 0]

        def skew(_: float, W: Array) -> Array:
            history.push(W)
            W = W.copy()
            for c in late:
                W[c] = history.ago(self.late_s[c])[c]
            return W

        return skew


@dataclass(frozen=True)
class StaleTransform(Unknown):
    """The controller reports the wrench in the axes of the cell and about its origin, with the pose of some cycles ago; who reads it brings
    it back with the pose of now. Neither wrench nor joints are late, and at rest all is well; in motion the wrench is turned by how far the
    sensor has turned meanwhile, and its torque is about the place where the sensor was."""

    variant = "stale_transform"

    stale_s: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """4 to 40 ms."""
        return cls(size * draw_log_uniform(rng, 0.004, 0.04))

    def sense(self, machine: Machine) -> Channel | None:
        """Takes the wrench to the world with the sensor's pose of `stale_s` before and back with that of now."""
        site = int(machine.model.site("ft").id)
        axes, place = machine.data.site_xmat[site], machine.data.site_xpos[site]
        history = History(self.stale_s, machine.period)

        def report(_: float, W: Array) -> Array:
            history.push(np.concatenate((axes, place)))
            pose = history.ago(self.stale_s)
            then, now = pose[:9].reshape(3, 3), axes.reshape(3, 3)
            force = then @ W[:3]
            torque = then @ W[3:] + cross_vectors(pose[9:] - place, force)
            return np.concatenate((now.T @ force, now.T @ torque))

        return report


UNKNOWN_TIMING: tuple[type[Fault], ...] = (
    SkewedChannels,
    StaleTransform,
)
