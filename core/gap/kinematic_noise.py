"""What the noise of the poses, and of their instants, makes of the accelerations that the twin predicts from: draws of it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array

from core.array import Array
from core.estimation.kinematics import Poses

DRAWS = 16
"""A mean over them is right to a few units of chi-square."""


@dataclass(frozen=True)
class KinematicNoise:
    """Draws of linear and angular acceleration as the noise alone would make them.

    Args:
        on_grid: (M, N, 6). windowed, rate, rate_of_rate: (M, K, 6), means of it, of its rate and of the rate's rate.
    """

    on_grid: Array
    windowed: Array
    rate: Array
    rate_of_rate: Array


def draw_noise(poses: Poses, second: csr_array, jittered: list[csr_array], t: Array, average: csr_array) -> KinematicNoise:
    """Always the same draws.

    Args:
        second: (N, samples), second differences of the poses on the grid. jittered: (N, samples) six times, accelerations there by unit
            errors of the instants; none where they are not off.
        t: (N,), s, of the grid. average: (K, N), windowed means over it.
    """
    rng = np.random.default_rng(0)
    values, vectors = np.linalg.eigh(poses.noise)
    signs = rng.integers(2, size=(len(poses.t), DRAWS * 6), dtype=np.int8)
    seen = second @ (2.0 * signs - 1.0)
    drawn = np.ascontiguousarray(seen.reshape(-1, DRAWS, 6).transpose(1, 0, 2) @ (vectors * np.sqrt(np.maximum(values, 0.0))).T)
    if jittered:
        early = rng.standard_normal((len(poses.t), DRAWS))
        drawn += np.stack([(each @ early).T for each in jittered], axis=2)
    rate, columns = rate_matrix(t), drawn.transpose(1, 0, 2).reshape(len(t), -1)
    means = [operator @ columns for operator in (average, average @ rate, average @ rate @ rate)]
    return KinematicNoise(drawn, *(np.ascontiguousarray(each.reshape(-1, DRAWS, 6).transpose(1, 0, 2)) for each in means))


def rate_matrix(t: Array) -> csr_array:
    """(N, N), derivatives at times t (N,), by the two rows beside each (`numpy.gradient`)."""
    step = np.diff(t)
    before, after = step[:-1], step[1:]
    weights = np.stack((-after / (before * (before + after)), (after - before) / (before * after), before / (after * (before + after))))
    rows = np.arange(1, len(t) - 1)
    data = np.concatenate(([-1.0 / step[0], 1.0 / step[0]], weights.T.ravel(), [-1.0 / step[-1], 1.0 / step[-1]]))
    columns = np.concatenate(([0, 1], (rows[:, None] + [-1, 0, 1]).ravel(), [len(t) - 2, len(t) - 1]))
    counts = np.concatenate(([0, 2], np.full(len(rows), 3), [2]))
    return csr_array((data, columns, np.cumsum(counts)), shape=(len(t), len(t)))
