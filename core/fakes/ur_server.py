"""A Universal Robots e-series controller on the line: RTDE (30004), the secondary interface (30002) and the dashboard server (29999)."""

from __future__ import annotations

import math
import selectors
import socket
import struct
import threading
import time
from collections.abc import Callable
from random import Random
from types import TracebackType
from typing import Self

from core.fakes.rtde_protocol import RtdePeer
from core.fakes.ur_arm import JOINT_SPEED, LIMIT, NORMAL, PERIOD, UrArm

RTDE_PORT, SECONDARY_PORT, DASHBOARD_PORT = 30004, 30002, 29999
STATE_EVERY = 50
"""Periods between two states on the secondary interface."""
RETRY_S = 0.02
"""How much later what is sent again arrives on a line that loses packets."""


class UrServer:
    """Serves one arm until it is left; all of it in one thread.

    Args:
        arm: the controller and its robot.
        host: address to listen at.
        patience_s: how long a period waits for the client's answer to the last one before the clock goes on: on a computer that is busy
            with other things nothing then comes late. None for the wall clock alone, as a real controller does it.
    """

    def __init__(self, arm: UrArm, host: str = "127.0.0.1", *, patience_s: float | None = None) -> None:
        self.arm, self.host, self.patience_s = arm, host, patience_s
        self.cut = False
        """Nothing passes in either direction while it is set, and no connection is closed."""
        self.jitter_s = self.loss = 0.0
        """Largest delay of each package to the client, and the share of packages that have to be sent again."""
        self.latencies_s: list[float] = []
        """From a package sent to the first command that answers it."""
        self.late_periods = 0
        """Periods that began more than half a period late by the wall clock: this computer's doing, not the client's."""
        self._random = Random(0)
        self._selector = selectors.DefaultSelector()
        self._peers: dict[socket.socket, RtdePeer] = {}
        self._states: list[socket.socket] = []
        self._delayed: list[tuple[float, socket.socket, bytes]] = []
        self._tick = 0
        self._sent_at = 0.0
        self._answered = True
        self._silent = False
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._serve, name="ur-server", daemon=True)
        self._orders: list[Callable[[], None]] = []

    def __enter__(self) -> Self:
        doors = {RTDE_PORT: self._accept_rtde, SECONDARY_PORT: self._accept_secondary, DASHBOARD_PORT: self._accept_dashboard}
        for port, accept in doors.items():
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
            due = self._wait(due + PERIOD)
            while self._orders:
                self._orders.pop(0)()
            self.arm.step()
            self._tick += 1
            self._send_states()

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
        self.late_periods += now > due + 0.5 * PERIOD
        return due if now < due + 0.5 * PERIOD and self.patience_s is None else now

    def _look(self, timeout_s: float) -> None:
        for key, _ in self._selector.select(timeout_s):
            key.data(key.fileobj)

    def _expects_answers(self) -> bool:
        return self.arm.playing and any(peer.started and peer.inputs for peer in self._peers.values())

    def _send_states(self) -> None:
        now = time.monotonic()
        if self._peers:
            values = self.arm.report()
            for line, peer in list(self._peers.items()):
                if peer.started and self._tick % peer.every == 0:
                    self._post(line, peer.package(values), now)
            self._sent_at, self._answered = now, not self._expects_answers()
        if self._tick % STATE_EVERY == 0:
            for line in list(self._states):
                self._send(line, self._describe_configuration())

    def _post(self, line: socket.socket, data: bytes, now: float) -> None:
        """Sends, as late as the line is; what is behind something late waits for it."""
        wait = self._random.uniform(0.0, self.jitter_s) + (RETRY_S if self._random.random() < self.loss else 0.0)
        behind = max([at for at, other, _ in self._delayed if other is line], default=0.0)
        if self.cut or wait > 0.0 or behind > 0.0:  # what waits and is due now is sent by the next look, and nothing overtakes it
            self._delayed.append((max(now + wait, behind), line, data))
        else:
            self._send(line, data)

    def _flush(self, now: float) -> None:
        while self._delayed and self._delayed[0][0] <= now and not self.cut:
            _, line, data = self._delayed.pop(0)
            self._send(line, data)

    def _send(self, line: socket.socket, data: bytes) -> None:
        if self.cut:
            return
        try:
            line.sendall(data)
        except OSError:
            self._drop(line)

    def _drop(self, line: socket.socket) -> None:
        """A client has gone."""
        self._peers.pop(line, None)
        self._delayed = [each for each in self._delayed if each[1] is not line]
        if line in self._states:
            self._states.remove(line)
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

    def _accept_rtde(self, listener: socket.socket) -> None:
        taken = {name for peer in self._peers.values() for names in peer.inputs.values() for name in names}
        self._peers[self._accept(listener, self._read_rtde)] = RtdePeer(self.arm.version, taken)

    def _read_rtde(self, line: socket.socket) -> None:
        data = self._read(line)
        if not data:
            return
        try:
            answer, written = self._peers[line].take(data)
        except (ValueError, struct.error, UnicodeDecodeError):
            self._drop(line)
            return
        if answer:
            self._send(line, answer)
        before = self.arm.inputs.get("input_int_register_24")
        for name, value in written:
            self.arm.take(name, value)
        if written and not self._answered:
            if self.arm.inputs.get("input_int_register_24") != before:
                self.latencies_s.append(time.monotonic() - self._sent_at)
            self._answered, self._silent = True, False

    def _accept_secondary(self, listener: socket.socket) -> None:
        self._states.append(self._accept(listener, self._read_secondary))

    def _read_secondary(self, line: socket.socket) -> None:
        data = self._read(line)
        if data.strip():
            self.arm.run(data.decode("utf-8", "replace"))

    def _accept_dashboard(self, listener: socket.socket) -> None:
        line = self._accept(listener, self._read_dashboard)
        self._send(line, b"Connected: Universal Robots Dashboard Server\n")

    def _read_dashboard(self, line: socket.socket) -> None:
        for asked in self._read(line).decode("utf-8", "replace").splitlines():
            self._send(line, (self._answer_dashboard(asked.strip()) + "\n").encode())

    def _answer_dashboard(self, asked: str) -> str:
        arm = self.arm
        version = ".".join(str(part) for part in arm.version)
        answers = {
            "is in remote control": str(arm.remote).lower(),
            "get robot model": arm.model,
            "get serial number": arm.serial,
            "PolyscopeVersion": f"URSoftware {version} (Nov 24 2026)",
            "robotmode": "Robotmode: RUNNING" if arm.robot_mode == 7 else "Robotmode: POWER_OFF",
            "safetystatus": "Safetystatus: NORMAL" if arm.safety_mode == NORMAL else "Safetystatus: FAULT",
            "running": f"Program running: {str(arm.playing).lower()}",
        }
        if asked == "stop":
            arm.end_program()
            return "Stopped"
        return answers.get(asked, f"could not understand: '{asked}'")

    def _describe_configuration(self) -> bytes:
        """A robot state of the secondary interface with the sub-package of the configuration."""
        n = 6
        limits = [value for _ in range(n) for value in (-LIMIT, LIMIT)]
        speeds = [value for _ in range(n) for value in (JOINT_SPEED, 40.0)]
        defaults = [1.05, 1.4, 0.25, 1.2, 0.0]
        links = [[0.0] * n, [0.0] * n, [math.pi / 2, 0.0, 0.0, math.pi / 2, -math.pi / 2, 0.0], [0.0] * n]
        numbers = [*limits, *speeds, *defaults, *(value for row in links for value in row)]
        content = struct.pack(f">{len(numbers)}d4i", *numbers, 0, 0, 2, 0)
        package = struct.pack(">iB", 5 + len(content), 6) + content
        return struct.pack(">iB", 5 + len(package), 16) + package
