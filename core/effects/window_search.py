"""When something began (and ended): the windows of time, or the steps, in which given columns explain most of a residual."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.effects.scene import Scene
from core.payload.inertia import regressor

Rows = NDArray[np.intp]

LEVER = 0.05
"""Noise of torque over noise of force for common wrist sensors, m; used where the sensor's description does not say."""
ROWS = 2000
"""The search looks at no more rows than about this many."""
COARSE = 60
"""Parts of the run between which windows are first looked for."""
ROUNDS = 4
"""Times that each of several steps is moved, at most."""


def weights(scene: Scene) -> Array:
    """(6,), one over the sensor's noise up to a common factor."""
    for described in (scene.noise, scene.resolution, scene.range):
        if described is not None and (described > 0).all():
            return np.asarray(described[0] / described)
    return np.array([1.0, 1.0, 1.0, *[1.0 / LEVER] * 3])


def columns_of_payload_and_offsets(scene: Scene, rows: slice) -> Array:
    """(n, 6, 16), what payload and offsets take up of a residual in those rows of the scene, weighed as it is."""
    V = regressor(scene.motion[rows])
    return np.concatenate([V, np.broadcast_to(np.eye(6), (len(V), 6, 6))], axis=2) * weights(scene)[:, None]


def best_windows(
    scene: Scene, residual: Array, columns: Array, count: int, *, open_end: bool, longest_s: float = np.inf
) -> list[tuple[float, float]]:
    """Windows in which the columns are switched on, best first, no two of them close to each other.

    Payload and offsets are fitted along with the columns, so a change that they would take up does not count.

    Args:
        residual: (N, 6), measured minus predicted with payload and offsets fitted, in standard deviations of the noise.
        columns: (N, 6, k), N and N m.
        count: at most this many.
        open_end: windows last to the end of the recording (steps).
        longest_s: of a window that ends before that.

    Returns:
        Beginnings and ends, s.
    """
    rows = slice(0, None, max(1, len(scene) // ROWS))
    gain = _Gain.of(scene, residual, columns, rows)
    t = np.append(scene.t[rows], scene.t[-1])
    N = len(t) - 1
    if open_end:
        first = np.arange(2, N - 1)
        last = np.full(len(first), N)
    else:
        first, last = (index * N // COARSE for index in np.triu_indices(COARSE + 1, 1))
        short = t[last] - t[first] <= longest_s
        first, last = first[short], last[short]
    found = _distinct(first, last, gain(first, last), count, N // 20)
    if not open_end:
        found = [_refine_window(gain, begin, end, N // COARSE, N) for begin, end in found]
    return [(float(t[begin]), float(t[end])) for begin, end in found]


class Steps(NamedTuple):
    """Times at which columns are switched on for good, each time with amplitudes of their own.

    Args:
        times: (count,), s, increasing.
        directions: (count, k), the amplitudes, the largest of which is 1.
        share: of the residual's square that they explain.
    """

    times: Array
    directions: Array
    share: float


def best_steps(scene: Scene, residual: Array, columns: Array, most: int) -> list[Steps]:
    """Two, three, and up to `most` steps of the columns that together explain most of a residual, payload and offsets fitted along.

    The best pair of a coarse grid, then one more at a time; each is moved where it explains most until none moves.

    Args:
        residual, columns: as for `best_windows`.
    """
    rows = slice(0, None, max(1, len(scene) // ROWS))
    gain, t = _Gain.of(scene, residual, columns, rows), scene.t[rows]
    N = len(t)
    apart = max(2, N // COARSE)
    all_rows, coarse = np.arange(apart, N - apart), np.linspace(apart, N - apart - 1, COARSE // 2, dtype=np.intp)
    pairs = np.column_stack([coarse[index] for index in np.triu_indices(len(coarse), 1)])
    best, found = pairs[np.argmax(gain.of_steps(pairs)[0])], []
    whole = max(float(np.square(residual[rows]).sum()), 1e-12)
    for count in range(2, most + 1):
        if count > 2:
            best = _place(gain, np.append(best, all_rows[0]), count - 1, all_rows, apart)
        for _ in range(ROUNDS):
            before = best
            for k in range(count):
                best = _place(gain, best, k, all_rows, apart)
            if np.array_equal(best, before):
                break
        steps = np.sort(best)
        taken, amplitudes = gain.of_steps(steps[None])
        found.append(Steps(t[steps], amplitudes[0] / max(float(np.abs(amplitudes).max()), 1e-12), float(taken[0]) / whole))
    return found


def _place(gain: _Gain, steps: Rows, k: int, candidates: Rows, apart: int) -> Rows:
    """The steps with the k-th of them where it explains most, and at least so many rows from each other one."""
    others = np.delete(steps, k)
    free = candidates[(np.abs(candidates[:, None] - others) >= apart).all(axis=1)]
    tried = np.tile(steps, (len(free), 1))
    tried[:, k] = free
    return np.asarray(tried[np.argmax(gain.of_steps(tried)[0])])


class _Gain(NamedTuple):
    """Sums over the rows before each (N + 1, ...), the inverse of the payload's and offsets' normal matrix, and what these take out of
    the residual in this metric, which is not quite that of the fit."""

    XX: Array
    XZ: Array
    Xr: Array
    inverse: Array
    taken: Array

    @classmethod
    def of(cls, scene: Scene, residual: Array, columns: Array, rows: slice) -> _Gain:
        scale = weights(scene)
        X = (columns[rows] * scale[:, None]).transpose(0, 2, 1)
        Z = columns_of_payload_and_offsets(scene, rows)
        normal = np.tensordot(Z, Z, axes=((0, 1), (0, 1)))
        inverse = np.asarray(np.linalg.pinv(normal, rcond=1e-9, hermitian=True), dtype=np.float64)
        sums = (_integral(X @ X.transpose(0, 2, 1)), _integral(X @ Z), _integral(X @ residual[rows][:, :, None]))
        return cls(*sums, inverse, inverse @ np.tensordot(Z, residual[rows], axes=((0, 1), (0, 1))))

    def __call__(self, first: Rows, last: Rows) -> Array:
        """Sum of squares that the columns take out of the residual when they are on in rows `first` to `last` (excluded)."""
        B = self.XZ[last] - self.XZ[first]
        A = self.XX[last] - self.XX[first] - B @ self.inverse @ B.transpose(0, 2, 1)
        k = A.shape[1]
        A += 1e-6 / k * np.trace(self.XX[-1]) * np.eye(k)
        c = self.Xr[last] - self.Xr[first]
        return np.asarray((c.transpose(0, 2, 1) @ np.linalg.solve(A, c))[:, 0, 0])

    def of_steps(self, first: Rows) -> tuple[Array, Array]:
        """The same, (M,), of columns that are on from each of rows (M, s) to the end, and their amplitudes (M, s, k)."""
        M, s = first.shape
        k = self.XX.shape[1]
        B = self.XZ[-1] - self.XZ[first]
        later = np.maximum(first[:, :, None], first[:, None])
        A = self.XX[-1] - self.XX[later] - np.einsum("miaz,zy,mjby->mijab", B, self.inverse, B, optimize=True)
        A = A.transpose(0, 1, 3, 2, 4).reshape(M, s * k, s * k)
        A += 1e-6 / k * np.trace(self.XX[-1]) * np.eye(s * k)
        c = (self.Xr[-1] - self.Xr[first] - B @ self.taken[:, None]).reshape(M, s * k, 1)
        x = np.linalg.solve(A, c)
        return (c * x).sum(axis=(1, 2)), x.reshape(M, s, k)


def _integral(values: Array) -> Array:
    return np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(values, axis=0)])


def _distinct(first: Rows, last: Rows, gain: Array, count: int, near: int) -> list[tuple[int, int]]:
    """The best windows, no two of them within `near` rows of each other."""
    found: list[tuple[int, int]] = []
    for i in np.argsort(-gain):
        if all(abs(first[i] - begin) + abs(last[i] - end) > near for begin, end in found):
            found.append((int(first[i]), int(last[i])))
        if len(found) == count:
            break
    return found


def _refine_window(gain: _Gain, begin: int, end: int, cell: int, N: int) -> tuple[int, int]:
    """The best window whose ends are within a cell of the given ones."""
    around = np.unique(np.linspace(-cell, cell, 21).astype(int))
    first, last = (x.ravel() for x in np.meshgrid(np.clip(begin + around, 0, N - 1), np.clip(end + around, 1, N)))
    first, last = first[first < last], last[first < last]
    best = int(np.argmax(gain(first, last)))
    return int(first[best]), int(last[best])


def ramp(t: Array, begin: float, over: float, period: float) -> Array:
    """(N,), from 0 to 1 within `over` >= 0 seconds from `begin` on, smooth over two samples so that a fit can move it."""
    width, over = 4.0 * period, over + 0.5 * period

    def area(x: Array) -> Array:
        """Below `(1 + tanh(2 x / width)) / 2` up to x."""
        return np.asarray(0.5 * (x + np.abs(x) + width * np.log1p(np.exp(-4.0 * np.abs(x) / width)) / 2.0))

    return (area(t - begin) - area(t - begin - over)) / over


def onset_parameter_scale(scene: Scene) -> tuple[float, float, float, float]:
    """Middle, beginning, end and spread of the times at which something may happen, s."""
    begin, end = float(scene.t[0]), float(scene.t[-1])
    return 0.5 * (begin + end), begin, end, 0.3 * (end - begin)
