"""A payload that is written to a UFACTORY controller, against the server that stands in for it."""

import threading

import numpy as np
import pytest

from core.errors import NotConnected, PayloadNotTaken, WrongRobot
from core.fakes.xarm_arm import COLLISION, SERVO, XarmArm
from core.fakes.xarm_server import XarmServer
from core.sessions.set_payload import SetPayload
from core.sessions.xarm_payload import read_payload, write_payload
from tests.core.sessions.test_xarm import CELL, PORT, cell_at
from tests.loopback import HOST

NOTHING = SetPayload(0.0, (0.0,) * 3)
WANTED = SetPayload(2.783, (0.001, -0.0168, 0.0465))


@pytest.fixture
def server():
    with XarmServer(XarmArm(CELL, CELL.payloads["steel_block"].parameters, seed=1), HOST, port=PORT) as server:
        yield server


def has(arm) -> list[float]:
    return [arm.payload, *arm.payload_com]


@pytest.mark.parametrize("ready", [False, True])
def test_what_is_written_is_had_in_the_makers_units_and_read_back(server, ready):
    if ready:
        server.arm.set_state(0)
    state = server.arm.state
    cell = cell_at(HOST)
    before = read_payload(cell)
    assert before == NOTHING
    found = write_payload(cell, WANTED, before=before)
    np.testing.assert_allclose(found.numbers, WANTED.numbers, rtol=1e-6)
    np.testing.assert_allclose(has(server.arm), [2.783, 0.001, -0.0168, 0.0465], rtol=1e-6)
    assert (server.arm.state, server.arm.moves) == (state, False)


def run_servo(arm):
    arm.set_mode(SERVO)
    arm.set_state(0)


def drift(arm):
    arm.last = arm.target - 1e-4
    arm._braking = [arm.target + 1e-4 * k for k in range(1, 2000)]


@pytest.mark.parametrize(
    ("what", "says"),
    [
        (lambda arm: arm.fail(COLLISION), "collision"),
        (lambda arm: arm.enable(on=False), "motors are off"),
        (run_servo, "a program runs or is paused"),
        (lambda arm: arm.set_state(3), "a program runs or is paused"),
        (drift, "moves; nothing was written"),
    ],
    ids=["error", "off", "servo", "paused", "moves"],
)
def test_a_robot_that_is_not_at_rest_and_at_hand_is_not_written(server, what, says):
    done = threading.Event()
    server.order(lambda: (what(server.arm), done.set()))
    assert done.wait(20.0)
    with pytest.raises(NotConnected, match=says):
        write_payload(cell_at(HOST), WANTED, before=NOTHING)
    assert has(server.arm) == [0.0] * 4


@pytest.mark.parametrize(
    ("said", "arm", "says"),
    [({"serial": "1"}, {}, "serial number"), ({}, {"type": 9}, "Lite6"), ({}, {"stretch": 0.012}, r"12\.0 mm")],
)
def test_another_robot_than_the_cells_is_not_written(server, said, arm, says):
    for name, value in arm.items():
        setattr(server.arm, name, value)
    with pytest.raises(WrongRobot, match=says):
        write_payload(cell_at(HOST, **said), WANTED, before=NOTHING)
    assert has(server.arm) == [0.0] * 4


def test_a_payload_that_somebody_else_has_set_meanwhile_is_left_alone(server):
    server.arm.payload = 1.0
    with pytest.raises(NotConnected, match="another payload than was shown"):
        write_payload(cell_at(HOST), WANTED, before=NOTHING)
    assert server.arm.payload == 1.0


def test_a_controller_that_keeps_something_else_is_told_with_both_values(server, monkeypatch):
    monkeypatch.setattr("core.sessions.set_payload.TAKEN_S", 0.3)
    take = server.arm.set_load
    monkeypatch.setattr(server.arm, "set_load", lambda mass, com: take(round(mass, 1), com))
    with pytest.raises(PayloadNotTaken, match=r"m is 2\.8 kg where 2\.783 was sent\. Do not move"):
        write_payload(cell_at(HOST), WANTED, before=NOTHING)
