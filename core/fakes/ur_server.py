"""A Universal Robots e-series controller on the line: RTDE (30004), the secondary interface (30002) and the dashboard server (29999)."""

from __future__ import annotations

import math
import socket
import struct
from collections.abc import Callable

from core.fakes.paced_server import PacedServer
from core.fakes.rtde_protocol import RtdePeer
from core.fakes.ur_arm import JOINT_SPEED, LIMIT, NORMAL, PERIOD, UrArm

RTDE_PORT, SECONDARY_PORT, DASHBOARD_PORT = 30004, 30002, 29999
STATE_EVERY = 50
"""Periods between two states on the secondary interface."""


class UrServer(PacedServer):
    """Serves one arm until it is left.

    Args:
        arm: the controller and its robot.
        host, patience_s: see `PacedServer`.
    """

    def __init__(self, arm: UrArm, host: str = "127.0.0.1", *, patience_s: float | None = None) -> None:
        super().__init__(host, PERIOD, patience_s)
        self.arm = arm
        self._peers: dict[socket.socket, RtdePeer] = {}
        self._states: list[socket.socket] = []

    def _doors(self) -> dict[int, Callable[[socket.socket], None]]:
        return {RTDE_PORT: self._accept_rtde, SECONDARY_PORT: self._accept_secondary, DASHBOARD_PORT: self._accept_dashboard}

    def _step(self) -> None:
        self.arm.step()

    def _expects_answers(self) -> bool:
        return self.arm.playing and any(peer.started and peer.inputs for peer in self._peers.values())

    def _report(self, now: float) -> None:
        if self._peers:
            values = self.arm.report()
            for line, peer in list(self._peers.items()):
                if peer.started and self._tick % peer.every == 0:
                    self._post(line, peer.package(values), now)
            self._await_answer(now)
        if self._tick % STATE_EVERY == 0:
            for line in list(self._states):
                self._send(line, self._describe_configuration())

    def _forget(self, line: socket.socket) -> None:
        self._peers.pop(line, None)
        if line in self._states:
            self._states.remove(line)

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
        if written:
            self._take_answer(new=self.arm.inputs.get("input_int_register_24") != before)

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
