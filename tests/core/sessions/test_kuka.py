"""The driver of KUKA arms against a server that speaks their interface, with the virtual robot behind it."""

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import count
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.cell.session import KukaRobot
from core.errors import BadCell, ControllerStopped, MissingPackage, NotConnected, WrongKinematics, WrongRobot
from core.fakes.fri_arm import COMMANDING_ACTIVE, FriArm
from core.fakes.fri_server import FriServer
from core.sessions.external_sensor import ExternalSensorSession
from core.sessions.kuka import KukaSession
from tests.core.sessions.conformance import Conformance, move
from tests.core.sessions.datagram_bench import DatagramBench

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
CARRIED = CELL.payloads["steel_block"].parameters
PATIENCE_S = 1.0
SENSOR = {"driver": "ati_net_ft", "host": "127.0.0.1"}
PAD_RAD = np.array([0.3, -0.5, 0.7, 1.2, -0.9, 0.6, 1.5])
PORTS = count(31000)


def read_pad(arm: FriArm) -> dict:
    """What the smartPAD of this arm would show at one pose, axes in its own order."""
    position, rotation = arm.flange(PAD_RAD)
    abc = Rotation.from_matrix(rotation).as_euler("ZYX", degrees=True)
    return {"q_deg": np.degrees(PAD_RAD[arm.order]).tolist(), "xyz_mm": (1e3 * position).tolist(), "abc_deg": abc.tolist()}


class KukaBench(DatagramBench):
    AWAY_S, SENSOR_HZ = 0.01, 1000.0

    def __init__(self, server: FriServer, listen: str, port: int) -> None:
        super().__init__(server)
        self.said = {"driver": "kuka_fri", "host": server.host, "listen": listen, "port": port, "send_period_ms": 5, "sensor": SENSOR}
        if self.arm.version == 1:
            self.said["pad"] = read_pad(self.arm)

    @property
    def cell(self) -> Cell:
        return self.cell_with()

    def cell_with(self, **said) -> Cell:
        return CELL.model_copy(update={"session": KukaRobot.model_validate(self.said | said)})

    def open(self, cell: Cell | None = None) -> ExternalSensorSession:
        sensor, clock = self.put_sensor()
        return ExternalSensorSession(KukaSession(cell or self.cell), sensor, clock=clock)

    def alone(self, **said) -> KukaSession:
        """Without a sensor, which costs a second of listening."""
        return KukaSession(self.cell_with(**said))

    def swap_joints(self) -> Cell:
        super().swap_joints()
        if "pad" in self.said:
            self.said["pad"] = read_pad(self.arm)
        return self.cell


@contextmanager
def serve(request, monkeypatch, version: int) -> Iterator[KukaBench]:
    monkeypatch.setattr("core.sessions.kuka.LINK_S", 3.0)  # the computer that tests may be busy
    seed = abs(hash(request.node.nodeid))
    host, port = f"127.{30 + seed % 200}.{(seed >> 8) % 250}.{2 + (seed >> 16) % 250}", next(PORTS)
    with FriServer(
        FriArm(CELL, CARRIED, seed=1, period_ms=5, version=version), host, client=host, port=port, patience_s=PATIENCE_S
    ) as server:
        yield KukaBench(server, host, port)


@pytest.fixture
def bench(request, monkeypatch):
    with serve(request, monkeypatch, version=2) as bench:
        yield bench


class TestConformance(Conformance):
    """With FRI 1, which says where the arm is commanded to be before anybody commands it, and whose flange is read off the smartPAD."""

    @pytest.fixture
    def bench(self, request, monkeypatch):
        with serve(request, monkeypatch, version=1) as bench:
            yield bench

    def test_another_model_is_refused_with_what_was_found_and_expected(self, bench):
        """The interface names no model: another arm shows by a flange that is elsewhere."""
        bench.arm.stretch = 0.012
        bench.said["pad"] = read_pad(bench.arm)
        before = bench.where()
        for refuse in (lambda session: session.find_start(), lambda session: session.__enter__()):
            with pytest.raises(WrongRobot, match=r"12\.0 mm \(limit 5\.0 mm\)"):
                refuse(bench.alone())
        np.testing.assert_allclose(bench.where(), before, atol=1e-6)


def disturb(bench, what):
    arm, server = bench.arm, bench.server
    {
        "stop 0": lambda: arm.stop_safely(1),
        "stop 1": lambda: arm.stop_safely(2),
        "stop 2": lambda: arm.stop_safely(3),
        "motion ended": arm.end_motion,
        "closed": arm.close,
        "mode": lambda: setattr(arm, "operation", 0),
        "drive": lambda: setattr(arm, "drives_off", 3),
        "control": lambda: setattr(arm, "control", 2),
        "deaf": lambda: setattr(server, "deaf", True),
        "poor": lambda: setattr(server, "loss", 0.3),
        "vanished": lambda: setattr(server, "cut", True),
    }[what]()


@pytest.mark.parametrize(
    ("what", "says"),
    [
        pytest.param("stop 0", "safety controller has stopped the robot at once", marks=pytest.mark.thorough),
        ("stop 1", "stopped the robot on its path"),
        pytest.param("stop 2", "asks for a standstill", marks=pytest.mark.thorough),
        ("motion ended", r"session state 2, 4 needed.*paused or stopped"),
        pytest.param("closed", "has closed the session", marks=pytest.mark.thorough),
        pytest.param("mode", r"mode of operation \(T1", marks=pytest.mark.thorough),
        ("drive", r"axis A1 is off.*state 0, 2 needed"),
        pytest.param("control", "to 2; Heft needs 0", marks=pytest.mark.thorough),
        ("deaf", r"quality 0 of 3, 2 needed|had no command"),
        pytest.param("poor", r"quality [01] of 3, 2 needed", marks=pytest.mark.thorough),
    ],
)
def test_what_the_controller_the_line_or_somebody_else_does_ends_the_motion_with_a_reason(bench, what, says):
    with pytest.raises(ControllerStopped, match=says) as raised, bench.alone() as session:
        move(session, bench.cell, seconds=0.2)
        bench.server.order(lambda: disturb(bench, what))
        move(session, bench.cell, seconds=3.0)
    assert not raised.value.may_go_on
    Conformance.check_standing(bench)


@pytest.mark.parametrize(("said", "arm", "error", "says"), [
    ({}, {"safety": 1}, NotConnected, "cannot be moved as it is: the safety controller"),
    ({}, {"period_ms": 4}, NotConnected, "sends every 4 ms, and session.send_period_ms says every 5 ms"),
    ({}, {"multiplier": 2}, NotConnected, "every 2th message"),
    ({}, {"stretch": 0.012}, WrongRobot, r"12\.0 mm \(limit 5\.0 mm\)"),
    ({"tool": {"xyz_m": [0.0, 0.0, 0.1]}}, {}, WrongRobot, r"100\.0 mm"),
])  # fmt: skip
def test_another_robot_or_one_that_cannot_be_moved_is_refused_and_nothing_is_answered(bench, said, arm, error, says):
    for name, value in arm.items():
        setattr(bench.arm, name, value)
    with pytest.raises(error, match=says):
        bench.alone(**said).find_start()
    assert bench.arm._reflected == 0 and bench.arm.session == 1


def test_t1_is_refused_where_the_cell_is_faster_than_t1_allows(bench):
    bench.arm.operation = 0
    fast = bench.cell.model_copy(update={"limits": CELL.limits.model_copy(update={"cartesian_speed_m_s": 0.4})})
    with pytest.raises(NotConnected, match=r"no point may be faster than 0\.25 m/s, and the cell allows 0\.40 m/s"):
        KukaSession(fast).find_start()
    bench.alone().find_start()


@pytest.mark.parametrize(
    ("arm", "says"),
    [
        ({"application": False}, "has begun no motion that Heft could lead"),
        ({"command_mode": 3}, r"takes no joint positions \(command mode 3"),
        ({"overlay": 2}, "overlay 2"),
        ({"control": 1}, "another control mode"),
    ],
)
def test_a_motion_that_heft_cannot_lead_is_not_begun(bench, monkeypatch, arm, says):
    monkeypatch.setattr("core.sessions.kuka.BEGIN_S", 1.0)
    for name, value in arm.items():
        setattr(bench.arm, name, value)
    before = bench.where()
    with pytest.raises(NotConnected, match=says), bench.alone():
        pass
    assert bench.arm.periods_followed == 0
    np.testing.assert_allclose(bench.where(), before, atol=1e-4)


def test_a_line_that_stays_poor_is_told(bench, monkeypatch):
    monkeypatch.setattr("core.sessions.kuka.BEGIN_S", 0.5)
    bench.server.deaf = True
    with pytest.raises(NotConnected, match="quality 0 of 3, 2 needed"), bench.alone():
        pass


def test_nobody_at_the_other_end_is_told_with_who_else_sends(bench, monkeypatch):
    monkeypatch.setattr("core.sessions.kuka.FIRST_S", 2.0)
    with pytest.raises(NotConnected, match=rf"from the robot at 127\.29\.0\.2 .*but some from {bench.server.host}"):
        bench.alone(host="127.29.0.2").find_start()
    with pytest.raises(NotConnected, match=r"within 2 s; nothing has moved"):
        bench.alone(port=next(PORTS)).find_start()


def test_a_port_that_another_program_has_is_told(bench):
    with bench.alone(), pytest.raises(NotConnected, match="another program has this port"):
        bench.alone().find_start()


@pytest.mark.parametrize("told", [b"\x08\x01", b"no message at all", b""])
def test_messages_of_something_else_are_told(bench, monkeypatch, told):
    monkeypatch.setattr(bench.arm, "message", lambda: told)
    with pytest.raises(NotConnected, match=r"FRI is 1\.11 to 2\.7"):
        bench.alone().find_start()


def test_swapped_joints_that_stand_at_one_angle_stop_within_the_first_degree(bench):
    bench.arm.order[:] = [2, 1, 0, 3, 4, 5, 6]  # both at zero: where the arm stands nothing shows
    begin = bench.where()
    with pytest.raises(WrongKinematics, match=r"joints .* and .* swapped it agrees"), bench.alone() as session:
        q = session.state().q_cmd
        for k in range(200):
            q = q + session.period * 0.1 * min(1.0, k / 40) * np.eye(7)[0]
            session.command(q)
            session.state()
    Conformance.check_standing(bench)
    assert np.degrees(np.abs(bench.where() - begin)).max() < 1.5


@pytest.mark.parametrize(
    ("q", "says"),
    [([20.0, -30.0, 0.0, 70.0, -50.0, 35.0, 85.0], "axis a3|axis .* turned round"), ([20.0, -30.0, 40.0, 70.0, -50.0, 35.0, 85.0], None)],
)
def test_a_pose_of_the_pad_has_to_tell_the_joints_apart(bench, q, says):
    position, rotation = bench.arm.flange(np.radians(q))
    pad = {
        "q_deg": q,
        "xyz_mm": (1e3 * position).tolist(),
        "abc_deg": Rotation.from_matrix(rotation).as_euler("ZYX", degrees=True).tolist(),
    }
    session = bench.alone(pad=pad)
    if says is None:
        session.find_start()
        return
    with pytest.raises(BadCell, match=says):
        session.find_start()


def test_without_a_pose_of_its_own_the_pad_is_asked_for(bench):
    bench.arm.version = 1
    with pytest.raises(BadCell, match=r"session\.pad.*read axes and flange off the smartPAD"):
        bench.alone().find_start()


def test_an_arm_without_a_sensor_is_refused_with_what_is_possible(bench):
    with pytest.raises(BadCell, match="heft identify LOADED --without EMPTY"):
        bench.alone(sensor=None)


def test_without_its_package_the_driver_says_what_to_install(bench, monkeypatch):
    def missing(name):
        raise ImportError(name)

    monkeypatch.setattr("core.sessions.vendor.import_module", missing)
    with pytest.raises(MissingPackage, match=r'pip install "heft\[fri\]"'):
        bench.alone().find_start()


def test_where_it_begins_is_where_the_arm_stands_within_its_encoders_noise(bench):
    session = bench.alone()
    start = session.find_start()
    with session:
        assert np.abs(session.state().q_cmd - start).max() < 1e-3
    assert session.remarks()[0].parameters["missed"] == 0


def test_no_cycle_passes_without_a_command_and_torques_and_speeds_are_the_arms(bench):
    with bench.alone() as session:
        states = move(session, bench.cell, seconds=1.0)
        followed, missed, last = bench.arm.periods_followed, bench.arm.missed, bench.arm.samples[-1]
    assert followed >= 195 and missed == 0 and session.missed == 0
    np.testing.assert_allclose(states[-1].q, last.q)
    np.testing.assert_allclose(states[-1].tau, last.tau)
    assert np.isnan(states[-1].wrench).all() and not states[-1].wrench_measured
    np.testing.assert_allclose(np.mean([s.dq for s in states[-40:]], axis=0), 0.1 * np.array([1, -1, 1, -1, 1, -1, 1]), atol=5e-3)


def test_the_wrench_of_the_sensor_on_its_own_line_is_that_of_the_virtual_robot(bench):
    with bench.open() as session:
        states = [session.state() for _ in range(50)]
        assert [each.code for each in session.remarks()][:2] == ["kuka-counted", "kuka-external"]
    force = np.mean([state.wrench for state in states], axis=0) - bench.arm._robot.truth.offset
    expected = -CARRIED.mass * session.inner._robot.sensor_pose(states[-1].q).rotation.T @ CELL.gravity
    np.testing.assert_allclose(force[:3], expected, atol=0.1)
    np.testing.assert_allclose(force[3:], np.cross(CARRIED.com, expected), atol=0.02)


def test_the_controller_notices_that_heft_has_gone(bench):
    with bench.alone() as session:
        move(session, bench.cell)
        assert bench.arm.session == COMMANDING_ACTIVE
    bench.arm.application = False
    Conformance.check_standing(bench)
    assert not bench.arm.obeys
