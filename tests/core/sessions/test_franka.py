"""The driver of Franka's arms against a server that speaks their interface, with the virtual robot behind it."""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.cell.session import FrankaRobot
from core.errors import BadCell, BadState, ControllerStopped, NotConnected, TooFast, WrongKinematics, WrongRobot
from core.fakes.franka_arm import IDLE, JOINT_REFLEX, POSITION_LIMIT, FrankaArm
from core.fakes.franka_server import FrankaServer
from core.sessions.external_sensor import ExternalSensorSession
from core.sessions.franka import FrankaSession
from tests.core.sessions.conformance import Conformance, move
from tests.core.sessions.datagram_bench import DatagramBench

BENCH = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
CELL = BENCH.model_copy(update={"robot": BENCH.robot.model_copy(update={"acceleration_rad_s2": (7.5,) * 7})})
CARRIED = CELL.payloads["steel_block"].parameters
PATIENCE_S = 1.0
SENSOR = {"driver": "ati_net_ft", "host": "127.0.0.1"}


class FrankaBench(DatagramBench):
    AWAY_S, SENSOR_HZ = 0.001, 2000.0

    def __init__(self, server: FrankaServer) -> None:
        super().__init__(server)
        self.said = {"driver": "franka_fci", "host": server.host, "model": self.arm.model, "sensor": SENSOR}

    @property
    def cell(self) -> Cell:
        return self.cell_with()

    def cell_with(self, **said) -> Cell:
        return CELL.model_copy(update={"session": FrankaRobot.model_validate(self.said | said)})

    def open(self, cell: Cell | None = None) -> ExternalSensorSession:
        sensor, clock = self.put_sensor()
        return ExternalSensorSession(FrankaSession(cell or self.cell), sensor, clock=clock)

    def alone(self, **said) -> FrankaSession:
        """Without a sensor, which costs a second of listening."""
        return FrankaSession(self.cell_with(**said))


@contextmanager
def serve(request, monkeypatch, version: int = 10) -> Iterator[FrankaBench]:
    monkeypatch.setattr("core.sessions.franka.LINK_S", 3.0)  # the computer that tests may be busy
    seed = abs(hash(request.node.nodeid))
    host = f"127.{30 + seed % 200}.{(seed >> 8) % 250}.{2 + (seed >> 16) % 250}"
    with FrankaServer(FrankaArm(CELL, CARRIED, seed=1, version=version), host, patience_s=PATIENCE_S) as server:
        yield FrankaBench(server)


@pytest.fixture
def bench(request, monkeypatch):
    with serve(request, monkeypatch) as bench:
        yield bench


class TestConformance(Conformance):
    @pytest.fixture
    def bench(self, bench):
        return bench


def disturb(bench, what):
    arm, server = bench.arm, bench.server
    {
        "reflex": lambda: arm.fail(JOINT_REFLEX),
        "limit": lambda: arm.fail(POSITION_LIMIT),
        "unknown": lambda: arm.fail(35),
        "user stop": arm.press_user_stop,
        "guided": arm.guide,
        "brakes": arm.close_brakes,
        "preempted": arm.stop_move,
        "load": lambda: arm.set_load(1.0, np.zeros(3), np.zeros(9)),
        "deaf": lambda: setattr(server, "deaf", True),
    }[what]()


@pytest.mark.parametrize(
    ("what", "says"),
    [
        ("reflex", r"a collision, or a load that it does not know \(joint_reflex\)"),
        pytest.param("limit", r"limit of its own \(joint_position_limits_violation\)", marks=pytest.mark.thorough),
        pytest.param("unknown", r"with a reflex \(instability_detected\)", marks=pytest.mark.thorough),
        ("user stop", "stop button or enabling device"),
        pytest.param("guided", "guides it by hand", marks=pytest.mark.thorough),
        pytest.param("brakes", "Unlock the joints in Desk", marks=pytest.mark.thorough),
        ("preempted", "stopped by somebody else"),
        ("load", r"changed from 0\.000 to 1\.000 kg"),
        ("deaf", r"had no command for 20 ms \(communication_constraints_violation\)"),
    ],
)
def test_what_the_controller_the_line_or_somebody_else_does_ends_the_motion_with_a_reason(bench, what, says):
    with pytest.raises(ControllerStopped, match=says) as raised, bench.alone() as session:
        move(session, bench.cell, seconds=0.2)
        bench.server.order(lambda: disturb(bench, what))
        move(session, bench.cell, seconds=3.0)
    assert not raised.value.may_go_on
    Conformance.check_standing(bench)
    if what in {"reflex", "deaf"}:
        with pytest.raises(NotConnected, match=r"cannot be moved as it is: .*[Cc]lear the error in Desk"):
            bench.alone().find_start()


def test_a_controller_that_obeys_is_left_at_rest_and_without_an_error(bench):
    with pytest.raises(KeyError), bench.alone() as session:
        move(session, bench.cell)
        raise KeyError
    assert bench.arm.mode == IDLE and not bench.arm.errors
    assert not bench.arm.moves


@pytest.mark.parametrize(("arm", "said", "error", "says"), [
    ({"mode": 5}, {}, NotConnected, "cannot be moved as it is: its stop button"),
    ({"mode": 3}, {}, NotConnected, "somebody guides it"),
    ({"mode": 2}, {}, NotConnected, "a motion runs on it"),
    ({"stretch": 0.012}, {}, WrongRobot, r"12\.0 mm \(limit 5\.0 mm\)"),
    ({"model": "tmrv0_2"}, {}, WrongRobot, "calls itself tmrv0_2"),
    ({}, {"firmware": "9"}, WrongRobot, "has version 10"),
    ({}, {"serial": "295341-1"}, WrongRobot, "has the serial number -"),
    ({"speed_limit": np.full(7, 1.0)}, {}, WrongRobot, r"allows 1\.00 rad/s"),
    ({"lower": np.full(7, -1.9)}, {}, WrongRobot, "joint joint1: the controller stops at -108"),
    ({"end_effector_kg": 50.0}, {}, WrongRobot, r"a payload of 50\.00 kg"),
])  # fmt: skip
def test_another_robot_or_one_that_cannot_be_moved_is_refused_and_nothing_is_moved(bench, monkeypatch, arm, said, error, says):
    for name, value in arm.items():
        setattr(bench.arm, name, value)
    session = bench.alone(**said)
    if "end_effector_kg" in arm:
        limited = session.cell.model_copy(update={"robot": session.cell.robot.model_copy(update={"payload_limit_kg": 3.0})})
        session = FrankaSession(limited)
    with pytest.raises(error, match=says):
        session.find_start()
    assert bench.arm.periods_followed == 0


def test_a_cell_that_accelerates_more_than_the_controller_allows_is_refused(bench):
    robot = CELL.robot.model_copy(update={"acceleration_rad_s2": (7.0, 10.5, 7.0, 7.0, 7.0, 7.0, 7.0)})
    with pytest.raises(WrongRobot, match=r"joint joint2: the controller allows 10\.0 rad/s², the cell 10\.5 rad/s²"):
        FrankaSession(bench.cell.model_copy(update={"robot": robot})).find_start()


def test_nobody_at_the_other_end_is_told_with_what_to_look_for(bench):
    with pytest.raises(NotConnected, match="Activate FCI"):
        bench.alone(host="127.29.0.2").find_start()


def test_a_second_client_is_told_that_there_may_be_another(bench):
    with bench.alone(), pytest.raises(NotConnected, match="no other program is connected"):
        bench.alone().find_start()


@pytest.mark.parametrize("version", [5, 6, 7, 8, 9])
def test_every_version_of_the_server_is_spoken_to_in_its_own(request, monkeypatch, version):
    with serve(request, monkeypatch, version) as bench, bench.alone(firmware=str(version)) as session:
        states = move(session, bench.cell, seconds=0.3)
        assert np.abs(states[-1].q_cmd - states[0].q_cmd).min() > 1e-3
    assert bench.arm.mode == IDLE and bench.arm.missed == 0


def test_a_server_that_is_older_or_newer_is_refused_with_its_version(bench):
    bench.arm.version = 4
    with pytest.raises(WrongRobot, match="has version 4; this driver knows server versions 5 to 10"):
        bench.alone().find_start()


def test_a_safety_function_and_other_refusals_are_told(bench, monkeypatch):
    for outcome, says in (("rejected_by_safety", "Watchman in Desk"), ("not_possible", "in its present mode"), ("singular", "singular")):
        monkeypatch.setattr("core.fakes.franka_server.read_move", lambda *_, outcome=outcome: outcome)
        numbers = {"invalid_argument": {"rejected_by_safety": 4, "not_possible": 5, "singular": 6}[outcome], "started": 1}
        monkeypatch.setattr("core.fakes.franka_server.answers_to_move", lambda _, numbers=numbers: numbers)
        with pytest.raises(NotConnected, match=says), bench.alone():
            pass
    assert bench.arm.periods_followed == 0


def test_swapped_joints_that_stand_at_one_angle_stop_within_the_first_degree(bench):
    bench.arm.order[:] = [2, 1, 0, 3, 4, 5, 6]  # both at zero: where the arm stands nothing shows; their limits are alike
    begin = bench.where()
    slow = bench.cell.robot.model_copy(update={"velocity_rad_s": (1.5,) * 7})
    with (
        pytest.raises(WrongKinematics, match=r"joints .* and .* swapped it agrees"),
        FrankaSession(bench.cell.model_copy(update={"robot": slow})) as session,
    ):
        q = session.state().q_cmd
        for k in range(1000):
            q = q + session.period * 0.1 * min(1.0, k / 200) * np.eye(7)[0]
            session.command(q)
            session.state()
    Conformance.check_standing(bench)
    assert np.degrees(np.abs(bench.where() - begin)).max() < 1.5


def test_an_arm_without_a_sensor_is_refused_with_what_is_possible(bench):
    with pytest.raises(BadCell, match="heft identify LOADED --without EMPTY"):
        bench.alone(sensor=None)


@pytest.mark.parametrize(("step", "says"), [
    (lambda k: 1e-6 * k**2 * (k > 3), r"rad/s² commanded"),
    (lambda k: 6e-6 * min(k, 4) * k, "jerk"),
])  # fmt: skip
def test_a_path_that_the_controller_would_refuse_is_not_sent_and_the_robot_brakes(bench, step, says):
    with bench.alone() as session:
        begin = session.state().q_cmd
        with pytest.raises(TooFast, match=says):
            for k in range(60):
                session.command(begin + step(k))
                session.state()
        with pytest.raises(BadState):
            session.command(begin)
        [session.state() for _ in range(300)]
        assert not bench.arm.errors and bench.arm.mode == IDLE and not bench.arm.moves


def test_commands_that_get_lost_on_the_way_are_made_up_for_without_a_jump(bench):
    with bench.alone() as session:
        move(session, bench.cell, seconds=0.3)
        bench.server.loss = 0.03
        states = move(session, bench.cell, seconds=1.0)
        bench.server.loss = 0.0
        states += [session.state() for _ in range(600)]
        lost, missed = session.lost, session.missed
    assert lost > 10 and missed > 5
    assert not bench.arm.errors and bench.arm.mode == IDLE
    np.testing.assert_allclose(bench.where(), states[-1].q_cmd, atol=2e-3)


def test_a_line_on_which_most_commands_come_too_late_ends_the_motion_or_never_begins_it(bench):
    bench.server.jitter_s = 0.02
    bench.server.patience_s = 0.001
    with pytest.raises(ControllerStopped, match=r"too late|no smooth way back|had no command"), bench.alone() as session:
        move(session, bench.cell, seconds=3.0)
    bench.server.jitter_s = 0.0
    Conformance.check_standing(bench)


def test_a_robot_that_stands_is_kept_while_nobody_asks_in_its_motion_and_after_a_stop_without_one(bench):
    with bench.alone() as session:
        target = move(session, bench.cell)[-1].q_cmd
        session.stop()
        [session.state() for _ in range(300)]
        bench.server.patience_s = 0.4  # after which the clock goes on, and twenty periods without a command end a motion
        time.sleep(1.5)
        assert bench.arm.mode == IDLE
        session.release()
        session.command(session.state().q_cmd)  # with its first command the motion begins
        time.sleep(1.5)
        stands = session.state().q_cmd
        assert np.abs(stands - target).max() < 0.1
        assert bench.arm.obeys and not bench.arm.errors
        bench.server.patience_s = PATIENCE_S
        assert np.abs(move(session, bench.cell)[-1].q_cmd - stands).min() > 1e-3


def test_no_cycle_passes_without_a_command_and_torques_and_speeds_are_the_arms(bench):
    with bench.alone() as session:
        states = move(session, bench.cell, seconds=1.0)
        followed, missed, last = bench.arm.periods_followed, bench.arm.missed, bench.arm.samples[-1]
        remarks = {each.code: each.parameters for each in session.remarks()}
    assert followed >= 990 and missed == 0 and session.missed == 0 and session.lost == 0
    np.testing.assert_allclose(states[-1].q, last.q, atol=1e-6)
    np.testing.assert_allclose(states[-1].dq, last.dq, atol=1e-6)
    np.testing.assert_allclose(states[-1].tau, last.tau, rtol=1e-5, atol=1e-5)
    assert np.isnan(states[-1].wrench).all() and not states[-1].wrench_measured
    assert remarks["franka-external"]["force"] == 0.0 and remarks["franka-counted"]["lost"] == 0


def test_the_wrench_of_the_sensor_on_its_own_line_is_that_of_the_virtual_robot(bench):
    with bench.open() as session:
        states = [session.state() for _ in range(50)]
    force = np.mean([state.wrench for state in states], axis=0) - bench.arm._robot.truth.offset
    expected = -CARRIED.mass * session.inner._robot.sensor_pose(states[-1].q).rotation.T @ CELL.gravity
    np.testing.assert_allclose(force[:3], expected, atol=0.1)
    np.testing.assert_allclose(force[3:], np.cross(CARRIED.com, expected), atol=0.02)


def test_commands_that_come_too_late_too_often_end_the_motion_with_that_as_the_reason(bench):
    """A controller that has lost a command and is 0.2 rad away: from there no smooth way leads back."""

    def lose() -> None:
        bench.arm.target, bench.arm._order = bench.arm.target + 0.2, None

    with bench.alone() as session:
        states = move(session, bench.cell, seconds=0.3)
        ahead = session._sent
        bench.server.order(lose)
        with pytest.raises(ControllerStopped, match="no smooth way back"):
            for k in range(5000):
                session.command(states[-1].q_cmd + (k + 1) * session.period * ahead.dq)
                session.state()
    assert session.lost >= 1
