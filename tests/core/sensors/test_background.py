"""A sensor that is read by a thread of its own, over a real line, beside a virtual robot that moves with its clock."""

from __future__ import annotations

import time
from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.errors import BadState
from core.fakes.ati_server import AtiServer, LossyLine
from core.payload.inertia import InertialParameters
from core.sensors.ati_net_ft import NetFt
from core.sensors.background import BackgroundSensor
from core.sessions.external_sensor import ExternalSensorSession
from core.sessions.pace import RealTime
from core.sessions.simulated import SimulatedSession

CELL = load_cell(Path(__file__).parents[3] / "cells" / "ur5e_line")


def background(server: AtiServer) -> BackgroundSensor:
    return BackgroundSensor(NetFt("127.0.0.1", rdt_port=server.rdt_port, http_port=server.http_port))


def test_nothing_is_lost_while_nobody_asks_and_arrivals_are_those_of_the_line():
    with AtiServer(lambda t: (t, 0, 0, 0, 0, 0)) as server, background(server) as sensor:
        time.sleep(1.0)
        readings = sensor.read()
        late = [reading.arrival_s - server.zero_s - reading.wrench[0] for reading in readings]
    assert len(readings) > 300
    assert np.median(late) < 0.3  # read when they came, not after the second


def test_what_stops_the_sensor_is_raised_after_what_it_had_read():
    with AtiServer(first_packet=100_000) as server, background(server) as sensor:
        while not sensor.read(0.1):
            pass
        server._first_packet = 0
        with pytest.raises(BadState, match="from the beginning"):
            while True:
                sensor.read(0.1)


def test_over_the_wire_the_wrench_stands_beside_the_joints_of_its_moment():
    """The box reports its true time as a force: each state tells of which moment its wrench is. The robot has its own clock."""
    robot = SimulatedSession(CELL, InertialParameters(np.zeros(10)), pace=RealTime())
    with AtiServer(lambda t: (-t, 0, 0, 0, 0, 0), line=LossyLine(lost=0.05), drift=80e-6) as server:
        session = ExternalSensorSession(robot, background(server))
        with session:
            ours: list[tuple[float, float]] = []
            for _ in range(30_000):  # a busy computer measures few of them
                try:
                    state = session.state()
                except BadState:  # this computer got no time
                    session.release()
                    continue
                if state.wrench_measured:
                    ours.append((state.t, float(state.wrench[0])))
                if len(ours) == 100:
                    break
        assert 1 not in {command for command, _ in server.commands}
    assert len(ours) > 30
    apart = np.array([t - moment for t, moment in ours])
    assert np.ptp(apart) < 0.1
    assert all(b > a for a, b in zip([w for _, w in ours], [w for _, w in ours][1:], strict=False))
