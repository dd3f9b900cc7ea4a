"""Loads beyond a limit are clipped: a range that is set too small, an amplifier at its end."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.effects.channels import CHANNELS, SUFFIXES, UNITS, six
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene

Array = NDArray[np.float64]

CORNER = 0.01
"""Half the width over which the limit sets in, as a share of the limit."""


class SensorSaturation(Effect):
    """`W = clip(w, -1/l, 1/u)` with a rounded corner, for each channel.

    The reciprocals are fitted: zero is no limit. Upper and lower limits differ because the sensor clips load and offset together, and `w`
    is without offset.
    """

    id = "sensor_saturation"
    title = "clipping of the sensor"
    stage = "sensor"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """See `Effect.parameters`: six upper limits, then six lower ones."""
        return tuple(
            Parameter(
                f"{channel}_{side}_limit_per_{suffix}",
                f"1/({unit})" if " " in unit else f"1/{unit}",
                0.0,
                0.0,
                float(20 * scale),
                float(scale),
            )
            for side in ("upper", "lower")
            for channel, suffix, unit, scale in zip(CHANNELS, SUFFIXES, UNITS, six(0.1, 2.0), strict=True)
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """See `Effect.wrench`."""
        W = w.copy()
        for j in range(6):
            if theta[j] > 0:
                W[:, j] = limited(W[:, j], 1 / theta[j])
            if theta[6 + j] > 0:
                W[:, j] = -limited(-W[:, j], 1 / theta[6 + j])
        return W

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """See `Effect.starts`: for each channel and side the limit whose missing load looks most like the residual."""
        w = scene.nominal
        found = [_limit_seen(side * w[:, j], side * residual[:, j]) for side in (1, -1) for j in range(6)]
        start = np.clip([limit for limit, _ in found], 0.0, [p.upper for p in self.parameters(scene)])
        best = np.zeros(12)
        k = int(np.argmax([seen for _, seen in found]))
        best[k] = start[k]
        return [start] if np.count_nonzero(start) < 2 else [start, best]

    def advice(self, scene: Scene, theta: Array) -> str:
        """See `Effect.advice`."""
        reach = np.abs(scene.nominal).max(axis=0)
        k = int((theta * np.tile(reach, 2)).argmax())
        side = "above" if k < 6 else "below"
        limit = (1 if k < 6 else -1) / max(float(theta[k]), 1e-6)
        return (
            f"Choose a larger range of the sensor or a lighter payload: {CHANNELS[k % 6]} is clipped {side} {limit:+.3g} {UNITS[k % 6]} "
            f"(without the offset), the run needs {reach[k % 6]:.3g} {UNITS[k % 6]}."
        )


def limited(x: Array, limit: float) -> Array:
    """`min(x, limit)` for a positive limit, rounded by a parabola near it."""
    d = CORNER * limit
    inside = np.clip(x - limit + d, 0.0, 2 * d)
    return np.asarray(np.minimum(x, limit + d) - inside**2 / (4 * d))


def _limit_seen(x: Array, residual: Array) -> tuple[float, float]:
    """One over the upper limit at which the load that would be missing looks most like the residual, and the chi-square that it explains.

    Constant and gain are taken out of both, since offset and payload take them up. Zero limit where nothing is seen (below 5 sigma).
    """
    top = float(x.max())
    if top <= 0 or np.ptp(x) == 0:
        return 0.0, 0.0
    nuisance, _ = np.linalg.qr(np.column_stack([np.ones_like(x), x]))
    r = residual - nuisance @ (nuisance.T @ residual)
    best = (0.0, 25.0)
    for limit in top * np.linspace(0.08, 0.98, 24):
        missing = limited(x, limit) - x
        missing -= nuisance @ (nuisance.T @ missing)
        along, size = float(missing @ r), float(missing @ missing)
        if along > 0 and size > 0 and along**2 / size > best[1]:
            best = (1 / limit, along**2 / size)
    return best if best[0] else (0.0, 0.0)
