"""The tool between sensor and payload is flexible and rings."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.effects.channels import shares
from core.effects.effect import Effect, Parameter
from core.effects.oscillator import oscillate, spectral_peaks
from core.effects.rigid_body import rigid_wrench
from core.effects.scene import Scene

Array = NDArray[np.float64]


class ToolFlexibility(Effect):
    """A share of each channel of the payload's wrench arrives through an oscillator: `w + diag(e) (G(s) - 1) V phi`.

    `G = w_n^2 / (s^2 + 2 zeta w_n s + w_n^2)`, so `G(0) = 1`: at rest nothing changes, so only the part that motion causes rings.
    """

    id = "tool_flexibility"
    title = "a tool that rings"
    stage = "payload"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """See `Effect.parameters`."""
        highest = min(60.0, 0.45 / scene.period)
        return (
            Parameter("frequency_hz", "Hz", min(20.0, 0.5 * highest), min(4.0, 0.2 * highest), highest, 10.0),
            Parameter("damping_ratio", "1", 0.05, 0.002, 1.0, 0.1),
            *shares("share", lower=-2.0, upper=3.0, scale=0.7),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """See `Effect.wrench`."""
        rigid = rigid_wrench(scene.motion, scene.phi)
        y, _, _ = oscillate(rigid, scene.period, theta[0], theta[1])
        return w + theta[2:] * (y - rigid)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Where the residual's spectrum has peaks, and over the plausible range."""
        frequency = self.parameters(scene)[0]
        peaks = spectral_peaks(residual, scene.period, frequency.lower, frequency.upper, 2)
        grid = [f for f in (10.0, 18.0, 30.0) if frequency.lower < f < frequency.upper] or [frequency.absent]
        return [np.array([f, 0.05, *([0.3] * 6)]) for f in (*peaks, *grid)]

    def advice(self, scene: Scene, theta: Array) -> str:
        """See `Effect.advice`."""
        return f"Stiffen the tool or smooth the motion: it rings at {theta[0]:.1f} Hz with {100 * theta[1]:.0f} % of critical damping."
