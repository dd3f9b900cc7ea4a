"""The driver of UFACTORY arms against a server that speaks their protocol, with the virtual robot behind it."""

import threading
import time
from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.cell.session import XarmRobot
from core.errors import ControllerStopped, NotConnected, WrongRobot, WrongSensor
from core.fakes.xarm_arm import COLLISION, EMERGENCY, PAUSE, POSITION, SENSOR, STOP, XarmArm
from core.fakes.xarm_protocol import XarmPeer
from core.fakes.xarm_server import XarmServer
from core.sessions.xarm import LEAP_M, XarmSession
from tests.core.sessions.conformance import Bench, Conformance, fall_into_step, move

CELLS = Path(__file__).parents[3] / "cells"
CELL = load_cell(CELLS / "ur5e_line")
PATIENCE_S = 20.0
PORT = 5020


def cell_at(host: str, cell: Cell = CELL, **said) -> Cell:
    model = f"xArm{len(cell.robot.home_rad)}"
    link = XarmRobot.model_validate({"driver": "xarm", "host": host, "port": PORT, "model": model, **said})
    return cell.model_copy(update={"session": link})


class XarmBench(Bench):
    def __init__(self, server: XarmServer, cell: Cell = CELL) -> None:
        self.server, self.arm = server, server.arm
        self.cell = cell_at(server.host, cell)

    def open(self, cell: Cell | None = None, **said) -> XarmSession:
        return XarmSession(cell or cell_at(self.server.host, self.cell, **said))

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
    monkeypatch.setattr("core.sessions.xarm.LINK_S", 3.0)  # the computer that tests may be busy
    seed = abs(hash(request.node.nodeid))
    host = f"127.{30 + seed % 200}.{(seed >> 8) % 250}.{2 + (seed >> 16) % 250}"
    carried = CELL.payloads["steel_block"].parameters
    with XarmServer(XarmArm(CELL, carried, seed=1), host, port=PORT, patience_s=PATIENCE_S) as server:
        yield XarmBench(server)


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


def disturb(arm, what):
    {
        "emergency": lambda: arm.fail(EMERGENCY),
        "collision": lambda: arm.fail(COLLISION),
        "sensor": lambda: arm.fail(SENSOR),
        "motor": lambda: arm.fail(13),
        "unknown": lambda: arm.fail(110),
        "mode": lambda: arm.set_mode(POSITION),
        "paused": lambda: arm.set_state(PAUSE),
        "stopped": lambda: arm.set_state(STOP),
        "payload": lambda: setattr(arm, "payload", 0.5),
        "tool": lambda: setattr(arm, "tcp_offset", np.array([0.0, 0.0, 0.12, 0.0, 0.3, 0.0])),
        "zeroed": arm.set_sensor_zero,
        "went off": lambda: setattr(arm, "sensor_on", False),
        "off": lambda: arm.enable(on=False),
        "simulation": lambda: setattr(arm, "simulation", True),
        "force control": lambda: setattr(arm, "sensor_mode", 2),
    }[what]()


@pytest.mark.parametrize(
    ("what", "says"),
    [
        ("emergency", "emergency stop is pressed"),
        ("collision", r"collision.*\(error 31\)"),
        pytest.param("sensor", r"force/torque sensor.*\(error 50\)", marks=pytest.mark.thorough),
        pytest.param("motor", r"motor \(error 13\)", marks=pytest.mark.thorough),
        pytest.param("unknown", "reports the error 110", marks=pytest.mark.thorough),
        ("mode", r"into mode 0 \(Heft needs 1"),
        pytest.param("paused", "was paused in UFACTORY Studio", marks=pytest.mark.thorough),
        ("stopped", "was stopped in UFACTORY Studio"),
        ("payload", r"from 0\.000 to 0\.500 kg.*nothing is recorded across it"),
        pytest.param("tool", "tool centre point", marks=pytest.mark.thorough),
        pytest.param("zeroed", "set the zero of the force/torque sensor", marks=pytest.mark.thorough),
        pytest.param("went off", "switched the force/torque sensor off", marks=pytest.mark.thorough),
    ],
)
def test_what_the_controller_or_somebody_else_does_ends_the_motion_with_a_reason(bench, what, says):
    with pytest.raises(ControllerStopped, match=says) as raised, bench.open() as session:
        move(session, bench.cell, seconds=0.2)
        bench.server.order(lambda: disturb(bench.arm, what))
        move(session, bench.cell, seconds=2.0)
    assert not raised.value.may_go_on
    Conformance.check_standing(bench)


@pytest.mark.parametrize(
    ("what", "says"),
    [
        ("emergency", "emergency stop"),
        ("off", "motors are off"),
        ("simulation", "simulation mode"),
        ("force control", "force control mode"),
    ],
)
def test_a_robot_that_cannot_be_moved_is_refused_before_anything_moves(bench, what, says):
    bench.server.order(lambda: disturb(bench.arm, what))
    before = bench.where()
    bench.settle()
    with pytest.raises(NotConnected, match=says) as raised, bench.open():
        pass
    assert bench.server.host in str(raised.value)
    assert bench.arm.mode == POSITION
    np.testing.assert_allclose(bench.where(), before, atol=1e-4)


@pytest.mark.parametrize(
    ("said", "arm", "says"),
    [
        ({"serial": "1"}, {}, "serial number XI130506D42L01.* expects 1;"),
        ({"firmware": "2.4"}, {}, r"version 2\.5\.5.* expects 2\.4;"),
        ({}, {"version": "v1.12.8"}, r"version 1\.12\.8; this driver knows 2\.1"),
        ({}, {"stretch": 0.012}, r"12\.0 mm \(limit 5\.0 mm\)"),
        ({}, {"type": 9}, "calls itself Lite6"),
        ({"model": "xArm6 type 8"}, {"type": 9}, "expects xArm6 type 8"),
        ({}, {"joint_speed": 1.0}, r"joint shoulder_pan: the controller allows 1\.00 rad/s"),
    ],
)
def test_another_robot_than_the_cells_is_refused_with_what_was_found(bench, said, arm, says):
    for name, value in arm.items():
        setattr(bench.arm, name, value)
    with pytest.raises(WrongRobot, match=says):
        bench.open(**said).find_start()


def test_joint_limits_that_are_narrower_than_the_cells_are_found_by_asking(bench):
    bench.arm.upper[2] = 2.5
    with pytest.raises(WrongRobot, match=r"joint elbow: the controller stops at 143\.\d+°, the URDF allows up to 180"):
        bench.open().find_start()


def test_joint_limits_of_the_reduced_mode_count(bench):
    bench.arm.lower, bench.arm.upper = bench.arm.lower * 1.0, bench.arm.upper * 1.0
    bench.open().find_start()
    bench.arm.reduced, bench.arm.is_beyond = True, lambda _: False
    bench.arm.lower[5] = -1.0
    with pytest.raises(WrongRobot, match="joint wrist_3: the controller stops at -57"):
        bench.open().find_start()


def test_swapped_joints_are_named(bench):
    with pytest.raises(WrongRobot, match="joints shoulder_lift and elbow swapped they agree"):
        bench.open(bench.swap_joints()).find_start()


def test_swapped_joints_that_stand_at_one_angle_are_named_before_anything_moves(bench):
    bench.arm.order[:] = [5, 1, 2, 3, 4, 0]  # both at zero: where the arm stands nothing shows
    before = bench.where()
    with pytest.raises(WrongRobot, match="joints shoulder_pan and wrist_3 swapped they agree"):
        bench.open().find_start()
    np.testing.assert_allclose(bench.where(), before, atol=1e-6)


def test_reports_at_another_rate_than_the_cell_says_are_told(bench):
    with pytest.raises(NotConnected, match=r"every 5\.0 ms, and session\.rate_hz says every 4\.0 ms"):
        bench.open(rate_hz=250).find_start()


def test_nobody_at_the_other_end_is_told_with_what_to_look_at():
    with pytest.raises(NotConnected, match=r"nobody answers at 127\.29\.0\.2"):
        XarmSession(cell_at("127.29.0.2")).find_start()


def test_a_controller_of_something_else_is_told(bench, monkeypatch):
    monkeypatch.setattr("core.fakes.xarm_protocol.XarmPeer._text", staticmethod(lambda _: b"no controller".ljust(40, b"\0")))
    with pytest.raises(NotConnected, match="a version that reads 'no controller'"):
        bench.open().find_start()


def test_no_period_passes_without_a_command(bench):
    with bench.open() as session:
        fall_into_step(session)
        before = session.missed
        states = move(session, bench.cell, seconds=1.0)
        followed, missed = bench.arm.periods_followed, bench.arm.missed
        assert session.missed == before
    np.testing.assert_allclose(np.diff([state.t for state in states]), session.period, atol=1e-6)
    assert followed >= 195 and missed == 0


def test_an_arm_of_seven_joints_without_a_sensor_of_its_own_moves_at_250_hz(monkeypatch):
    monkeypatch.setattr("core.sessions.xarm.LINK_S", 3.0)
    cell, host = load_cell(CELLS / "lwr4_bench"), "127.29.0.3"
    arm = XarmArm(cell, period=0.004)
    arm.joint_speed = 4.0
    with XarmServer(arm, host, port=PORT, patience_s=PATIENCE_S) as server:
        bench = XarmBench(server, cell)
        with bench.open(rate_hz=250, sensor={"driver": "ati_net_ft", "host": "127.0.0.1"}) as session:
            fall_into_step(session)
            states = move(session, cell, seconds=0.5)
            assert server.arm.missed == 0
        assert not server.arm.sensor_on
    assert np.abs(states[-1].q - states[0].q).min() > 1e-3
    np.testing.assert_allclose(np.diff([state.t for state in states]), 0.004, atol=1e-6)


def cut_for(bench, seconds):
    bench.server.cut = True
    time.sleep(seconds)
    bench.server.cut = False


def test_a_line_that_is_silent_for_a_while_is_waited_for_while_the_arm_stands(bench):
    with bench.open() as session:
        before, stamps = session.state().t, [time.monotonic()]
        threading.Thread(target=cut_for, args=(bench, 0.6)).start()
        for _ in range(200):
            after = session.state().t
            stamps.append(time.monotonic())
        move(session, bench.cell)
    assert after > before + 0.6
    assert np.diff(stamps).max() > 0.3


def test_a_moving_arm_that_was_sent_nothing_meanwhile_is_told_that_it_stood_and_does_not_leap(bench):
    with pytest.raises(ControllerStopped, match="was sent nothing for"), bench.open() as session:
        move(session, bench.cell)
        threading.Thread(target=cut_for, args=(bench, 0.6)).start()
        move(session, bench.cell, seconds=5.0)
    Conformance.check_standing(bench)


def test_commands_that_the_controller_does_not_take_do_not_pile_up_to_a_leap(bench, monkeypatch):
    def leave_unread(peer, data):
        peer._rest += data
        peer.served += 1
        return b""

    with bench.open() as session:
        move(session, bench.cell, seconds=0.3)
        with monkeypatch.context() as deaf:
            deaf.setattr(XarmPeer, "take", leave_unread)
            stood = bench.arm.target.copy()
            with pytest.raises(ControllerStopped, match="has not taken the last 9 commands"):
                move(session, bench.cell, seconds=2.0)
        for _ in range(60):  # it takes them now, all at once
            session.state()
    leap = bench.arm.flange(bench.arm.target)[0] - bench.arm.flange(stood)[0]
    assert np.linalg.norm(leap) < LEAP_M
    Conformance.check_standing(bench)


def test_it_is_left_out_of_servo_motion(bench):
    with bench.open() as session:
        move(session, bench.cell)
    assert bench.arm.mode == POSITION and not bench.arm.obeys


def test_a_sensor_with_the_other_sign_is_told_at_the_second_pose(bench):
    with pytest.raises(WrongSensor, match=r"as if the load had -2\.\d+ kg"), bench.open(wrench_acts_on="payload") as session:
        for _ in range(60):
            session.state()
        q = session.state().q_cmd
        for share in 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, 300)):
            session.state()
            session.command(q + 0.8 * share * np.eye(6)[3])
        for _ in range(80):
            session.state()
    Conformance.check_standing(bench)
