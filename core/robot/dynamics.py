"""What the links of an arm, and a load where there is one, ask of its joints: inertia and torque, from the masses of the URDF."""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from core.array import Array
from core.payload.inertia import PINOCCHIO_ORDER, InertialParameters
from core.robot.chain import first_moment_many
from core.robot.model import RobotModel


class LinkDynamics:
    """Rigid-body dynamics of the arm.

    Args:
        robot: with masses in its URDF (see `has_masses`).
        gravity: (3,), in the frame of the robot model's poses, m/s2.
        load: what hangs on the sensor, in its frame; None for the bare arm.
    """

    def __init__(self, robot: RobotModel, gravity: Array, load: InertialParameters | None = None) -> None:
        self._model = robot.model.copy()
        self._model.gravity.linear = np.asarray(gravity, dtype=float)
        if load is not None:
            sensor = self._model.frames[robot.sensor_frame_id]
            carried = pin.Inertia.FromDynamicParameters(load.phi[PINOCCHIO_ORDER])
            self._model.inertias[sensor.parentJoint] += sensor.placement.act(carried)
        self._data = self._model.createData()
        self._chain = robot.chain

    def inertia(self, q: Array) -> Array:
        """(N, n, n), in joint coordinates, kg m2, at each row of q (N, n)."""
        found = np.empty((*q.shape, q.shape[1]))
        for k, row in enumerate(q):
            found[k] = pin.crba(self._model, self._data, row)
        upper = np.triu(found)
        return np.asarray(upper + np.triu(upper, 1).transpose(0, 2, 1))

    def torque(self, q: Array, dq: Array, ddq: Array) -> Array:
        """(N, n), N m, for positions, velocities and accelerations (N, n): recursive Newton-Euler."""
        found = np.empty(q.shape)
        for k, row in enumerate(zip(q, dq, ddq, strict=True)):
            found[k] = pin.rnea(self._model, self._data, *row)
        return found

    def first_moment(self, q: Array) -> Array:
        """(N, 3), kg m, mass times centre of mass of all that moves, in the frame of the robot model's poses, at each row of q (N, n)."""
        bodies = self._model.inertias[1:]
        masses = np.array([body.mass for body in bodies])
        firsts = np.array([body.mass * body.lever for body in bodies])
        return first_moment_many(self._chain, masses, firsts, np.ascontiguousarray(q, dtype=float))


def has_masses(robot: RobotModel) -> bool:
    """Whether the URDF states any mass."""
    return bool(sum(inertia.mass for inertia in robot.model.inertias) > 0.0)
