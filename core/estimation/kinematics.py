"""Kinematics of the sensor frame: poses of a recording and smoothed motion without lag."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.local_polynomial import derive_with_ends_held
from core.estimation.lost_rows import FilledRows, fill_lost_rows
from core.payload.inertia import Motion
from core.recording.recording import Recording
from core.robot.model import RobotModel

SLOWEST_PERIOD_S, FEWEST_SAMPLES = 0.02, 50
"""Sampled more slowly, or fewer, a recording is a list of poses: nothing is known of the way between them."""
TWIST_S = 0.05
"""Window of the local cubics behind the speed that jitter goes with."""
SMOOTH_S = 0.08
"""Window of the local cubics through the rotations that accelerations are turned with."""
LONGEST_STENCIL = 8.0
"""Periods, of five samples that a cubic is laid through."""
FEWEST, SPEEDS = 30, 6
"""Samples of a class, and classes of speed, that tell jitter from noise."""


@dataclass(frozen=True)
class Joints:
    """Joints that poses follow from.

    Args:
        robot: in the base frame.
        q: (N, n), measured positions, rad.
    """

    robot: RobotModel
    q: Array


@dataclass(frozen=True)
class Poses:
    """Sensor frame in the base frame, one row per sample.

    Args:
        t: (N,), s.
        rotation: (N, 3, 3).
        position: (N, 3), m; None where the recording does not give it.
        gravity: (3,), base frame.
        noise: (6, 6), covariance of one sample's position (m) and orientation (rad), sensor axes, averaged over the recording.
        joints: that they follow from; None where poses were recorded.
        jitter_s: standard deviation of the samples' instants about their stamps.
    """

    t: Array
    rotation: Array
    position: Array | None
    gravity: Array
    noise: Array
    joints: Joints | None = None
    jitter_s: float = 0.0

    @property
    def g(self) -> Array:
        """(N, 3), gravity in the sensor frame."""
        return np.asarray(self.gravity @ self.rotation)

    @property
    def period(self) -> float:
        """Median sampling period, s."""
        return float(np.median(np.diff(self.t)))

    @property
    def apart(self) -> bool:
        """Whether these are poses by themselves and no motion."""
        return self.period > SLOWEST_PERIOD_S or len(self.t) < FEWEST_SAMPLES

    def take(self, rows: slice | NDArray[np.intp]) -> Poses:
        """Some rows."""
        joints = None if self.joints is None else replace(self.joints, q=self.joints.q[rows])
        position = None if self.position is None else self.position[rows]
        return replace(self, t=self.t[rows], rotation=self.rotation[rows], position=position, joints=joints)

    def fill(self, rows: FilledRows) -> Poses:
        """On an even clock, with the rows that were lost."""
        if self.joints is not None:
            joints = replace(self.joints, q=rows.fill @ self.joints.q)
            pose = joints.robot.sensor_poses(joints.q)
            return replace(self, t=rows.t, rotation=pose.rotation, position=pose.position, joints=joints)
        from scipy.spatial.transform import Rotation  # noqa: PLC0415 - half of SciPy, for recordings of attitudes that have lost rows

        rotation = Rotation.from_matrix((rows.fill @ self.rotation.reshape(len(self.t), 9)).reshape(-1, 3, 3)).as_matrix()
        position = None if self.position is None else rows.fill @ self.position
        return replace(self, t=rows.t, rotation=rotation, position=position)

    def with_zeros(self, zeros: Array) -> Poses:
        """The same measured joints with their zeros (n,), rad, elsewhere; poses that do not follow from joints stay."""
        if self.joints is None:
            return self
        pose = self.joints.robot.sensor_poses(self.joints.q + zeros)
        return replace(self, rotation=pose.rotation, position=pose.position)

    def with_sensor_turned(self, rotation: Array, gravity: Array) -> Poses:
        """The sensor turned in its mounting by a rotation (3, 3), in a gravity (3,)."""
        return replace(self, rotation=self.rotation @ rotation, gravity=gravity)


def poses_of(recording: Recording) -> Poses | None:
    """Poses by forward kinematics of the joints, or as recorded; None where the recording has neither."""
    t = recording.t
    if recording.q is not None and recording.robot is not None:
        robot, q = RobotModel(recording.robot), recording.q
        pose = robot.sensor_poses(q)
        jitter_s, white = find_jitter(t, q)
        return Poses(t, pose.rotation, pose.position, recording.gravity, _joint_noise(robot, q, white), Joints(robot, q), jitter_s)
    if recording.orientation is not None:
        rotation, position = recording.orientation, recording.position
        noise = np.zeros((6, 6))
        if position is not None:
            noise[:3, :3] = np.eye(3) * white_noise_std(t, position).mean() ** 2
        jitter_s, white = find_jitter(t, rotation.reshape(len(t), 9))
        noise[3:, 3:] = np.eye(3) * white.mean() ** 2 * 1.5
        return Poses(t, rotation, position, recording.gravity, noise, jitter_s=jitter_s)
    return None


def white_noise_std(t: Array, x: Array) -> Array:
    """Standard deviation of white noise on a smooth signal (N, n) at times (N,), robust to motion.

    The median over the recording is taken, so that the parts at rest or at constant speed decide.
    """
    off, _ = _off_a_cubic(t, x)
    return _median_std(off)


def find_jitter(t: Array, x: Array) -> tuple[float, Array]:
    """Standard deviation, s, of the instants about their stamps t (N,), and white noise (n,) of a smooth signal (N, n) beside it.

    White noise is the same at every speed, that of wrong instants goes with the speed. 0 where it is not the larger part when the signal
    is fast.
    """
    off, rows = _off_a_cubic(t, x)
    white = _median_std(off)
    if len(off) < 2 * SPEEDS * FEWEST:
        return 0.0, white
    velocity = local_derivative(x, 1, t, window_s=TWIST_S)[rows]
    speed = np.linalg.norm(velocity, axis=1)
    moving = np.flatnonzero(speed > 0.1 * np.quantile(speed, 0.95))
    if len(moving) < SPEEDS * FEWEST:
        return 0.0, white
    along = (off[moving] * velocity[moving]).sum(axis=1) / speed[moving] ** 2
    classes = np.array_split(np.argsort(speed[moving]), SPEEDS)
    seen = np.array([_median_std(along[each]) ** 2 for each in classes])
    slowness = np.array([np.median(speed[moving][each] ** -2.0) for each in classes])
    if not seen.all():
        return 0.0, white
    square = find_level(np.column_stack((np.ones(SPEEDS), slowness)) / seen[:, None])
    if square < 0.5 * seen[-1]:
        return 0.0, white
    slow = np.argsort(speed)[: len(speed) // 4]
    return float(np.sqrt(square)), _median_std(off[slow])


def find_level(columns: Array) -> float:
    """The first of the two coefficients, neither negative, with which columns (n, 2), both positive, add up to ones best."""
    level, rest = np.linalg.lstsq(columns, np.ones(len(columns)), rcond=None)[0]
    if rest < 0.0:
        level = columns[:, 0].sum() / (columns[:, 0] @ columns[:, 0])
    return max(float(level), 0.0)


def _median_std(x: Array) -> Array:
    """Standard deviation of noise (N, ...) by the median of its size, which outliers do not move; 0 of nothing."""
    return np.asarray(1.4826 * np.median(np.abs(x), axis=0)) if len(x) else np.zeros(x.shape[1:])


def _off_a_cubic(t: Array, x: Array) -> tuple[Array, NDArray[np.intp]]:
    """How far samples (N, n) are off the cubic through their four neighbours, in units of one sample's noise; and which rows those are."""
    n, period = len(t), float(np.median(np.diff(t))) if len(t) > 1 else 0.0
    rows = np.arange(2, n - 2)
    rows = rows[t[rows + 2] - t[rows - 2] < LONGEST_STENCIL * period]
    beside = rows[:, None] + np.array([-2, -1, 1, 2])
    away = t[beside] - t[rows, None]
    weights = np.ones_like(away)
    for j, m in np.ndindex(4, 4):
        if j != m:
            weights[:, j] *= -away[:, m] / (away[:, j] - away[:, m])
    off = x[rows] - np.einsum("rj,rjn->rn", weights, x[beside])
    return off / np.sqrt(1.0 + (weights**2).sum(axis=1))[:, None], rows


def _joint_noise(robot: RobotModel, q: Array, std: Array) -> Array:
    rows = np.linspace(0, len(q) - 1, min(60, len(q))).astype(int)
    J = robot.sensor_jacobians(q[rows])
    return np.asarray(np.einsum("kij,j,klj->il", J, std**2, J) / len(rows))


def smooth_motion(poses: Poses, *, window_s: float) -> tuple[Motion, Array]:
    """Motion without lag, by centred local cubics over `window_s`, and the speed of the sensor origin (N,).

    Angular velocity and acceleration are the skew parts of `R^T R'` and `R^T R''`. Rows that a recorder lost are filled in for it.
    """
    filled = fill_lost_rows(poses.t, window_s)
    if filled is not None:
        motion, speed = smooth_motion(poses.fill(filled), window_s=window_s)
        return motion[filled.measured], speed[filled.measured]
    length = max(5, 2 * round(window_s / poses.period / 2) + 1)
    R, t = poses.rotation, poses.t
    if length > len(t) or len(t) < 5:
        return Motion.still(poses.g), np.zeros(len(t))
    flat = R.reshape(len(t), 9)
    R1 = _derivative(flat, length, 1, poses.period).reshape(R.shape)
    R2 = _derivative(flat, length, 2, poses.period).reshape(R.shape)
    omega, alpha = axial(np.einsum("nji,njk->nik", R, R1)), axial(np.einsum("nji,njk->nik", R, R2))
    if poses.position is None:
        return Motion(poses.g, np.zeros_like(omega), omega, alpha), np.zeros(len(t))
    v = _derivative(poses.position, length, 1, poses.period)
    a = np.einsum("nji,nj->ni", R, _derivative(poses.position, length, 2, poses.period))
    return Motion(poses.g, a, omega, alpha), np.linalg.norm(v, axis=1)


def smooth_rotation(poses: Poses) -> Array:
    """(N, 3, 3), that second differences are turned with.

    Two noisy factors are noise that no window damps, and with a mean of its own where they share samples: one has to be smooth.
    """
    window_s = max(SMOOTH_S, 7.0 * poses.period)
    return local_derivative(poses.rotation.reshape(-1, 9), 0, poses.t, window_s=window_s).reshape(-1, 3, 3)


def local_derivative(x: Array, order: int, t: Array, *, window_s: float) -> Array:
    """Derivative of some order (0, 1, 2) of samples (N, n) at times t (N,), s, without lag, by centred local cubics over `window_s`; rows
    that a recorder lost off an even clock are filled in for it."""
    filled = fill_lost_rows(t, window_s)
    if filled is not None:
        return local_derivative(filled.fill @ x, order, filled.t, window_s=window_s)[filled.measured]
    period = float(np.median(np.diff(t))) if len(t) > 1 else window_s
    length = max(5, 2 * round(window_s / period / 2) + 1)
    return _derivative(x, length, order, period) if length <= len(x) else np.zeros_like(x) if order else x


def axial(matrix: Array) -> Array:
    """(..., 3), vector of the skew part."""
    return 0.5 * np.stack(
        (
            matrix[..., 2, 1] - matrix[..., 1, 2],
            matrix[..., 0, 2] - matrix[..., 2, 0],
            matrix[..., 1, 0] - matrix[..., 0, 1],
        ),
        axis=-1,
    )


def _derivative(x: Array, length: int, order: int, period: float) -> Array:
    return derive_with_ends_held(x, length, 3, order, period)
