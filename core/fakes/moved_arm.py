"""The virtual robot as the arm of a controller: how its drives go from command to command, how it brakes, where its flange is."""

from __future__ import annotations

from collections import deque

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.fakes.flange import flange_at
from core.payload.inertia import InertialParameters
from core.plant.braking import braking_positions
from core.plant.virtual_robot import VirtualRobot

BRAKING = 6.0
"""Of every joint in a stop, rad/s2."""
MOVING_RAD = 1e-6
"""A robot whose target moves by less in a period stands."""
DRIVES = 0.001
"""Period of the drives, s."""
SPLINE = np.array([[1.0, -3.0, 3.0, -1.0], [4.0, 0.0, -6.0, 3.0], [1.0, 3.0, 3.0, -3.0], [0.0, 0.0, 0.0, 1.0]]) / 6.0
"""(4, 4), shares of four targets in a row, oldest first, for 1, s, s2, s3 of the way s through a period: a uniform cubic B-spline."""


class MovedArm:
    """An arm that a controller tells a target once a period.

    Its drives go on a cubic spline whose acceleration has no steps, one period late. A curve with steps in its velocity has an acceleration
    of its own in each period: a report that always comes at the same place of the period then tells the force of another moment than the
    positions do.

    Args:
        cell: gives arm, sensor and where the arm stands.
        payload: what it carries, sensor frame; a bare flange where None.
        seed: of the sensor's offset and noise.
        period: of the controller, s.
    """

    def __init__(self, cell: Cell, payload: InertialParameters | None, seed: int, period: float) -> None:
        carried = payload or InertialParameters(np.zeros(10))
        self.cell, self.period = cell, period
        self._robot = VirtualRobot(cell, carried, np.random.default_rng(seed))
        self.n = self._robot.arm.n
        self.order = list(range(self.n))
        """Which of the arm's joints the controller counts as its first, second, ...; another order is another robot."""
        self.stretch = 0.0
        """How much farther the flange is along its z than the model says, m: an arm with another calibration."""
        self.periods_followed = self.missed = 0
        """Periods in which commands were followed, and those of them in which the arm moved and no new one had come."""
        self._braking: list[Array] = []
        self.target = self.last = self._robot.home
        self._path = deque([self.target] * 4, maxlen=4)
        s = (1.0 + np.arange(round(period / DRIVES))) / round(period / DRIVES)
        self._shares: Array = np.vander(s, 4, increasing=True) @ SPLINE.T
        self.t = 0.0
        self.samples = [self._robot.step(self.target)]

    @property
    def q(self) -> Array:
        """(n,), where the arm really is, rad."""
        return self._robot.truth.q

    @property
    def moves(self) -> bool:
        """Whether it is on its way."""
        return float(np.abs(self.target - self.last).max()) > MOVING_RAD

    def flange(self, q: Array) -> tuple[Array, Array]:
        """Position, m, and rotation of the flange in the base frame."""
        position, rotation = flange_at(self.cell, self._robot.arm, q)
        return position + rotation[:, 2] * self.stretch, rotation

    def _move(self, before: Array) -> None:
        """A period passes, at whose beginning the target was `before`."""
        self._path.append(self.target)
        self.samples = [self._robot.step(q) for q in self._shares @ np.array(self._path)]
        self.last = before
        self.t += self.period

    def _brake(self, acceleration: float = BRAKING) -> None:
        """Where it moves and does not brake already, the targets of the periods to come let it stand."""
        if self._braking:
            return
        dq = (self.target - self.last) / self.period
        if np.abs(dq).max() > 0.0:
            self._braking = list(braking_positions(self.target, dq, np.full(self.n, acceleration), period=self.period))
