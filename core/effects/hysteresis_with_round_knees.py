"""Loops whose knees are round, and that began before the run: with the sensor unloaded, or nearer to the run's first load."""

from __future__ import annotations

import numpy as np
from numba import njit

from core.array import Array
from core.effects.channels import full_scale
from core.effects.effect import Parameter
from core.effects.scene import Scene
from core.effects.sensor_hysteresis import SPREAD, SensorHysteresis

BEGINNINGS = ((0.0, 0.0), (1.0, 0.5))
"""Where the loops begin, as a share of the first load, and how round they are, from which fits start."""
SETTLED_S, LEAST_S = 0.3, 0.5
"""Of a hold, that is left out at its beginning, and that has to be left."""
GOES_ON = 0.15
"""Of the residual's size, that it may change by within a hold: what creeps does so while the load rests, and no loop."""


class HysteresisWithRoundKnees(SensorHysteresis):
    """`W = w - h FS ((1 - m) z + m y)`: z the three stops, y the mean of three elements `y' = (w' - |w'| y) / R`, of the same R, which bend
    from each turning point on and do not close small loops (Bouc-Wen with n = 1 and gamma = 0; Dahl 1968; endochronic, Valanis 1971).

    All begin without anything held back at the share b of the run's first load: 0 where the sensor was unloaded before, as after mounting.
    """

    wider_shape = True
    followed = 2

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Those of the hysteresis, then b and m."""
        return (
            *super().parameters(scene),
            Parameter("loop_start_share", "1", 1.0, 0.0, 1.0, 0.5),
            Parameter("loop_roundness_share", "1", 0.0, 0.0, 1.0, 0.5),
        )

    def smaller_shape(self, scene: Scene) -> int:
        """Loops as before that began elsewhere."""
        del scene
        return 14

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` less what is held back."""
        full = full_scale(scene, w)
        radius = np.exp(theta[6:12] + theta[12] * SPREAD[:, None]) * full
        past = scene.past("loops")
        if past.rows is None:  # where the stops' plays are, what the round ones hold back, and the load
            past.rows = np.concatenate((np.tile(theta[13] * w[0], (len(SPREAD), 1)), np.zeros_like(radius), theta[13] * w[:1]))
        W, past.rows = _bend(np.ascontiguousarray(w), theta[:6] * full, radius, theta[14], past.rows)
        return np.asarray(W)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Loops without height as before, sharp ones that began unloaded and round ones; none where the reading goes on while it rests."""
        if _goes_on_at_rest(scene, residual):
            return []
        return [np.concatenate((start, beginning)) for start in super().starts(scene, residual) for beginning in BEGINNINGS]


def _goes_on_at_rest(scene: Scene, residual: Array) -> bool:
    """Whether a residual (N, 6) changes much within the holds, from the mean of their first third to that of their last."""
    changes = []
    for rows in np.split(np.arange(len(scene)), np.flatnonzero(scene.phase[1:] != scene.phase[:-1]) + 1):
        inside = residual[rows[round(SETTLED_S / scene.period) :]]
        if str(scene.phase[rows[0]]).startswith("hold") and len(inside) * scene.period >= LEAST_S:
            third = len(inside) // 3
            changes.append(inside[-third:].mean(axis=0) - inside[:third].mean(axis=0))
    return bool(changes) and np.square(changes).mean(axis=0).sum() > GOES_ON**2 * np.square(residual).mean(axis=0).sum()


@njit(cache=True)
def _bend(w: Array, height: Array, radius: Array, roundness: float, before: Array) -> tuple[Array, Array]:
    """`w` (N, 6) less `height` times the mean of stops and of round elements of `radius` (n, 6), that share of these; and where they end,
    (2 n + 1, 6)."""
    out, at, n = np.empty_like(w), before.copy(), len(radius)
    for k in range(len(w)):
        for c in range(w.shape[1]):
            x, way, sharp, bent = w[k, c], w[k, c] - at[2 * n, c], 0.0, 0.0
            at[2 * n, c] = x
            for s in range(n):
                R = radius[s, c]
                at[s, c] = max(x - R, min(x + R, at[s, c]))
                sharp += (x - at[s, c]) / R
                kept = np.exp(-abs(way) / R)
                at[n + s, c] = kept * at[n + s, c] + (1.0 - kept) * np.sign(way)
                bent += at[n + s, c]
            out[k, c] = x - height[c] * ((1.0 - roundness) * sharp + roundness * bent) / n
    return out, at
