"""How much motions tell of a payload through the torques of the joints, where the robot makes them with it and without it.

The rows are those of the estimator itself (`core.estimation.joint_torques`): windows in which friction can be told, and beside the payload
everything that it estimates along, with its priors: friction, gains, rotors, the arm's links. How large the noise of the torques is nobody
knows before a recording; motions are compared under the same for all of them.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.cell.tools import add_cell_tools
from core.estimation.determination import scales
from core.estimation.joint_torques.arm_prior import ASSUMED_LINK_STD, link_modes
from core.estimation.joint_torques.torque_regressor import TorqueRegressor
from core.estimation.joint_torques.unknowns import PHI, Recorded, TorqueModel
from core.estimation.joint_torques.windows import PERIOD_S, TorqueWindows, cut_into_windows
from core.payload.inertia import InertialParameters
from core.planning.information import UNKNOWN_STD
from core.recording.recording import Recording
from core.robot.model import RobotModel
from core.robot.trajectory import JointTrajectory

NOISE_SHARE = 0.002
"""Of the largest torque of a joint: what a window of it is off by."""
GAIN_STD = 0.02
"""Relative, of the torques. A gain that is wrong makes the payload wrong by as much, whatever the motion."""
NO_LOAD = InertialParameters(np.zeros(10))


class TorqueInformation:
    """Of one cell's robot and what it is taken to carry, sensor frame."""

    def __init__(self, cell: Cell, robot: RobotModel, load: InertialParameters) -> None:
        self._robot = robot
        self._gravity = cell.gravity_in_base
        self._regressor = TorqueRegressor(robot, self._gravity)
        self._loaded, self._empty = (np.asarray(add_cell_tools(cell, each).phi) for each in (load, NO_LOAD))

    def find_covariance(self, motions: Sequence[JointTrajectory]) -> Array:
        """(10, 10), of the payload's parameters after motions that follow each other, made with the payload and without."""
        q = np.concatenate([motion.q for motion in motions])
        every = max(1, round(PERIOD_S / motions[0].period))
        return self._find_covariance(q[::every], every * motions[0].period)

    def find_open(self, motions: Sequence[JointTrajectory]) -> float:
        """What they leave open: squared uncertainties over the scales by which a parameter counts as determined, summed (A-optimality)."""
        return float((np.diag(self.find_covariance(motions)) / scales(self._loaded) ** 2).sum())

    def _find_covariance(self, q: Array, period: float) -> Array:
        known = [(True, np.zeros(10)), (False, self._empty)]
        recorded = [
            Recorded(windows, carries, phi)
            for (carries, phi), windows in zip(known, self._cut(q, period), strict=True)
            if windows is not None
        ]
        links = self._regressor.links
        gain_std = np.full(self._robot.n, GAIN_STD)
        if not recorded:
            return np.diag(UNKNOWN_STD[PHI] ** 2)
        model = TorqueModel(recorded, links, link_modes(links, ASSUMED_LINK_STD), gain_std, np.array(self._robot.model.effortLimit))
        b = np.zeros(model.size)
        b[PHI] = self._loaded
        A = np.eye(model.size)
        A[PHI, PHI] = np.diag(UNKNOWN_STD[PHI] ** -2.0)
        for each, (torques, J) in zip(recorded, model.evaluate(b), strict=True):
            noise = NOISE_SHARE * np.maximum(np.abs(torques).max(axis=0), 1e-6)
            rows = (J / noise[:, None])[each.windows.usable]
            A += rows.T @ rows
        return np.asarray(np.linalg.inv(A)[PHI, PHI])

    def _cut(self, q: Array, period: float) -> list[TorqueWindows | None]:
        """The windows with the payload and without it; None where the motion is too short for any."""
        dq = np.gradient(q, period, axis=0)
        Y = self._regressor.rows(q, dq, np.gradient(dq, period, axis=0))
        t = np.asarray(period * np.arange(len(q)), dtype=np.float64)
        cut = []
        for phi in (self._loaded, self._empty):
            tau = Y @ np.concatenate((self._regressor.links.ravel(), phi))
            recording = Recording(t=t, gravity=self._gravity, q=q, tau=tau, robot=self._robot.description)
            cut.append(cut_into_windows(recording, self._robot))
        return cut
