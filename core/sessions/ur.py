"""Universal Robots e-series arms over RTDE: `driver = "ur_rtde"`.

Heft speaks RTDE itself: a driver has to see every sample, and to stop and say why at the first that stays away.
"""

from __future__ import annotations

import time
from typing import NoReturn

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.cell.session import UniversalRobot
from core.errors import BadState, ControllerStopped, NotConnected, RobotStateLate, WrongRobot
from core.sessions.controller_session import ControllerSession
from core.sessions.flange_watch import FlangeWatch
from core.sessions.rtde import Rtde, RtdeError, Value
from core.sessions.sensor_sign import SensorSign
from core.sessions.session import RobotState
from core.sessions.ur_connection import check_arm, reach
from core.sessions.ur_controller import PLAYING, Secondary
from core.sessions.ur_readiness import check_payload_kept, check_ready, check_safety, explain_end, flange_of, payload_set
from core.sessions.ur_servo import (
    BRAKE,
    END,
    FOLLOW,
    INPUTS,
    JOINTS,
    MODE,
    NUMBER,
    OBEYS,
    WAIT,
    WATCHDOG_S,
    read_number,
    read_vector,
    write_program,
)  # fmt: skip

PERIOD = 0.002
RATE_HZ = 500.0
LOOKAHEAD_S, GAIN = 0.03, 600.0
LINK_S = 0.25
"""Without a sample for this long the line counts as lost; the controller's watchdog has stopped the robot by then."""
BEGIN_S = 5.0
"""How long the controller may take to begin the program, and the robot to stand after a stop."""
LOOK = 5
"""Every so many samples the flange that the controller reports is held against the cell's."""
OUTPUTS = (
    "timestamp", "actual_q", "actual_qd", "target_q", "target_qd", "actual_TCP_pose", "tcp_offset", "ft_raw_wrench", "robot_mode",
    "safety_mode", "runtime_state", "speed_scaling", "payload", "payload_cog", OBEYS,
)  # fmt: skip


class UniversalRobotsSession(ControllerSession):
    """A Universal Robots e-series arm with its built-in wrist sensor.

    `state()` waits for the controller's next sample and gives the newest; a cycle without a command sends the last one
    once more, as a sign of life for the controller's watchdog.
    The controller sends the raw wrench about the flange; it is given about the cell's sensor frame, with the paper's sign.

    Args:
        cell: names host and model, and where the sensor frame is on the flange.

    Raises:
        BadCell, BadRobot: the cell does not say enough of it.
    """

    late_s = 0.5 * WATCHDOG_S

    def __init__(self, cell: Cell) -> None:
        assert isinstance(cell.session, UniversalRobot)
        super().__init__(cell, PERIOD)
        self._link = cell.session
        self._flange_watch = FlangeWatch(self._kinematics, self._robot.description.joints)
        assert cell.sensor.mount is not None
        self._mount_rotation, self._mount_position = cell.sensor.mount.rotation, cell.sensor.mount.translation
        self._sign = -1.0 if self._link.wrench_acts_on == "robot" else 1.0
        self._braking = 0.8 * float(np.min(cell.robot.acceleration_rad_s2))
        self._sensor_sign = SensorSign(cell, self._robot)
        self._rtde: Rtde | None = None
        self._sample: dict[str, Value] = {}
        self._payload: tuple[float, ...] = ()
        self._number, self._mode, self._moving = 0, WAIT, False
        self._samples, self._sent = 0, False
        self._token = time.time_ns() % 2**30

    def state(self) -> RobotState:
        """Waits for the controller's next sample.

        Raises:
            ControllerStopped: the controller has stopped the robot or the program, or was set to another payload.
            RobotStateLate: no sample came; the line is lost.
            BadState, WrongKinematics: the flange is not where the cell has it, or moves otherwise.
            WrongSensor: the wrench does not turn with it.
        """
        sample = self._next()
        try:
            check_payload_kept(self._payload, sample)
        except ControllerStopped:
            self.stop()
            raise
        if self._mode == FOLLOW:
            self._check_obeys(sample)
        else:
            self._q_cmd = np.array(read_vector(sample, "target_q"))
        return self._state_of(sample)

    def command(self, q: Array) -> None:
        """Sets the joint positions (6,) to be reached by the next period, rad.

        Raises:
            BadState: the session is stopped, or q is not six finite numbers.
            OutOfLimits, TooFast: no such step is possible; the robot brakes.
            ControllerStopped: the controller takes no commands any more.
        """
        self._open()
        if self._mode == BRAKE:
            raise BadState("session-command-after-stop", value=1.0, limit=0.0)
        q = self._check_step(q)
        if not self._moving and not self._obeys(self._sample):
            # nobody asked for samples for a while, and the watchdog has ended the program of a robot that stood: it goes on there
            self._begin()
        self._moving = not np.array_equal(q, self._q_cmd)
        self._q_cmd = q
        self._number += 1
        self._send(FOLLOW)

    def stop(self) -> None:
        """The controller brakes the robot (`stopj`) until `release()`."""
        if self._mode != BRAKE and self._rtde is not None:
            self._moving = False
            try:
                self._send(BRAKE)
            except OSError:  # the line is lost: the controller's watchdog stops it
                self._mode = BRAKE

    def release(self) -> None:
        """Waits until the robot stands and allows commands again, from there. A program that ended meanwhile is begun again.

        Raises:
            ControllerStopped: the controller lets the robot not move.
        """
        self._stand()
        self._mode = WAIT
        sample = self._next()
        check_safety(sample, braking=self._mode == BRAKE)
        if not self._obeys(sample):
            self._begin()
        self._q_cmd = np.array(read_vector(self._sample, "target_q"))

    def _open(self) -> Rtde:
        if self._rtde is None:
            raise RuntimeError("outside of the session; use it inside `with session:`")
        return self._rtde

    def _connect(self) -> Array:
        host = self._link.host
        reached = reach(host, OUTPUTS, INPUTS, RATE_HZ)
        self._rtde = reached.rtde
        self._number, self._mode, self._moving = 0, WAIT, False
        try:
            sample = self._receive()
        except BadState as error:
            raise NotConnected("session-not-reached", host=host, reason=str(error.message.code)) from error
        self._q_cmd = np.array(read_vector(sample, "target_q"))
        check_arm(self.cell, self._robot, reached, sample)
        self._check_payload(sample)
        check_ready(sample, reached.found, host)
        self._payload = payload_set(sample)
        self._flange_watch = FlangeWatch(self._kinematics, self._robot.description.joints)
        return self._q_cmd

    def _take(self) -> None:
        self._begin()
        self.missed = 0

    def _give_back(self) -> None:
        """Ends the program; where the line is lost, the controller's watchdog has done it."""
        self._stand()
        self._send(END)

    def _check_payload(self, sample: dict[str, Value]) -> None:
        limit, payload = self.cell.robot.payload_limit_kg, read_number(sample, "payload")
        if limit is not None and payload > limit:
            raise WrongRobot("session-payload-beyond-limit", found=payload, expected=limit)

    def _begin(self) -> None:
        """Sends the program and waits until it runs."""
        self._mode = WAIT
        self._token = self._token % 2**30 + 1
        self._keep_alive()  # the registers still hold what the last session asked for
        program = write_program(token=self._token, period=PERIOD, lookahead_s=LOOKAHEAD_S, gain=GAIN, braking_rad_s2=self._braking)
        try:
            secondary = Secondary(self._link.host)  # it tells its state all the time, so it is not left open unread
        except OSError as error:
            raise NotConnected("session-not-reached", host=self._link.host, reason=str(error)[:120]) from error
        try:
            secondary.run(program)
            self._await_program()
        finally:
            secondary.close()

    def _obeys(self, sample: dict[str, Value]) -> bool:
        """Whether this session's program runs."""
        return read_number(sample, "runtime_state") == PLAYING and read_number(sample, OBEYS) == self._token

    def _await_program(self) -> None:
        until = time.monotonic() + BEGIN_S
        while time.monotonic() < until:
            sample = self._next()
            check_safety(sample, braking=self._mode == BRAKE)
            if self._obeys(sample):
                return
        raise NotConnected("session-ur-program-not-begun", host=self._link.host, limit_s=BEGIN_S)

    def _next(self) -> dict[str, Value]:
        """The controller's next sample; where nothing was sent since the last one, a sign of life goes out first."""
        if not self._sent:
            self._keep_alive()
        self._sent = False
        return self._receive()

    def _receive(self) -> dict[str, Value]:
        """The newest sample."""
        rtde = self._open()
        try:
            found = rtde.receive(LINK_S)
        except (OSError, RtdeError) as error:
            self._lose(error)
        if not found:
            self._lose(None)
        before = self._sample
        self._sample = found[-1]
        if before:
            gap = round((read_number(self._sample, "timestamp") - read_number(before, "timestamp")) / PERIOD) - 1
            self.missed += max(0, gap)
        return self._sample

    def _lose(self, error: Exception | None) -> NoReturn:
        self._mode = BRAKE
        raise RobotStateLate("session-link-lost", value=LINK_S, limit=WATCHDOG_S, host=self._link.host) from error

    def _keep_alive(self) -> None:
        self._number += self._mode == FOLLOW  # to stay where the last command was is a command, too: between two motions nobody gives one
        try:
            self._send(self._mode)
        except OSError as error:
            self._lose(error)

    def _send(self, mode: int) -> None:
        """The present command, or the same place once more: a sign of life."""
        self._mode = mode
        values: dict[str, float] = {NUMBER: self._number, MODE: mode}
        values |= dict(zip(JOINTS, self._q_cmd.tolist(), strict=True))
        self._open().send(values)
        self._sent = True

    def _check_obeys(self, sample: dict[str, Value]) -> None:
        """Raises ControllerStopped where a moving robot is no longer moved by the program."""
        try:
            check_safety(sample, braking=self._mode == BRAKE)
            if self._moving and not self._obeys(sample):
                raise explain_end(sample, self._link.host)
        except ControllerStopped:
            self._mode, self._moving = BRAKE, False
            raise

    def _state_of(self, sample: dict[str, Value]) -> RobotState:
        q = np.array(read_vector(sample, "actual_q"))
        self._samples += 1
        dq = np.array(read_vector(sample, "actual_qd"))
        if self._samples % LOOK == 0:
            try:
                self._flange_watch.look(q, dq, *flange_of(sample))
            except BadState:
                self.stop()
                raise
        wrench = self._sign * np.array(read_vector(sample, "ft_raw_wrench"))
        force, R = wrench[:3], self._mount_rotation
        torque = wrench[3:] - np.cross(self._mount_position, force)
        state = RobotState(read_number(sample, "timestamp"), q, dq, self._q_cmd, np.concatenate([R.T @ force, R.T @ torque]))
        if self._mode != BRAKE and self._link.sensor is None:
            self._sensor_sign.look(state)
        return state

    def _stand(self) -> None:
        """Waits until the robot stands."""
        until = time.monotonic() + BEGIN_S
        while self._rtde is not None and time.monotonic() < until:
            sample = self._next()
            if max(abs(v) for v in read_vector(sample, "target_qd")) < 1e-6:
                return

    def _let_go(self) -> None:
        if self._rtde is not None:
            self._rtde.close()
        self._rtde = None
        self._sample = {}
