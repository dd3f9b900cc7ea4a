"""The lines to a UFACTORY controller: requests on its control port, and the reports that it sends by itself.

Source: the maker's manual of its private TCP protocol, its description of the report ports, and its published client (`xarm-python-sdk`,
BSD). Heft speaks it itself: that client hands on the newest report only, connects again by itself, waits inside without a limit where a
motion is paused, clears warnings on its own, and reads an answer for each command before the next may go out.
"""

from __future__ import annotations

import select
import socket
import struct
import time
from contextlib import suppress
from typing import NamedTuple

HEADER = struct.Struct(">3HB")
"""Transaction, protocol, length of what follows, register."""
PRIVATE = 2
"""The private protocol, without a sign of life that the controller waits for."""
VERSION, SERIAL, ENABLE, SET_STATE, GET_ERROR, SET_MODE, SERVO = 1, 2, 11, 12, 15, 19, 29
SET_LOAD, GET_POSE, FORWARD, IS_BEYOND = 36, 41, 44, 45
ENABLE_SENSOR, SENSOR_MODE, SENSOR_SETUP = 201, 203, 212
"""Registers."""
INVALID, FAILED = 0x08, 0x40
"""Bits of an answer's status: not carried out; the controller has an error."""
LARGEST = 65536
"""Of a report, B."""


class XarmLineError(ConnectionError):
    """What came is not what was asked for."""


class Answer(NamedTuple):
    """What a controller says to a request."""

    register: int
    status: int
    data: bytes

    @property
    def failed(self) -> bool:
        """Whether the controller has an error, whatever was asked."""
        return bool(self.status & FAILED)

    def floats(self, count: int) -> tuple[float, ...]:
        """The first numbers of its data.

        Raises:
            XarmLineError: there are fewer.
        """
        if len(self.data) < 4 * count:
            raise XarmLineError(f"register {self.register}: {len(self.data)} B")
        return struct.unpack_from(f"<{count}f", self.data)


def pack_floats(*values: float) -> bytes:
    """Single precision, little-endian."""
    return struct.pack(f"<{len(values)}f", *values)


class ControlLine:
    """The control port: one request, one answer, in this order; several may be on the way.

    Raises:
        OSError: it cannot be reached.
    """

    def __init__(self, host: str, port: int, timeout_s: float = 3.0) -> None:
        self._socket = socket.create_connection((host, port), timeout=timeout_s)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._timeout_s, self._buffer, self._number = timeout_s, b"", 0
        self._sent_at: dict[int, float] = {}

    def send(self, register: int, data: bytes = b"") -> int:
        """A request, whose answer `receive` will have."""
        self._number = self._number % 65535 + 1
        self._socket.sendall(HEADER.pack(self._number, PRIVATE, 1 + len(data), register) + data)
        self._sent_at[self._number] = time.monotonic()
        return self._number

    def ask(self, register: int, data: bytes = b"") -> Answer:
        """A request and its answer; answers to earlier ones are let go.

        Raises:
            OSError: none comes.
            XarmLineError: the controller has not carried it out.
        """
        number, until = self.send(register, data), time.monotonic() + self._timeout_s
        while True:
            for transaction, answer in self._take():
                if transaction == number:
                    if answer.register != register or answer.status & INVALID:
                        raise XarmLineError(f"register {register}: status {answer.status:#x}")
                    return answer
            if not self._read(until - time.monotonic()):
                raise TimeoutError(f"register {register}: no answer")

    def receive(self) -> list[Answer]:
        """The answers that are here, the oldest first.

        Raises:
            OSError: the controller has closed the line.
        """
        while self._read(0.0):
            pass
        return [answer for _, answer in self._take()]

    @property
    def silent_s(self) -> float:
        """For how long the oldest request has had no answer, s."""
        return time.monotonic() - min(self._sent_at.values()) if self._sent_at else 0.0

    @property
    def waiting(self) -> int:
        """How many requests have had no answer."""
        return len(self._sent_at)

    def abort(self) -> None:
        """Lets go of a line that is lost: what has not got through is thrown away, so that no command arrives when the line is back."""
        with suppress(OSError):  # it was let go before
            self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        self._socket.close()

    def close(self) -> None:
        """Lets go; the controller notices."""
        self._socket.close()

    def _take(self) -> list[tuple[int, Answer]]:
        """The whole answers in the buffer, by their transaction."""
        taken = []
        while len(self._buffer) >= HEADER.size + 1:
            number, protocol, length, register = HEADER.unpack_from(self._buffer)
            if protocol != PRIVATE or length < 2:
                raise XarmLineError(f"protocol {protocol}, {length} B")
            if len(self._buffer) < 6 + length:
                break
            taken.append((number, Answer(register, self._buffer[7], self._buffer[8 : 6 + length])))
            self._buffer = self._buffer[6 + length :]
            self._sent_at.pop(number, None)
        return taken

    def _read(self, timeout_s: float) -> bool:
        more = _receive(self._socket, timeout_s)
        self._buffer += more
        return bool(more)


class ReportLine:
    """A port on which a controller reports by itself.

    Args:
        least: how long a report has to be, B; those of later versions are longer.

    Raises:
        OSError: it cannot be reached.
    """

    def __init__(self, host: str, port: int, least: int, timeout_s: float = 3.0) -> None:
        self._socket = socket.create_connection((host, port), timeout=timeout_s)
        self._least, self._buffer = least, b""

    def receive(self, timeout_s: float) -> list[bytes]:
        """Every report that has come, the oldest first; waits for the first of them. Empty where none comes in time.

        Raises:
            OSError: the controller has closed the line.
            XarmLineError: what it sends is no report.
        """
        until = time.monotonic() + timeout_s
        found: list[bytes] = []
        while True:
            report = self._take()
            if report is not None:
                found.append(report)
                continue
            more = _receive(self._socket, 0.0 if found else until - time.monotonic())
            if not more:
                return found
            self._buffer += more

    def close(self) -> None:
        """Lets go; the controller notices."""
        self._socket.close()

    def _take(self) -> bytes | None:
        """The next whole report in the buffer."""
        if len(self._buffer) < 4:
            return None
        (length,) = struct.unpack_from(">I", self._buffer)
        if not self._least <= length <= LARGEST:
            raise XarmLineError(f"a report of {length} B, expected {self._least} B at least")
        if len(self._buffer) < length:
            return None
        report, self._buffer = self._buffer[:length], self._buffer[length:]
        return report


def _receive(line: socket.socket, timeout_s: float) -> bytes:
    """What has come in time; empty where nothing has.

    Raises:
        ConnectionResetError: the controller has closed the line.
    """
    if not select.select([line], [], [], max(0.0, timeout_s))[0]:
        return b""
    more = line.recv(65536)
    if not more:
        raise ConnectionResetError("closed by the controller")
    return more
