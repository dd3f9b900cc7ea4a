"""What the robot does in one phase: a mover gives the next commanded joint positions, one control period at a time."""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np

from core.array import Array
from core.control.resuming import resume_path, smooth_share
from core.errors import BadState
from core.robot.trajectory import JointTrajectory
from core.sessions.session import RobotState

START_TOLERANCE = 1e-3
"""How far from the robot's commanded position a trajectory may start, rad."""

FADE_S = 1.0
"""Time in which that distance is brought to nothing, so that the command never jumps."""


class Mover(ABC):
    """One motion, used once, from standstill to standstill."""

    period: float
    """Control period it was made for, s."""

    @abstractmethod
    def next(self, state: RobotState) -> Array | None:
        """Joint positions (n,) to be reached by the next period, rad; None when the motion has ended."""

    @abstractmethod
    def resume(self, q: Array) -> None:
        """Goes on with the rest of the motion after it was stopped in the middle, from standstill at commanded joint positions q (n,).

        Raises:
            BadState: the robot is no longer where it stopped.
        """


class Playback(Mover):
    """Follows a trajectory sample by sample.

    An arm with more joints than its task needs comes back from a rotation that was stopped on its way with another posture than planned.
    What is left is faded out smoothly along the way.

    Args:
        trajectory: at the session's period, starting where the robot stands.
    """

    def __init__(self, trajectory: JointTrajectory) -> None:
        self.period = trajectory.period
        self._q = np.array(trajectory.q, dtype=float, order="C")  # one array type, or the guard compiles again while the robot moves
        self._k = 0
        self._away = np.zeros(trajectory.q.shape[1])
        self._fade = min(round(FADE_S / trajectory.period), len(trajectory.q) - 1)

    def next(self, state: RobotState) -> Array | None:
        """The next sample of the trajectory, joint positions (n,), rad, plus what is left of the start's offset; None after the last one.

        Raises:
            BadState: the trajectory does not start where the robot stands.
        """
        if self._k == 0:
            self._check_start(state)
            self._away = state.q_cmd - self._q[0]
        self._k += 1
        if self._k >= len(self._q):
            return None
        planned = np.asarray(self._q[self._k])
        return planned if self._k >= self._fade else planned + self._away * (1.0 - smooth_share(self._k / self._fade))

    def resume(self, q: Array) -> None:
        """Goes back onto the trajectory from joint positions q (n,), rad, where braking has left it, then along it, slowly at first.

        Raises:
            BadState: the robot is no longer where it stopped.
        """
        if self._k == 0:
            return
        self._q = np.array(resume_path(self._q, max(0, self._k - 1), q, self.period), order="C")
        self._k, self._fade = 0, 0

    def _check_start(self, state: RobotState) -> None:
        away = np.abs(self._q[0] - state.q_cmd)
        j = int(np.argmax(away))
        if not away[j] <= START_TOLERANCE:
            raise BadState("motion-starts-elsewhere", joint=j + 1, value=float(away[j]), limit=START_TOLERANCE)


class StandStill(Mover):
    """Holds the commanded position.

    Args:
        duration: s.
        period: control period, s.
    """

    def __init__(self, duration: float, period: float) -> None:
        self.period = period
        self._whole = self._left = round(duration / period)
        self._q: Array | None = None

    def next(self, state: RobotState) -> Array | None:
        """The joint positions (n,), rad, that were commanded when the hold began; None when its time is over."""
        if self._q is None:
            self._q = state.q_cmd.copy()
        self._left -= 1
        return self._q if self._left >= 0 else None

    def resume(self, q: Array) -> None:
        """Begins the hold once more at joint positions q (n,), rad, so that it is motionless for its whole time."""
        self._left, self._q = self._whole, q.copy()
