"""What every controller on the line has: doors, one thread, a clock of whole periods, and a line that can be late, lossy or cut."""

from __future__ import annotations

import selectors
import socket
import threading
import time
from abc import ABC, abstractmethod
from collections.abc import Callable
from random import Random
from types import TracebackType
from typing import Self

RETRY_S = 0.02
"""How much later what is sent again arrives on a line that loses packets."""


class PacedServer(ABC):
    """Serves one arm until it is left; all of it in one thread.

    Args:
        host: address to listen at.
        period: of the controller, s.
        patience_s: how long a period waits for the client's answer to the last one before the clock goes on: on a computer that is busy
            with other things nothing then comes late. None for the wall clock alone, as a real controller does it.
    """

    def __init__(self, host: str, period: float, patience_s: float | None) -> None:
        self.host, self.patience_s = host, patience_s
        self.cut = self.deaf = False
        """Nothing passes in either direction while it is set, or no datagram from the client; no connection is closed."""
        self.jitter_s = self.loss = 0.0
        """Largest delay of each package to the client, and the share of packages that have to be sent again."""
        self.latencies_s: list[float] = []
        """From a package sent to the first command that answers it."""
        self.late_periods = 0
        """Periods that began more than half a period late by the wall clock: this computer's doing, not the client's."""
        self.period, self._tick = period, 0
        self._random = Random(0)
        self._selector = selectors.DefaultSelector()
        self._delayed: list[tuple[float, socket.socket, bytes]] = []
        self._sent_at = 0.0
        self._answered, self._silent = True, False
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._serve, name=type(self).__name__, daemon=True)
        self._orders: list[Callable[[], None]] = []

    @abstractmethod
    def _doors(self) -> dict[int, Callable[[socket.socket], None]]:
        """Which ports are listened at, and what accepts there."""

    @abstractmethod
    def _step(self) -> None:
        """One period of the arm."""

    @abstractmethod
    def _report(self, now: float) -> None:
        """Sends what a period sends, by `_post`, `_post_datagram` and `_send`."""

    @abstractmethod
    def _expects_answers(self) -> bool:
        """Whether a client has to answer each period."""

    @abstractmethod
    def _forget(self, line: socket.socket) -> None:
        """A client has gone."""

    def __enter__(self) -> Self:
        for port, accept in self._doors().items():
            listener = socket.create_server((self.host, port))
            listener.setblocking(False)
            self._selector.register(listener, selectors.EVENT_READ, accept)
        self._thread.start()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self._ended.set()
        self._thread.join(10.0)
        for key in list(self._selector.get_map().values()):
            assert isinstance(key.fileobj, socket.socket)
            key.fileobj.close()
        self._selector.close()

    def order(self, what: Callable[[], None]) -> None:
        """Does something to the arm between two periods."""
        self._orders.append(what)

    def _serve(self) -> None:
        due = time.monotonic()
        while not self._ended.is_set():
            due = self._wait(due + self.period)
            while self._orders:
                self._orders.pop(0)()
            self._step()
            self._tick += 1
            self._report(time.monotonic())

    def _await_answer(self, now: float) -> None:
        """What was sent just now is to be answered."""
        self._sent_at, self._answered = now, not self._expects_answers()

    def _take_answer(self, *, new: bool) -> None:
        """The client has answered; `new` where it was a command and no sign of life."""
        if self._answered:
            return
        if new:
            self.latencies_s.append(time.monotonic() - self._sent_at)
        self._answered, self._silent = True, False

    def _loses_answer(self) -> bool:
        """Whether an answer that has come gets lost on its way. It is not waited for: whoever is patient waits for a busy client alone."""
        lost = self.deaf or self._random.random() < self.loss
        if lost:
            self._take_answer(new=False)
        return lost

    def _wait(self, due: float) -> float:
        """Takes what comes until the next period begins; gives when it did. A period that begins late puts off all that follow."""
        self._look(0.0)
        while not self._ended.is_set():
            now = time.monotonic()
            self._flush(now)
            waits_for_answer = not (self.patience_s is None or self._answered or self._silent or self.cut) and self._expects_answers()
            if waits_for_answer and now > self._sent_at + (self.patience_s or 0.0):
                self._silent, waits_for_answer = True, False
            answered = self.patience_s is not None and self._answered and self._expects_answers()
            if answered or (now >= due and not waits_for_answer):
                break
            until = min([due if not waits_for_answer else now + 0.01, *(at for at, _, _ in self._delayed)])
            self._look(max(0.0, until - now))
        now = time.monotonic()
        self.late_periods += now > due + 0.5 * self.period
        return due if now < due + 0.5 * self.period and self.patience_s is None else now

    def _look(self, timeout_s: float) -> None:
        for key, _ in self._selector.select(timeout_s):
            key.data(key.fileobj)

    def _post(self, line: socket.socket, data: bytes, now: float) -> None:
        """Sends, as late as the line is; what is behind something late waits for it."""
        wait = self._random.uniform(0.0, self.jitter_s) + (RETRY_S if self._random.random() < self.loss else 0.0)
        behind = max([at for at, other, _ in self._delayed if other is line], default=0.0)
        if self.cut or wait > 0.0 or behind > 0.0:  # what waits and is due now is sent by the next look, and nothing overtakes it
            self._delayed.append((max(now + wait, behind), line, data))
        else:
            self._send(line, data)

    def _post_datagram(self, line: socket.socket, data: bytes, now: float) -> None:
        """Sends a datagram, as late as the line is; what gets lost is not sent again or answered, and nothing overtakes."""
        if self.cut:
            return
        if self._random.random() < self.loss:
            self._answered = True
            return
        if self.jitter_s > 0.0:
            behind = max([at for at, _, _ in self._delayed], default=0.0)
            self._delayed.append((max(now + self._random.uniform(0.0, self.jitter_s), behind), line, data))
        else:
            self._send(line, data)

    def _flush(self, now: float) -> None:
        if self.cut:
            return
        due = [each for each in self._delayed if each[0] <= now]
        self._delayed = [each for each in self._delayed if each[0] > now]
        streams: dict[socket.socket, bytes] = {}
        for _, line, data in due:
            if line.type == socket.SOCK_STREAM:  # what has waited comes at once, not a package at a time while the client answers each
                streams[line] = streams.get(line, b"") + data
            else:
                self._send(line, data)
        for line, data in streams.items():
            self._send(line, data)

    def _send(self, line: socket.socket, data: bytes) -> None:
        if self.cut:
            return
        try:
            line.sendall(data)
        except OSError:
            self._drop(line)

    def _drop(self, line: socket.socket) -> None:
        self._forget(line)
        self._delayed = [each for each in self._delayed if each[1] is not line]
        if line.fileno() >= 0:
            self._selector.unregister(line)
            line.close()

    def _accept(self, listener: socket.socket, read: Callable[[socket.socket], None]) -> socket.socket:
        line, _ = listener.accept()
        line.setblocking(False)
        line.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._selector.register(line, selectors.EVENT_READ, read)
        return line

    def _read(self, line: socket.socket) -> bytes:
        if self.cut:
            time.sleep(0.001)
            return b""
        try:
            data = line.recv(65536)
        except OSError:
            data = b""
        if not data:
            self._drop(line)
        return data
