"""A client of Universal Robots' Real-Time Data Exchange, protocol version 2, from its public description; nothing of Heft is in it.

A package is its length (2 bytes), its kind (1 byte) and its content, big endian. Which outputs come, and which inputs go, is a recipe that
the controller confirms with the types of its fields.
"""

from __future__ import annotations

import select
import socket
import struct
import time
from collections.abc import Mapping, Sequence
from typing import NamedTuple

PORT = 30004
VERSION = 2
REQUEST_VERSION, GET_CONTROLLER, TEXT, DATA = ord("V"), ord("v"), ord("M"), ord("U")
SETUP_OUTPUTS, SETUP_INPUTS, START, PAUSE = ord("O"), ord("I"), ord("S"), ord("P")
TYPES = {
    "BOOL": "?",
    "UINT8": "B",
    "UINT32": "I",
    "UINT64": "Q",
    "INT32": "i",
    "DOUBLE": "d",
    "VECTOR3D": "3d",
    "VECTOR6D": "6d",
    "VECTOR6INT32": "6i",
    "VECTOR6UINT32": "6I",
}
HEADER = struct.Struct(">HB")

Value = float | tuple[float, ...]
"""A number, or the numbers of a vector."""


class RtdeError(Exception):
    """The controller's answer is not what the protocol says, or it refuses what was asked.

    Args:
        what: which step.
        answer: what came.
    """

    def __init__(self, what: str, answer: str) -> None:
        super().__init__(f"{what}: {answer}")
        self.what, self.answer = what, answer


class Field(NamedTuple):
    """One value of a recipe: its name, its format and how many numbers it has."""

    name: str
    form: str
    size: int


class Recipe:
    """The fields of a data package in their order.

    Args:
        number: by which packages name it.
        names, types: as they were asked for, and as the controller answered.

    Raises:
        RtdeError: the controller does not know a field, or somebody else writes it.
    """

    def __init__(self, number: int, names: Sequence[str], types: Sequence[str]) -> None:
        for name, kind in zip(names, types, strict=True):
            if kind not in TYPES:
                raise RtdeError(name, kind)
        self.number = number
        forms = [TYPES[kind] for kind in types]
        self.fields = [Field(name, form, int(form[:-1] or 1)) for name, form in zip(names, forms, strict=True)]
        self._struct = struct.Struct(">B" + "".join(forms))

    def unpack(self, content: bytes) -> dict[str, Value]:
        """The values of a package by name."""
        if len(content) != self._struct.size:
            raise RtdeError("data", f"{len(content)} B")
        numbers = self._struct.unpack(content)
        values: dict[str, Value] = {}
        k = 1
        for name, _, size in self.fields:
            values[name] = numbers[k] if size == 1 else numbers[k : k + size]
            k += size
        return values

    def pack(self, values: Mapping[str, float]) -> bytes:
        """A package's content."""
        return self._struct.pack(self.number, *(values[each.name] for each in self.fields))


class Rtde:
    """A connection.

    Args:
        host: of the controller.
        timeout_s: for everything but data.

    Raises:
        OSError: it cannot be reached.
        RtdeError: it does not speak version 2.
    """

    def __init__(self, host: str, timeout_s: float = 5.0) -> None:
        self._socket = socket.create_connection((host, PORT), timeout=timeout_s)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._buffer = b""
        self._timeout_s = timeout_s
        self._outputs: Recipe | None = None
        self._inputs: Recipe | None = None
        try:
            if self._ask(REQUEST_VERSION, struct.pack(">H", VERSION)) != b"\x01":
                raise RtdeError("version", "refused")
        except BaseException:
            self.close()
            raise

    def find_version(self) -> str:
        """The controller's software, `5.17.3`."""
        major, minor, bugfix, _ = struct.unpack(">4I", self._ask(GET_CONTROLLER, b""))
        return f"{major}.{minor}.{bugfix}"

    def set_up(self, outputs: Sequence[str], inputs: Sequence[str], rate_hz: float) -> None:
        """Agrees on what comes and what goes."""
        answer = self._ask(SETUP_OUTPUTS, struct.pack(">d", rate_hz) + ",".join(outputs).encode())
        self._outputs = Recipe(answer[0], outputs, answer[1:].decode().split(","))
        if inputs:
            answer = self._ask(SETUP_INPUTS, ",".join(inputs).encode())
            self._inputs = Recipe(answer[0], inputs, answer[1:].decode().split(","))

    def start(self) -> None:
        """Lets the data come."""
        if self._ask(START, b"") != b"\x01":
            raise RtdeError("start", "refused")

    def send(self, values: Mapping[str, float]) -> None:
        """One package of inputs."""
        assert self._inputs is not None
        self._send(DATA, self._inputs.pack(values))

    def receive(self, timeout_s: float) -> list[dict[str, Value]]:
        """Every data package that has come, the oldest first; waits for the first of them. Empty where none comes in time.

        Raises:
            OSError: the controller has closed the connection.
        """
        until = time.monotonic() + timeout_s
        found: list[dict[str, Value]] = []
        while True:
            package = self._take()
            if package is not None:
                if package[0] == DATA and self._outputs is not None:
                    found.append(self._outputs.unpack(package[1]))
                continue
            if not self._read(0.0 if found else until - time.monotonic()):
                return found

    def close(self) -> None:
        """Lets go; the controller notices."""
        self._socket.close()

    def _ask(self, kind: int, content: bytes) -> bytes:
        self._send(kind, content)
        until = time.monotonic() + self._timeout_s
        while True:
            package = self._take()
            if package is not None and package[0] == kind:
                return package[1]
            if package is None and not self._read(until - time.monotonic()):
                raise RtdeError(chr(kind), "no answer")

    def _send(self, kind: int, content: bytes) -> None:
        self._socket.sendall(HEADER.pack(HEADER.size + len(content), kind) + content)

    def _take(self) -> tuple[int, bytes] | None:
        """The next whole package in the buffer."""
        if len(self._buffer) < HEADER.size:
            return None
        length, kind = HEADER.unpack_from(self._buffer)
        if length < HEADER.size:
            raise RtdeError("length", str(length))
        if len(self._buffer) < length:
            return None
        content, self._buffer = self._buffer[HEADER.size : length], self._buffer[length:]
        return kind, content

    def _read(self, timeout_s: float) -> bool:
        """Whether more bytes have come in time."""
        if not select.select([self._socket], [], [], max(0.0, timeout_s))[0]:
            return False
        more = self._socket.recv(65536)
        if not more:
            raise ConnectionResetError("closed by the controller")
        self._buffer += more
        return True
