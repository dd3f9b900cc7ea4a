"""KUKA LBR iiwa and LBR Med over the Fast Robot Interface (FRI): `driver = "kuka_fri"`.

A Sunrise application on the controller opens the session and begins a motion that follows the client (`FRIJointOverlay`). Heft answers each
of its messages with one command. The controller itself ends the motion when the answers stay away: that is its watchdog.
"""

from __future__ import annotations

from collections import deque
from typing import NoReturn

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.errors import BadCell, BadState, ControllerStopped, NotConnected, RobotStateLate
from core.plant.braking import braking_positions
from core.sessions.controller_session import ControllerSession
from core.sessions.flange_watch import FlangeWatch
from core.sessions.kuka_arm import check_arm, flange_of, link_of
from core.sessions.kuka_line import FriLine
from core.sessions.kuka_messages import Codec, Quality, Sample, State
from core.sessions.kuka_readiness import UNBEGUN, check_overlay, check_ready, explain_end
from core.sessions.session import RobotState
from core.words.message import Message

LOOK = 2
"""Every so many samples the flange that the controller reports is held against the cell's."""
STARVED_S = 0.1
"""A moving arm that was sent nothing for so long, or whose controller has had nothing for so long, is stopped."""
LINK_S = 0.25
"""Without a message for this long the line counts as lost; the controller has ended the motion by then."""
FIRST_S = 3.0
"""How long the first message may take."""
BEGIN_S = 30.0
"""How long the connection may take to become good, and the Sunrise application to begin its motion, by the controller's clock."""
WAIT, FOLLOW, BRAKE = "wait", "follow", "brake"


class KukaSession(ControllerSession):
    """A KUKA LBR, its wrench that of a sensor on a line of its own: until that is put in it is not a number.

    `state()` waits for the controller's next message and gives the newest; a message that no command has answered is answered with the
    last one. `stop()` makes the driver itself brake in the periods that follow: the interface has no word for it. Joint speeds are
    differences of the measured positions, for the controller tells none; torques are those it measures, in its sign.

    Args:
        cell: names host, port and period, where the tool centre point is on the flange, and the sensor.

    Raises:
        BadCell, BadRobot: the cell does not say enough of it.

    Attributes:
        external_torque: (n,), N m, which the controller does not explain by what it knows of the arm and its load; of the newest message.
    """

    late_s = 0.5 * STARVED_S

    def __init__(self, cell: Cell) -> None:
        self._link = link_of(cell)
        if self._link.sensor is None:
            raise BadCell(cell.locate("session.sensor"), "kuka-no-sensor")
        super().__init__(cell, 1e-3 * self._link.send_period_ms)
        self._acceleration = np.array(cell.robot.acceleration_rad_s2)
        self._line: FriLine | None = None
        self._sample: Sample | None = None
        self._flange_watch: FlangeWatch | None = None
        self._operation, self._zero_s, self._samples, self._missed_at_begin = 0, 0, 0, 0
        self._mode, self._answered = WAIT, True
        self._braking: deque[Array] = deque()
        self._q_before = self._q_cmd
        self._dq, self.external_torque, self._external_at_begin = np.zeros((3, self._robot.n))
        self._worst_quality = int(Quality.EXCELLENT)

    def state(self) -> RobotState:
        """Waits for the controller's next message.

        Raises:
            ControllerStopped: the robot obeys no longer, or would not in a moment.
            RobotStateLate: no message came; the line is lost.
            BadState, WrongKinematics: the flange is not where the cell has it, or moves otherwise.
        """
        before, sample = self._newest(), self._next()
        if self._mode != BRAKE:
            try:
                self._check(before, sample)
            except BadState:
                self.stop()
                raise
        return RobotState(self._time(sample), sample.q, self._dq, self._q_cmd, np.full(6, np.nan), tau=sample.torque, wrench_measured=False)

    def command(self, q: Array) -> None:
        """Sets the joint positions (n,) to be reached by the next period, rad.

        Raises:
            BadState: the session is stopped, or q is not n finite numbers.
            OutOfLimits, TooFast: no such step is possible; the robot brakes.
        """
        self._newest()
        if self._mode == BRAKE:
            raise BadState("session-command-after-stop", value=1.0, limit=0.0)
        q = self._check_step(q)
        self._mode, self._q_before, self._q_cmd = FOLLOW, self._q_cmd, q
        self._send(q)

    def stop(self) -> None:
        """The driver brakes in the periods that follow, along the path, and then keeps the place until `release()`."""
        if self._mode != BRAKE and self._line is not None:
            self._mode = BRAKE
            speed = (self._q_cmd - self._q_before) / self.period
            self._braking = deque(braking_positions(self._q_cmd, speed, self._acceleration, period=self.period))

    def release(self) -> None:
        """Waits until the robot stands and allows commands again, from there.

        Raises:
            ControllerStopped: the controller lets the robot not move.
        """
        self._stand()
        ended = explain_end(self._newest(), self._operation)
        if ended is not None:
            raise ended
        self._mode = WAIT

    def remarks(self) -> list[Message]:
        """What was lost on the way, how good the connection was at worst, and what the controller felt before anything moved."""
        j = int(np.argmax(np.abs(self._external_at_begin)))
        return [
            Message.of("kuka-counted", missed=self.missed, quality=self._worst_quality),
            Message.of("kuka-external", joint=self._robot.description.joints[j], torque=float(self._external_at_begin[j])),
        ]

    def _newest(self) -> Sample:
        if self._line is None or self._sample is None:
            raise RuntimeError("outside of the session; use it inside `with session:`")
        return self._sample

    def _connect(self) -> Array:
        """Hears the controller and checks that it is the cell's robot, ready to be moved. Nothing is answered: the Sunrise application
        goes on waiting. Where the controller does not say where it commands the arm to be (FRI 2 in monitor mode), where the arm stands."""
        link = self._link
        codec = Codec(self.cell.locate("session.driver"))
        try:
            self._line = FriLine(codec, link.host, link.listen, link.port)
            sample = self._line.receive(FIRST_S)
        except OSError as error:
            raise NotConnected("kuka-no-line", host=link.host, port=str(link.port), reason=str(error)[:120]) from error
        if sample is None:
            raise NotConnected("kuka-silent", host=link.host, port=str(link.port), strange=self._line.strange or "none", limit_s=FIRST_S)
        check_arm(self.cell, self._robot, self._kinematics, sample)
        check_ready(sample, link.host, self.cell.limits.cartesian_speed_m_s)
        self._flange_watch = None if sample.pose is None else FlangeWatch(self._kinematics, self._robot.description.joints)
        self._mode, self._answered, self._sample = WAIT, False, sample
        self._operation, self._zero_s, self._dq = sample.operation, sample.stamp[0], np.zeros(self._robot.n)
        self._braking.clear()
        told = sample.ipo if sample.ipo is not None else sample.commanded
        return sample.q if told is None else told

    def _take(self) -> None:
        """Answers until the Sunrise application has begun its motion; the arm stays where it is.

        Raises:
            NotConnected: it does not begin, or begins another kind of motion.
        """
        link, speed = self._link, self.cell.limits.cartesian_speed_m_s
        self._let_end()
        sample = self._newest()
        until = self._time(sample) + BEGIN_S
        while sample.state != State.COMMANDING_ACTIVE:
            if self._time(sample) > until:
                code = UNBEGUN[min(sample.state, int(State.COMMANDING_WAIT))]
                raise NotConnected(code, host=link.host, limit_s=BEGIN_S, quality=sample.quality)
            if sample.state == State.COMMANDING_WAIT:
                check_overlay(sample, link.host)
            sample = self._next()
            check_ready(sample, link.host, speed)
        check_overlay(sample, link.host)
        self._operation, self._worst_quality, self._external_at_begin = sample.operation, sample.quality, sample.external
        self._missed_at_begin, self.missed = self.missed + self._missed_at_begin, 0

    def _let_end(self) -> None:
        """A motion of before is not answered, so that the controller ends it."""
        until = self._time(self._newest()) + FIRST_S
        while self._newest().state == State.COMMANDING_ACTIVE:
            if self._time(self._newest()) > until:
                raise NotConnected("kuka-commanded-already", host=self._link.host)
            self._answered = True
            self._next()

    def _next(self) -> Sample:
        """The controller's next message; the last one is answered first where no command has done so.

        Raises:
            RobotStateLate: none comes.
        """
        before, line = self._newest(), self._line
        assert line is not None
        if not self._answered:
            self._answer(before)
        try:
            sample = line.receive(LINK_S)
        except OSError as error:
            self._lose(error)
        if sample is None:
            self._lose(None)
        elapsed = self._time(sample) - self._time(before)
        if elapsed > 0.0:
            self._dq = (sample.q - before.q) / elapsed
        self._sample, self._answered = sample, False
        self.external_torque, self.missed = sample.external, line.missed - self._missed_at_begin
        self._worst_quality = min(self._worst_quality, sample.quality)
        return sample

    def _answer(self, sample: Sample) -> None:
        """The next command of a stop, or the present one once more; where the controller does not follow yet, where it is itself."""
        if sample.state == State.COMMANDING_ACTIVE:
            self._q_before = self._q_cmd
            if self._braking:
                self._q_cmd = self._braking.popleft()
            self._send(self._q_cmd)
        elif sample.state == State.COMMANDING_WAIT and sample.ipo is not None:
            self._q_cmd = self._q_before = sample.ipo
            self._send(sample.ipo)
        else:
            self._send(sample.commanded)

    def _send(self, q: Array | None) -> None:
        assert self._line is not None
        try:
            self._line.answer(q)
        except OSError as error:
            self._lose(error)
        self._answered = True

    def _check(self, before: Sample, sample: Sample) -> None:
        """Nothing where the robot obeys, and is where the cell has it."""
        assert self._line is not None
        elapsed, unheard = self._time(sample) - self._time(before), self._line.lag * self.period
        if elapsed > STARVED_S and not np.array_equal(self._q_cmd, self._q_before):
            raise ControllerStopped("kuka-starved", value=elapsed, limit=STARVED_S)
        ended = explain_end(sample, self._operation)
        if ended is not None:
            raise ended
        if unheard > STARVED_S:
            raise ControllerStopped("kuka-unheard", value=unheard, limit=STARVED_S)
        self._samples += 1
        if self._flange_watch is not None and sample.pose is not None and self._samples % LOOK == 0:
            self._flange_watch.look(sample.q, self._dq, *flange_of(self.cell, sample.pose))

    def _time(self, sample: Sample) -> float:
        """Of the controller's clock since the second in which it was first heard, s: all of its digits in a number."""
        return float(sample.stamp[0] - self._zero_s) + 1e-9 * sample.stamp[1]

    def _lose(self, error: Exception | None) -> NoReturn:
        self._mode = BRAKE
        self._braking.clear()
        raise RobotStateLate("kuka-link-lost", value=LINK_S, limit=LINK_S, host=self._link.host) from error

    def _give_back(self) -> None:
        """The controller's application notices that no answer comes, and ends its motion."""
        self._stand()

    def _stand(self) -> None:
        """Waits until the robot stands, or the controller does not follow any more."""
        while self._braking and self._newest().state == State.COMMANDING_ACTIVE:
            self._next()

    def _let_go(self) -> None:
        if self._line is not None:
            self._line.close()
        self._line = None
