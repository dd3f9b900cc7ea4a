"""Wrench and joints of two clocks: what a state calls measured is the wrench of its own moment; the rest is held and not recorded."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.array import Array
from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.errors import NotConnected, SensorFault, SensorLate, UnusableSensor
from core.robot.model import RobotModel
from core.sensors.sensor import Reading
from core.sessions.external_sensor import ExternalSensorSession
from core.sessions.sample_log import SampleLog
from core.sessions.session import RobotState
from core.sessions.simulated import SimulatedSession
from core.words.message import Message
from tests.core.sessions.conformance import Bench, Conformance
from tests.core.sessions.lockstep import LockstepRobot, LockstepSensor, TrueTime

CELL = load_cell(Path(__file__).parents[3] / "cells" / "ur5e_line")
SLOPE = np.array([10.0, -20.0, 5.0, 1.0, 0.5, -0.25])
"""Of the wrench, N/s and N m/s: a wrench that is late by 1 ms is wrong by a thousandth of this."""


class PlantTime(TrueTime):
    """A virtual robot's own time, a moment later, as far as nobody has waited for longer."""

    def __init__(self, session: SimulatedSession) -> None:
        self._session, self._waited = session, 0.0

    @property
    def now(self) -> float:
        try:
            t = self._session.plant.truth.t
        except RuntimeError:  # before its first step
            t = 0.0
        return max(self._waited, 1000.0 + t + 1e-4)

    @now.setter
    def now(self, value: float) -> None:
        self._waited = value


class SensedBench(Bench):
    """The virtual robot, its wrench from a sensor beside it."""

    linked = False
    cell = CELL

    def open(self, cell: Cell | None = None) -> ExternalSensorSession:
        self._robot = SimulatedSession(cell or self.cell, CELL.payloads["steel_block"].parameters, seed=1)
        time = PlantTime(self._robot)
        sensor = LockstepSensor(time, ramp, rate_hz=4000.0, offset_s=77.0, drift=-50e-6, jitter_s=0.0002)
        return ExternalSensorSession(self._robot, sensor, clock=time)

    def where(self) -> Array:
        return self._robot.plant.truth.q


class TestConformance(Conformance):
    @pytest.fixture
    def bench(self) -> SensedBench:
        return SensedBench()


def ramp(true_s: float) -> Array:
    return SLOPE * (true_s - 1000.0)


def put_together(**line: object) -> tuple[ExternalSensorSession, LockstepRobot, LockstepSensor]:
    time = TrueTime()
    robot = LockstepRobot(time, offset_s=12.5, drift=-30e-6, jitter_s=0.0002)
    sensor = LockstepSensor(time, ramp, **{"offset_s": -5000.0, "drift": 40e-6, "jitter_s": 0.0002, **line})
    return ExternalSensorSession(robot, sensor, clock=time), robot, sensor


def lateness_s(robot: LockstepRobot, state: RobotState) -> float:
    """How long before the state's moment its wrench was, by each channel; they agree."""
    late = (robot.true(state.t) - 1000.0) - (-state.wrench / SLOPE)
    np.testing.assert_allclose(late, late[0], atol=1e-9)
    return float(late[0])


def test_wrenches_are_of_the_moment_of_the_joints_and_in_the_sign_of_what_the_sensor_exerts():
    session, robot, _ = put_together(lost=0.05)
    with session:
        states = [session.state() for _ in range(5000)]
    measured = [state for state in states[2500:] if state.wrench_measured]
    assert len(measured) > 0.9 * 2500
    assert max(abs(lateness_s(robot, state)) for state in measured) < 0.5e-3
    assert all(state.wrench[0] < 0.0 for state in measured)


@pytest.mark.parametrize("seed", range(3))
def test_with_jitter_the_clocks_are_found_and_a_wrench_that_is_not_there_yet_is_not_called_measured(seed: int):
    session, robot, _ = put_together(jitter_s=0.02, lost=0.05, seed=seed)
    with session:
        late, held = [], 0
        for _ in range(5000):
            try:
                state = session.state()
            except SensorLate:
                continue
            held += not state.wrench_measured
            if state.wrench_measured:
                late.append(lateness_s(robot, state))
        assert max(map(abs, late[len(late) // 2 :])) < 0.5e-3
        assert held > 100
        assert session.to_sensor(state.t) == pytest.approx(session.sensor.shown(robot.true(state.t)), abs=0.5e-3)


def test_a_wrench_that_came_later_is_recorded_beside_its_moment_and_what_never_came_is_not():
    session, robot, _ = put_together(jitter_s=0.015, silent=lambda true_s: 1003.0 < true_s < 1003.015)
    log = SampleLog(CELL, RobotModel.of_cell(CELL), payload=None, reference=None, complete=session.complete)
    taken = []
    with session:
        for _ in range(3000):
            taken += log.extend([session.state()], "transfer")
    log.recording()
    at_once = sum(state.wrench_measured for state in taken)
    assert 0 < len(taken) - at_once < 40 and len(log) > 2900
    assert all(abs(lateness_s(robot, state)) < 0.5e-3 for state in log.states[500:])
    assert not any(1003.0015 < robot.true(state.t) < 1003.0145 for state in log.states)
    assert (np.diff([state.t for state in log.states]) > 0.0).all()


def test_a_sensor_that_stops_stops_the_robot_within_the_guards_milliseconds_and_says_so():
    session, robot, sensor = put_together(silent=lambda true_s: true_s > 1003.0)
    with session:
        with pytest.raises(SensorLate, match=r"has sent nothing for 2\d ms \(limit 20 ms\)"):
            while True:
                session.state()
        assert robot.stopped == 1
        assert robot.taken_at - 1003.0 < 0.025
    assert (robot.entered, sensor.entered) == (0, 0)


def test_through_an_outage_the_last_wrench_is_held_and_not_called_measured():
    session, robot, _ = put_together(silent=lambda true_s: 1003.0 < true_s < 1003.015)
    with session:
        states = [session.state() for _ in range(2000)]
    inside = [state for state in states if 1003.0015 < robot.true(state.t) < 1003.0145]
    assert len(inside) >= 5 and not any(state.wrench_measured for state in inside)
    assert all(abs(lateness_s(robot, state)) < 0.5e-3 for state in states[500:] if state.wrench_measured)
    assert sum(state.wrench_measured for state in states) > 1950


def test_a_reading_that_the_sensor_calls_none_stops_the_robot():
    fault = Message.of("sensors-fault-saturated", status="0x80020000")

    def saturate(reading: Reading, true_s: float) -> Reading:
        return replace(reading, fault=fault) if true_s > 1002.5 else reading

    session, robot, _ = put_together(change=saturate)
    with session:
        with pytest.raises(SensorFault, match="sensor is saturated"):
            while True:
                session.state()
        assert robot.stopped == 1


def test_a_sensor_that_sends_too_little_to_tell_its_clock_is_refused_and_both_are_let_go():
    session, robot, sensor = put_together(silent=lambda _: True)
    with pytest.raises(NotConnected, match="sent 0 samples within 5 s"):
        session.__enter__()
    assert (robot.entered, sensor.entered) == (0, 0)


def test_a_sensor_that_is_saturated_before_the_guard_stops_the_robot_is_refused():
    time = TrueTime()
    robot, sensor = LockstepRobot(time, offset_s=0.0, drift=0.0, jitter_s=0.0), LockstepSensor(time, ramp)
    sensor.range = np.array([145.0, 145.0, 290.0, 5.0, 5.0, 5.0])
    session = ExternalSensorSession(robot, sensor, range_=np.array([145.0, 145.0, 400.0, 5.0, 5.0, 5.0]), clock=time)
    with pytest.raises(UnusableSensor, match=r"measures fz up to 290\.0 N, the cell's sensor\.range says 400\.0"):
        session.__enter__()
    assert (robot.entered, sensor.entered) == (0, 0)


def test_a_slow_sensor_gives_every_state_a_wrench_between_its_readings_or_says_that_it_is_held():
    session, robot, _ = put_together(rate_hz=100.0)
    with session:
        states = [session.state() for _ in range(3000)]
    measured = [state for state in states[1000:] if state.wrench_measured]
    assert all(abs(lateness_s(robot, state)) < 0.5e-3 for state in measured)
    assert measured
    assert "Set its rate to 1000 Hz" in session.remarks()[-1].text


def test_the_person_is_told_what_was_lost_and_how_the_clocks_go():
    session, _, _ = put_together(lost=0.05)
    with session:
        for _ in range(5000):
            session.state()
        counted, clocks = session.remarks()
    assert counted.parameters["lost"] > 100
    assert clocks.parameters["drift_ppm"] == pytest.approx(70.0, abs=30.0)
    assert "ppm" in clocks.text
