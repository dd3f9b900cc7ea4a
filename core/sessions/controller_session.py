"""A session with a real robot's controller: what every driver does on entry and at the end."""

from __future__ import annotations

from abc import abstractmethod
from types import TracebackType
from typing import Self

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.errors import BadState, RobotStateLate, Stopped
from core.robot.model import RobotModel
from core.sessions.command_limits import CommandLimits
from core.sessions.controller import Kinematics
from core.sessions.session import RobotSession


class ControllerSession(RobotSession):
    """Connects, checks and takes the robot on entry; brakes it, gives it back and disconnects at the end, whatever happens in between.

    Args:
        cell: names the controller, and where the sensor frame is on the flange.
        period: of its control loop, s.

    Attributes:
        missed: samples of the controller that were not seen: the loop was late, or the line was.

    Raises:
        BadCell, BadRobot: the cell does not say enough of it.
    """

    def __init__(self, cell: Cell, period: float) -> None:
        self.cell, self.period = cell, period
        self._robot = robot = RobotModel.of_cell(cell)
        self._kinematics = Kinematics(cell, robot)
        given = cell.robot.velocity_rad_s
        velocity = robot.velocity if given is None else np.array(given)
        self._limits = CommandLimits(robot.description.joints, robot.lower, robot.upper, velocity, period)
        self._q_cmd = np.array(cell.robot.home_rad)
        self.missed = 0

    def find_start(self) -> Array:
        """Where the controller commands the arm to be, (n,), rad. Connects, checks, and lets go."""
        try:
            return self._connect()
        finally:
            self._let_go()

    def __enter__(self) -> Self:
        try:
            self._connect()
            self._take()
        except BaseException:
            self._let_go()
            raise
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        """Brakes, gives the robot back and lets go; where the line is lost, the controller has stopped it by itself."""
        try:
            if not isinstance(error, RobotStateLate):
                self.stop()
                self._give_back()
        except (BadState, OSError):
            pass  # it stands already, or its controller stops it
        finally:
            self._let_go()

    def _check_step(self, q: Array) -> Array:
        """The command q (n,), rad; a robot for which it is no possible step brakes.

        Raises:
            BadState: q is not n finite numbers.
            OutOfLimits, TooFast: no such step is possible.
        """
        q = np.array(q, dtype=float)
        try:
            self._limits.check(q, self._q_cmd)
        except Stopped:
            self.stop()
            raise
        return q

    @abstractmethod
    def _connect(self) -> Array:
        """Reaches the controller and checks that it is the cell's robot, ready to be moved. Nothing moves.

        Returns:
            (n,), rad: where it commands the arm to be.
        """

    @abstractmethod
    def _take(self) -> None:
        """Has the controller follow commands; the arm stays where it is, and `missed` counts from then on."""

    @abstractmethod
    def _give_back(self) -> None:
        """Waits until a robot that brakes stands, and ends what `_take` has begun."""

    @abstractmethod
    def _let_go(self) -> None:
        """Disconnects, if it is connected."""
