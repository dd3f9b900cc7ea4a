"""What an effect spares itself by smoothing the twin's own noise.

The twin predicts from measured joints, and their noise goes through every effect with the rest. A filter takes some of it away, so its
residual gets smaller whether the filter is there or not. That is no evidence, and is given back.
"""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.gap.problem import Problem
from core.gap.windows import BLUR, LATE, PHI, Windows
from core.payload.inertia import spatial_inertia


def estimate_spared_noise(problem: Problem, theta: Array, beta: Array) -> Array:
    """(6, K), chi-square that the noise of the kinematics loses on its way through effects and small imperfections, as expected for each
    motion and channel.

    Args:
        theta: of the effects.
        beta: payload, through which noise of the kinematics becomes a wrench, offsets, small imperfections.
    """
    windows, phi = problem.windows, beta[PHI]
    accelerations = windows.acceleration_noise
    if not accelerations.any():
        return np.zeros(windows.target.shape)
    noise = accelerations @ spatial_inertia(phi).T
    scene = windows.basis.scene.with_phi(phi)
    rate = np.gradient(noise, scene.t, axis=1)
    late = -beta[LATE] * rate + 0.5 * beta[BLUR] * np.gradient(rate, scene.t, axis=1)
    return _by_motion(windows, _power(windows, noise) - _power(windows, problem.pass_changes(theta, scene, noise) + late))


def _power(windows: Windows, changes: Array) -> Array:
    """(6, K), mean square of the rows of changes (M, N, 6)."""
    return np.asarray(np.square(windows.rows_of(list(changes))).mean(axis=2))


def _by_motion(windows: Windows, rows: Array) -> Array:
    """(6, K), each row replaced by the mean over its motion."""
    count = np.bincount(windows.group)
    means = [np.bincount(windows.group, weights=channel) / np.maximum(count, 1) for channel in rows]
    return np.array([mean[windows.group] for mean in means])
