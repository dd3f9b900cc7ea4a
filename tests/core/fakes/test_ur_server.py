"""The stand-in of a Universal Robots controller, asked by hand and, where it is installed, by the package `ur_rtde`, which others wrote."""

import json
import socket
import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.fakes.ur_arm import UrArm
from core.fakes.ur_server import UrServer
from tests.loopback import HOST

CELL = load_cell(Path(__file__).parents[3] / "cells" / "ur5e_line")


@pytest.fixture
def server():
    with UrServer(UrArm(CELL, CELL.payloads["steel_block"].parameters, seed=2), HOST) as server:
        yield server


def ask(line, kind, body):
    line.sendall(struct.pack(">HB", 3 + len(body), ord(kind)) + body)
    size, answered = struct.unpack(">HB", line.recv(3, socket.MSG_WAITALL))
    assert chr(answered) == kind
    return line.recv(size - 3, socket.MSG_WAITALL)


def test_the_steps_of_the_protocol_are_answered_as_its_description_has_them(server):
    with socket.create_connection((HOST, 30004), timeout=20.0) as line:
        assert ask(line, "V", struct.pack(">H", 1)) == b"\x00"
        assert ask(line, "V", struct.pack(">H", 2)) == b"\x01"
        assert struct.unpack(">4I", ask(line, "v", b"")) == server.arm.version
        assert ask(line, "O", struct.pack(">d", 125.0) + b"timestamp,no_such_output")[1:] == b"DOUBLE,NOT_FOUND"
        assert ask(line, "O", struct.pack(">d", 125.0) + b"timestamp,actual_q,runtime_state")[1:] == b"DOUBLE,VECTOR6D,UINT32"
        assert ask(line, "I", b"input_int_register_30")[1:] == b"INT32"
        assert ask(line, "S", b"") == b"\x01"
        stamps = []
        for _ in range(5):
            size, kind = struct.unpack(">HB", line.recv(3, socket.MSG_WAITALL))
            assert (size, kind) == (3 + 1 + 8 + 48 + 4, ord("U"))
            stamp, *q, state = struct.unpack(">7dI", line.recv(size - 3, socket.MSG_WAITALL)[1:])
            stamps.append(stamp)
            np.testing.assert_allclose(q, CELL.robot.home_rad, atol=1e-3)
            assert state == 1
        np.testing.assert_allclose(np.diff(stamps), 0.008, atol=1e-9)


FOREIGN = """
import json, sys
from dashboard_client import DashboardClient
from rtde_receive import RTDEReceiveInterface
dashboard = DashboardClient(sys.argv[1])
dashboard.connect()
remote = dashboard.isInRemoteControl()
dashboard.disconnect()
names = ["timestamp", "actual_q", "actual_TCP_pose", "ft_raw_wrench", "robot_mode", "safety_mode"]
robot = RTDEReceiveInterface(sys.argv[1], 500.0, names)
found = [remote, robot.getRobotMode(), robot.getSafetyMode(), robot.getActualQ(), robot.getActualTCPPose(), robot.getFtRawWrench()]
print(json.dumps(found))
robot.disconnect()
"""
"""In a process of its own: its constructor keeps the interpreter for itself while it waits for our answer."""


def test_the_package_that_others_wrote_reads_the_same_robot(server):
    run = subprocess.run([sys.executable, "-c", FOREIGN, HOST], capture_output=True, text=True, timeout=120, check=True)
    remote, mode, safety, q, pose, wrench = json.loads(run.stdout.strip().splitlines()[-1])
    assert (remote, mode, safety) == (True, 7, 1)
    np.testing.assert_allclose(q, CELL.robot.home_rad, atol=1e-3)
    np.testing.assert_allclose(pose, server.arm.report()["actual_TCP_pose"], atol=1e-3)
    np.testing.assert_allclose(wrench, server.arm.report()["ft_raw_wrench"], atol=0.5)
