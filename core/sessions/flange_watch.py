"""Whether a flange moves as the cell's kinematics say: what an arm at rest hides shows within its first degree of motion.

Two joints that are swapped and stand at the same angle, and a joint near zero that turns the other way round, leave the flange where it
should be. As soon as one of them moves it goes elsewhere.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import combinations_with_replacement

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.errors import BadState, WrongKinematics
from core.sessions.controller import ANGLE_RAD, POSITION_M, Kinematics

WITHIN_RAD = 0.05
"""How far apart any joint is, at most, in two samples that are compared: a calibration changes little within that."""
STRAY_M, STRAY_RAD = 0.0015, 0.004
"""The flange may have gone this much otherwise meanwhile."""
APART_S = 0.004
"""Pose and joint positions of one sample may be of instants this far apart."""
REACH_M = 1.0
"""What a joint's speed is taken to be at the flange, at most, for that."""

Pose = tuple[Array, Array]
"""Position (3,), m, and rotation (3, 3)."""


class FlangeWatch:
    """Compares the flange that a controller reports with the cell's, sample by sample.

    Args:
        joints: names of the joints, in the order of q.
    """

    def __init__(self, kinematics: Kinematics, joints: tuple[str, ...]) -> None:
        self._kinematics, self._joints = kinematics, joints
        self._before: tuple[Array, Pose] | None = None

    def look(self, q: Array, dq: Array, position: Array, rotation: Array) -> None:
        """One sample: joint positions (n,), rad, their speeds, rad/s, and the flange in the controller's base frame.

        Raises:
            WrongKinematics: it has moved otherwise than the cell's kinematics say.
            BadState: it is elsewhere.
        """
        far, turned = self._kinematics.distance(q, position, rotation)
        if far > 2 * POSITION_M or turned > 2 * ANGLE_RAD:  # pose and positions are not quite of the same instant
            raise BadState("session-flange-elsewhere", value=far, limit=2 * POSITION_M, angle_rad=turned)
        if self._before is None or np.abs(q - self._before[0]).max() > WITHIN_RAD:
            self._before = q, (position, rotation)
            return
        seen = _motion(self._before[1], (position, rotation))
        late = APART_S * float(np.abs(dq).sum())
        far, turned = self._stray(seen, q, lambda each: each)
        if far > STRAY_M + REACH_M * late or turned > STRAY_RAD + late:
            self._refuse(seen, q, far, turned)

    def _stray(self, seen: Pose, q: Array, mistake: Callable[[Array], Array]) -> tuple[float, float]:
        """How far (m) and how much turned (rad) the flange has gone otherwise than the cell's would have with a mistake in q."""
        assert self._before is not None
        there, here = (self._kinematics.flange(mistake(each)) for each in (self._before[0], q))
        expected = _motion(there, here)
        return float(np.linalg.norm(seen[0] - expected[0])), float(Rotation.from_matrix(expected[1].T @ seen[1]).magnitude())

    def _refuse(self, seen: Pose, q: Array, far: float, turned: float) -> None:
        assert self._before is not None
        moved = float(np.abs(q - self._before[0]).max())
        mistaken = self._find_mistake(seen, q, 0.3 * _score(far, turned))
        if mistaken is None:
            raise WrongKinematics("session-flange-strays", value=far, limit=STRAY_M, angle_rad=turned, limit_rad=STRAY_RAD, moved_rad=moved)
        first, second = (self._joints[k] for k in mistaken)
        if first == second:
            raise WrongKinematics(
                "session-flange-strays-sign", joint=first, value=far, limit=STRAY_M, angle_rad=turned, limit_rad=STRAY_RAD, moved_rad=moved
            )
        raise WrongKinematics(
            "session-flange-strays-swapped",
            first=first,
            second=second,
            value=far,
            limit=STRAY_M,
            angle_rad=turned,
            limit_rad=STRAY_RAD,
            moved_rad=moved,
        )

    def _find_mistake(self, seen: Pose, q: Array, score: float) -> tuple[int, int] | None:
        """The two joints that explain the motion best where they are exchanged, or one twice whose sign does; None beyond this score."""
        best = None
        for i, j in combinations_with_replacement(range(q.size), 2):
            found = _score(*self._stray(seen, q, partial(_exchange, i=i, j=j)))
            if found < score:
                score, best = found, (i, j)
        return best


def _score(far: float, turned: float) -> float:
    return far / STRAY_M + turned / STRAY_RAD


def _motion(before: Pose, after: Pose) -> Pose:
    """How a flange has moved, and how it has turned in its own axes."""
    return after[0] - before[0], before[1].T @ after[1]


def _exchange(q: Array, i: int, j: int) -> Array:
    """q with two joints exchanged; with one of the other sign where both are the same."""
    changed = q.copy()
    changed[[i, j]] = -q[i] if i == j else q[[j, i]]
    return changed
