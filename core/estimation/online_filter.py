"""The paper's Kalman filter sample by sample, while the robot moves: the only user of filterpy.

It stands by itself because filterpy loads all of `scipy.stats`, which whoever has a whole recording need not wait for.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from filterpy.kalman import KalmanFilter

from core.array import Array
from core.estimation.kinematic_filter import START_VARIANCE, find_bandwidth, integrate_over, jerk_noise_over, steady_std
from core.payload.inertia import Motion
from core.robot.rotations import exponential, logarithm

SAME_GAIN = 1e-12
"""Share by which the gain still changes when it has settled; from then on filterpy's steady-state steps do the same for a fraction."""


class KinematicFilter:
    """Orientation, angular velocity and acceleration, position, velocity and acceleration, from poses, sample by sample.

    State of the linear filter, base frame: `[dtheta, omega, alpha, p, v, a]`, 18 values, with white jerk; `dtheta` is the small rotation
    that has not yet been moved into the rotation matrix and is zero between calls.

    Args:
        period: s.
        position_std, orientation_std: noise of one measured pose, m and rad; the jerk allowed for follows from it (`find_bandwidth`).
    """

    def __init__(self, period: float, *, position_std: float, orientation_std: float) -> None:
        self.period = period
        self._bandwidth = find_bandwidth(orientation_std, period)
        self._std = orientation_std, position_std
        kf = KalmanFilter(dim_x=18, dim_z=6)
        kf.H = np.zeros((6, 18))
        kf.H[:3, :3] = kf.H[3:, 9:12] = np.eye(3)
        kf.F = np.kron(np.eye(2), np.kron(integrate_over(period), np.eye(3)))
        kf.R = np.diag(np.repeat([orientation_std**2, position_std**2], 3))
        jerk = np.array([orientation_std**2, position_std**2]) * self._bandwidth**6 * period
        kf.Q = np.kron(np.diag(jerk), np.kron(jerk_noise_over(period), np.eye(3)))
        kf.P = np.diag(np.repeat([orientation_std**2, *START_VARIANCE, position_std**2, *START_VARIANCE], 3))
        kf.x = np.zeros(18)
        self._filter = kf
        self._rotation = np.eye(3)
        self._started = self._settled = False

    def update(self, rotation: Array, position: Array) -> None:
        """Takes the pose of the next period: rotation (3, 3) and position (3,) of the sensor in the base frame."""
        kf = self._filter
        if not self._started:
            self._started = True
            self._rotation = rotation.copy()
            kf.x[9:12] = position
            return
        if self._settled:
            kf.predict_steadystate()
        else:
            kf.predict()
        self._absorb()
        innovation = np.empty(3)
        logarithm(rotation @ self._rotation.T, innovation)
        measured = np.concatenate((innovation, position))
        if self._settled:
            kf.update_steadystate(measured)
        else:
            gain = kf.K
            kf.update(measured)
            self._settled = bool(np.abs(kf.K - gain).max() < SAME_GAIN * np.abs(kf.K).max())
        self._absorb()

    def _absorb(self) -> None:
        """Moves the small rotation into the rotation matrix."""
        x = self._filter.x
        turned = np.empty((3, 3))
        exponential(np.ascontiguousarray(x[:3]), turned)
        self._rotation = turned @ self._rotation
        x[:3] = 0.0

    @property
    def rotation(self) -> Array:
        """(3, 3), sensor axes in the base frame."""
        return self._rotation

    @property
    def twist(self) -> Array:
        """(6,), linear then angular velocity of the sensor, sensor axes."""
        x, R = self._filter.x, self.rotation
        return np.concatenate((x[12:15] @ R, x[3:6] @ R))

    def motion(self, gravity: Array) -> Motion:
        """One row: the filtered motion in the sensor frame, for gravity (3,) in the base frame."""
        x, R = self._filter.x, self.rotation
        return Motion((gravity @ R)[None], (x[15:18] @ R)[None], (x[3:6] @ R)[None], (x[6:9] @ R)[None])

    @property
    def alpha(self) -> Array:
        """(3,), angular acceleration, sensor axes."""
        return np.asarray(self._filter.x[6:9] @ self.rotation)

    @cached_property
    def steady_std(self) -> Array:
        """(4,), of omega, alpha, v and a when the filter has settled."""
        return steady_std(self.period, position_std=self._std[1], orientation_std=self._std[0])
