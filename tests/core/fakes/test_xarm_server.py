"""The stand-in of a UFACTORY controller, asked by hand and by the package `xarm-python-sdk`, which others wrote."""

import json
import socket
import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.cell.folder import load_cell
from core.fakes.xarm_arm import COLLISION, EMERGENCY, SERVO, XarmArm
from core.fakes.xarm_server import XarmServer
from tests.loopback import HOST

CELLS = Path(__file__).parents[3] / "cells"
CELL = load_cell(CELLS / "ur5e_line")
PORT = 5020


@pytest.fixture
def server():
    with XarmServer(XarmArm(CELL, CELL.payloads["steel_block"].parameters, seed=2), HOST, port=PORT) as server:
        yield server


def ask(line, register, body=b"", protocol=2):
    line.sendall(struct.pack(">3HB", 7, protocol, 1 + len(body), register) + body)
    transaction, same, length, answered, status = struct.unpack(">3HBB", line.recv(8, socket.MSG_WAITALL))
    assert (transaction, same, answered) == (7, protocol, register)
    return status, line.recv(length - 2, socket.MSG_WAITALL) if length > 2 else b""


def test_requests_are_answered_as_the_makers_description_has_them(server):
    with socket.create_connection((HOST, PORT), timeout=20.0) as line:
        status, version = ask(line, 1)
        assert status == 0x10, "a controller that was just switched on is stopped"
        assert version.rstrip(b"\0") == b"6,6,XI1305,AC1304,v2.5.5"
        assert len(version) == 40
        assert ask(line, 13) == (0x10, b"\x04")
        assert ask(line, 19, b"\x01\x00") == (0x10, b"")
        assert ask(line, 13) == (0x10, b"\x05"), "another mode resets the system"
        assert ask(line, 12, b"\x00") == (0, b"")
        assert ask(line, 13) == (0, b"\x02")
        q = struct.unpack("<7f", ask(line, 42)[1])
        np.testing.assert_allclose(q, [*CELL.robot.home_rad, 0.0], atol=1e-3)
        assert ask(line, 99) == (0x20, b"")
        assert ask(line, 15) == (0x20, b"\x00\x0d"), "no such command"
        assert ask(line, 17) == (0, b"")
        assert ask(line, 29, b"\x00" * 8, protocol=3) == (0x08, b""), "too short a command does nothing"
        home = struct.pack("<7f", *CELL.robot.home_rad, 0.0)
        assert ask(line, 45, home) == (0, b"\x00")
        assert ask(line, 45, struct.pack("<7f", 100.0, *CELL.robot.home_rad[1:], 0.0)) == (0, b"\x01")


def test_another_protocol_is_hung_up_on(server):
    with socket.create_connection((HOST, PORT), timeout=20.0) as line:
        line.sendall(struct.pack(">3H2B2H", 1, 0, 6, 1, 3, 0, 1))
        assert line.recv(8) == b""


def test_the_pose_is_told_as_angles_of_roll_pitch_and_yaw_and_as_a_rotation_vector(server):
    with socket.create_connection((HOST, PORT), timeout=20.0) as line:
        angles = struct.unpack("<6f", ask(line, 41)[1])
        vector = struct.unpack("<6f", ask(line, 91)[1])
        forward = struct.unpack("<6f", ask(line, 44, ask(line, 42)[1])[1])
    np.testing.assert_allclose(angles[:3], vector[:3], atol=0.1)
    np.testing.assert_allclose(forward, angles, atol=1e-2)
    roll, pitch, yaw = angles[3:]
    turns = [Rotation.from_rotvec([0, 0, yaw]), Rotation.from_rotvec([0, pitch, 0]), Rotation.from_rotvec([roll, 0, 0])]
    np.testing.assert_allclose((turns[0] * turns[1] * turns[2]).as_matrix(), Rotation.from_rotvec(vector[3:]).as_matrix(), atol=1e-3)


FOREIGN = """
import json, socket, sys, time
from xarm.core.config.x_config import XCONF
XCONF.SocketConf.TCP_CONTROL_PORT = int(sys.argv[2])
from xarm.wrapper import XArmAPI
from xarm.x3.report import ReportDataStructure

def read(port):
    with socket.create_connection((sys.argv[1], port), timeout=20.0) as line:
        size = int.from_bytes(line.recv(4, socket.MSG_PEEK | socket.MSG_WAITALL), "big")
        report = ReportDataStructure.create(port)
        report.update(line.recv(size, socket.MSG_WAITALL))
        return size, report

arm = XArmAPI(sys.argv[1], is_radian=True, check_joint_limit=False)
while arm.tcp_load[0] == 0.0:
    time.sleep(0.01)
told = {"axis": arm.axis, "given": arm.get_robot_sn()[1]}
told |= {"box": arm.control_box_sn, "version": list(arm.version_number), "load": arm.tcp_load}
told["codes"] = [arm.set_mode(1), arm.set_state(0), arm.set_ft_sensor_enable(1)]
told["error"], told["mode"] = arm.get_err_warn_code()[1], arm.set_ft_sensor_mode(0)
told["q"], told["pose"], told["vector"] = arm.get_servo_angle()[1], arm.get_position()[1], arm.get_position_aa()[1]
told["forward"], told["limit"] = arm.get_forward_kinematics(told["q"], True, True)[1], arm.is_joint_limit(told["q"], True)[1]
while arm.mode != 1:
    time.sleep(0.01)
aim = list(told["q"])
for _ in range(40):
    aim[5] += 0.0005
    told["servo"] = arm.set_servo_angle_j(aim, is_radian=True)
    time.sleep(0.005)
time.sleep(0.3)
told["aim"], told["gone"] = aim, arm.get_servo_angle()[1]
told["states"] = arm.get_joint_states(is_radian=True, num=2)[1]
told["raw"], told["zeroed"] = arm.get_ft_sensor_data(is_raw=True)[1], arm.set_ft_sensor_zero()
told["external"], told["config"] = arm.get_ft_sensor_data()[1], arm.get_ft_sensor_config()[1][:10]
told["set load"] = arm.set_tcp_load(1.25, [1.5, -2.5, 40.0])
size, fast = read(30000)
told["fast"] = [size, fast.state, fast.mode, fast.actual_joint_angle, fast.target_joint_angle, fast.actual_tcp_pose, fast.ft_raw_force]
size, rich = read(30002)
told["rich"] = [size, rich.robot_axis, rich.version, rich.tcp_payload, rich.tcp_offset, rich.ft_sensor_is_enable, rich.joint_max_speed,
    rich.reduced_joint_limits, rich.motor_enable_status, rich.is_simulation_robot, rich.ft_ext_force]
size, short = read(30003)
told["short"] = [size, short.actual_joint_angle, short.ft_raw_force]
size, normal = read(30001)
told["normal"] = [size, normal.tcp_payload]
told["stop"] = [arm.set_state(4), arm.get_state()[1]]
arm.disconnect()
print(json.dumps(told))
"""
"""In a process of its own: it prints as it likes, has threads that go on, and sets the default timeout of every socket."""


def test_the_package_that_others_wrote_reads_and_moves_the_same_robot(server):
    arm = server.arm
    server.order(lambda: setattr(arm, "payload", 0.5))
    arm.version = "v2.7.1"  # the package asks for raw forces from 2.6.109 on
    run = subprocess.run([sys.executable, "-c", FOREIGN, HOST, str(PORT)], capture_output=True, text=True, timeout=120, check=True)
    told = json.loads(run.stdout.strip().splitlines()[-1])
    assert (told["axis"], told["given"], told["box"], told["version"]) == (6, arm.serial, arm.box_serial, [2, 7, 1])
    assert told["load"] == [0.5, [0.0, 0.0, 0.0]]
    assert told["codes"] == [0, 0, 0]
    assert (told["error"], told["mode"], told["servo"], told["zeroed"], told["set load"]) == ([0, 0], 0, 0, 0, 0)
    np.testing.assert_allclose(told["q"], [*CELL.robot.home_rad, 0.0], atol=1e-3)
    np.testing.assert_allclose(told["forward"], told["pose"], atol=0.05)
    assert told["limit"] is False
    np.testing.assert_allclose(told["aim"][5] - told["q"][5], 0.02, atol=1e-6)
    np.testing.assert_allclose(told["gone"], told["aim"], atol=1e-3)
    np.testing.assert_allclose(told["states"][0], told["aim"], atol=1e-3)
    np.testing.assert_allclose(told["raw"], -arm.samples[-1].wrench, atol=1.0)
    np.testing.assert_allclose(told["external"], np.zeros(6), atol=1.0)
    np.testing.assert_allclose(np.array(told["config"][8]), told["raw"], atol=1.0)
    size, state, mode, q, target, pose, raw = told["fast"]
    assert (size, state, mode) == (784, 2, SERVO)
    np.testing.assert_allclose(q, told["gone"], atol=1e-3)
    np.testing.assert_allclose(target, told["aim"], atol=1e-6)
    np.testing.assert_allclose(raw, told["raw"], atol=1.0)
    at, turned = arm.flange(arm.samples[-1].q)
    np.testing.assert_allclose(pose[:3], 1e3 * (at + turned @ arm.tcp_offset[:3]), atol=1.0)
    tool = turned @ Rotation.from_euler("xyz", arm.tcp_offset[3:]).as_matrix()
    np.testing.assert_allclose(Rotation.from_rotvec(pose[3:]).as_matrix(), tool, atol=2e-3)
    size, axes, version, load, offset, on, speed, limits, motors, simulation, external = told["rich"]
    assert (size, axes, version, on, motors, simulation) == (587, 6, "v2.7.1", True, 0b111111, False)
    np.testing.assert_allclose(load, [1.25, 1.5, -2.5, 40.0], rtol=1e-6)
    np.testing.assert_allclose(offset, [0.0, 0.0, 100.0, 0.0, 0.3, 0.0], atol=1e-5)
    np.testing.assert_allclose(speed, np.pi, rtol=1e-6)
    np.testing.assert_allclose([low for low, _ in limits[:6]], arm.lower, rtol=1e-6)
    np.testing.assert_allclose(external, np.zeros(6), atol=1.0)
    size, q, raw = told["short"]
    assert size == 135
    np.testing.assert_allclose(q, told["gone"], atol=1e-3)
    np.testing.assert_allclose(raw, told["raw"], atol=1.0)
    assert told["normal"] == [145, load]
    assert told["stop"] == [0, 4]


def test_servo_commands_count_only_in_servo_mode_and_an_error_stops_what_moves():
    arm = XarmArm(CELL, seed=1)
    aim = np.array(CELL.robot.home_rad) + 0.5
    arm.servo(aim)
    arm.step()
    assert not arm.moves
    arm.set_mode(SERVO)
    arm.set_state(0)
    arm.servo(aim)
    for _ in range(5):
        arm.step()
    assert arm.moves
    assert (arm.state, arm.missed) == (1, 4)
    np.testing.assert_allclose(arm.target - CELL.robot.home_rad, 5 * 0.005 * np.pi, rtol=1e-9)
    arm.fail(COLLISION)
    for _ in range(150):
        arm.step()
    assert not arm.moves
    assert arm.state == 4
    arm.set_state(0)
    assert arm.state == 4, "an error has to be cleared first"
    arm.error = 0
    arm.set_state(0)
    assert arm.state == 2
    arm.fail(EMERGENCY)
    arm.error = 0
    arm.set_state(0)
    assert arm.state == 4, "after an emergency stop the motors are off"
    arm.enable(on=True)
    arm.set_state(0)
    assert arm.state == 2


def test_a_robot_of_seven_joints_moves_at_250_hz():
    cell = load_cell(CELLS / "lwr4_bench")
    arm = XarmArm(cell, period=0.004)
    arm.set_mode(SERVO)
    arm.set_state(0)
    for k in range(25):
        arm.servo(np.array(cell.robot.home_rad) + 0.001 * k)
        arm.step()
    assert (arm.periods_followed, arm.missed) == (25, 0)
    np.testing.assert_allclose(arm.t, 0.1)
    np.testing.assert_allclose(arm.q, np.array(cell.robot.home_rad) + 0.024, atol=5e-3)
