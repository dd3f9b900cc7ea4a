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
    inertia = spatial_inertia(phi).T
    seen, rate, rate_of_rate = windows.windowed_acceleration_noise
    rows = windows.whiten_windowed(seen @ inertia)
    late = windows.whiten_windowed((-beta[LATE] * rate + 0.5 * beta[BLUR] * rate_of_rate) @ inertia)
    passed = rows
    if not problem.only_adds:
        scene = windows.basis.scene.with_phi(phi)
        passed = windows.rows_of(problem.pass_changes(theta, scene, accelerations @ inertia)).transpose(2, 0, 1)
    return _by_motion(windows, np.square(rows).mean(axis=0) - np.square(passed + late).mean(axis=0))


def _by_motion(windows: Windows, rows: Array) -> Array:
    """(6, K), each row replaced by the mean over its motion."""
    count = np.bincount(windows.group)
    means = [np.bincount(windows.group, weights=channel) / np.maximum(count, 1) for channel in rows]
    return np.array([mean[windows.group] for mean in means])
