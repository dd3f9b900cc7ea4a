"""What a recording of a UFACTORY arm relies on beside its motion: payload, tool centre point, the sensor and its zero."""

from __future__ import annotations

import time
from collections.abc import Sequence

from core.errors import ControllerStopped, NotConnected
from core.sessions.xarm_connection import Reached
from core.sessions.xarm_line import ENABLE_SENSOR, SENSOR_MODE, SENSOR_SETUP, Answer
from core.sessions.xarm_readiness import check_kept
from core.sessions.xarm_reports import SlowReport, read_slow

ON_S = 5.0
"""How long the controller may take to switch the sensor on."""
REPORT_S = 5.0
"""The slow reports come five times a second; the arm stands while one is waited for."""
ZERO = slice(26, 50)
"""Where the sensor's zero is in its set-up, six numbers of 4 B."""


class XarmSettings:
    """Watches that nobody changes them.

    Args:
        reached: the controller's lines.
        sensor: whether its own force/torque sensor is used.
    """

    def __init__(self, reached: Reached, *, sensor: bool) -> None:
        self._reached, self._sensor = reached, sensor
        self.now: SlowReport = reached.slow
        self._kept: SlowReport | None = None
        self._zero: bytes | None = None

    def switch_sensor_on(self, host: str) -> None:
        """Its readings are reported only while it is.

        Raises:
            OSError: the controller does not answer.
            NotConnected: it does not come on, or moves the arm by the force that it measures.
        """
        control = self._reached.control
        if any(control.ask(SENSOR_MODE).data[:1]):
            raise NotConnected("xarm-force-control", host=host)
        if not self.now.sensor_on:
            control.ask(ENABLE_SENSOR, b"\x01")
        until = time.monotonic() + ON_S
        while not self.now.sensor_on:
            if time.monotonic() > until:
                raise NotConnected("xarm-sensor-not-on", host=host)
            self.look(REPORT_S)

    def keep(self) -> None:
        """From now on they are to stay as they are.

        Raises:
            OSError: the controller does not answer.
        """
        self._kept = self.now
        if self._sensor:
            self._zero = self._reached.control.ask(SENSOR_SETUP).data[ZERO]

    def ask(self) -> None:
        """Asks for the zero of the sensor; the answer comes with the others."""
        if self._sensor:
            self._reached.control.send(SENSOR_SETUP)

    def look(self, timeout_s: float = 0.0) -> None:
        """Takes the slow reports that have come.

        Raises:
            OSError: the controller has closed the line.
            ControllerStopped: somebody has changed what is to stay.
        """
        found = self._reached.slow_line.receive(timeout_s)
        if found:
            self.now = read_slow(found[-1], self._reached.identity.axes)
            if self._kept is not None:
                check_kept(self._kept, self.now, sensor=self._sensor)

    def check_zero(self, answers: Sequence[Answer]) -> None:
        """Nothing where no answer tells another zero.

        Raises:
            ControllerStopped: one does.
        """
        for answer in answers:
            if answer.register == SENSOR_SETUP and self._zero is not None and answer.data[ZERO] != self._zero:
                raise ControllerStopped("xarm-sensor-zeroed", value=1.0, limit=0.0)
