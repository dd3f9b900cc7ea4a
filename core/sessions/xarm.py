"""UFACTORY xArm, 850 and Lite 6 over the private TCP protocol: `driver = "xarm"`.

Heft speaks the protocol itself: a driver has to see every sample, and to stop and say why at the first that stays away.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from contextlib import suppress
from typing import NoReturn

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.cell.session import XarmRobot
from core.errors import BadState, ControllerStopped, NotConnected, RobotStateLate
from core.sessions.controller_session import ControllerSession
from core.sessions.flange_watch import FlangeWatch
from core.sessions.sensor_sign import SensorSign
from core.sessions.session import RobotState
from core.sessions.xarm_connection import Reached, check_arm, check_rate, reach
from core.sessions.xarm_line import GET_ERROR, SERVO, SET_MODE, SET_STATE, Answer, pack_floats
from core.sessions.xarm_readiness import GO, POSITION, STOPPED, check_obeys, check_ready, explain_error, obeys
from core.sessions.xarm_readiness import SERVO as SERVO_MODE
from core.sessions.xarm_reports import SLOTS, FastReport, read_fast, read_pose, remove_tool
from core.sessions.xarm_settings import REPORT_S, XarmSettings

STARVED_S = 0.1
"""A moving arm that was sent nothing for so long has stood in between, at the last position that it was sent."""
LINK_S = 1.0
"""Without a sample or an answer for this long the line counts as lost. The controller keeps one position only, the newest: an arm that is
sent none goes there and stands, within a period, however long this program waits (the maker's guide to its servo mode). And nothing is sent
meanwhile, for each command answers a report. So patience costs no safety, and what it has to outlast is the line: TCP sends again after 0.2
and 0.6 s, the third time after 1.4 s. Whether a motion may go on then, `STARVED_S` decides by the controller's own clock."""
LEAP_M = 0.01
"""Farthest that servo motion may go in one step, by the maker's guide. Commands that the controller has not taken yet are one step to it:
it goes to the newest at once, at its full speed. A user saw it stand for 190 ms before it did (issue 154 of the maker's client)."""
FEWEST_WAITING = 2
"""Commands that may be on the way: one that was just sent, and one whose answer is."""
BEGIN_S = 5.0
"""How long the controller may take to switch servo motion or the sensor on, and the robot to stand after a stop."""
STANDS_RAD_S = 1e-4
LOOK = 5
"""Every so many samples the flange that the controller reports is held against the cell's."""
ASK_SETUP = 200
"""Every so many samples the controller is asked for the zero of its sensor."""
WAIT, FOLLOW, BRAKE = "wait", "follow", "brake"


class XarmSession(ControllerSession):
    """A UFACTORY arm with its six-axis force/torque sensor.

    `state()` waits for the controller's next report and gives the newest; in a cycle without a command the last one is sent once more, and
    where there is none the controller is asked for its errors: each answer says whether it has any.
    The raw wrench is given in the axes of the sensor, which are the cell's sensor frame, with the paper's sign.

    Args:
        cell: names host and model, and where the sensor frame is on the flange.

    Raises:
        BadCell, BadRobot: the cell does not say enough of it.
    """

    late_s = 0.5 * STARVED_S

    def __init__(self, cell: Cell) -> None:
        assert isinstance(cell.session, XarmRobot)
        super().__init__(cell, 1.0 / cell.session.rate_hz)
        self._link = cell.session
        self._sign = -1.0 if self._link.wrench_acts_on == "robot" else 1.0
        self._most_waiting = max(FEWEST_WAITING, int(LEAP_M / (cell.limits.cartesian_speed_m_s * self.period)))
        self._sensor_sign = SensorSign(cell, self._robot)
        self._reached: Reached | None = None
        self._mode, self._moving, self._sent = WAIT, False, False
        self._samples = 0

    def state(self) -> RobotState:
        """Waits for the controller's next report.

        Raises:
            ControllerStopped: the controller has an error or takes no commands, or somebody else has stopped it or changed its settings.
            RobotStateLate: no report came; the line is lost.
            BadState, WrongKinematics: the flange is not where the cell has it, or moves otherwise.
            WrongSensor: the wrench does not turn with it.
        """
        before = self._open().fast.t
        sample = self._next()
        try:
            if self._moving and sample.t - before > STARVED_S:
                raise ControllerStopped("xarm-starved", value=sample.t - before, limit=STARVED_S)
            waiting = self._open().control.waiting
            if self._moving and waiting > self._most_waiting:
                raise ControllerStopped("xarm-not-taken", value=waiting, limit=self._most_waiting, leap_m=LEAP_M)
            if self._mode == FOLLOW and not obeys(sample):
                self._explain_end(sample)
        except ControllerStopped:
            self.stop()
            raise
        if self._mode != FOLLOW:
            self._q_cmd = sample.target_q
        return self._state_of(sample)

    def command(self, q: Array) -> None:
        """Sets the joint positions (n,) to be reached by the next period, rad.

        Raises:
            BadState: the session is stopped, or q is not n finite numbers.
            OutOfLimits, TooFast: no such step is possible; the robot brakes.
            ControllerStopped: the controller takes no commands any more.
        """
        reached = self._open()
        if self._mode == BRAKE:
            raise BadState("session-command-after-stop", value=1.0, limit=0.0)
        q = self._check_step(q)
        if self._mode == WAIT and not obeys(reached.fast):
            self._begin()
        self._moving = not np.array_equal(q, self._q_cmd)
        self._q_cmd, self._mode = q, FOLLOW
        try:
            self._send()
        except OSError as error:
            self._lose(error)

    def stop(self) -> None:
        """The controller brakes the robot until `release()`."""
        if self._mode != BRAKE and self._reached is not None:
            self._mode, self._moving = BRAKE, False
            with suppress(OSError):  # where the line is lost it stands where it was sent last
                self._reached.control.send(SET_STATE, bytes([STOPPED]))

    def release(self) -> None:
        """Waits until the robot stands and allows commands again, from there.

        Raises:
            ControllerStopped: the controller lets the robot not move.
        """
        self._stand()
        self._begin()

    def _open(self) -> Reached:
        if self._reached is None:
            raise RuntimeError("outside of the session; use it inside `with session:`")
        return self._reached

    def _connect(self) -> Array:
        self._mode, self._moving, self._sent = WAIT, False, False
        reached = self._reached = reach(self.cell)
        self._settings = XarmSettings(reached, sensor=self._link.sensor is None)
        check_arm(self.cell, self._robot, reached)
        check_ready(reached.slow, self._link.host)
        check_rate(self.cell, reached, LINK_S)
        self._q_cmd = reached.fast.target_q
        self._flange_watch = FlangeWatch(self._kinematics, self._robot.description.joints)
        return self._q_cmd

    def _take(self) -> None:
        self._set_up()
        self._begin()
        self.missed = 0

    def _give_back(self) -> None:
        """Leaves servo motion; where the line is lost, the arm stands where it was sent last."""
        self._stand()
        self._open().control.ask(SET_MODE, bytes([POSITION, 0]))

    def _set_up(self) -> None:
        """The sensor is on, and nobody changes the settings from now on.

        Raises:
            NotConnected: it does not come on, or moves the arm.
        """
        try:
            if self._link.sensor is None:
                self._settings.switch_sensor_on(self._link.host)
            self._settings.keep()
        except OSError as error:
            raise NotConnected("session-not-reached", host=self._link.host, reason=str(error)[:120]) from error

    def _begin(self) -> None:
        """Switches servo motion on; the arm stays where it is.

        Raises:
            ControllerStopped: the controller lets the robot not move.
            NotConnected: it is not switched on in time.
        """
        self._mode, self._moving = WAIT, False
        control = self._open().control
        try:
            for register, value in ((SET_MODE, bytes([SERVO_MODE, 0])), (SET_STATE, bytes([GO]))):
                if control.ask(register, value).failed:
                    raise self._explain_failure()
        except OSError as error:
            self._lose(error)
        until = time.monotonic() + BEGIN_S
        while time.monotonic() < until:
            sample = self._next()
            if obeys(sample):
                self._q_cmd = sample.target_q
                return
        raise NotConnected("xarm-not-begun", host=self._link.host, limit_s=BEGIN_S)

    def _next(self) -> FastReport:
        """The controller's next sample; where nothing was sent since the last one, a sign of life goes out first.

        Raises:
            ControllerStopped: the controller has an error, or its settings were changed.
        """
        reached = self._open()
        try:
            if not self._sent:
                self._send()
            self._sent = False
            found = reached.fast_line.receive(LINK_S)
            answers = reached.control.receive()
            if not found or reached.control.silent_s > LINK_S:
                self._lose(None)
            error = self._explain_failure() if any(answer.failed for answer in answers) and self._mode != BRAKE else None
        except OSError as lost:
            self._lose(lost)
        sample = read_fast(found[-1], self._robot.n)
        self.missed += max(0, round((sample.t - reached.fast.t) / self.period) - 1)
        self._reached = self._open()._replace(fast=sample)
        if error is not None:
            self.stop()
            raise error
        self._check_settings(answers=answers)
        return sample

    def _check_settings(self, timeout_s: float = 0.0, answers: Sequence[Answer] = ()) -> None:
        """Raises ControllerStopped where somebody has changed them."""
        try:
            self._settings.look(timeout_s)
            self._settings.check_zero(answers)
        except OSError as lost:
            self._lose(lost)
        except ControllerStopped:
            self.stop()
            raise

    def _explain_end(self, sample: FastReport) -> None:
        """Raises ControllerStopped with what has ended servo motion."""
        try:
            error = self._explain_failure()
        except OSError as lost:
            self._lose(lost)
        if error.value:
            raise error
        check_obeys(sample)

    def _explain_failure(self) -> ControllerStopped:
        """Asks the controller for its error.

        Raises:
            OSError: it does not answer.
        """
        data = self._open().control.ask(GET_ERROR).data
        return explain_error(data[0] if data else 0)

    def _send(self) -> None:
        """The present command, or a question for errors where there is none."""
        control = self._open().control
        if self._mode == FOLLOW:
            control.send(SERVO, pack_floats(*self._q_cmd, *[0.0] * (SLOTS + 3 - self._q_cmd.size)))
        else:
            control.send(GET_ERROR)
        if self._samples % ASK_SETUP == 0:
            self._settings.ask()
        self._sent = True

    def _lose(self, error: Exception | None) -> NoReturn:
        self._mode, self._moving = BRAKE, False
        self._open().control.abort()
        raise RobotStateLate("xarm-link-lost", value=LINK_S, limit=LINK_S, host=self._link.host) from error

    def _state_of(self, sample: FastReport) -> RobotState:
        reached = self._open()
        self._samples += 1
        if self._samples % LOOK == 0:
            try:
                flange = remove_tool(read_pose(sample.tool, reached.turn), self._settings.now.offset)
                self._flange_watch.look(sample.q, sample.dq, *flange)
            except BadState:
                self.stop()
                self._check_settings(REPORT_S)  # another tool centre point looks like another arm until it is reported
                raise
        state = RobotState(sample.t, sample.q, sample.dq, self._q_cmd, self._sign * sample.raw)
        if self._mode != BRAKE and self._link.sensor is None:
            self._sensor_sign.look(state)
        return state

    def _stand(self) -> None:
        """Waits until the robot stands."""
        until = time.monotonic() + BEGIN_S
        while self._reached is not None and time.monotonic() < until:
            if np.abs(self._next().target_dq).max() < STANDS_RAD_S:
                return

    def _let_go(self) -> None:
        if self._reached is not None:
            self._reached.close()
        self._reached = None
