"""Places in the space of an arm's joints, each in an attitude that differs from those before."""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from bench.second_stranger.arms import Arm, load_model
from bench.second_stranger.array import Array

CANDIDATES, FARTHEST_RAD, FARTHEST_BASE_RAD, REMEMBERED = 24, 2.4, 1.6, 5
LEAST_HEIGHT_M, LEAST_REACH_M = 0.08, 0.22
ALIGNED_RAD = 0.03


class Places:
    """Draws places of an arm that stands so that `up` (3,), base axes, is against gravity, within a share of what its joints can turn."""

    def __init__(self, arm: Arm, rng: np.random.Generator, up: Array, share: float = 1.0) -> None:
        self._rng, self._up = rng, up
        self._limits = share * np.minimum(arm.angle_limits - 0.1, 2.9)
        self._limits[0] = min(self._limits[0], FARTHEST_BASE_RAD)
        self._model = load_model(arm)
        self._data = self._model.createData()
        self._frame = self._model.getFrameId("ft_sensor")
        self._seen: list[Array] = []

    def draw(self, before: Array | None) -> Array:
        """Joints (n,), rad, not too far from those before; of many that the arm can be at, the one in the newest attitude."""
        found: list[tuple[float, Array, Array]] = []
        while len(found) < CANDIDATES:
            q = self._guess(before)
            at = self._locate(q)
            if at.translation[2] < LEAST_HEIGHT_M or np.linalg.norm(at.translation[:2]) < LEAST_REACH_M:
                continue
            up = at.rotation.T @ self._up
            nearest = max((float(up @ other) for other in self._seen[-REMEMBERED:]), default=0.0)
            found.append((nearest, q, up))
        _, q, up = min(found, key=lambda each: each[0])
        self._seen.append(up)
        return q

    def label_hold(self, q: Array) -> str:
        """Which axis of the sensor lies along gravity at joints (n,), rad."""
        down = -(self._locate(q).rotation.T @ self._up)
        axis = int(np.argmax(np.abs(down)))
        is_aligned = abs(down[axis]) > np.cos(ALIGNED_RAD) * np.linalg.norm(down)
        return f"hold:{'xyz'[axis]}{'+' if down[axis] > 0 else '-'}" if is_aligned else "hold:free"

    def _guess(self, before: Array | None) -> Array:
        q = self._rng.uniform(-self._limits, self._limits)
        if before is not None:
            q = np.clip(q, before - FARTHEST_RAD, before + FARTHEST_RAD)
        return np.asarray(q)

    def _locate(self, q: Array) -> pin.SE3:
        pin.framesForwardKinematics(self._model, self._data, q)
        return self._data.oMf[self._frame]
