"""A bench of drivers whose controller sends a datagram a cycle, its sensor on a line of its own."""

from __future__ import annotations

import time
from typing import ClassVar

import numpy as np

from core.cell.cell import Cell
from core.fakes.franka_arm import FrankaArm
from core.fakes.franka_server import FrankaServer
from core.fakes.fri_arm import FriArm
from core.fakes.fri_server import FriServer
from tests.core.sessions.conformance import Bench
from tests.core.sessions.lockstep import LockstepSensor, TrueTime


class ArmTime(TrueTime):
    """The arm's own time, a moment later, as far as nobody has waited for longer."""

    def __init__(self, arm: FriArm | FrankaArm) -> None:
        self._arm, self._waited = arm, 0.0

    @property
    def now(self) -> float:
        return max(self._waited, 1000.0 + self._arm.t + 1e-4)

    @now.setter
    def now(self, value: float) -> None:
        self._waited = value


class DatagramBench(Bench):
    """With the server at the other end of the line, and its arm."""

    AWAY_S: ClassVar[float]
    """How long the server waits for an answer while nobody is there to give one."""
    SENSOR_HZ: ClassVar[float]

    def __init__(self, server: FriServer | FrankaServer) -> None:
        self.server, self.arm = server, server.arm

    def put_sensor(self) -> tuple[LockstepSensor, TrueTime]:
        """On the flange, with the clock of both."""
        clock = ArmTime(self.arm)
        return LockstepSensor(clock, lambda _: -self.arm.samples[-1].wrench, rate_hz=self.SENSOR_HZ), clock

    def where(self) -> np.ndarray:
        return self.arm.q.copy()

    def swap_joints(self) -> Cell:
        self.arm.order[1:4] = [3, 2, 1]
        return self.cell

    def cut(self) -> None:
        self.server.cut = True

    def stay_away(self) -> None:
        self.server.patience_s = self.AWAY_S
        self.settle()

    def settle(self) -> None:
        """Nobody answers meanwhile, so the server's clock may go faster."""
        t, self.server.period = self.arm.t, 0.1 * self.arm.period
        until = time.monotonic() + 60.0
        while self.arm.t < t + 1.0 and time.monotonic() < until:
            time.sleep(0.01)
        self.server.period = self.arm.period
        assert self.arm.t >= t + 1.0
