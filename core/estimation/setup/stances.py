"""Short windows of a recording with what was felt in each, chosen without trusting its clock or its units.

A second difference over three rows is the mean of the acceleration between them under a triangle; the wrench is averaged under the same
triangle, so that both belong together and no filter is needed.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.kinematics import white_noise_std
from core.recording.recording import Recording
from core.robot.model import RobotModel

LOOKED_AT = 300
"""Windows that are chosen from a recording."""
WINDOW_S = 0.08
"""Half a window's width, for a clock that can be right."""
SLOW_SHARE = 0.01
"""Share of the recording's whole change that half a window may move by, where the clock cannot be right."""
MOST_ROWS = 40
FEWEST_ROWS = 200
"""Of a recording that can be a path and not a series of poses."""
LIKELY_PERIOD_S = (2e-4, 0.11)
APART = 0.01
"""Share of the recording's whole change by which two windows count as different poses."""
LARGEST_STEP = 0.1
"""Share of it that a path, which is not a series of poses, moves from row to row."""
FORCE, TORQUE = slice(0, 3), slice(3, 6)


@dataclass(frozen=True)
class Stances:
    """Poses of the sensor in the base frame at the beginning, middle and end of each window, and the mean raw wrench, as recorded.

    Args:
        rotation: (P, 3, 3, 3); `position`: (P, 3, 3), m, None where not recorded.
        steps_s: (P, 2), from a window's first row to its middle one and from there to its last, by the recording's clock, which may be
            uneven; zero where poses are not of one motion.
        gravity: (3,), base frame, m/s2.
        wrench: (P, 6), N and N m.
        noise: (P, 6), standard uncertainty of these means, as far as their samples tell.
        distinct: how many of the windows are at places of their own.
        jitter: standard deviations of one row's position (m) and orientation (rad).
        t: (P,), s. q: (P, 3, n), rad, and `robot`, of a recording with joints.
    """

    rotation: Array
    position: Array | None
    steps_s: Array
    gravity: Array
    wrench: Array
    noise: Array
    distinct: int
    jitter: tuple[float, float]
    t: Array
    q: Array | None = None
    robot: RobotModel | None = None

    def __len__(self) -> int:
        return len(self.rotation)

    @property
    def moves(self) -> bool:
        """Whether accelerations can be told."""
        return bool((self.steps_s > 0.0).any())

    @property
    def half_s(self) -> Array:
        """(P,), half a window's width."""
        return np.asarray(self.steps_s.mean(axis=1))

    def differentiate_twice(self, x: Array) -> Array:
        """(P, ...), second derivatives by time of values (P, 3, ...) at the rows of the windows: divided differences."""
        before, after = self.steps_s.T
        first, last = 2.0 / (before * (before + after)), 2.0 / (after * (before + after))
        return np.asarray(np.einsum("kw,kw...->k...", np.stack((first, -first - last, last), axis=1), x))

    @property
    def base(self) -> Array:
        """(P, 3, 3), R^T in the middle: turns vectors of the base frame into the sensor's."""
        return np.swapaxes(self.rotation[:, 1], 1, 2)

    def thin(self, most: int) -> Stances:
        """So many of them at most, evenly."""
        rows = np.unique(np.linspace(0, len(self) - 1, min(len(self), most)).astype(int))
        return replace(
            self,
            rotation=self.rotation[rows],
            position=None if self.position is None else self.position[rows],
            steps_s=self.steps_s[rows],
            wrench=self.wrench[rows],
            noise=self.noise[rows],
            distinct=min(self.distinct, len(rows)),
            t=self.t[rows],
            q=None if self.q is None else self.q[rows],
        )

    def at_joints(self, q: Array) -> Stances:
        """The same wrenches with other joint angles (P, 3, n)."""
        assert self.robot is not None
        pose = self.robot.sensor_poses(q.reshape(-1, q.shape[-1]))
        return replace(self, q=q, rotation=pose.rotation.reshape(-1, 3, 3, 3), position=pose.position.reshape(-1, 3, 3))


def stances_of(recording: Recording) -> Stances | None:
    """Stances of a recording; None where it has no wrench or no poses, or never leaves its first one."""
    joints = recording.q if recording.robot is not None else None
    poses = joints if joints is not None else recording.orientation
    if recording.wrench is None or poses is None:
        return None
    x = poses.reshape(len(poses), -1)
    total = float(np.linalg.norm(np.ptp(x, axis=0)))
    if total == 0.0:
        return None
    half = _find_half(recording.t, x, total)
    middle = _choose(recording.t, half)
    rows = np.stack((middle - half, middle, middle + half), axis=1)
    means, noise = _average(recording.wrench, middle, half)
    distinct = _count_distinct(x[middle], APART * total)
    common = np.diff(recording.t[rows], axis=1), recording.gravity, means, noise, distinct, _jitter(recording, joints), recording.t[middle]
    if joints is not None and recording.robot is not None:
        robot = RobotModel(recording.robot)
        return Stances(np.zeros((len(rows), 3, 3, 3)), None, *common, robot=robot).at_joints(joints[rows])
    assert recording.orientation is not None
    return Stances(recording.orientation[rows], None if recording.position is None else recording.position[rows], *common)


def _jitter(recording: Recording, joints: Array | None) -> tuple[float, float]:
    """Of joints as if each had an arm of a metre."""
    if joints is not None:
        size = float(np.linalg.norm(white_noise_std(recording.t, joints)))
        return size, size
    assert recording.orientation is not None
    turning = float(white_noise_std(recording.t, recording.orientation.reshape(len(recording), 9)).mean())
    return 0.0 if recording.position is None else float(white_noise_std(recording.t, recording.position).mean()), turning


def _find_half(t: Array, x: Array, total: float) -> int:
    """Half a window's width in rows; 0 for a series of poses."""
    steps = np.linalg.norm(np.diff(x, axis=0), axis=1)
    moving = steps[steps > 1e-3 * steps.max()]
    step = float(np.median(moving))
    if len(x) < FEWEST_ROWS or step > LARGEST_STEP * total:
        return 0
    period = float(np.median(np.diff(t)))
    if LIKELY_PERIOD_S[0] < period < LIKELY_PERIOD_S[1]:
        return max(1, min(round(WINDOW_S / period), len(x) // 4))
    return int(np.clip(SLOW_SHARE * total / step, 1, MOST_ROWS))


def _choose(t: Array, half: int) -> NDArray[np.intp]:
    """Middles of windows, evenly over the rows, without those that a gap in time would cut."""
    n = len(t)
    middle = np.unique(np.linspace(half, n - 1 - half, min(n - 2 * half, LOOKED_AT)).astype(int))
    if not half:
        return middle
    left, right = t[middle] - t[middle - half], t[middle + half] - t[middle]
    even = np.abs(left - right) < 0.2 * (left + right)
    usual = left + right < 2.0 * float(np.median(left + right))
    kept = middle[even & usual]
    return kept if len(kept) else middle[:1]


def _average(wrench: Array, middle: NDArray[np.intp], half: int) -> tuple[Array, Array]:
    """Means under a triangle (P, 6), and their standard uncertainty were the samples' noise white."""
    weights = half + 1.0 - np.abs(np.arange(-half, half + 1)) if half else np.ones(1)
    weights /= weights.sum()
    samples = wrench[middle[:, None] + np.arange(-half, half + 1)]
    means = np.einsum("k,pkc->pc", weights, samples)
    differences = np.diff(samples, axis=1) if half else np.zeros((len(middle), 1, 6))
    white = np.median(np.mean(differences**2, axis=1), axis=0) / 2.0
    return np.asarray(means), np.broadcast_to(np.sqrt(white * (weights**2).sum()), means.shape)


def _count_distinct(x: Array, apart: float) -> int:
    last, count = x[0], 1
    for each in x[1:]:
        if np.linalg.norm(each - last) > apart:
            last, count = each, count + 1
    return count
