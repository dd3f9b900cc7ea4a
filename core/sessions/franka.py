"""Panda and Franka Research 3 over the Franka Control Interface (FCI): `driver = "franka_fci"`.

Heft speaks the protocol itself: the maker's library is C++, and its Python package could not be had. The controller sends its state a
thousand times a second and takes one command of joint positions for each, which its own joint impedance follows. What it has not within
the millisecond it makes up by itself; after twenty of these in a row it ends the motion: that is its watchdog.
"""

from __future__ import annotations

import threading
from collections import deque
from typing import NoReturn

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.errors import BadCell, BadState, ControllerStopped, NotConnected, RobotStateLate, TooFast
from core.sessions.controller_session import ControllerSession
from core.sessions.flange_watch import FlangeWatch
from core.sessions.franka_arm import flange_of, link_of, reach
from core.sessions.franka_keeper import Keeper
from core.sessions.franka_line import FciLine
from core.sessions.franka_messages import JOINTS, PERIOD, Command, Mode, Sample, write_move
from core.sessions.franka_path import SHARE, Difference, Smoothness, Steps, braking_path, make_of
from core.sessions.franka_readiness import check_ready, explain_end, explain_refusal, runs
from core.sessions.session import RobotState
from core.words.message import Message

LOOK = 10
"""Every so many samples the flange that the controller reports is held against the cell's."""
STARVED_S = 0.02
"""The controller has ended the motion of an arm that was sent nothing for so long."""
LINK_S = 0.25
"""Without a state for this long the line counts as lost; the controller has ended the motion by then."""
BEGIN_S = 3.0
"""How long the controller may take to begin a motion, or to end it."""
OUTCOME_S = 0.1
"""How long it may take to say what has become of a motion."""
START_RAD = 0.005
"""Farther than this from where the arm stands no motion is begun."""
TAKEN_RAD = 4e-7
"""Beyond this what the controller commands is not what it was sent. Single precision loses at most a third of it; what goes unnoticed below
it counts as a jerk of 400 rad/s3 to the controller, and of three times that in the period that follows."""
MOST_LATE, LATELY = 0.5, 0.02
"""A robot that does more than this share of its motion by itself is led by nobody; what a cycle counts in it, so that some fifty do."""
WAIT, FOLLOW, BRAKE = "wait", "follow", "brake"


class FrankaSession(ControllerSession):
    """A Panda or Research 3, its wrench that of a sensor on a line of its own: until that is put in it is not a number.

    `state()` waits for the controller's next state and gives the newest; one that no command has answered is answered with the last one,
    and where the arm moved it brakes. `stop()` makes the driver itself brake in the periods that follow, within the limits of the
    controller. Where that had a command too late and went on by itself, the way back to the path is smooth; `q_cmd` of a state is the path.
    While nobody asks, an arm that stands is kept in its motion (`Keeper`); after a stop the motion is over, and `release()` begins another.

    Args:
        cell: names host and model, and the sensor.

    Raises:
        BadCell, BadRobot: the cell does not say enough of it.

    Attributes:
        external_torque: (7,), N m, which the controller does not explain by what it knows of the arm and its load; of the newest state.
        estimate: (6,), N and N m, the force on the tool as it follows from these, base axes: no measurement.
        lost: how often the controller went on by itself.
    """

    late_s = 0.5 * STARVED_S

    def __init__(self, cell: Cell) -> None:
        self._link = link_of(cell)
        if self._link.sensor is None:
            raise BadCell(cell.locate("session.sensor"), "franka-no-sensor")
        super().__init__(cell, PERIOD)
        self._line: FciLine | None = None
        self._sample: Sample | None = None
        self._mode, self._answered, self._move = WAIT, True, 0
        self._sent = self._path = Steps(self._q_cmd)
        self._difference = Difference(JOINTS)
        self._braking: deque[Array] = deque()
        self._zero_s, self._samples, self._missed_at_begin, self.lost = 0.0, 0, 0, 0
        self.external_torque, self._external_at_begin = np.zeros((2, JOINTS))
        self.estimate, self._estimate_at_begin = np.zeros((2, 6))
        self._late = 0.0
        self._lock = threading.RLock()
        self._keeper: Keeper | None = None

    def state(self) -> RobotState:
        """Waits for the controller's next state.

        Raises:
            ControllerStopped: the robot obeys no longer, or would not in a moment.
            RobotStateLate: no state came; the line is lost.
            BadState, WrongKinematics: the flange is not where the cell has it, or moves otherwise.
        """
        with self._lock:
            moves = not self._rests
            before, sample = self._newest(), self._next()
            if self._mode != BRAKE:
                try:
                    self._check(before, sample, moves=moves)
                except BadState:
                    self.stop()
                    raise
            self._note()
            unknown = np.full(6, np.nan)
            return RobotState(sample.t - self._zero_s, sample.q, sample.dq, self._q_cmd, unknown, tau=sample.torque, wrench_measured=False)

    def command(self, q: Array) -> None:
        """Sets the joint positions (n,) to be reached by the next period, rad.

        Raises:
            BadState: the session is stopped, or q is not n finite numbers.
            OutOfLimits, TooFast: no such step is possible, or not without a jerk that the controller refuses; the robot brakes.
            ControllerStopped: the same, because the controller went on by itself too far.
        """
        with self._lock:
            self._newest()
            if self._mode == BRAKE:
                raise BadState("session-command-after-stop", value=1.0, limit=0.0)
            q = self._check_step(q)
            if self._mode == WAIT or self._braking:  # where the path begins, or goes on after it was told nothing for a moment
                self._path = Steps(q if self._mode == WAIT else self._q_cmd)
                self._difference.set(self._sent, self._path)
                self._braking.clear()
            sent = self._sent.next(q + self._difference.next())
            try:
                self._smooth.check(self._sent, sent)
            except TooFast as error:
                late = self._difference.any
                self.stop()
                if late:
                    raise ControllerStopped("franka-too-late", value=float(self.lost), limit=0.0) from error
                raise
            self._mode, self._q_cmd, self._path = FOLLOW, q, self._path.next(q)
            self._send(sent)
            self._note()

    def stop(self) -> None:
        """The driver brakes in the periods that follow, along the path, and ends the motion: the controller keeps the place."""
        with self._lock:
            if self._mode != BRAKE and self._line is not None:
                self._mode = BRAKE
                self._brake()

    def release(self) -> None:
        """Waits until the robot stands and begins a new motion, from there.

        Raises:
            ControllerStopped: the controller lets the robot not move.
            NotConnected: it does not begin the motion.
        """
        with self._lock:
            self._end()
            if self._newest().mode != Mode.IDLE:
                raise self._explain(self._newest())
            self._begin()
            self._note()

    def remarks(self) -> list[Message]:
        """What was lost on the way, and what the controller felt before anything moved: estimates of its own, no measurements."""
        j = int(np.argmax(np.abs(self._external_at_begin)))
        force = float(np.linalg.norm(self._estimate_at_begin[:3]))
        return [
            Message.of("franka-counted", missed=self.missed, lost=self.lost),
            Message.of("franka-external", joint=self._robot.description.joints[j], torque=float(self._external_at_begin[j]), force=force),
        ]

    def _newest(self) -> Sample:
        if self._line is None or self._sample is None:
            raise RuntimeError("outside of the session; use it inside `with session:`")
        return self._sample

    @property
    def _rests(self) -> bool:
        """Whether nothing moves, nor is to."""
        return self._sent.rests and self._path.rests and not self._difference.any

    def _open(self) -> FciLine:
        assert self._line is not None
        return self._line

    def _connect(self) -> Array:
        """Connects and checks. Where the controller commands the arm to be is where it stands, but for the sag of its impedance; a
        position that it has left behind (guided by hand since) is none."""
        reached = reach(self.cell, self._robot)
        self._line, sample = reached.line, reached.sample
        check_ready(sample, self._link.host)
        self._smooth = Smoothness(self._robot.description.joints, make_of(reached.line.version), reached.description.envelope)
        self._flange_watch = FlangeWatch(self._kinematics, self._robot.description.joints)
        self._mode, self._answered, self._sample, self._zero_s = WAIT, True, sample, sample.t
        self._braking.clear()
        near = float(np.abs(sample.q_d - sample.q).max()) <= START_RAD
        self._q_cmd = sample.q_d if near else sample.q
        return self._q_cmd

    def _take(self) -> None:
        self._begin()
        sample, line = self._newest(), self._open()
        self._external_at_begin, self._estimate_at_begin = sample.external, sample.estimate
        self._missed_at_begin, self.missed, self.lost, self._samples = line.missed, 0, 0, 0
        self._keeper = Keeper(self._attend)
        self._keeper.begin()

    def _begin(self) -> None:
        """Has the controller follow joint positions; the arm stays where it is.

        Raises:
            NotConnected: it does not begin.
        """
        line, host = self._open(), self._link.host
        try:
            self._move, answer = line.ask(Command.MOVE, write_move(line.dialect.move_tail))
            self._check_begun(answer)
            until = self._newest().t + BEGIN_S
            while True:
                sample = line.receive(LINK_S)
                if sample is None:
                    raise TimeoutError("no state")
                later = line.answer_to(self._move)
                if later is not None:
                    self._check_begun(later)
                if runs(sample):
                    break
                if sample.t > until:
                    raise NotConnected("franka-not-begun", host=host, limit_s=BEGIN_S)
        except OSError as error:
            raise NotConnected("franka-not-reached", host=host, port=str(self._link.port), reason=str(error)[:120]) from error
        apart = float(np.abs(sample.q_d - sample.q).max())
        if apart > START_RAD:
            raise NotConnected("franka-start", host=host, value=apart, limit=START_RAD)
        self._sample, self._answered, self._load, self._mode = sample, False, sample.load, WAIT
        self._sent = self._path = Steps(sample.q_d)
        self._q_cmd, self._difference, self._late = sample.q_d, Difference(JOINTS), 0.0

    def _check_begun(self, answer: bytes) -> None:
        """Raises NotConnected where the controller has not begun the motion, or has ended it at once."""
        outcome = self._name_outcome(answer)
        if outcome != "started":
            raise NotConnected("session-not-ready", host=self._link.host, why=explain_refusal(outcome))

    def _name_outcome(self, answer: bytes) -> str:
        names = self._open().dialect.outcomes
        return names[answer[0]] if answer[0] < len(names) else str(answer[0])

    def _next(self) -> Sample:
        """The controller's next state; the last one is answered first where no command has done so.

        Raises:
            RobotStateLate: none comes.
        """
        if not self._answered:
            self._answer(self._newest())
        try:
            sample = self._open().receive(LINK_S)
        except OSError as error:
            self._lose(error)
        if sample is None:
            self._lose(None)
        self._hear(sample)
        return sample

    def _hear(self, sample: Sample) -> None:
        """A new state: where the controller has gone on by itself, all goes on from there."""
        self._sample, self._answered = sample, False
        self.external_torque, self.estimate = sample.external, sample.estimate
        self.missed = self._open().missed - self._missed_at_begin
        if not runs(sample):
            return
        late = bool(np.abs(sample.q_d - self._sent.q).max() > TAKEN_RAD)
        self._late += LATELY * (late - self._late)
        if late:
            self.lost += 1
            self._sent = Steps(sample.q_d, sample.dq_d, sample.ddq_d)
            if self._mode == FOLLOW and not self._braking:
                self._difference.set(self._sent, self._path)
            else:
                self._brake()

    def _answer(self, sample: Sample) -> None:
        """The next command of a stop, which ends with the motion, or the present one once more; an arm that moves and is told nothing
        brakes."""
        self._answered = True
        if not runs(sample):
            self._braking.clear()
            return
        if not self._braking and not self._rests:
            self._brake()
        q = self._braking.popleft() if self._braking else self._sent.q
        self._send(self._sent.next(q), finished=self._mode == BRAKE and not self._braking)
        self._path, self._q_cmd = self._sent, self._sent.q

    def _brake(self) -> None:
        acceleration = SHARE * np.minimum(self._smooth.acceleration, np.array(self.cell.robot.acceleration_rad_s2))
        self._braking = deque(braking_path(self._sent, acceleration, SHARE * self._smooth.jerk))
        self._difference = Difference(JOINTS)

    def _send(self, sent: Steps, *, finished: bool = False) -> None:
        self._sent, self._answered = sent, True
        try:
            self._open().command(self._newest().number, sent.q, finished=finished)
        except OSError as error:
            self._lose(error)

    def _check(self, before: Sample, sample: Sample, *, moves: bool) -> None:
        """Nothing where the robot obeys, and is where the cell has it."""
        if not runs(sample):
            raise self._explain(sample)
        elapsed = sample.t - before.t
        if moves and elapsed > STARVED_S:
            raise ControllerStopped("franka-starved", value=elapsed, limit=STARVED_S)
        if self._late > MOST_LATE:
            raise ControllerStopped("franka-often-late", value=self._late, limit=MOST_LATE)
        if not np.array_equal(sample.load, self._load):
            raise ControllerStopped("franka-load-changed", value=float(sample.load[0]), limit=float(self._load[0]))
        self._samples += 1
        if self._samples % LOOK == 0:
            self._flange_watch.look(sample.q, sample.dq, *flange_of(sample))

    def _explain(self, sample: Sample) -> ControllerStopped:
        try:
            answer = self._open().answer_to(self._move, OUTCOME_S)
        except OSError as error:
            self._lose(error)
        return explain_end(sample, None if answer is None else self._name_outcome(answer))

    def _lose(self, error: Exception | None) -> NoReturn:
        self._mode = BRAKE
        self._braking.clear()
        raise RobotStateLate("franka-link-lost", value=LINK_S, limit=LINK_S, host=self._link.host) from error

    def _give_back(self) -> None:
        """The motion is ended; where the controller has ended it already, there is nothing to be done."""
        with self._lock:
            self._end()

    def _end(self) -> None:
        """Waits until a robot that brakes stands and its controller has ended the motion."""
        until = self._newest().t + BEGIN_S
        while runs(self._newest()) and self._newest().t < until:
            self._next()

    def _attend(self) -> None:
        """Answers in the place of a control loop that is away, an arm that stands or brakes; one that is led stays with its controller's
        watchdog."""
        with self._lock:
            try:  # somebody may have come while the lock was waited for
                while self._line is not None and self._keeper is not None and self._keeper.alone and (self._braking or self._rests):
                    sample = self._line.receive(self.period)
                    if sample is not None:
                        self._hear(sample)
                        self._answer(sample)
                    if not self._braking:
                        self._note()
            except (OSError, RobotStateLate):
                self._note()  # whoever asks next finds the line lost, too

    def _note(self) -> None:
        if self._keeper is not None:
            self._keeper.note()

    def _let_go(self) -> None:
        if self._keeper is not None:
            self._keeper.end()
        if self._line is not None:
            self._line.close()
        self._line = self._keeper = None
