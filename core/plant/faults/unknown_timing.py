"""Channels that do not run together, in a way that has no name in the table of effects."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from core.array import Array
from core.plant.faults.draws import channels, draw_signed_log_uniform, six
from core.plant.faults.fault import Channel, Fault, Machine, Setting, Six, Unknown
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


UNKNOWN_TIMING: tuple[type[Fault], ...] = (SkewedChannels,)
