"""The stand-in of a Franka controller, asked by hand: messages are read and made here byte by byte, by the published headers.

The maker's own client is C++ and was not to be had. So the places of what matters are counted out here once more, number by number.
"""

import socket
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import count
from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.fakes.franka_arm import FrankaArm
from core.fakes.franka_server import FrankaServer
from tests.loopback import HOST

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
HOME = np.array(CELL.robot.home_rad)
PORTS = count(33000)
PLACE = {
    "O_T_EE": 0, "F_T_EE": 32, "m_ee": 96, "m_load": 109, "I_load": 110, "F_x_Cload": 119, "tau_J": 126, "q": 147, "q_d": 154, "dq": 161,
    "dq_d": 168, "ddq_d": 175, "tau_ext": 208, "O_F_ext": 215,
}  # fmt: skip
"""Index of the first number of each, in the states of all versions."""


class Told:
    """A state, by the places of its bytes: 284 double numbers up to version 9, 320 single ones in version 10."""

    def __init__(self, data: bytes) -> None:
        self.code, self.width, self.count = {2373: ("d", 8, 284), 1377: ("f", 4, 320)}[len(data)]
        self.data, self.number = data, struct.unpack_from("<Q", data)[0]
        after = 8 + self.width * self.count
        self.motion, self.controller = data[after], data[after + 1]
        self.errors = [k for k in range(41) if data[after + 2 + k]]
        self.reasons = [k for k in range(41) if data[after + 43 + k]]
        self.mode = data[after + 84]
        self.success = struct.unpack_from(f"<{self.code}", data, after + 85)[0]

    def __getitem__(self, name: str) -> np.ndarray:
        sizes = {"O_T_EE": 16, "F_T_EE": 16, "m_ee": 1, "m_load": 1, "I_load": 9, "F_x_Cload": 3, "O_F_ext": 6}
        return np.array(struct.unpack_from(f"<{sizes.get(name, 7)}{self.code}", self.data, 8 + self.width * PLACE[name]))


class Client:
    def __init__(self, version: int, port: int) -> None:
        self.version = version
        self.line = socket.create_connection((HOST, port), timeout=20.0)
        self.states = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.states.bind((self.line.getsockname()[0], 0))
        self.states.settimeout(20.0)
        self.asked = 0

    def ask(self, command: int, body: bytes = b"") -> tuple[int, bytes]:
        self.line.sendall(struct.pack("<III", command, self.asked, 12 + len(body)) + body)
        self.asked += 1
        return self.hear_answer(command, self.asked - 1)

    def hear_answer(self, command: int, number: int) -> tuple[int, bytes]:
        head = self.line.recv(12, socket.MSG_WAITALL)
        assert struct.unpack("<II", head[:8]) == (command, number)
        body = self.line.recv(struct.unpack("<I", head[8:])[0] - 12, socket.MSG_WAITALL)
        return body[0], body[1:]

    def connect(self) -> tuple[int, bytes]:
        return self.ask(0, struct.pack("<HH", self.version, self.states.getsockname()[1]))

    def hear(self) -> Told:
        data, self.peer = self.states.recvfrom(4096)
        return Told(data)

    def move(self) -> int:
        body = struct.pack("<II6d", 0, 0, *[10.0, 3.12, 6.28] * 2)
        return self.ask(1, body + (bytes(57) if self.version >= 10 else b""))[0]

    def command(self, told: Told, q: np.ndarray, *, finished: bool = False) -> None:
        body = struct.pack("<Q", told.number) + struct.pack("<7d", *q) + bytes(8 * 31) + bytes([0, finished]) + bytes(8 * 7)
        self.states.sendto(body + (b"\0" if self.version >= 7 else b""), self.peer)

    def close(self) -> None:
        self.line.close()
        self.states.close()


@contextmanager
def connect(version: int = 10, *, patience_s: float = 20.0) -> Iterator[tuple[FrankaServer, Client]]:
    port = next(PORTS)
    with FrankaServer(FrankaArm(CELL, seed=2, version=version), HOST, port=port, patience_s=patience_s) as server:
        client = Client(version, port)
        try:
            assert client.connect() == (0, struct.pack("<H", version))
            yield server, client
        finally:
            client.close()


def follow(client: Client, steps: int, ahead=lambda _: 0.0) -> Told:
    """Sends where the controller says it is, and `ahead(k)` more at every joint; gives the last state.

    It begins with the first state of the motion, whose answer is waited for: those before may have been lying here.
    """
    while (told := client.hear()).mode != 2:
        pass
    begin = told["q_d"]
    for k in range(steps):
        client.command(told, begin + ahead(k))
        told = client.hear()
        if told.mode != 2:
            break
    return told


@pytest.mark.parametrize("version", [5, 7, 10])
def test_states_are_what_the_published_headers_say(version):
    with connect(version) as (server, client):
        told = client.hear()
        later = client.hear()
        position, rotation = server.arm.flange(HOME)
    assert (told.code, told.count) == (("f", 320) if version == 10 else ("d", 284))
    assert later.number == told.number + 1
    np.testing.assert_allclose(told["q"], HOME, atol=1e-3)
    np.testing.assert_allclose(told["q_d"], HOME, atol=1e-6)
    pose, tool = told["O_T_EE"].reshape(4, 4).T, told["F_T_EE"].reshape(4, 4).T
    flange = pose @ np.linalg.inv(tool)
    np.testing.assert_allclose(flange[:3, 3], position, atol=1e-3)
    np.testing.assert_allclose(flange[:3, :3], rotation, atol=2e-3)
    assert (told.mode, told.motion, told.errors, told.reasons, told.success) == (1, 0, [], [], 0.0)


def test_another_version_is_refused_and_told_its_own():
    port = next(PORTS)
    with FrankaServer(FrankaArm(CELL, version=8), HOST, port=port):
        client = Client(10, port)
        assert client.connect() == (1, struct.pack("<H", 8))
        client.close()


def test_the_description_has_a_name_and_seven_joints():
    for version, command in ((8, 12), (10, 11)):
        with connect(version) as (_, client):
            status, text = client.ask(command)
        assert status == 0 and text.decode().count("<limit ") == 7 and '<robot name="fr3"' in text.decode()


@pytest.mark.parametrize("version", [5, 6, 9, 10])
def test_a_motion_begins_follows_and_is_finished_with_two_answers(version):
    with connect(version) as (server, client):
        assert client.move() == 1
        told = follow(client, 400, lambda k: 5e-4 * (1.0 - np.cos(np.pi * min(k, 200) / 200)))
        assert (told.mode, told.motion, told.controller) == (2, 1, 0)
        assert server.arm.missed == 0 and server.arm.periods_followed >= 390
        np.testing.assert_allclose(told["q_d"] - HOME, 1e-3, atol=1e-5)
        client.command(told, told["q_d"], finished=True)
        assert client.hear_answer(1, 1) == (0, b"")
        for _ in range(5):
            told = client.hear()
        assert (told.mode, told.motion) == (1, 0)


@pytest.mark.parametrize(("ahead", "error"), [
    (lambda _: 0.02, 11),
    (lambda k: 0.0 if k < 3 else 0.01, 13),
    (lambda k: 0.0 if k < 3 else 2e-5, 14),
    (lambda k: 0.0 if k < 3 else 6e-6, 15),
])  # fmt: skip
def test_a_command_beyond_a_limit_ends_the_motion_with_the_error_of_that_limit(ahead, error):
    """Speed, 20 rad/s2 and 6000 rad/s3 by backward differences; the first command only has to be near."""
    with connect() as (_, client):
        client.move()
        told = follow(client, 10, ahead)
        assert (told.mode, told.errors) == (4, [error])
        assert client.hear_answer(1, 1) == (8, b""), "the motion was ended by a reflex"
        assert client.move() == 5, "no motion is possible until the error is cleared"
        assert client.ask(10) == (0, b"")
        while client.hear().mode != 1:
            pass


def test_lost_commands_are_made_up_for_at_the_same_acceleration_and_twenty_end_the_motion():
    with connect(patience_s=5.0) as (server, client):
        client.move()
        told = follow(client, 200, lambda k: 1e-3 * 2e-3 * k**2 / 2)  # 2 rad/s2
        server.patience_s = 0.002
        speed, acceleration = told["dq_d"], told["ddq_d"]
        np.testing.assert_allclose(acceleration, 2.0, rtol=1e-2)
        later = client.hear()
        elapsed = 1e-3 * (later.number - told.number)
        np.testing.assert_allclose(later["dq_d"], speed + elapsed * acceleration, rtol=1e-4)
        np.testing.assert_allclose(later["ddq_d"], acceleration, rtol=1e-6)
        while later.mode == 2:
            later = client.hear()
        assert later.errors == [25] and later.number - told.number == 20
        assert server.arm.missed == 20
        for _ in range(300):
            stands = client.hear()["q"]
        np.testing.assert_allclose(client.hear()["q"], stands, atol=1e-3)


def test_a_late_command_is_dropped_and_one_of_another_version_is_none():
    with connect(patience_s=0.002) as (server, client):
        client.move()
        told = client.hear()
        client.hear()
        client.command(told, told["q_d"])
        client.states.sendto(b"\1" * 370, client.peer)
        client.hear()
        assert server.arm.periods_followed == 0


def test_a_load_is_set_while_nothing_moves_and_told_in_every_state():
    body = struct.pack("<13d", 2.5, 0.01, 0.02, 0.03, 1e-3, 1e-4, 2e-4, 1e-4, 2e-3, 3e-4, 2e-4, 3e-4, 3e-3)
    for version, command in ((5, 10), (10, 9)):
        with connect(version) as (_, client):
            assert client.ask(command, body)[0] == 0
            while (told := client.hear())["m_load"][0] == 0.0:
                pass
            np.testing.assert_allclose(told["F_x_Cload"], [0.01, 0.02, 0.03], rtol=1e-6)
            np.testing.assert_allclose(told["I_load"].reshape(3, 3)[1], [1e-4, 2e-3, 3e-4], rtol=1e-6)
            assert client.ask(command, struct.pack("<13d", -1.0, *[0.0] * 12))[0] == 2
            client.move()
            assert client.ask(command, body)[0] == 1


def test_whoever_stops_the_motion_is_answered_twice():
    with connect() as (_, client):
        client.move()
        follow(client, 5)
        client.line.sendall(struct.pack("<III", 2, 2, 12))
        assert client.hear_answer(1, 1) == (2, b"") and client.hear_answer(2, 2) == (0, b"")


def test_a_second_client_is_sent_away():
    with connect() as (server, client):
        other = Client(10, server._port)
        with pytest.raises((ConnectionError, AssertionError, struct.error)):
            other.connect()
        other.close()
        assert client.hear().mode == 1
