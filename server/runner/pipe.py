"""The ends of the pipe: threads listen and speak, so that neither the control loop nor the server waits for the other.

Whoever is frozen leaves the pipe full, and a plain `send` hangs in it. What happened waits in a queue; of what is only worth something
while it is new (samples, renewals of the lease), the newest is kept.
"""

from __future__ import annotations

import threading
from collections import deque
from multiprocessing.connection import Connection
from typing import Generic, TypeVar

from core.sessions.leased import Lease, Renewal
from core.words.message import Message
from server.runner.messages import Beat, End, Hold, PageLate, Release, Resume, ToChild, ZoneChanged

Said = TypeVar("Said")


class Listener:
    """Takes what the server says, most of it straight into the lease.

    Args:
        lease: of the robot.
    """

    def __init__(self, connection: Connection, lease: Lease) -> None:
        self._connection, self._lease = connection, lease
        self.zones: deque[ZoneChanged] = deque()
        self.released: str | None = None
        """SHA-256 of what was released."""
        self.ended = threading.Event()
        threading.Thread(target=self._listen, name="listener", daemon=True).start()

    def _listen(self) -> None:
        while True:
            try:
                self._take(self._connection.recv())
            except (EOFError, OSError):
                self._end(Message.of("runs-server-gone"))
                return

    def _take(self, message: ToChild) -> None:
        match message:
            case Renewal():
                self._lease.renew(message)
            case Beat(stamp_s=stamp_s, service=service):
                self._lease.beat(stamp_s, service)
            case PageLate(late_s=late_s):
                self._lease.note_late_page(late_s)
            case Release(plan_sha256=released):
                self.released = released
            case Hold():
                self._lease.hold(message.lateness)
            case Resume():
                self._lease.resume()
            case End(reason=reason):
                self._end(reason)
            case ZoneChanged():
                self.zones.append(message)

    def _end(self, reason: Message) -> None:
        self._lease.end(reason)
        self.ended.set()


class Speaker(Generic[Said]):
    """Says what it is told, in order.

    Args:
        fleeting: the kinds of messages of which only the newest is kept.
    """

    def __init__(self, connection: Connection, *fleeting: type[Said]) -> None:
        self._connection, self._fleeting = connection, fleeting
        self._waiting: deque[Said] = deque()
        self._newest: dict[type[Said], Said] = {}
        self._something = threading.Condition()
        self._closing = False
        self._thread = threading.Thread(target=self._speak, name="speaker", daemon=True)
        self._thread.start()

    def tell(self, message: Said) -> None:
        """Returns at once."""
        with self._something:
            if isinstance(message, self._fleeting):
                self._newest[type(message)] = message
            else:
                self._waiting.append(message)
            self._something.notify()

    def close(self, timeout_s: float = 2.0) -> None:
        """Waits until everything is said; whoever no longer listens is not waited for longer than `timeout_s`."""
        with self._something:
            self._closing = True
            self._something.notify()
        self._thread.join(timeout_s)

    def _next(self) -> Said | None:
        with self._something:
            while not (self._waiting or self._newest or self._closing):
                self._something.wait()
            if self._waiting:
                return self._waiting.popleft()
            return self._newest.pop(next(iter(self._newest))) if self._newest else None

    def _speak(self) -> None:
        while (message := self._next()) is not None:
            try:
                self._connection.send(message)
            except OSError:  # who listens on the same pipe has noticed it too
                return
