"""The Kalman filter that the paper's estimate takes its kinematics from, over a whole recording; on line: `core.estimation.online_filter`.

The filter of the paper's reference [19] has a unit quaternion in its state and an extended update. Here orientation is an error state: the
filter's vector holds a small rotation that is moved into the rotation matrix after every step, so that a linear filter with constant
matrices is enough. To first order in one sample's rotation both are the same.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray
from scipy.linalg import solve_discrete_are

from core.array import Array
from core.estimation.kinematics import Poses
from core.estimation.segments import stretches
from core.payload.inertia import Motion
from core.robot.rotations import exponential, logarithm

ALPHA_VARIANCE = 1.1e-3
"""Of the filter's angular acceleration, (rad/s2)^2: the paper's Table 2(b)."""
SETTLING_S = 0.3
"""The filter starts as if anything could be moving; what it says before is not used."""
START_VARIANCE = 1.0, 100.0
"""Of velocity and acceleration before the first sample, angular and linear, SI."""
QUIETEST_RAD = 1e-7
"""No encoder's readings are quieter; a filter has to assume some noise."""


def pose_noise_std(encoder_std: float, joints: int) -> float:
    """Noise of one measured pose: of its orientation in rad, and with an arm about a metre long of its position in m.

    Args:
        encoder_std: of one joint's reading, rad. `joints`: how many they are.
    """
    return max(encoder_std, QUIETEST_RAD) * float(np.sqrt(joints))


def find_pose_noise(poses: Poses, encoder_std: float | None) -> tuple[float, float]:
    """Noise of one pose's position, m, and orientation, rad, about each axis: as the recording shows it, and no less than is stated.

    Args:
        encoder_std: of one joint's reading, rad; None where nobody has said.
    """
    joints = 1 if poses.joints is None else poses.joints.robot.n
    stated = pose_noise_std(encoder_std or QUIETEST_RAD, joints)
    position, orientation = (float(np.sqrt(np.trace(block) / 3.0)) for block in (poses.noise[:3, :3], poses.noise[3:, 3:]))
    return max(position, stated), max(orientation, stated)


def find_bandwidth(orientation_std: float, period: float) -> float:
    """Bandwidth w, rad/s, with which the filter's angular acceleration has the variance of the paper's Table 2(b).

    A filter with white jerk settles at poles of a third-order Butterworth filter. Its Riccati equation gives variances of 2 w r for the
    orientation and 2 w^5 r for the angular acceleration, with measurement noise of density `r = orientation_std^2 period`.
    """
    return float((ALPHA_VARIANCE / (2.0 * orientation_std**2 * period)) ** 0.2)


def steady_std(period: float, *, position_std: float, orientation_std: float) -> Array:
    """(4,), standard deviations of omega, alpha, v and a, rad and m, when a filter of this period and noise has settled."""
    F, H = integrate_over(period), np.array([[1.0, 0.0, 0.0]])
    # solved for unit noise, then scaled
    jerk = find_bandwidth(orientation_std, period) ** 6 * period
    P = solve_discrete_are(F.T, H.T, jerk * jerk_noise_over(period), np.eye(1))
    settled = P - P @ H.T @ H @ P / (P[0, 0] + 1.0)
    rate, acceleration = np.sqrt(np.diag(settled)[1:])
    return np.array([orientation_std * rate, orientation_std * acceleration, position_std * rate, position_std * acceleration])


def filter_motion(poses: Poses, *, position_std: float, orientation_std: float) -> tuple[Motion, Array, NDArray[np.bool_]]:
    """The same filter over a whole recording: motion in the sensor frame, speed of the sensor origin (N,), and where it has settled (N,).

    Lost rows are steps that take longer; after a gap it starts anew.
    """
    n = len(poses.t)
    position = np.zeros((n, 3)) if poses.position is None else poses.position
    noise = np.array([orientation_std, position_std]) ** 2
    jerk = noise * find_bandwidth(orientation_std, poses.period) ** 6 * poses.period
    rotation, state, settled = np.empty((n, 3, 3)), np.zeros((n, 2, 3, 3)), np.zeros(n, dtype=bool)
    for part in stretches(poses.t):
        t = np.ascontiguousarray(poses.t[part])
        measured = np.ascontiguousarray(poses.rotation[part]), np.ascontiguousarray(position[part])
        _filter(t, *measured, noise, jerk, rotation[part], state[part])
        settled[part] = t - t[0] >= SETTLING_S
    omega, alpha, v, a = (np.einsum("ni,nij->nj", state[:, block, order], rotation) for block in (0, 1) for order in (1, 2))
    return Motion(poses.gravity @ rotation, a, omega, alpha), np.linalg.norm(v, axis=1), settled


@njit(cache=True)
def _filter(t: Array, rotation: Array, position: Array, noise: Array, jerk: Array, R: Array, x: Array) -> None:
    """Fills R (N, 3, 3) and x (N, 2, 3, 3): for orientation and for position the value and its two derivatives, a row each.

    Noise is alike about all axes, so one covariance (3, 3) serves for the orientation and one for the position.
    """
    P = np.zeros((2, 3, 3))
    for block in range(2):
        P[block, 0, 0], P[block, 1, 1], P[block, 2, 2] = noise[block], START_VARIANCE[0], START_VARIANCE[1]
    F, Q, turned, innovation = np.eye(3), np.empty((3, 3)), np.empty((3, 3)), np.empty((2, 3))
    R[0] = rotation[0]
    x[0, 1, 0] = position[0]
    for k in range(1, len(t)):
        T = t[k] - t[k - 1]
        F[0, 1] = F[1, 2] = T
        F[0, 2] = 0.5 * T * T
        Q[0, 0], Q[1, 1], Q[2, 2] = T**5 / 20.0, T**3 / 3.0, T
        Q[0, 1] = Q[1, 0] = T**4 / 8.0
        Q[0, 2] = Q[2, 0] = T**3 / 6.0
        Q[1, 2] = Q[2, 1] = 0.5 * T * T
        for block in range(2):
            x[k, block] = F @ x[k - 1, block]
            P[block] = F @ P[block] @ F.T + jerk[block] * Q
        exponential(x[k, 0, 0], turned)
        R[k] = turned @ R[k - 1]
        x[k, 0, 0] = 0.0
        logarithm(rotation[k] @ R[k].T, innovation[0])
        innovation[1] = position[k] - x[k, 1, 0]
        for block in range(2):
            K = P[block, :, 0] / (P[block, 0, 0] + noise[block])
            for i in range(3):
                for j in range(3):
                    x[k, block, i, j] += K[i] * innovation[block, j]
            P[block] = P[block] - np.outer(K, P[block, 0])
        exponential(x[k, 0, 0], turned)
        R[k] = turned @ R[k]
        x[k, 0, 0] = 0.0


def integrate_over(T: float) -> Array:
    """(3, 3), what a value and its two derivatives are a time T, s, later."""
    return np.array([[1.0, T, T * T / 2.0], [0.0, 1.0, T], [0.0, 0.0, 1.0]])


def jerk_noise_over(T: float) -> Array:
    """(3, 3), covariance that white jerk of unit density gives them in a time T, s."""
    return np.array([[T**5 / 20, T**4 / 8, T**3 / 6], [T**4 / 8, T**3 / 3, T**2 / 2], [T**3 / 6, T**2 / 2, T]])
