"""The driver of Universal Robots arms against a server that speaks their protocols, with the virtual robot behind it."""

import time
from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.cell.session import UniversalRobot
from core.errors import ControllerStopped, NotConnected, WrongKinematics, WrongRobot, WrongSensor
from core.fakes.ur_arm import EMERGENCY, PROTECTIVE, UrArm
from core.fakes.ur_server import UrServer
from core.sessions.ur import UniversalRobotsSession
from tests.core.sessions.conformance import Bench, Conformance, fall_into_step, move

CELL = load_cell(Path(__file__).parents[3] / "cells" / "ur5e_line")
PATIENCE_S = 20.0


def cell_at(host: str, **said) -> Cell:
    link = UniversalRobot(driver="ur_rtde", host=host, model="UR5e", **said)
    return CELL.model_copy(update={"session": link})


class UrBench(Bench):
    def __init__(self, server: UrServer) -> None:
        self.server, self.arm = server, server.arm
        self.cell = cell_at(server.host)

    def open(self, cell: Cell | None = None, **said) -> UniversalRobotsSession:
        return UniversalRobotsSession(cell or cell_at(self.server.host, **said))

    def where(self):
        return self.arm.q.copy()

    def swap_joints(self) -> Cell:
        self.arm.order[1:3] = [2, 1]
        return self.cell

    def cut(self) -> None:
        self.server.cut = True

    def stay_away(self) -> None:
        self.server.patience_s = 0.01
        self.settle()

    def settle(self) -> None:
        t = self.arm.t
        until = time.monotonic() + 60.0
        while self.arm.t < t + 1.0 and time.monotonic() < until:
            time.sleep(0.01)
        assert self.arm.t >= t + 1.0


@pytest.fixture
def bench(request, monkeypatch):
    monkeypatch.setattr("core.sessions.ur.LINK_S", 3.0)  # the computer that tests may be busy
    seed = abs(hash(request.node.nodeid))
    host = f"127.{30 + seed % 200}.{(seed >> 8) % 250}.{2 + (seed >> 16) % 250}"
    carried = CELL.payloads["steel_block"].parameters
    with UrServer(UrArm(CELL, carried, seed=1), host, patience_s=PATIENCE_S) as server:
        yield UrBench(server)


class TestConformance(Conformance):
    pass


def test_the_wrench_is_that_of_the_virtual_robot_in_its_own_frame_and_sign(bench):
    with bench.open() as session:
        states = [session.state() for _ in range(50)]
    phi, cell = CELL.payloads["steel_block"].parameters, CELL
    force = np.mean([state.wrench for state in states], axis=0) - bench.arm._robot.truth.offset
    R = session._robot.sensor_pose(states[-1].q).rotation
    expected = -phi.mass * R.T @ cell.gravity
    np.testing.assert_allclose(force[:3], expected, atol=0.1)
    np.testing.assert_allclose(force[3:], np.cross(phi.com, expected), atol=0.02)


def stop_of(arm, what):
    if what == "slider":
        arm.speed_fraction = 0.5
    elif what == "ended":
        arm.end_program()
    elif what == "remote":
        arm.remote = False
        arm.end_program()
    elif what == "off":
        arm.robot_mode = 3
        arm.end_program()
    else:
        arm.stop_safely({"emergency": EMERGENCY, "protective": PROTECTIVE, "safeguard": 5}[what])


@pytest.mark.parametrize(
    ("what", "says"),
    [
        ("emergency", "emergency stop is pressed"),
        ("protective", "protective stop"),
        pytest.param("safeguard", "safeguard stop", marks=pytest.mark.thorough),
        ("slider", "speed slider is at 50 %"),
        ("ended", "program on the controller has ended"),
        pytest.param("remote", "taken out of remote control", marks=pytest.mark.thorough),
        pytest.param("off", "not switched on", marks=pytest.mark.thorough),
    ],
)
def test_what_the_controller_does_by_itself_ends_the_motion_with_a_reason(bench, what, says):
    with pytest.raises(ControllerStopped, match=says) as raised, bench.open() as session:
        move(session, bench.cell)
        bench.server.order(lambda: stop_of(bench.arm, what))
        move(session, bench.cell, seconds=2.0)
    assert not raised.value.may_go_on
    Conformance.check_standing(bench)


@pytest.mark.parametrize("what", ["emergency", "protective", "slider", "remote", "off"])
def test_a_robot_that_cannot_be_moved_is_refused_before_anything_moves(bench, what):
    bench.server.order(lambda: stop_of(bench.arm, what))
    before = bench.where()
    bench.settle()
    with pytest.raises(NotConnected, match=bench.server.host):
        bench.open().find_start()
    np.testing.assert_allclose(bench.where(), before, atol=1e-4)


@pytest.mark.parametrize(
    ("said", "arm", "says"),
    [
        ({"serial": "1"}, {}, "serial number 20245500123.* expects 1;"),
        ({"firmware": "5.16"}, {}, r"version 5\.17\.3.* expects 5\.16;"),
        ({}, {"version": (5, 9, 4, 0)}, r"version 5\.9\.4; this driver knows 5\.10"),
        ({}, {"stretch": 0.012}, r"12\.0 mm \(limit 5\.0 mm\)"),
        ({}, {"model": "UR10"}, "calls itself UR10e"),
    ],
)
def test_another_robot_than_the_cells_is_refused_with_what_was_found(bench, said, arm, says):
    for name, value in arm.items():
        setattr(bench.arm, name, value)
    with pytest.raises(WrongRobot, match=says):
        bench.open(**said).find_start()


def test_swapped_joints_are_named(bench):
    with pytest.raises(WrongRobot, match="joints shoulder_lift and elbow swapped they agree"):
        bench.open(bench.swap_joints()).find_start()


def test_swapped_joints_that_stand_at_one_angle_are_named_within_a_degree_of_motion(bench):
    bench.arm.order[:] = [5, 1, 2, 3, 4, 0]  # both at zero: nothing shows at the entry
    before = bench.where()
    with pytest.raises(WrongKinematics, match="joints shoulder_pan and wrist_3 swapped it agrees"), bench.open() as session:
        move(session, bench.cell)
    Conformance.check_standing(bench)
    assert 1e-4 < np.abs(bench.where() - before).max() < 0.0175


def test_registers_that_somebody_else_writes_are_told(bench):
    with bench.open():
        bench.server.patience_s = 0.01  # the first session waits for the second
        with pytest.raises(NotConnected, match="IN_USE"):
            bench.open().find_start()


def test_nobody_at_the_other_end_is_told_with_what_to_look_at():
    with pytest.raises(NotConnected, match=r"nobody answers at 127\.29\.0\.1"):
        UniversalRobotsSession(cell_at("127.29.0.1")).find_start()


def test_no_period_passes_without_a_command(bench):
    with bench.open() as session:
        fall_into_step(session)
        before = session.missed
        states = move(session, bench.cell, seconds=1.0)
        followed, missed = bench.arm.periods_followed, bench.arm.missed
        assert session.missed == before
    np.testing.assert_allclose(np.diff([state.t for state in states]), session.period, atol=1e-6)
    assert followed >= 495 and missed == 0


def test_between_two_motions_the_arm_is_told_to_stay_where_it_is(bench):
    with bench.open() as session:
        move(session, bench.cell, seconds=0.2)
        session.state()  # in which the first has ended and the second not begun, while the lookahead still carries the arm on
        move(session, bench.cell, seconds=0.2)
        missed = bench.arm.missed
    assert missed == 0


def test_a_robot_that_stood_goes_on_after_the_loop_was_away(bench):
    """Planning takes seconds, and the watchdog ends the program meanwhile."""
    with bench.open() as session:
        move(session, bench.cell)
        session.stop()
        session.release()
        bench.stay_away()
        bench.server.patience_s = PATIENCE_S
        assert not bench.arm.playing
        before = bench.where()
        move(session, bench.cell)
        assert np.abs(bench.where() - before).min() > 1e-3


def turn_wrist(session) -> None:
    """Turns the third last joint by 0.8 rad and stands there."""
    q = session.state().q_cmd
    for share in 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, 700)):
        session.state()
        session.command(q + 0.8 * share * np.eye(6)[3])
    for _ in range(150):
        session.state()


def test_a_sensor_with_the_other_sign_is_told_at_the_second_pose(bench):
    with pytest.raises(WrongSensor, match=r"as if the load had -2\.\d+ kg"), bench.open(wrench_acts_on="payload") as session:
        for _ in range(60):
            session.state()
        turn_wrist(session)
    Conformance.check_standing(bench)


def test_a_sensor_with_the_right_sign_is_found_right(bench):
    with bench.open() as session:
        for _ in range(60):
            session.state()
        turn_wrist(session)
        assert session._sensor_sign.decided
