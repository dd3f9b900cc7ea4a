"""The stand-in of a KUKA controller, asked by hand: datagrams are read and made here byte by byte, by the published field numbers.

No client that others wrote can be had: none is in a package index, and the licence of KUKA's own library allows its use with KUKA's
products only, which this stand-in is not.
"""

import socket
import struct
import time
from collections.abc import Iterator
from itertools import count
from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.fakes.fri_arm import FriArm
from core.fakes.fri_server import FriServer
from tests.loopback import HOST

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
PORTS = count(32000)
Message = dict[int, list]


def read_varint(data: bytes, at: int) -> tuple[int, int]:
    value = shift = 0
    while True:
        value |= (data[at] & 0x7F) << shift
        at, shift = at + 1, shift + 7
        if not data[at - 1] & 0x80:
            return value, at


def read(data: bytes) -> Message:
    """Every field by its number, undecoded: numbers, 8 bytes, or the bytes of a message inside."""
    fields: Message = {}
    at = 0
    while at < len(data):
        key, at = read_varint(data, at)
        if key & 7 == 0:
            value, at = read_varint(data, at)
        elif key & 7 == 1:
            value, at = struct.unpack_from("<d", data, at)[0], at + 8
        else:
            assert key & 7 == 2, "no other wire type is in these messages"
            length, at = read_varint(data, at)
            value, at = data[at : at + length], at + length
        fields.setdefault(key >> 3, []).append(value)
    return fields


def inside(message: Message, *numbers: int) -> Message:
    for number in numbers:
        message = read(message[number][0])
    return message


def varint(value: int) -> bytes:
    out = b""
    while value > 0x7F:
        out, value = out + bytes([value & 0x7F | 0x80]), value >> 7
    return out + bytes([value])


def field(number: int, body: bytes) -> bytes:
    return varint(number << 3 | 2) + varint(len(body)) + body


def command(sequence: int, reflected: int, q: np.ndarray | None) -> bytes:
    header = b"".join(varint(number << 3) + varint(value) for number, value in ((1, 0x34001), (2, sequence), (3, reflected)))
    joints = b"" if q is None else field(2, field(1, b"".join(b"\x09" + struct.pack("<d", each) for each in q)))
    return field(1, header) + joints


class Client:
    """One cycle after the other."""

    def __init__(self, line: socket.socket) -> None:
        self.line, self.sent = line, 0

    def hear(self) -> Message:
        data, self.peer = self.line.recvfrom(2048)
        return read(data)

    def cycle(self, answer) -> Message:
        """A message, and its answer: joint positions as `answer` gives them of it, or None."""
        told = self.hear()
        self.line.sendto(command(self.sent, inside(told, 1)[2][0], answer(told)), self.peer)
        self.sent += 1
        return told

    def go_on(self, state: int, answer, most: int = 400) -> Message:
        for _ in range(most):
            told = self.cycle(answer)
            if inside(told, 4)[1] == [state]:
                return told
        raise AssertionError(f"state {state} never came; now {inside(told, 4)}")


def ipo(told: Message) -> np.ndarray:
    return np.array(inside(told, 5, 1)[1])


def start(version: int = 2) -> tuple[FriServer, int]:
    port = next(PORTS)
    return FriServer(FriArm(CELL, seed=2, period_ms=5, version=version), HOST, client=HOST, port=port, patience_s=1.0), port


@pytest.fixture
def pair() -> Iterator[tuple[FriServer, Client]]:
    server, port = start()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as line, server:
        line.bind((HOST, port))
        line.settimeout(20.0)
        yield server, Client(line)


def test_messages_are_what_the_published_field_numbers_say(pair):
    server, client = pair
    told = client.hear()
    assert inside(told, 1)[1] == [0x245142]
    assert inside(told, 4) == {1: [1], 2: [0], 3: [5], 4: [1]}
    robot, measured = inside(told, 2), inside(told, 3)
    assert (robot[1], robot[2], robot[5], robot[6], robot[7]) == ([7], [0], [0] * 7, [2], [0])
    np.testing.assert_allclose(inside(measured, 1)[1], CELL.robot.home_rad, atol=1e-3)
    assert all(len(inside(measured, number)[1]) == 7 for number in (2, 4, 5))
    pose = inside(measured, 9)[2]
    position, _ = server.arm.flange(np.array(CELL.robot.home_rad))
    np.testing.assert_allclose(pose[:3], 1e3 * position, atol=1.0)
    assert np.linalg.norm(pose[3:]) == pytest.approx(1.0)
    stamp = inside(measured, 15)
    assert stamp[1][0] > 1e9 and stamp[2][0] < 1e9
    later = client.hear()
    assert inside(later, 1)[2][0] == inside(told, 1)[2][0] + 1
    assert inside(later, 3, 15)[2][0] - stamp[2][0] == pytest.approx(5e6, abs=2)


def test_the_first_version_tells_the_last_command_and_no_pose():
    server, port = start(version=1)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as line, server:
        line.bind((HOST, port))
        line.settimeout(20.0)
        measured = inside(Client(line).hear(), 3)
    assert 9 not in measured
    np.testing.assert_allclose(inside(measured, 3)[1], CELL.robot.home_rad)


def test_a_session_goes_through_its_states_only_as_its_client_does_its_part(pair):
    server, client = pair
    ready = client.go_on(2, lambda _: None)
    assert inside(ready, 4)[2][0] >= 2 and 5 not in ready
    client.go_on(3, lambda _: None)
    for _ in range(40):
        told = client.cycle(lambda told: ipo(told) + 0.01)
        assert inside(told, 4)[1] == [3], "it waits for a client that echoes its interpolation"
    active = client.go_on(4, ipo)
    assert inside(active, 2)[5] == [2] * 7 and inside(active, 5)[10] == [1] and inside(active, 5)[11] == [1]
    q = ipo(active)
    for _ in range(100):
        q = q + 0.0005
        told = client.cycle(lambda _, q=q: q)
    assert inside(told, 1)[3] == [client.sent - 2], "it reflects the newest command that it has"
    np.testing.assert_allclose(inside(told, 3, 1)[1], q, atol=0.01)
    assert server.arm.missed == 0 and server.arm.periods_followed >= 99
    for _ in range(3):
        client.hear()  # unanswered
    client.cycle(lambda _: q)
    assert server.arm.missed == 1, "the first cycle without a command; from then on the arm stands"


def test_a_client_that_goes_away_ends_the_motion_and_one_that_jumps_too(pair):
    _, client = pair
    client.go_on(4, lambda told: ipo(told) if 5 in told else None)
    for _ in range(15):
        told = client.hear()
    assert inside(told, 4)[1] == [1] and inside(told, 4)[2] == [0]
    client.go_on(4, lambda told: ipo(told) if 5 in told else None)
    client.cycle(lambda told: ipo(told) + 0.5)
    client.cycle(lambda _: None)
    assert inside(client.cycle(lambda _: None), 4)[1] == [2]


@pytest.mark.parametrize("what", [b"", b"\xff" * 30, field(1, b"\x08\x01\x10\x02\x18\x03")])
def test_what_is_no_command_counts_as_no_answer(pair, what):
    server, client = pair
    for _ in range(60):
        client.hear()
        client.line.sendto(what, client.peer)
    assert inside(client.hear(), 4)[2] == [0]
    assert not server.arm.obeys


def test_what_nobody_hears_is_sent_all_the_same():
    server, port = start()
    with server:
        time.sleep(0.1)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as line:
            line.bind((HOST, port))
            line.settimeout(20.0)
            assert inside(Client(line).hear(), 4)[1] == [1]
