"""A controller of a KUKA LBR on the line: one datagram a cycle to its client, whose answers it waits for no longer than that."""

from __future__ import annotations

import selectors
import socket
from collections.abc import Callable
from typing import Self

from core.fakes.fri_arm import FriArm
from core.fakes.paced_server import PacedServer

PORT = 30200
"""Of the client, unless somebody has said another."""


class FriServer(PacedServer):
    """Sends to one client until it is left; nothing has to be there to receive it.

    Args:
        arm: the controller and its robot.
        host, patience_s: see `PacedServer`; a client that does not answer is not waited for.
        client, port: where it sends to.
    """

    def __init__(
        self, arm: FriArm, host: str = "127.0.0.1", *, client: str = "127.0.0.1", port: int = PORT, patience_s: float | None = None
    ) -> None:
        super().__init__(host, arm.period, patience_s)
        self.arm, self._client = arm, (client, port)
        self._line = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._heard = False

    def __enter__(self) -> Self:
        self._line.bind((self.host, 0))
        self._line.connect(self._client)
        self._line.setblocking(False)
        self._selector.register(self._line, selectors.EVENT_READ, self._take)
        super().__enter__()
        return self

    def _doors(self) -> dict[int, Callable[[socket.socket], None]]:
        return {}

    def _step(self) -> None:
        self.arm.step()

    def _expects_answers(self) -> bool:
        return self._heard

    def _report(self, now: float) -> None:
        self._await_answer(now)
        self._post_datagram(self._line, self.arm.message(), now)

    def _forget(self, line: socket.socket) -> None:
        del line  # there is one only
        self._heard = False

    def _take(self, line: socket.socket) -> None:
        """What has come; a datagram that is lost is lost."""
        try:
            data = line.recv(65536)
        except OSError:  # nobody listens at the other end
            self._heard = False
            return
        if self.cut or self._loses_answer():
            return
        new = self.arm.take(data)
        self._heard = True
        if new:
            self._take_answer(new=self.arm.obeys)

    def _send(self, line: socket.socket, data: bytes) -> None:
        try:
            line.send(data)
        except OSError:  # nobody listens at the other end
            self._heard = False
