"""What the joints' torques are linear in: the links of the arm and what the sensor's frame carries."""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from core.array import Array
from core.payload.inertia import PINOCCHIO_ORDER, frame_change
from core.robot.model import RobotModel


class TorqueRegressor:
    """Regressor of an arm's equations of motion, `tau = Y (links, payload)`.

    Args:
        robot: in the base frame.
        gravity: (3,), base frame, m/s2.

    Attributes: `links` (n, 10), the URDF's inertial parameters of what moves with each joint, in the joint's frame, the paper's order.
    """

    def __init__(self, robot: RobotModel, gravity: Array) -> None:
        self._model = robot.model.copy()
        self._model.gravity.linear = np.asarray(gravity, dtype=float)
        self._data = self._model.createData()
        self.n = robot.n
        moving = list(self._model.inertias)[1:]
        self.links = np.stack([np.asarray(inertia.toDynamicParameters())[PINOCCHIO_ORDER] for inertia in moving])
        sensor = self._model.frames[robot.sensor_frame_id].placement
        self._of_payload = frame_change(sensor.rotation, sensor.translation)

    def rows(self, q: Array, dq: Array, ddq: Array) -> Array:
        """(N, n, 10 n + 10) for positions, velocities and accelerations (N, n): ten columns for each link, then those of the payload."""
        n = self.n
        order = (10 * np.arange(n)[:, None] + PINOCCHIO_ORDER).ravel()
        Y = np.empty((len(q), n, 10 * n + 10))
        for k in range(len(q)):
            Y[k, :, : 10 * n] = pin.computeJointTorqueRegressor(self._model, self._data, q[k], dq[k], ddq[k])[:, order]
        Y[:, :, 10 * n :] = Y[:, :, 10 * n - 10 : 10 * n] @ self._of_payload
        return Y
