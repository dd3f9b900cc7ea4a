"""A UFACTORY controller on the line: control (502) and reports (30000 every period, 30001 and 30002 at 5 Hz, 30003 at 100 Hz)."""

from __future__ import annotations

import socket
from collections.abc import Callable
from functools import partial

from core.fakes.paced_server import PacedServer
from core.fakes.xarm_arm import XarmArm
from core.fakes.xarm_protocol import XarmPeer, fast_report, normal_report, rich_report, short_report

CONTROL_PORT = 502
FAST_PORT = 30000
REPORTS = {FAST_PORT: (0.0, fast_report), 30001: (0.2, normal_report), 30002: (0.2, rich_report), 30003: (0.01, short_report)}
"""What is sent on which port, and how often, s; 0 for every period."""


class XarmServer(PacedServer):
    """Serves one arm until it is left.

    Args:
        arm: the controller and its robot.
        host, patience_s: see `PacedServer`.
        port: of the control; 502 on a real controller, which on many computers only the administrator may listen at.
    """

    def __init__(self, arm: XarmArm, host: str = "127.0.0.1", *, port: int = CONTROL_PORT, patience_s: float | None = None) -> None:
        super().__init__(host, arm.period, patience_s)
        self.arm, self._port = arm, port
        self._peers: dict[socket.socket, XarmPeer] = {}
        self._readers: dict[int, list[socket.socket]] = {port: [] for port in REPORTS}

    def _doors(self) -> dict[int, Callable[[socket.socket], None]]:
        doors: dict[int, Callable[[socket.socket], None]] = {self._port: self._accept_control}
        return doors | {port: partial(self._accept_reader, port=port) for port in REPORTS}

    def _step(self) -> None:
        self.arm.step()

    def _expects_answers(self) -> bool:
        return bool(self.arm.obeys and self._readers[FAST_PORT] and self._peers)

    def _report(self, now: float) -> None:
        for port, (every_s, report) in REPORTS.items():
            if self._readers[port] and self._tick % max(1, round(every_s / self.arm.period)) == 0:
                told = report(self.arm)
                for line in list(self._readers[port]):
                    self._post(line, told, now)
        self._await_answer(now)

    def _forget(self, line: socket.socket) -> None:
        self._peers.pop(line, None)
        for readers in self._readers.values():
            if line in readers:
                readers.remove(line)

    def _accept_reader(self, listener: socket.socket, *, port: int) -> None:
        self._readers[port].append(self._accept(listener, self._discard))

    def _discard(self, line: socket.socket) -> None:
        self._read(line)

    def _accept_control(self, listener: socket.socket) -> None:
        self._peers[self._accept(listener, self._read_control)] = XarmPeer(self.arm)

    def _read_control(self, line: socket.socket) -> None:
        data = self._read(line)
        if not data:
            return
        peer = self._peers[line]
        served, asked = peer.served, peer.asked
        try:
            answers = peer.take(data)
        except ValueError:
            self._drop(line)
            return
        self._send(line, answers)
        if peer.served > served or peer.asked > asked:  # what else it asks is no answer to a report
            self._take_answer(new=peer.served > served)
