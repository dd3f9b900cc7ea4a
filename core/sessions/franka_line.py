"""The lines to a controller of Franka: requests and answers over TCP (port 1337), states and commands over UDP."""

from __future__ import annotations

import select
import socket
import time
from typing import Self

from core.array import Array
from core.sessions.franka_messages import (
    CONNECTED,
    HEADER,
    NEWEST,
    OLDEST,
    Command,
    Dialect,
    FrankaError,
    Sample,
    dialect_of,
    read_state,
    write_command,
    write_connect,
)

LARGEST = 4096
"""Of a datagram, B."""
LONGEST = 4_000_000
"""Of an answer, B: the description of the robot is the longest."""
STALE_S, FRESH_S = 0.05, 0.005
"""After nobody has looked for so long, another state is waited for."""
ANSWER_S = 3.0
"""How long an answer may take."""


class VersionError(FrankaError):
    """The server speaks a version that is not known here.

    Args:
        version: its own.
    """

    def __init__(self, version: int) -> None:
        super().__init__(f"server version {version}")
        self.version = version


class FciLine:
    """Connected in the server's own version.

    Args:
        host, port: of the controller.

    Attributes:
        version: of the server.
        missed: states of the controller that were not seen, by the number of those that were.

    Raises:
        OSError: nobody answers there, or not in this protocol.
        VersionError: in another version of it.
    """

    def __init__(self, host: str, port: int) -> None:
        self.version, self.missed, self._looked = NEWEST, 0, time.monotonic()
        self._newest: Sample | None = None
        self._open(host, port)
        try:
            found = self._shake_hands()
            if found != self.version:  # it says which it speaks, and is asked again in that
                self.close()
                self._open(host, port)
                self.version = found
                if self._shake_hands() != found:
                    raise FrankaError(f"a server that refuses its own version {found}")
            self._dialect = dialect_of(self.version)
        except BaseException:
            self.close()
            raise

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def dialect(self) -> Dialect:
        """How this server is spoken to."""
        return self._dialect

    def knows(self, command: Command) -> bool:
        """Whether the server of this version has the command."""
        return command in self._dialect.commands

    def ask(self, command: Command, body: bytes = b"") -> tuple[int, bytes]:
        """Sends a request and waits for its answer.

        Returns:
            The number of the request, for what else is said of it, and the answer without its header: a status, and what is behind it.

        Raises:
            OSError: none comes.
        """
        number = self._ask(self._dialect.commands[command], body)
        return number, self._await_answer(number)

    def answer_to(self, number: int, timeout_s: float = 0.0) -> bytes | None:
        """A further answer to a request of before; None where none has come within that time.

        Raises:
            OSError: the controller has closed the line.
        """
        until = time.monotonic() + timeout_s
        while number not in self._answers:
            left = until - time.monotonic()
            if not self._read_answers(max(0.0, left)) and left <= 0.0:
                return None
        return self._answers.pop(number)

    def receive(self, timeout_s: float) -> Sample | None:
        """The newest state that has come since the last call; waits for one. None where none comes in time.

        Raises:
            FrankaError: what comes is none.
        """
        newest = self._wait_for_state(timeout_s)
        if time.monotonic() - self._looked > STALE_S:  # what has waited here is from the beginning of that time: a full line takes no more
            newest = self._wait_for_state(FRESH_S) or newest
        self._looked = time.monotonic()
        return newest

    def command(self, number: int, q: Array, *, finished: bool = False) -> None:
        """Answers the state of that number with joint positions (7,), rad.

        Raises:
            OSError: nobody listens.
        """
        if self._peer is not None:
            self._states.sendto(write_command(number, q, finished=finished, tail=self._dialect.command_tail), self._peer)

    def close(self) -> None:
        """Lets go."""
        self._requests.close()
        self._states.close()

    def _wait_for_state(self, timeout_s: float) -> Sample | None:
        until = time.monotonic() + timeout_s
        while True:
            if not select.select([self._states], [], [], max(0.0, until - time.monotonic()))[0]:
                return None
            newest = self._drain()
            if newest is not None:
                return newest

    def _open(self, host: str, port: int) -> None:
        self._requests = socket.create_connection((host, port), timeout=ANSWER_S)
        self._requests.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._states = socket.socket(self._requests.family, socket.SOCK_DGRAM)
        self._states.bind((self._requests.getsockname()[0], 0))
        self._states.setblocking(False)
        self._controller = self._requests.getpeername()[0]
        self._peer: tuple[str, int] | None = None
        self._buffer, self._answers, self._asked = b"", dict[int, bytes](), 0

    def _shake_hands(self) -> int:
        """The server's version."""
        status, low, high = self._await_answer(self._ask(0, write_connect(self.version, self._states.getsockname()[1])))[:3]
        found = low + 256 * high
        if status != CONNECTED and not OLDEST <= found <= NEWEST:
            raise VersionError(found)
        return found

    def _ask(self, command: int, body: bytes) -> int:
        number, self._asked = self._asked, self._asked + 1
        self._requests.sendall(HEADER.pack(command, number, HEADER.size + len(body)) + body)
        return number

    def _await_answer(self, number: int) -> bytes:
        answer = self.answer_to(number, ANSWER_S)
        if answer is None:
            raise TimeoutError(f"no answer within {ANSWER_S:g} s")
        return answer

    def _read_answers(self, timeout_s: float) -> bool:
        """Takes what has come, waiting for it; whether anything has."""
        if not select.select([self._requests], [], [], timeout_s)[0]:
            return False
        data = self._requests.recv(65536)
        if not data:
            raise ConnectionResetError("the controller has closed the line")
        self._buffer += data
        while len(self._buffer) >= HEADER.size:
            _, number, length = HEADER.unpack_from(self._buffer)
            if not HEADER.size < length <= LONGEST:
                raise FrankaError(f"an answer of {length} B")
            if len(self._buffer) < length:
                break
            self._answers[number], self._buffer = self._buffer[HEADER.size : length], self._buffer[length:]
        return True

    def _drain(self) -> Sample | None:
        found: Sample | None = None
        while True:
            try:
                data, sender = self._states.recvfrom(LARGEST)
            except BlockingIOError:
                break
            if sender[0] != self._controller:
                continue
            sample = read_state(data)
            last = self._newest
            if last is not None and sample.number <= last.number:
                continue  # overtaken on the way, or twice
            self.missed += 0 if last is None else sample.number - last.number - 1
            self._peer, self._newest, found = sender, sample, sample
        return found
