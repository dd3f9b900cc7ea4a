"""The decoupling motion as the robot performs it: a rotation about a sensor axis through the sensor origin, by SNS."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation as SpatialRotation

from core.array import Array
from core.control.bounds import JointLimits
from core.control.movers import Mover
from core.control.resuming import place_on_path, smooth_share
from core.control.rotation_step import _rotation_step
from core.errors import OutOfLimits
from core.robot.chain import forward
from core.robot.collision import SpeedPoints
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile
from core.sessions.session import RobotState

SPEED_SHARE = 0.97
"""Of the Cartesian limit that a rotation may command."""

STALLED = 0.5
"""A rotation is given up when it has not got on for this long, s."""

RAMP_S = 1.0
"""Time in which the planned rate is reached again after a stop in the middle, s."""

AT_REST = 1e-4
"""Joint speed at which the end of a rotation counts as standstill, rad/s."""


class Rotation(Mover):
    """Rotates the sensor about one of its axes along a profile while the sensor origin stays where it is.

    The six-dimensional task is the profile's rate plus a correction of the pose error of the *commanded* configuration,
    so that integration does not drift and no measurement noise gets into the command. Where SNS scales the task, or a
    point of the robot would exceed the Cartesian limit, time along the profile passes more slowly.

    Args:
        robot: kinematics.
        points: of the robot and the payload box, whose speed is limited.
        limits: of the joints.
        cartesian_speed: limit for all points, m/s.
        profile: angle and rate, at the control period.
        axis: of the sensor, 0, 1, 2.
    """

    def __init__(
        self,
        robot: RobotModel,
        points: SpeedPoints,
        limits: JointLimits,
        *,
        cartesian_speed: float,
        profile: AngularProfile,
        axis: int,
    ) -> None:
        self.period = profile.period
        self.profile = profile
        self.axis = axis
        self.scaled = 0
        """Number of periods in which the task was scaled."""
        self._robot = robot
        self._limits = limits
        self._fixed = (*limits, points.joint, points.local, SPEED_SHARE * cartesian_speed, self.period)
        self._q: Array | None = None
        self._dq = np.zeros(robot.n)
        self._start = np.empty((4, 4))
        self._elapsed = 0.0  # in periods of the profile
        self._ramp = 1.0  # share of the time in which the planned rate is reached again after a stop
        self._stalled = 0.0  # s
        self._warm_up()

    def _warm_up(self) -> None:
        """Compiles the step, or loads it, before anything moves."""
        home = np.zeros(self._robot.n)
        T = forward(self._robot.chain, home)
        _rotation_step(*self._robot.chain, home, self._dq, self.axis, T, 0.0, 0.0, *self._fixed, np.empty(len(home)))

    @property
    def progress(self) -> float:
        """Share of the profile that has been done."""
        return min(1.0, self._elapsed / (len(self.profile.angle) - 1))

    @property
    def repetitions_done(self) -> int:
        """How often it has come back to where it began."""
        return int(np.count_nonzero(self.profile.rests <= self._elapsed))

    def end_early(self) -> int:
        """Ends with the repetition that is under way instead of at the end; how many repetitions that leaves out."""
        rests = self.profile.rests
        # the mean rate over the next period has been taken already, so what ends within two periods goes on
        ahead = rests[rests >= self._elapsed + 2]
        if not len(ahead):
            return 0
        self.profile = self.profile.cut(int(ahead[0]))
        return len(ahead) - 1

    def next(self, state: RobotState) -> Array | None:
        """Joint positions (n,), rad, one period further along the profile, as fast as the limits allow; None once it rests at the end.

        Raises:
            OutOfLimits: the limits leave no way to go on with the rotation.
        """
        if self._q is None:
            self._q = state.q_cmd.copy()
            self._start = forward(self._robot.chain, self._q)
        angle, rate = self._task()
        self._ramp = min(1.0, self._ramp + self.period / RAMP_S)
        pace = float(smooth_share(self._ramp))
        if rate == 0.0 and self.progress >= 1.0 and np.abs(self._dq).max() < AT_REST:
            return None
        dq = np.empty(len(self._q))
        chain = self._robot.chain
        s = _rotation_step(*chain, self._q, self._dq, self.axis, self._start, angle, pace * rate, *self._fixed, dq)
        self._q = self._q + self.period * dq
        self._dq = dq
        self._elapsed += s * pace
        self.scaled += s < 1.0
        self._watch(s, self._q)
        return self._q

    def resume(self, q: Array) -> None:
        """Goes on from the angle at which the robot stands with joint positions q (n,), rad, slowly at first.

        Raises:
            BadState: the robot is no longer where it stopped.
        """
        if self._q is None:
            return
        k = min(int(self._elapsed), len(self.profile.angle) - 1)
        now = forward(self._robot.chain, q)
        turned = float(SpatialRotation.from_matrix(self._start[:3, :3].T @ now[:3, :3]).as_rotvec()[self.axis])
        turned += 2.0 * np.pi * round((self.profile.angle[k] - turned) / (2.0 * np.pi))
        place = place_on_path(self.profile.angle[:, None], k, np.array([turned]), self.period)
        self._elapsed, self._ramp, self._stalled = float(place), 0.0, 0.0
        self._q, self._dq = q.copy(), np.zeros(self._robot.n)
        # braking along the tangent leaves the arm some 1e-4 beside the rotation: it goes on about the axis as it lies there
        back = SpatialRotation.from_rotvec(-self.profile.angle[place] * np.eye(3)[self.axis]).as_matrix()
        self._start = now.copy()
        self._start[:3, :3] = now[:3, :3] @ back

    def _task(self) -> tuple[float, float]:
        """Angle of the profile now, and the mean rate over the next period."""
        last = len(self.profile.angle) - 1
        angle, k = self.profile.angle, int(self._elapsed)
        if k >= last:
            return float(angle[last]), 0.0
        share = self._elapsed - k
        now = angle[k] + share * (angle[k + 1] - angle[k])
        after = angle[k + 1] if k + 2 > last else angle[k + 1] + share * (angle[k + 2] - angle[k + 1])
        return float(now), float(after - now) / self.period

    def _watch(self, s: float, q: Array) -> None:
        """Gives up where nothing moves any more."""
        self._stalled = self._stalled + self.period if s < 1e-3 else 0.0
        if self._stalled > STALLED:
            room = np.minimum(q - self._limits.lower, self._limits.upper - q)
            j = int(np.argmin(room))
            raise OutOfLimits(
                "motion-rotation-stalled",
                axis="xyz"[self.axis],
                progress=self.progress,
                joint=self._robot.description.joints[j],
                value=float(room[j]),
                limit=0.0,
            )
