"""The offset wanders more slowly than any hold shows: its steps are as large where gravity stays in the sensor as where it turns."""

from __future__ import annotations

import numpy as np

from core.array import Array, interpolate
from core.effects.drift_that_wanders import CHANGES, KNOTS, DriftThatWanders, find_spacing
from core.effects.scene import Scene
from core.effects.sensor_drift import SensorDrift
from core.effects.window_search import ROWS, columns_of_payload_and_offsets

MOST = 0.7
"""Share of the residual's square that a walk has to explain."""
AS_LARGE = 0.55
"""Steps of a walk where gravity stays, the third of them in which it turns least, against the third in which it turns most, root mean
squares; of what depends on the attitude they are less than 0.4."""
LESS = 0.75
"""Times as far it has to turn in those as in these at most, or there is nothing to compare with."""
RIDGE = 1e-6
"""Of steps that no row shows."""


class DriftInAnyAttitude(DriftThatWanders):
    """The walk of `DriftThatWanders` where no hold is long enough to show it. It can take up whatever is slow, so it is a last resort."""

    last_resort = True

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Without a walk; nothing where the residual depends on how gravity lies."""
        if not wanders_in_any_attitude(scene, residual):
            return []
        return [np.concatenate((start, np.zeros(CHANGES))) for start in SensorDrift().starts(scene, residual)[:1]]


def wanders_in_any_attitude(scene: Scene, residual: Array) -> bool:
    """Whether a walk beside payload and offsets explains most of residuals (N, 6), in standard deviations of the noise, and its steps are
    about as large where gravity stays in the sensor as where it turns."""
    if scene.apart or len(residual) < 8 * KNOTS:
        return False
    rows = slice(0, None, max(1, len(scene) // ROWS))
    at, wanted = np.linspace(0.0, KNOTS * find_spacing(scene), KNOTS + 1), residual[rows]
    ramps = np.clip((scene.elapsed[rows, None] - at[:-1]) / at[1], 0.0, 1.0)
    steps, share = _fit_walk(ramps, wanted, np.linalg.qr(columns_of_payload_and_offsets(scene, rows).reshape(wanted.size, -1))[0])
    g = interpolate(at, scene.elapsed, scene.motion.g)
    turns = np.linalg.norm(np.diff(g, axis=0), axis=1)[at[:-1] < scene.elapsed[-1]]
    order, third = np.argsort(turns), len(turns) // 3
    still, turning = (float(np.square(steps[some]).mean()) for some in (order[:third], order[-third:]))
    return bool(share > MOST and still > AS_LARGE**2 * turning and turns[order[third]] < LESS * turns[order[-third]])


def _fit_walk(ramps: Array, wanted: Array, Q: Array) -> tuple[Array, float]:
    """(KNOTS, 6), steps of each channel by least squares beside what Q takes up, and the share of `wanted` (n, 6) that they explain."""
    n = ramps.shape[1]
    rest = (wanted.ravel() - Q @ (Q.T @ wanted.ravel())).reshape(wanted.shape)
    taken = np.einsum("rk,rcq->ckq", ramps, Q.reshape(*wanted.shape, -1)).reshape(6 * n, -1)
    normal = np.kron(np.eye(6), ramps.T @ ramps) - taken @ taken.T
    along = (ramps.T @ rest).T.ravel()
    steps = np.linalg.solve(normal + RIDGE * np.trace(normal) / len(normal) * np.eye(len(normal)), along)
    return steps.reshape(6, n).T, float(steps @ along) / max(float(np.square(rest).sum()), 1e-300)
