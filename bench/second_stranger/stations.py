"""Where the sensor is turned about one of its own axes on the spot: poses that the arm reaches and paths between them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pinocchio as pin
from scipy.interpolate import CubicSpline

from bench.second_stranger.arms import Arm, load_model
from bench.second_stranger.array import Array

FARTHEST_RAD = 3.4
"""That a joint may turn on the way to the next station."""
Attitude = tuple[int, int]
"""An axis of the sensor, and whether it points along gravity (1) or against it (-1)."""


class Station(NamedTuple):
    """Joints (n,), rad, where the turn begins, and the path of the joints from there (0) to its end (1)."""

    q: Array
    path: CubicSpline


class Surveyor:
    """Finds stations of an arm, under a gravity whose z has a sign."""

    def __init__(self, arm: Arm, rng: np.random.Generator, gravity_sign: float) -> None:
        self.arm = arm
        self._rng = rng
        self._down = np.array([0, 0, gravity_sign])
        self._model = load_model(arm)
        self._data = self._model.createData()
        self._frame = self._model.getFrameId("ft_sensor")

    def place(self, q: Array) -> pin.SE3:
        """Where the sensor is at joints (n,), rad."""
        pin.framesForwardKinematics(self._model, self._data, q)
        return self._data.oMf[self._frame]

    def label_hold(self, q: Array) -> str:
        """Which axis of the sensor lies along gravity at joints (n,), rad."""
        down = self.place(q).rotation.T @ self._down
        axis = int(np.argmax(np.abs(down)))
        return f"hold:{'xyz'[axis]}{'+' if down[axis] > 0 else '-'}" if abs(down[axis]) > np.cos(0.03) else "hold:free"

    def find_station(self, before: Array | None, attitude: Attitude | None, axis: int, angle: float) -> Station | None:
        """A station that the joints (n,), rad, `before` it can go to, or None where none was found; any attitude for None."""
        for _ in range(400):
            target = self._draw_pose(before is None, attitude)
            q = self._reach(before, target)
            if q is None:
                continue
            path = self._turn(q, axis, angle)
            if path is not None:
                return Station(q, path)
        return None

    def _draw_pose(self, is_first: bool, attitude: Attitude | None) -> pin.SE3:
        rng = self._rng
        azimuth = rng.uniform(-1.3, 1.3) if is_first else rng.uniform(-1.6, 1.6)
        radius = rng.uniform(0.38, 0.68)
        p = np.array([radius * np.cos(azimuth), radius * np.sin(azimuth), rng.uniform(*self.arm.heights)])
        if attitude is None:
            v = rng.normal(size=4)
            return pin.SE3(pin.Quaternion(*(v / np.linalg.norm(v))).matrix(), p)
        axis, sign = attitude
        along = sign * self._down
        across = rng.normal(size=3)
        across -= along * (across @ along)
        across /= np.linalg.norm(across)
        R = np.zeros((3, 3))
        R[:, axis], R[:, (axis + 1) % 3], R[:, (axis + 2) % 3] = along, across, np.cross(along, across)
        return pin.SE3(R, p)

    def _reach(self, before: Array | None, target: pin.SE3) -> Array | None:
        """Joints (n,), rad, nearest to those before of what is found from four guesses; None where all are far."""
        found: list[tuple[float, Array]] = []
        for _ in range(4):
            q = self._solve(self._guess(before), target, 60, 1e-8)
            if q is None:
                continue
            q = (q + np.pi) % (2 * np.pi) - np.pi
            if before is not None:
                self._unwind(q, before)
            self.place(q)
            if self._is_good(q):
                found.append((0.0 if before is None else float(np.max(np.abs(q - before))), q))
        if not found:
            return None
        farthest, nearest = min(found, key=lambda each: each[0])
        return nearest if farthest <= FARTHEST_RAD else None

    def _guess(self, before: Array | None) -> Array:
        rng, n = self._rng, self.arm.joint_count
        if before is None or rng.random() < 0.5:
            return np.asarray(rng.uniform(-0.7, 0.7, n) * np.minimum(self.arm.angle_limits, 2.6))
        return np.asarray(before + rng.normal(size=n) * 0.3)

    def _unwind(self, q: Array, before: Array) -> None:
        """Adds whole turns to joints where that brings them nearer and their limits let them."""
        for j, limit in enumerate(self.arm.angle_limits):
            for other in (q[j] + 2 * np.pi, q[j] - 2 * np.pi):
                if abs(other) < limit - 0.1 and abs(other - before[j]) < abs(q[j] - before[j]):
                    q[j] = other

    def _solve(self, q: Array, target: pin.SE3, tries: int, tolerance: float) -> Array | None:
        """Joints (n,), rad, by damped Newton steps from a guess."""
        for _ in range(tries):
            e = pin.log6(self.place(q).actInv(target)).vector
            size = float(np.linalg.norm(e))
            if size < tolerance:
                return q
            J = self._find_jacobian(q)
            damped = J @ J.T + 1e-4 * min(1, size * size) * np.eye(6) + 1e-14 * np.eye(6)
            step = J.T @ np.linalg.solve(damped, e)
            longest = np.max(np.abs(step))
            q = q + step * min(1, 0.4 / longest if longest > 0 else 1)
        return None

    def _is_good(self, q: Array) -> bool:
        """Whether joints (n,), rad, are within their limits and far from singular."""
        if np.any(np.abs(q) > self.arm.angle_limits - 0.05):
            return False
        return bool(np.linalg.svd(self._find_jacobian(q), compute_uv=False)[-1] > 0.07)

    def _find_jacobian(self, q: Array) -> Array:
        return np.asarray(pin.computeFrameJacobian(self._model, self._data, q, self._frame, pin.LOCAL))

    def _turn(self, q: Array, axis: int, angle: float) -> CubicSpline | None:
        """The path that turns the sensor about its own axis by an angle in rad, its origin at rest; None where the arm cannot."""
        start = self.place(q).copy()
        n = max(4, int(abs(angle) / np.radians(2.5)))
        angles = np.linspace(0, angle, n + 1)
        passed = [q]
        for turned in angles[1:]:
            by = np.zeros(3)
            by[axis] = turned
            target = pin.SE3(start.rotation @ pin.exp3(by), start.translation)
            reached = self._solve(passed[-1], target, 25, 1e-11)
            if reached is None or not self._is_good(reached):
                return None
            if np.max(np.abs(reached - passed[-1])) > 3.2 * abs(angle) / n:
                return None
            passed.append(reached)
        return CubicSpline(angles / angle, np.array(passed))
