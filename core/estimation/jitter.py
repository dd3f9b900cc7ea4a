"""Accelerations that errors of the samples' instants make: each moves its pose along its way, and while it lasts the sensor's axes turn."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_array, diags_array

from core.estimation.kinematics import TWIST_S, Poses, local_derivative, smooth_rotation
from core.estimation.lost_rows import FilledRows


def find_jittered(poses: Poses, difference: csr_array, filled: FilledRows | None = None) -> list[csr_array]:
    """Three linear and three angular accelerations, sensor axes, m/s2 and rad/s2, as (N, M) times independent unit errors of the instants;
    none where the samples have their instants.

    Args:
        poses: N rows; difference: (N, N), second differences of them.
        filled: where the recorder has lost rows, which M of them were measured.
    """
    if poses.jitter_s == 0.0:
        return []
    apart = smooth_rotation(poses)
    position = np.zeros((len(apart), 3)) if poses.position is None else poses.position
    pose = np.concatenate((position, poses.rotation.reshape(-1, 9)), axis=1)
    way = poses.jitter_s * local_derivative(pose, 1, poses.t, window_s=TWIST_S)
    if filled is not None:
        way, difference = way[filled.measured], csr_array(difference @ filled.fill)
    turned = [[csr_array(diags_array(apart[:, base, axis]) @ difference) for base in range(3)] for axis in range(3)]

    def move_along(axis: int, columns: slice) -> csr_array:
        """(N, M), along an axis of the sensor, where the instants' errors move by these three columns of the way."""
        parts = [turned[axis][base] @ diags_array(each) for base, each in enumerate(way[:, columns].T)]
        return csr_array(parts[0] + parts[1] + parts[2])

    linear = [move_along(axis, slice(0, 3)) for axis in range(3)]
    angular = [0.5 * (move_along(k, slice(3 + j, 12, 3)) - move_along(j, slice(3 + k, 12, 3))) for j, k in ((1, 2), (2, 0), (0, 1))]
    return [*linear, *(csr_array(each) for each in angular)]
