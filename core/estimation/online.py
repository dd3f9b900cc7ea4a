"""The paper's estimation while the robot moves: Kalman filter, offsets and recursions, one call per sample."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.estimation.estimate import PaperEstimate
from core.estimation.kinematic_filter import SETTLING_S, pose_noise_std
from core.estimation.offset import OpposedPoses
from core.estimation.online_filter import KinematicFilter
from core.estimation.regression import RecursiveRegression, Thresholds
from core.estimation.still_poses import StillPoses
from core.payload.inertia import Motion
from core.robot.model import RobotModel


class OnlineEstimator:
    """Algorithms 1-5 on line.

    Args:
        robot: kinematics; gravity (3,) is in the same frame as its poses.
        period: control period, s.
        noise_std: (6,), of the wrench's samples, N and N m.
        encoder_std: of one reading of a joint's position, rad.
    """

    def __init__(self, robot: RobotModel, gravity: Array, *, period: float, noise_std: Array, encoder_std: float) -> None:
        self._robot = robot
        self._gravity = gravity
        self._noise_std = noise_std
        pose_std = pose_noise_std(encoder_std, robot.n)
        self._filter = KinematicFilter(period, position_std=pose_std, orientation_std=pose_std)
        omega_std, alpha_std, v_std, _ = self._filter.steady_std
        self._alpha_std = float(alpha_std)
        thresholds = Thresholds.of_noise(float(omega_std), float(v_std), self._alpha_std)
        self._regression = RecursiveRegression(thresholds, noise_std**2)
        self._opposed = OpposedPoses()
        self._still = StillPoses(noise_std)
        self._settling = round(SETTLING_S / period)

    def update(self, q: Array, wrench: Array) -> None:
        """Takes the sample of the next period: joint positions (n,) and raw wrench (6,), paper's sign."""
        if not self.follow(q):
            return
        kf = self._filter
        twist, alpha, g = kf.twist, kf.alpha, self._gravity @ kf.rotation
        if self._regression.update(g, twist[3:], twist[:3], alpha, wrench):
            self._opposed.add(g, wrench)
            self._still.add(g, wrench)

    def follow(self, q: Array) -> bool:
        """Takes the joint positions (n,) of the next period, for which there is no wrench; whether the motion is known by now."""
        pose = self._robot.sensor_pose(q)
        self._filter.update(pose.rotation, pose.position)
        if self._settling > 0:
            # the filter needs its run-in: it starts as if anything could be moving
            self._settling -= 1
            return False
        return True

    @property
    def motion(self) -> Motion:
        """The filtered motion of the last sample, one row, sensor frame."""
        return self._filter.motion(self._gravity)

    @property
    def estimate(self) -> PaperEstimate:
        """What the paper's method knows so far; NaN where nothing is: its offsets need every axis both ways."""
        offset = self._opposed.offset
        phi, std = self._regression.found.parameters(offset, torque_std=self._noise_std[3:], alpha_std=self._alpha_std)
        return PaperEstimate(phi, std, offset)

    @property
    def so_far(self) -> PaperEstimate:
        """The same, with mass, first moment and offsets from whatever poses were held, until the paper's method has them."""
        paper, (still, still_std) = self.estimate, self._still.found
        phi, std, offset = paper.phi.copy(), paper.std.copy(), np.where(np.isnan(paper.offset), still[4:], paper.offset)
        early = np.isnan(phi[:4])
        phi[:4], std[:4] = np.where(early, still[:4], phi[:4]), np.where(early, still_std[:4], std[:4])
        return PaperEstimate(phi, std, offset)
