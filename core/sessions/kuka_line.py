"""The line to a controller of a KUKA LBR: it sends a datagram in each cycle, by itself, and each is answered with one."""

from __future__ import annotations

import select
import socket
import time

from core.array import Array
from core.sessions.kuka_messages import Codec, Sample

LARGEST = 2048
"""Of a datagram, B; the client library of KUKA has 1500 for those of the controller."""
COUNTED = 2**32
"""At which the counters begin anew."""


class FriLine:
    """Listens for the controller, and answers only it.

    Args:
        host: of the controller; what others send is not looked at.
        listen, port: of this computer.

    Attributes:
        missed: messages of the controller that were not seen: by the count of those that were.

    Raises:
        OSError: the name is not known, or the port is in use.
        MissingPackage: the codec is not installed.
    """

    def __init__(self, codec: Codec, host: str, listen: str, port: int) -> None:
        self._codec = codec
        self._controller = socket.gethostbyname(host)
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        try:
            self._socket.bind((listen, port))
        except OSError:
            self._socket.close()
            raise
        self._socket.setblocking(False)
        self._peer: tuple[str, int] | None = None
        self._newest: Sample | None = None
        self._sent = 0
        self.missed = 0
        self.strange = ""
        """Who else has sent something, for a message that says that the controller has not."""

    def receive(self, timeout_s: float) -> Sample | None:
        """The newest message that has come since the last call; waits for one. None where none comes in time.

        Raises:
            FriError: the controller sends something else.
            OSError: it does not listen any more.
        """
        until = time.monotonic() + timeout_s
        while True:
            if not select.select([self._socket], [], [], max(0.0, until - time.monotonic()))[0]:
                return None
            newest = self._drain()
            if newest is not None:
                return newest

    def answer(self, q: Array | None) -> None:
        """Answers the newest message, once.

        Raises:
            OSError: the controller does not listen any more.
        """
        if self._peer is None or self._newest is None:
            return
        self._socket.sendto(self._codec.write(self._sent, self._newest.sequence, q), self._peer)
        self._sent = (self._sent + 1) % COUNTED

    @property
    def lag(self) -> int:
        """Commands that were sent and that the controller had not when it sent the newest message; 0 before the first it has."""
        if self._newest is None or not self._sent:
            return 0
        behind = (self._sent - 1 - self._newest.reflected) % COUNTED
        return behind if behind < COUNTED // 2 else 0

    def close(self) -> None:
        """Lets go; the controller notices by what does not come."""
        self._socket.close()

    def _drain(self) -> Sample | None:
        found: Sample | None = None
        while True:
            try:
                data, sender = self._socket.recvfrom(LARGEST)
            except BlockingIOError:
                return found
            if sender[0] != self._controller:
                self.strange = sender[0]
                continue
            sample = self._codec.read(data)
            last = self._newest
            ahead = 1 if last is None else (sample.sequence - last.sequence) % COUNTED
            if not 0 < ahead < COUNTED // 2:
                continue  # overtaken on the way, or twice
            self.missed += ahead - 1
            self._peer, self._newest, found = sender, sample, sample
