"""A robot's session with a force/torque sensor that has a line and a clock of its own.

Both clocks are held against this machine's (`core.sensors.clock`), and each sample of the robot gets the wrench of that moment, between the
two readings around it. Where these are not there yet the last wrench is held for the guard's sake and the state says so
(`wrench_measured`), so that nobody records it; when it gets too old the robot is stopped. What the lines alone take cannot be seen by
listening: it remains as a delay of the wrench, which the estimation finds.
"""

from __future__ import annotations

import time
from bisect import bisect_left, insort
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import replace
from statistics import median
from types import TracebackType
from typing import Self

import numpy as np

from core.array import Array
from core.errors import NotConnected, SensorFault, SensorLate, UnusableSensor
from core.payload.channels import CHANNELS
from core.sensors.clock import DeviceClock
from core.sensors.sensor import ForceSensor, Reading
from core.sessions.session import RobotSession, RobotState
from core.words.message import Message

STALE_PERIODS = 10.0
"""Control periods after which a wrench is too old: as many as the guard gives the robot's state."""
SYNC_S = 1.0
"""How long both are listened to before anything may move."""
FIRST_S = 5.0
"""Within this time the clocks have to be known."""
GAP_SAMPLES = 4.0
"""Between readings that are farther apart than this many of the sensor's periods nothing counts as measured."""
RANGE_TOLERANCE = 1.01
KEEP_S = 2.0
"""Readings older than this are no longer needed."""
WAIT_SHARE = 0.6
"""Of a control period that a state may wait for the reading behind it."""


class ExternalSensorSession(RobotSession):
    """The robot's session, its wrench that of the sensor.

    Args:
        inner: the robot.
        sensor: not entered yet.
        sign: -1 where the sensor reports what acts on it, as makers do; the wrench of a state is what it exerts on the payload.
        range_: (6,), N and N m, at which the guard stops the robot; the sensor has to measure so much. Not looked at where None.
        clock: monotonic, that of the sensor's arrivals, s.
    """

    def __init__(
        self,
        inner: RobotSession,
        sensor: ForceSensor,
        *,
        sign: int = -1,
        range_: Array | None = None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.inner, self.sensor = inner, sensor
        self.period, self.late_s = inner.period, inner.late_s
        self._sign, self._range, self._clock = float(sign), range_, clock
        self._stack = ExitStack()
        self._forget()

    def find_start(self) -> Array:
        """Of the robot."""
        return self.inner.find_start()

    def __enter__(self) -> Self:
        self._forget()
        with ExitStack() as stack:
            stack.enter_context(self.sensor)
            self._check_range()
            stack.enter_context(self.inner)
            self._synchronise()
            self._stack = stack.pop_all()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self._stack.__exit__(kind, error, traceback)

    def state(self) -> RobotState:
        """Waits for the next period; the robot's state then with the sensor's wrench of the same moment.

        Raises:
            SensorLate: the newest reading is too old. SensorFault: the sensor says that its reading is none. The robot was stopped.
        """
        state = self._listen()
        stamp_s = self.to_sensor(state.t)
        self._wait_for(stamp_s)
        age, limit = stamp_s - self._newest_s, max(STALE_PERIODS * self.period, GAP_SAMPLES * self._spacing_s)
        if age > limit:
            self.inner.stop()
            lost = self.sensor.tally.lost_share
            raise SensorLate("sensors-late", sensor=self.sensor.name, value=age, limit=limit, lost=lost, samples=(state,))
        wrench, measured, temperature = self._wrench_at(stamp_s)
        return replace(state, wrench=self._sign * wrench, wrench_measured=measured, temperature=temperature)

    def complete(self, state: RobotState) -> RobotState:
        """A state of before with the wrench of its moment, where both readings around it have come since; else as it was."""
        if state.wrench_measured:
            return state
        wrench, measured, temperature = self._wrench_at(self.to_sensor(state.t))
        return replace(state, wrench=self._sign * wrench, wrench_measured=True, temperature=temperature) if measured else state

    def command(self, q: Array) -> None:
        """Of the robot."""
        self.inner.command(q)

    def stop(self) -> None:
        """Of the robot."""
        self.inner.stop()

    def release(self) -> None:
        """Of the robot."""
        self.inner.release()

    def to_sensor(self, t: float) -> float:
        """What the sensor's clock showed when the robot's showed `t`, s, but for the difference of their lines' shortest delays."""
        return self._sensor_clock.line.to_device(self._robot_clock.line.to_here(t))

    def remarks(self) -> list[Message]:
        """How the sensor is set up, what was lost of its samples, and how the clocks go against each other."""
        if not (self._robot_clock.ready and self._sensor_clock.ready):
            return []
        tally, robot, sensor = self.sensor.tally, self._robot_clock.line, self._sensor_clock.line
        counted = Message.of(
            "sensors-counted", sensor=self.sensor.name, received=tally.received, lost=tally.lost, overtaken=tally.overtaken,
            repeated=tally.repeated, malformed=tally.malformed,
        )  # fmt: skip
        clocks = Message.of(
            "sensors-clocks", sensor=self.sensor.name, drift_ppm=1e6 * (robot.drift - sensor.drift), spread_s=sensor.spread_s
        )
        said = [*self.inner.remarks(), *self.sensor.remarks(), counted, clocks]
        if self._spacing_s > 0.6 * self.period:
            wanted_hz, rate_hz = 2.0 / self.period, 1.0 / self._spacing_s
            said.append(Message.of("sensors-slow", sensor=self.sensor.name, rate_hz=rate_hz, wanted_hz=wanted_hz))
        return said

    def _forget(self) -> None:
        self._robot_clock, self._sensor_clock = DeviceClock("robot"), DeviceClock(self.sensor.name)
        self._stamps: list[float] = []
        self._readings: dict[float, Reading] = {}
        self._spacing_s, self._newest_s = np.inf, -np.inf

    def _check_range(self) -> None:
        """Raises UnusableSensor where the sensor is saturated before the guard stops the robot."""
        if self._range is None or self.sensor.range is None:
            return
        for k, (ours, theirs) in enumerate(zip(self._range, self.sensor.range, strict=True)):
            if ours > RANGE_TOLERANCE * theirs:
                raise UnusableSensor(
                    "sensors-range-smaller", sensor=self.sensor.name, channel=CHANNELS[k], found=float(theirs), expected=float(ours),
                    unit="N" if k < 3 else "N m",
                )  # fmt: skip

    def _wait_for(self, stamp_s: float) -> None:
        """Until there is a reading as new as that, for a share of the period at most."""
        until = self._clock() + WAIT_SHARE * self.period
        while self._newest_s < stamp_s and (left := until - self._clock()) > 0.0:
            self._take(self.sensor.read(left))

    def _synchronise(self) -> None:
        """Listens to both until their clocks are known; nothing moves.

        Raises:
            NotConnected: one of them sends too little.
        """
        begin = self._clock()
        while not (self._clock() - begin >= SYNC_S and self._robot_clock.ready and self._sensor_clock.ready):
            self._listen()
            if self._clock() - begin > FIRST_S:
                raise NotConnected("sensors-no-clock", sensor=self.sensor.name, seconds=FIRST_S, received=self.sensor.tally.received)
        self._spacing_s = median(np.diff(self._stamps).tolist())

    def _listen(self) -> RobotState:
        state = self.inner.state()
        self._robot_clock.add(state.t, self._clock())
        self._take(self.sensor.read())
        return state

    def _take(self, readings: list[Reading]) -> None:
        for reading in readings:
            if reading.fault is not None:
                self.inner.stop()
                raise SensorFault("sensors-fault", sensor=self.sensor.name, fault=reading.fault, value=1.0, limit=0.0)
            self._sensor_clock.add(reading.stamp_s, reading.arrival_s)
            if reading.stamp_s not in self._readings:
                insort(self._stamps, reading.stamp_s)
                self._readings[reading.stamp_s] = reading
            self._newest_s = max(self._newest_s, reading.stamp_s)
        while self._stamps and self._stamps[0] < self._newest_s - KEEP_S:
            del self._readings[self._stamps.pop(0)]

    def _wrench_at(self, stamp_s: float) -> tuple[Array, bool, float | None]:
        """(6,) at a moment of the sensor's clock, whether it was measured around it, and the sensor's temperature."""
        behind = bisect_left(self._stamps, stamp_s)
        last = self._readings[self._stamps[min(max(behind - 1, 0), len(self._stamps) - 1)]]
        if behind == len(self._stamps) or (behind == 0 and self._stamps[0] != stamp_s):
            return last.wrench, False, last.temperature
        after = self._readings[self._stamps[behind]]
        gap = after.stamp_s - last.stamp_s
        if gap <= 0.0:
            return after.wrench, True, after.temperature
        share = (stamp_s - last.stamp_s) / gap
        measured = gap <= GAP_SAMPLES * self._spacing_s
        return (1.0 - share) * last.wrench + share * after.wrench, measured, last.temperature
