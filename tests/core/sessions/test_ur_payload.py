"""A payload that is written to a controller, against the server that stands in for it."""

import threading

import numpy as np
import pytest

from core.errors import ControllerStopped, NotConnected, PayloadNotTaken, WrongRobot
from core.fakes.ur_arm import EMERGENCY, PROTECTIVE, UrArm
from core.fakes.ur_server import UrServer
from core.sessions.set_payload import SetPayload
from core.sessions.ur_payload import read_payload, write_payload
from tests.core.sessions.conformance import Conformance, move
from tests.core.sessions.test_ur import CELL, UrBench, cell_at
from tests.loopback import HOST

NOTHING = SetPayload(0.0, (0.0,) * 3, (0.0,) * 6)
WANTED = SetPayload(2.783, (0.001, -0.0168, 0.0465), (0.0101, 0.0102, 0.0031, -1.2e-5, 0.0004, -0.0007))


@pytest.fixture
def server():
    with UrServer(UrArm(CELL, CELL.payloads["steel_block"].parameters, seed=1), HOST) as server:
        yield server


def has(arm) -> list[float]:
    return [arm.payload, *arm.payload_com, *arm.payload_inertia]


def test_what_is_written_is_had_in_the_makers_order_and_read_back(server):
    cell = cell_at(HOST)
    assert read_payload(cell) == NOTHING
    assert write_payload(cell, WANTED, before=NOTHING) == WANTED
    np.testing.assert_allclose(has(server.arm), [2.783, 0.001, -0.0168, 0.0465, 0.0101, 0.0102, 0.0031, -1.2e-5, 0.0004, -0.0007])
    assert server.arm.zeroed == 1
    assert read_payload(cell) == WANTED


def stop_safely(mode):
    return lambda arm: arm.stop_safely(mode)


def run_beside(arm):
    arm.run("def p():\n  while 1 == 1:\n    sync()\n  end\nend\n")


def drift(arm):
    arm.last = arm.target - 1e-4
    arm._braking = [arm.target + 1e-4 * k for k in range(1, 2000)]


@pytest.mark.parametrize(
    ("what", "says"),
    [
        (stop_safely(EMERGENCY), "emergency stop is pressed"),
        (stop_safely(PROTECTIVE), "protective stop"),
        (lambda arm: setattr(arm, "remote", False), "not in remote control"),
        (run_beside, "a program runs or is paused"),
        (drift, "moves; nothing was written"),
    ],
    ids=["emergency", "protective", "local", "program", "moves"],
)
def test_a_robot_that_is_not_at_rest_and_at_hand_is_not_written(server, what, says):
    done = threading.Event()
    server.order(lambda: (what(server.arm), done.set()))
    assert done.wait(20.0)
    with pytest.raises(NotConnected, match=says):
        write_payload(cell_at(HOST), WANTED, before=NOTHING)
    assert has(server.arm) == [0.0] * 10


@pytest.mark.parametrize(
    ("said", "arm", "says"),
    [({"serial": "1"}, {}, "serial number"), ({}, {"model": "UR10"}, "UR10e"), ({}, {"stretch": 0.012}, r"12\.0 mm")],
)
def test_another_robot_than_the_cells_is_not_written(server, said, arm, says):
    for name, value in arm.items():
        setattr(server.arm, name, value)
    with pytest.raises(WrongRobot, match=says):
        write_payload(cell_at(HOST, **said), WANTED, before=NOTHING)
    assert has(server.arm) == [0.0] * 10


def test_a_slider_that_is_down_keeps_nobody_from_writing(server):
    server.arm.speed_fraction = 0.1
    assert write_payload(cell_at(HOST), WANTED, before=NOTHING) == WANTED


def test_a_payload_that_somebody_else_has_set_meanwhile_is_left_alone(server):
    server.arm.payload = 1.0
    with pytest.raises(NotConnected, match="another payload than was shown"):
        write_payload(cell_at(HOST), WANTED, before=NOTHING)
    assert server.arm.payload == 1.0


def test_a_controller_that_keeps_something_else_is_told_with_both_values(server, monkeypatch):
    monkeypatch.setattr("core.sessions.set_payload.TAKEN_S", 0.2)
    take = server.arm._set_payload
    monkeypatch.setattr(server.arm, "_set_payload", lambda m, cog, inertia: take(round(m, 1), cog, [*inertia[:3], 0.0, *inertia[4:]]))
    with pytest.raises(PayloadNotTaken, match=r"written: m is 2\.8 kg where 2\.783 was sent, Ixy is 0 kg m2 where -1\.2e-5"):
        write_payload(cell_at(HOST), WANTED, before=NOTHING)


def test_a_controller_that_refuses_it_is_told(server, monkeypatch):
    monkeypatch.setattr("core.sessions.set_payload.TAKEN_S", 0.2)
    with pytest.raises(PayloadNotTaken, match=r"m is 0 kg where 2\.783"):
        write_payload(cell_at(HOST), WANTED._replace(inertia_kg_m2=(134.0, *[0.0] * 5)), before=NOTHING)
    assert has(server.arm) == [0.0] * 10


@pytest.mark.parametrize("what", ["payload", "payload_com"])
def test_a_payload_that_is_set_while_a_session_is_open_stops_the_robot(server, what, monkeypatch):
    monkeypatch.setattr("core.sessions.ur.LINK_S", 3.0)
    server.patience_s = 20.0
    bench = UrBench(server)
    with pytest.raises(ControllerStopped, match="nothing is recorded across it") as raised, bench.open() as session:
        move(session, bench.cell, seconds=0.1)
        server.order(lambda: setattr(server.arm, what, 0.5 if what == "payload" else np.array([0.0, 0.0, 0.02])))
        move(session, bench.cell, seconds=0.5)
    assert not raised.value.may_go_on
    Conformance.check_standing(bench)
