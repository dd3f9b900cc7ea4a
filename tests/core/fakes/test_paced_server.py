from __future__ import annotations

import socket
import struct
import time

from core.fakes.paced_server import PacedServer
from tests.loopback import HOST

PORT = 47010


class Counter(PacedServer):
    """Sends the number of each period to one client, which answers with a byte."""

    client: socket.socket | None = None

    def _doors(self):
        return {PORT: self._enter}

    def _enter(self, listener):
        self.client = self._accept(listener, self._hear_client)

    def _hear_client(self, line):
        for _ in self._read(line):
            self._take_answer(new=True)

    def _step(self):
        """Nothing moves."""

    def _report(self, now):
        if self.client is not None:
            self._post(self.client, struct.pack(">I", self._tick), now)
            self._await_answer(now)

    def _expects_answers(self):
        return self.client is not None

    def _forget(self, line):
        assert line is self.client
        self.client = None


def test_what_was_sent_before_a_report_was_read_leaves_the_client_not_one_period_behind():
    with Counter(HOST, 0.002, patience_s=5.0), socket.create_connection((HOST, PORT)) as line:
        line.recv(4, socket.MSG_PEEK)  # a report is there, unread, when the first answer is sent
        line.send(b"a")
        for _ in range(20):
            time.sleep(0.01)
            assert len(line.recv(4096)) == 4, "the clock is ahead of a client that answers each report"
            line.send(b"a")
