"""A load that is written to a controller of Franka, against the server that stands in for it."""

import threading

import numpy as np
import pytest

from core.errors import NotConnected, PayloadNotTaken, WrongRobot
from core.fakes.franka_arm import JOINT_REFLEX, FrankaArm
from core.fakes.franka_server import FrankaServer
from core.sessions.franka_payload import read_payload, write_payload
from core.sessions.set_payload import SetPayload
from tests.core.sessions.test_franka import CELL, FrankaBench
from tests.loopback import HOST

NOTHING = SetPayload(0.0, (0.0,) * 3, (0.0,) * 6)
WANTED = SetPayload(2.783, (0.001, -0.0168, 0.0465), (0.0069, 0.0066, 0.0033, 1e-4, -2e-4, 0.0017))


@pytest.fixture(params=[10, 5])
def bench(request):
    with FrankaServer(FrankaArm(CELL, CELL.payloads["steel_block"].parameters, seed=1, version=request.param), HOST) as server:
        yield FrankaBench(server)


def has(arm) -> list[float]:
    inertia = arm.inertia.reshape(3, 3).T
    return [arm.mass, *arm.com, *np.diag(inertia), inertia[0, 1], inertia[0, 2], inertia[1, 2]]


def test_what_is_written_is_had_as_the_maker_wants_it_and_read_back(bench):
    before = read_payload(bench.cell)
    assert before == NOTHING
    found = write_payload(bench.cell, WANTED, before=before)
    np.testing.assert_allclose(found.numbers, WANTED.numbers, rtol=1e-6)
    np.testing.assert_allclose(has(bench.arm), WANTED.numbers, rtol=1e-12)
    np.testing.assert_array_equal(bench.arm.inertia.reshape(3, 3), bench.arm.inertia.reshape(3, 3).T)
    assert not bench.arm.moves and bench.arm.periods_followed == 0


def drift(arm):
    arm.last = arm.target - 1e-4
    arm._braking = [arm.target + 1e-4 * k for k in range(1, 20000)]


@pytest.mark.parametrize(
    ("what", "says"),
    [
        (lambda arm: arm.fail(JOINT_REFLEX), "a collision, or a load"),
        (lambda arm: arm.begin_move(), "a motion runs on it"),
        (lambda arm: arm.close_brakes(), "Unlock the joints"),
        (drift, "moves; nothing was written"),
    ],
    ids=["reflex", "motion", "brakes", "moves"],
)
def test_a_robot_that_is_not_at_rest_and_at_hand_is_not_written(bench, what, says):
    done = threading.Event()
    bench.server.order(lambda: (what(bench.arm), done.set()))
    assert done.wait(20.0)
    with pytest.raises(NotConnected, match=says):
        write_payload(bench.cell, WANTED, before=NOTHING)
    assert has(bench.arm) == [0.0] * 10


def test_another_robot_than_the_cells_is_not_written(bench):
    bench.arm.stretch = 0.012
    with pytest.raises(WrongRobot, match=r"12\.0 mm"):
        write_payload(bench.cell, WANTED, before=NOTHING)
    assert has(bench.arm) == [0.0] * 10


def test_a_load_that_somebody_else_has_set_meanwhile_is_left_alone(bench):
    bench.arm.mass = 1.0
    with pytest.raises(NotConnected, match="another payload than was shown"):
        write_payload(bench.cell, WANTED, before=NOTHING)
    assert bench.arm.mass == 1.0


def test_a_controller_that_refuses_is_told(bench):
    with pytest.raises(NotConnected, match=r"has refused the load \(answer 2\); nothing was written"):
        write_payload(bench.cell, WANTED._replace(mass_kg=-1.0), before=NOTHING)
    assert has(bench.arm) == [0.0] * 10


def test_a_controller_that_keeps_something_else_is_told_with_both_values(bench, monkeypatch):
    monkeypatch.setattr("core.sessions.set_payload.TAKEN_S", 0.3)
    take = bench.arm.set_load
    monkeypatch.setattr(bench.arm, "set_load", lambda mass, com, inertia: take(round(mass, 1), com, inertia))
    with pytest.raises(PayloadNotTaken, match=r"m is 2\.8 kg where 2\.783 was sent\. Do not move"):
        write_payload(bench.cell, WANTED, before=NOTHING)
