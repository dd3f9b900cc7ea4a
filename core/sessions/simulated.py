"""A session with the virtual robot."""

from __future__ import annotations

from collections import deque
from types import TracebackType
from typing import Self

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.errors import BadState, Stopped
from core.payload.inertia import InertialParameters
from core.plant.braking import braking_positions
from core.plant.faults.fault import Fault
from core.plant.imperfections import Imperfections
from core.plant.mechanics import PERIOD, Drives
from core.plant.virtual_robot import VirtualRobot
from core.sessions.command_limits import CommandLimits
from core.sessions.pace import AsFastAsPossible, Pace
from core.sessions.session import RobotSession, RobotState
from core.sessions.twin_wrench import TwinWrench
from core.twin.twin import NOMINAL, Twin


class SimulatedSession(RobotSession):
    """The cell's virtual robot with a payload, standing at home on the first entry. Everything that is random follows
    from `seed`.

    `stop()` returns at once: the drives brake in the periods that follow, which `state()` shows as on a real robot.
    `release()` and leaving the session wait until the arm stands. A command that leaves the joint limits or jumps is
    refused, and the drives stop by themselves.

    Args:
        cell: robot, sensor, gravity.
        payload: what the robot carries beside the cell's tools, sensor frame; all zero for a bare flange.
        seed: of offset and noise.
        pace: as fast as possible, or real time for a person who watches.
        imperfections, faults: what is planted; nothing where absent.
        drives: friction and rotor inertia of the joints; those of a usual arm where absent.
        twin: effects that the simulation shows beyond the nominal ones.
        start: (n,), where it stands on the first entry instead of at home, rad.

    Raises:
        BadRobot, BadPayload: the simulation cannot be built.
    """

    period = PERIOD

    def __init__(
        self,
        cell: Cell,
        payload: InertialParameters,
        *,
        seed: int = 0,
        pace: Pace | None = None,
        imperfections: Imperfections | None = None,
        faults: tuple[Fault, ...] = (),
        drives: Drives | None = None,
        twin: Twin = NOMINAL,
        start: Array | None = None,
    ) -> None:
        if start is not None:
            cell = cell.model_copy(update={"robot": cell.robot.model_copy(update={"home_rad": tuple(start.tolist())})})
        rng = np.random.default_rng(seed)
        self.plant = VirtualRobot(cell, payload, rng, imperfections=imperfections, faults=faults, drives=drives)
        """The virtual robot; its `truth` is for tests and for the twin only."""
        self._twin = TwinWrench(cell, twin, self.plant.carried.phi, PERIOD) if twin.effects else None
        self._pace = pace or AsFastAsPossible()
        self._acceleration = np.array(cell.robot.acceleration_rad_s2)
        arm = self.plant.arm
        self._limits = CommandLimits([joint.name for joint in arm.joints], arm.lower, arm.upper, arm.velocity, PERIOD)
        self._q_last = self._q_now = self._q_next = self.plant.home
        self._braking: deque[Array] = deque()
        self._open = False
        self._stopped = False

    def find_start(self) -> Array:
        """Where it stands, (n,), rad."""
        return self._q_now

    def __enter__(self) -> Self:
        self._open = True
        self._stopped = False
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self.stop()
        self._stand()
        self._open = False

    def state(self) -> RobotState:
        """Advances the virtual robot by one period and returns its state then."""
        if not self._open:
            raise RuntimeError("state() outside of the session; use it inside `with session:`")
        target = self._braking.popleft() if self._braking else self._q_next
        sample = self.plant.step(target)
        self._q_last, self._q_now, self._q_next = self._q_now, target, target
        self._pace.wait_until(sample.t)
        wrench = sample.wrench if self._twin is None else sample.wrench + self._twin.change(self.plant.truth)
        return RobotState(sample.t, sample.q, sample.dq, sample.q_cmd, wrench, sample.tau)

    def command(self, q: Array) -> None:
        """Sets the joint positions (n,) that the drives reach by the next period, rad.

        Raises:
            BadState: the session is stopped, or q is not n finite numbers.
            OutOfLimits: q is outside the joint limits; the drives have stopped.
            TooFast: q is farther from the present command than a joint can move in one period; the drives have stopped.
        """
        if not self._open:
            raise RuntimeError("command() outside of the session; use it inside `with session:`")
        if self._stopped:
            raise BadState("session-command-after-stop", value=1.0, limit=0.0)
        q = np.array(q, dtype=float)
        try:
            self._limits.check(q, self._q_now)
        except Stopped:
            self.stop()
            raise
        self._q_next = q

    def stop(self) -> None:
        """Makes the drives brake to standstill in the periods that follow, at the joints' acceleration limits.

        A command that was given for the next period is dropped; further ones are refused until a new entry or `release()`.
        """
        if not self._stopped:
            dq = (self._q_now - self._q_last) / PERIOD
            self._braking.extend(braking_positions(self._q_now, dq, self._acceleration, period=PERIOD))
            self._q_next = self._q_now
            self._stopped = True

    def release(self) -> None:
        """Waits for the end of the braking and allows commands again; go on from the next state's `q_cmd`."""
        self._stand()
        self._stopped = False

    def _stand(self) -> None:
        while self._open and self._braking:
            self.state()
