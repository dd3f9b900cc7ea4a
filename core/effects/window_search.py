"""When something began (and ended): the windows of time in which given columns explain most of a residual."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.effects.scene import Scene
from core.inertia import regressor

Array = NDArray[np.float64]

LEVER = 0.05
"""Noise of torque over noise of force for common wrist sensors, m; used where the sensor's description does not say."""
ROWS = 1500
"""The search looks at no more rows than about this many."""


def weights(scene: Scene) -> Array:
    """(6,), one over the sensor's noise up to a common factor."""
    for described in (scene.resolution, scene.range):
        if described is not None and (described > 0).all():
            return np.asarray(described[0] / described)
    return np.array([1.0, 1.0, 1.0, *[1.0 / LEVER] * 3])


def best_windows(scene: Scene, residual: Array, columns: Array, count: int, *, open_end: bool) -> list[tuple[float, float]]:
    """Windows in which the columns are switched on, best first, no two of them close to each other.

    Payload and offsets are fitted along with the columns, so a change that they would take up does not count.

    Args:
        residual: (N, 6), measured minus predicted with payload and offsets fitted, in standard deviations of the noise.
        columns: (N, 6, k), N and N m.
        count: at most this many.
        open_end: windows last to the end of the recording (steps).

    Returns:
        Beginnings and ends, s.
    """
    step = max(1, len(scene) // ROWS)
    t = scene.t[::step]
    scale = weights(scene)
    X = (columns[::step] * scale[:, None]).transpose(0, 2, 1)
    k = X.shape[1]
    offsets = np.broadcast_to(np.eye(6), (len(t), 6, 6))
    Z = np.concatenate([regressor(scene.motion[::step]) * scale[:, None], offsets], axis=2).transpose(0, 2, 1)
    r = residual[::step]
    grid = np.unique(np.linspace(0, len(t), 150 if open_end else 60).astype(int))
    XX, XZ, Xr = (_integrals(part, grid) for part in (X @ X.transpose(0, 2, 1), X @ Z.transpose(0, 2, 1), (X @ r[:, :, None])))
    ZZ = np.linalg.pinv(np.einsum("nik,njk->ij", Z, Z), rcond=1e-9, hermitian=True)
    first, last = (np.arange(1, len(grid) - 1), np.full(len(grid) - 2, len(grid) - 1)) if open_end else np.triu_indices(len(grid), 2)
    B = XZ[last] - XZ[first]
    A = XX[last] - XX[first] - B @ ZZ @ B.transpose(0, 2, 1)
    c = Xr[last] - Xr[first]
    A += 1e-6 * (np.trace(XX[-1]) / k * np.eye(k))
    gain = (c.transpose(0, 2, 1) @ np.linalg.solve(A, c))[:, 0, 0]
    return _distinct(np.append(t, t[-1])[grid[first]], np.append(t, t[-1])[grid[last]], gain, count)


def _integrals(values: Array, grid: NDArray[np.intp]) -> Array:
    """Sums of the rows before each of the grid's."""
    total = np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(values, axis=0)])
    return np.asarray(total[grid])


def _distinct(begin: Array, end: Array, gain: Array, count: int) -> list[tuple[float, float]]:
    found: list[tuple[float, float]] = []
    near = 0.05 * (end.max() - begin.min())
    for i in np.argsort(-gain):
        if all(abs(begin[i] - b) + abs(end[i] - e) > near for b, e in found):
            found.append((float(begin[i]), float(end[i])))
        if len(found) == count:
            break
    return found


def onset(t: Array, at: float, period: float) -> Array:
    """(N,), 0 before and 1 after `at`, smooth over two samples so that a fit can move it."""
    return np.asarray(0.5 + 0.5 * np.tanh((t - at) / (2.0 * period)))


def onset_parameter_scale(scene: Scene) -> tuple[float, float, float, float]:
    """Middle, beginning, end and spread of the times at which something may happen, s."""
    begin, end = float(scene.t[0]), float(scene.t[-1])
    return 0.5 * (begin + end), begin, end, 0.3 * (end - begin)
