"""The controller of a KUKA LBR with an application that follows a client, and the virtual robot as its arm.

Session states, their order and what a client has to do in each are as KUKA's client library and its users describe them. What no public
source says is decided here, and docs/robots.md lists it: how quality follows from answers (the share of the last `WINDOW` messages that
were answered in their cycle, and `SILENT` unanswered ones in a row), how long each state takes, that a command which a joint cannot follow
ends the motion, and how hard the arm brakes.
"""

from __future__ import annotations

from collections import deque
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.cell.cell import Cell
from core.fakes.fri_protocol import Answer, FriMessages, fill
from core.fakes.moved_arm import MovedArm
from core.payload.inertia import InertialParameters

IDLE, MONITORING_WAIT, MONITORING_READY, COMMANDING_WAIT, COMMANDING_ACTIVE = range(5)
POOR, FAIR, GOOD, EXCELLENT = range(4)
SHARES = ((EXCELLENT, 0.97), (GOOD, 0.8), (FAIR, 0.5))
"""Share of answered messages from which a connection is so good."""
WINDOW, SILENT = 50, 10
"""Messages that are looked at; unanswered ones in a row that make it poor at once."""
READY, SYNCHRONOUS = 20, 10
"""Cycles from a good connection to the motion of the application; cycles for which a client has to echo before it is followed."""
ECHO_RAD = 1e-4
BEGAN_S = 1_700_000_000
"""What the controller's clock shows at the beginning, s."""


class FriArm(MovedArm):
    """What the controller knows and does; the cell's sensor is on a line of its own.

    Args:
        cell, payload, seed: as of any arm.
        period_ms: how often it sends.
        version: 1 tells the last command in every message, 2 the pose of the tool centre point instead.
    """

    def __init__(
        self, cell: Cell, payload: InertialParameters | None = None, seed: int = 0, *, period_ms: int = 2, version: int = 2
    ) -> None:
        super().__init__(cell, payload, seed, 1e-3 * period_ms)
        self.period_ms, self.version = period_ms, version
        self._messages = FriMessages()
        self.session, self.quality, self.safety, self.operation, self.control = MONITORING_WAIT, POOR, 0, 2, 0
        self.command_mode, self.overlay, self.multiplier = 1, 1, 1
        self.application = True
        """Whether it begins its motion as soon as the connection is good."""
        self.drives_off = 0
        """How many drives have failed."""
        self.joint_speed = np.array([joint.velocity for joint in self._robot.arm.joints])
        self._answers: deque[bool] = deque(maxlen=WINDOW)
        self._unanswered = self._in_state = self._echoed = 0
        self.sequence = self._reflected = 0
        self._wanted: Array | None = None
        self._fresh = self._answered = False
        self.held = self.target

    @property
    def obeys(self) -> bool:
        """Whether a client is followed."""
        return self.session == COMMANDING_ACTIVE

    def take(self, data: bytes) -> bool:
        """A datagram of the client; whether it answers the newest message."""
        answer = self._messages.take(data)
        if answer is None:
            return False
        self._reflected = answer.sequence
        newest = answer.reflected == self.sequence
        self._answered |= newest
        if answer.positions is not None and len(answer.positions) == self.n:
            self._take_positions(answer)
        return newest

    def stop_safely(self, level: int) -> None:
        """The safety controller asks for a stop: 1 is STOP 0 or 1, 2 is STOP 1 on the path, 3 is STOP 2."""
        self.safety = level
        self.end_motion()

    def end_motion(self) -> None:
        """The application's motion ends, by itself or because it was stopped; it begins no other."""
        self.application = False
        self._leave(MONITORING_READY)

    def close(self) -> None:
        """The application closes the session."""
        self._leave(IDLE)

    def step(self) -> None:
        """One cycle: what came is judged, the state goes on, the arm moves, and a new message is due."""
        if self.session != IDLE:
            self._judge()
            self._go_on()
        before = self.target
        if self._braking:
            self.target = self._braking.pop(0)
        elif self.obeys:
            self._follow()
        self._fresh = self._answered = False
        self._move(before)
        self.sequence = (self.sequence + 1) % 2**32

    def message(self) -> bytes:
        """What is sent in this cycle."""
        told, sample, order = self._messages.new(), self.samples[-1], self.order
        told.header.sequenceCounter, told.header.reflectedSequenceCounter = self.sequence, self._reflected
        told.connectionInfo.sessionState, told.connectionInfo.quality = self.session, self.quality
        told.connectionInfo.sendPeriod, told.connectionInfo.receiveMultiplier = self.period_ms, self.multiplier
        robot = told.robotInfo
        robot.numberOfJoints, robot.safetyState, robot.operationMode, robot.controlMode = self.n, self.safety, self.operation, self.control
        drive = {COMMANDING_WAIT: 1, COMMANDING_ACTIVE: 2}.get(self.session, 0)
        robot.driveState.extend([0] * self.drives_off + [drive] * (self.n - self.drives_off))
        data = told.monitorData
        fill(data.measuredJointPosition, sample.q[order])
        fill(data.measuredTorque, sample.tau[order])
        fill(data.commandedTorque, sample.tau[order])
        fill(data.externalTorque, np.zeros(self.n))
        if self.version == 1:
            fill(data.commandedJointPosition, self.target[order])
        else:
            self._tell_pose(data.measuredCartesianPose, sample.q)
        data.timestamp.sec, data.timestamp.nanosec = BEGAN_S + int(self.t + 1e-9), round(1e9 * ((self.t + 1e-9) % 1.0))
        if self.session >= COMMANDING_WAIT:
            fill(told.ipoData.jointPosition, self.held[order])
            told.ipoData.clientCommandMode, told.ipoData.overlayType = self.command_mode, self.overlay
            told.ipoData.trackingPerformance = 1.0 if self.obeys else 0.0
        return bytes(told.SerializeToString())

    def _tell_pose(self, pose: Any, q: Array) -> None:
        position, rotation = self.flange(q)
        pose.name = "measuredCartesianPose"
        pose.element.extend([*(1e3 * position).tolist(), *Rotation.from_matrix(rotation).as_quat(scalar_first=True).tolist()])

    def _take_positions(self, answer: Answer) -> None:
        q = np.empty(self.n)
        q[self.order] = answer.positions
        if self.session == COMMANDING_WAIT:
            self._echoed = self._echoed + 1 if float(np.abs(q - self.held).max()) < ECHO_RAD else 0
        if self.obeys:
            self._wanted, self._fresh = q, True

    def _judge(self) -> None:
        """How good the connection is."""
        self._answers.append(self._answered)
        self._unanswered = 0 if self._answered else self._unanswered + 1
        share = sum(self._answers) / WINDOW
        self.quality = next((name for name, least in SHARES if share >= least), POOR)
        if self._unanswered >= SILENT:
            self.quality = POOR
            self._answers.clear()

    def _go_on(self) -> None:
        """From one state of the session to the next."""
        self._in_state += 1
        if self.quality < GOOD:
            if self.session != MONITORING_WAIT:
                self._leave(MONITORING_WAIT)
        elif self.session == MONITORING_WAIT:
            self._enter(MONITORING_READY)
        elif self.session == MONITORING_READY and self.application and self.safety == 0 and self._in_state >= READY and not self._braking:
            self.held, self._echoed = self.target, 0
            self._enter(COMMANDING_WAIT)
        elif self.session == COMMANDING_WAIT and self._echoed >= SYNCHRONOUS:
            self._wanted = None
            self._enter(COMMANDING_ACTIVE)

    def _follow(self) -> None:
        """To where the client wants it, where the joints can do that in one cycle."""
        self.periods_followed += 1
        self.missed += self.moves and not self._fresh
        if self._wanted is None:
            return
        if not np.isfinite(self._wanted).all() or (np.abs(self._wanted - self.target) > 1.1 * self.joint_speed * self.period).any():
            self.end_motion()
            return
        self.target = self._wanted

    def _enter(self, state: int) -> None:
        self.session, self._in_state = state, 0

    def _leave(self, state: int) -> None:
        """A motion that is under way ends: the arm brakes."""
        if self.obeys and self.moves:
            self._brake()
        self._wanted = None
        self._enter(state)
