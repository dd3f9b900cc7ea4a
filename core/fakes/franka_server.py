"""A controller of Franka on the line: requests over TCP, a state a millisecond over UDP, whose answer it waits for no longer than that."""

from __future__ import annotations

import selectors
import socket
import struct
from collections.abc import Callable
from typing import Self

from core.fakes.franka_arm import IDLE, FrankaArm
from core.fakes.franka_protocol import (
    CONNECT,
    GET_ROBOT_MODEL,
    MOVE,
    PORT,
    RECOVER,
    SET_COLLISION_BEHAVIOR,
    SET_LOAD,
    STOP_MOVE,
    SUCCESS,
    Request,
    answer,
    answers_to_move,
    read_load,
    read_move,
    read_order,
    take_requests,
)
from core.fakes.paced_server import PacedServer

NOT_POSSIBLE, INVALID = 1, 2
"""Answers to whoever sets something."""


class FrankaServer(PacedServer):
    """Serves one client at a time until it is left.

    Args:
        arm: the controller and its robot.
        host, patience_s: see `PacedServer`. port: of the requests.
    """

    def __init__(self, arm: FrankaArm, host: str = "127.0.0.1", *, port: int = PORT, patience_s: float | None = None) -> None:
        super().__init__(host, arm.period, patience_s)
        self.arm, self._port = arm, port
        self._states = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._client: socket.socket | None = None
        self._to: tuple[str, int] | None = None
        self._rest = b""
        self._move: Request | None = None

    def __enter__(self) -> Self:
        self._states.bind((self.host, 0))
        self._states.setblocking(False)
        self._selector.register(self._states, selectors.EVENT_READ, self._take)
        super().__enter__()
        return self

    def _doors(self) -> dict[int, Callable[[socket.socket], None]]:
        return {self._port: self._welcome}

    def _welcome(self, listener: socket.socket) -> None:
        line = self._accept(listener, self._serve_requests)
        if self._client is not None:
            self._drop(line)
            return
        self._client, self._rest = line, b""

    def _serve_requests(self, line: socket.socket) -> None:
        requests, self._rest = take_requests(self._rest + self._read(line), self.arm.version)
        for request in requests:
            self._serve_request(line, request)

    def _serve_request(self, line: socket.socket, request: Request) -> None:
        arm = self.arm
        if request.kind == CONNECT:
            version, port = struct.unpack("<HH", request.body)
            fits = version == arm.version
            self._to = (line.getpeername()[0], port) if fits else None
            self._say(answer(request, SUCCESS if fits else 1, struct.pack("<H", arm.version)))
        elif request.kind == MOVE:
            self._begin_move(request)
        elif request.kind == STOP_MOVE:
            arm.stop_move()
            self._tell_end()
            self._say(answer(request, SUCCESS))
        elif request.kind == SET_LOAD:
            self._say(answer(request, self._set_load(request.body)))
        elif request.kind == SET_COLLISION_BEHAVIOR:
            self._say(answer(request, SUCCESS if arm.mode == IDLE else NOT_POSSIBLE))
        elif request.kind == RECOVER:
            arm.recover()
            self._say(answer(request, SUCCESS))
        elif request.kind == GET_ROBOT_MODEL:
            self._say(answer(request, SUCCESS, arm.description().encode()))
        else:
            self._say(answer(request, NOT_POSSIBLE))

    def _begin_move(self, request: Request) -> None:
        outcomes, asked = answers_to_move(self.arm.version), read_move(request.body, self.arm.version)
        if asked != (0, 0):  # joint impedance, joint positions: all that is played here
            outcome = "invalid_argument"
        elif self.arm.mode != IDLE or self.arm.moves:
            outcome = "not_possible"
        else:
            outcome = "started"
            self._move = request
            self.arm.begin_move()
        self._say(answer(request, outcomes[outcome]))

    def _set_load(self, body: bytes) -> int:
        arm, load = self.arm, read_load(body)
        if load is None or not load[0] >= 0.0:
            return INVALID
        if arm.mode != IDLE or arm.moves:
            return NOT_POSSIBLE
        arm.set_load(*load)
        return SUCCESS

    def _step(self) -> None:
        self.arm.step()
        self._tell_end()

    def _report(self, now: float) -> None:
        self._await_answer(now)
        if self._to is not None:
            self._post_datagram(self._states, self.arm.state(), now)

    def _expects_answers(self) -> bool:
        return self.arm.obeys and self._client is not None

    def _forget(self, line: socket.socket) -> None:
        if line is self._client:
            self._client = self._to = self._move = None

    def _take(self, line: socket.socket) -> None:
        try:
            data = line.recv(2048)
        except OSError:  # nobody listens at the other end
            return
        if self.cut or self._loses_answer():
            return
        order = read_order(data, self.arm.version)
        if order is not None and self.arm.take(order):
            self._take_answer(new=True)

    def _tell_end(self) -> None:
        """What has become of a move is its second answer."""
        outcomes = answers_to_move(self.arm.version)
        while self.arm.ended:
            outcome = self.arm.ended.popleft()
            if self._move is not None:
                self._say(answer(self._move, outcomes[outcome]))
            self._move = None

    def _say(self, data: bytes) -> None:
        if self._client is not None:
            self._send(self._client, data)

    def _send(self, line: socket.socket, data: bytes) -> None:
        if line is not self._states:
            super()._send(line, data)
        elif self._to is not None:
            try:
                line.sendto(data, self._to)
            except OSError:  # nobody listens at the other end
                self._to = None
