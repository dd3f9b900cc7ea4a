"""What a Universal Robots controller tells and takes beside RTDE: the dashboard server, and the secondary client interface."""

from __future__ import annotations

import socket
import struct
import time
from typing import NamedTuple

import numpy as np

from core.array import Array

DASHBOARD_PORT = 29999
SECONDARY_PORT = 30002
ROBOT_STATE, CONFIGURATION = 16, 6
SAFETY_NORMAL, SAFETY_REDUCED = 1, 2
MODE_RUNNING = 7
STOPPED, PLAYING, PAUSING, PAUSED = 1, 2, 3, 4
"""Runtime states. The maker does not document them; its users have found 0 stopping, these, and 5 resuming."""
STOPS = {
    3: "session-ur-protective",
    4: "session-ur-recovery",
    5: "session-ur-safeguard",
    6: "session-ur-emergency",
    7: "session-ur-emergency",
    8: "session-ur-violation",
    9: "session-ur-fault",
}
"""Safety modes in which the robot does not move, and the message that says so."""


class Dashboard:
    """The dashboard server: one line asked, one line answered.

    Raises:
        OSError: it cannot be reached, or is silent.
    """

    def __init__(self, host: str, timeout_s: float = 3.0) -> None:
        self._socket = socket.create_connection((host, DASHBOARD_PORT), timeout=timeout_s)
        self._lines = self._socket.makefile("r", encoding="utf-8", errors="replace", newline="\n")
        self._lines.readline()  # it greets

    def ask(self, line: str) -> str:
        """The answer to a command of the dashboard server."""
        self._socket.sendall(f"{line}\n".encode())
        answer = self._lines.readline()
        if not answer:
            raise ConnectionResetError("closed by the dashboard server")
        return answer.strip()

    def close(self) -> None:
        """Lets go."""
        self._lines.close()
        self._socket.close()


class Configuration(NamedTuple):
    """The safety configuration that the secondary interface tells, (6,) each: joint limits, rad, and largest joint speeds, rad/s."""

    lower: Array
    upper: Array
    velocity: Array


class Secondary:
    """The secondary client interface: it takes programs and tells the configuration, ten times a second.

    Raises:
        OSError: it cannot be reached.
    """

    def __init__(self, host: str, timeout_s: float = 3.0) -> None:
        self._socket = socket.create_connection((host, SECONDARY_PORT), timeout=timeout_s)
        self._timeout_s = timeout_s

    def run(self, program: str) -> None:
        """Lets the controller run a program. A main program (`def`) ends whatever ran before, a secondary one (`sec`) runs beside it."""
        self._socket.sendall(program.encode())

    def read_configuration(self) -> Configuration:
        """Waits for the next robot state that holds the configuration.

        Raises:
            OSError: none comes.
        """
        until = time.monotonic() + self._timeout_s
        while time.monotonic() < until:
            (length,) = struct.unpack(">i", self._read(4))
            content = self._read(length - 4)
            if content[0] == ROBOT_STATE:
                found = _find(content[1:], CONFIGURATION)
                if found is not None:
                    numbers = np.array(struct.unpack_from(">24d", found))
                    return Configuration(numbers[0:12:2], numbers[1:12:2], numbers[12::2])
        raise TimeoutError("no configuration")

    def close(self) -> None:
        """Lets go; the program runs on."""
        self._socket.close()

    def _read(self, count: int) -> bytes:
        content = b""
        while len(content) < count:
            more = self._socket.recv(count - len(content))
            if not more:
                raise ConnectionResetError("closed by the controller")
            content += more
        return content


def _find(packages: bytes, kind: int) -> bytes | None:
    """The content of the sub-package of this kind."""
    while len(packages) >= 5:
        length, found = struct.unpack_from(">iB", packages)
        if found == kind:
            return packages[5:length]
        packages = packages[max(5, length) :]
    return None


class ControllerFound(NamedTuple):
    """What a controller tells of itself beside RTDE."""

    remote: bool
    model: str
    serial: str
    configuration: Configuration


def read_controller(host: str) -> ControllerFound:
    """Asks the dashboard server and the secondary interface.

    Raises:
        OSError: one of them cannot be reached, or is silent.
    """
    dashboard = Dashboard(host)
    try:
        remote = dashboard.ask("is in remote control").casefold() == "true"
        model, serial = dashboard.ask("get robot model"), dashboard.ask("get serial number")
    finally:
        dashboard.close()
    secondary = Secondary(host)
    try:
        return ControllerFound(remote, model, serial, secondary.read_configuration())
    finally:
        secondary.close()
