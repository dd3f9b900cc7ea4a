"""Whether the wrench turns with the robot as the cell says: known from the first two poses in which the robot stands differently."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.errors import WrongSensor
from core.robot.model import RobotModel
from core.sessions.session import RobotState

STANDING_RAD_S = 0.02
"""Below this speed of every joint the robot stands."""
WINDOW = 50
"""Samples that are averaged."""
TURNED = 0.5
"""Gravity has to have turned by this share of itself in the sensor's frame before the force can tell."""
LEAST_N = 2.0
"""A load whose force changes by less tells nothing."""
ASKEW = 0.4
"""Share of the change that may point elsewhere than gravity's: what a cable or a crooked mount does."""


class SensorSign:
    """Compares how the force and how gravity change between two poses: f2 - f1 = -m (g2 - g1), with a positive mass m.

    The sensor's offset drops out, and nothing need be known of the load.
    """

    def __init__(self, cell: Cell, robot: RobotModel) -> None:
        self._gravity, self._robot = cell.gravity, robot
        self._forces: list[Array] = []
        self._first: tuple[Array, Array] | None = None
        self.decided = False
        """Whether two poses have told."""

    def look(self, state: RobotState) -> None:
        """One sample.

        Raises:
            WrongSensor: the force changed along other axes, or the other way round.
        """
        if self.decided:
            return
        if np.abs(state.dq).max() > STANDING_RAD_S:
            self._forces = []
            return
        self._forces.append(state.wrench[:3])
        if len(self._forces) < WINDOW:
            return
        force, gravity = np.mean(self._forces, axis=0), self._robot.sensor_pose(state.q).rotation.T @ self._gravity
        self._forces = []
        if self._first is None:
            self._first = force, gravity
        else:
            self._judge(force - self._first[0], gravity - self._first[1])

    def _judge(self, df: Array, dg: Array) -> None:
        strength = float(np.linalg.norm(dg))
        if strength < TURNED * np.linalg.norm(self._gravity) or np.linalg.norm(df) < LEAST_N:
            return
        mass = float(-df @ dg) / strength**2
        askew = float(np.linalg.norm(df + mass * dg) / np.linalg.norm(df))
        if askew > ASKEW:
            raise WrongSensor("session-sensor-axes", value=askew, limit=ASKEW)
        if mass < 0.0:
            raise WrongSensor("session-sensor-sign", value=mass, limit=0.0)
        self.decided = True
