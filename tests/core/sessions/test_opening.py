"""Which session a cell has, and what a table `[session]` may say."""

from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.errors import BadCell, MissingPackage
from core.sensors.ati_net_ft import NetFt
from core.sensors.bota_serial import BotaSerial
from core.sensors.robotiq_ft300 import RobotiqFt300
from core.sessions.external_sensor import ExternalSensorSession
from core.sessions.opening import Simulation, is_simulated, open_robot_session
from core.sessions.simulated import SimulatedSession
from core.sessions.vendor import import_vendor

UR5E = Path(__file__).parents[3] / "cells" / "ur5e_line"


def cell_with(folder: Path, session: str):
    for name in ("cell.toml", "robot.urdf"):
        (folder / name).write_text((UR5E / name).read_text())
    with (folder / "cell.toml").open("a") as file:
        file.write(f"\n{session}\n")
    return load_cell(folder)


def test_a_cell_that_says_nothing_is_simulated():
    cell = load_cell(UR5E)
    assert is_simulated(cell)
    session = open_robot_session(cell, Simulation(None, seed=3))
    assert isinstance(session, SimulatedSession)
    np.testing.assert_array_equal(session.find_start(), cell.robot.home_rad)


def test_a_cell_names_its_robot_and_its_sensor(tmp_path):
    table = """[session]
driver = "ur_rtde"
host = "192.168.1.10"
model = "UR5e"
firmware = "5.17"
[session.sensor]
driver = "ati_net_ft"
host = "192.168.1.1"
"""
    cell = cell_with(tmp_path, table)
    assert not is_simulated(cell)
    assert (cell.session.host, cell.session.serial, cell.session.sensor.host) == ("192.168.1.10", None, "192.168.1.1")


UR = """[session]
driver = "ur_rtde"
host = "a"
model = "UR5e"
[session.sensor]
"""


@pytest.mark.parametrize(
    ("sensor", "kind"),
    [
        ('driver = "ati_net_ft"\nhost = "b"\ncalibration = "FT27462"\nsign = 1', NetFt),
        ('driver = "bota_serial"\nport = "/dev/ttyUSB0"', BotaSerial),
        ('driver = "robotiq_ft300"\nport = "/dev/serial/by-id/usb-FTDI"', RobotiqFt300),
    ],
)
def test_a_sensor_on_a_line_of_its_own_is_put_on_whatever_robot_the_cell_names(tmp_path, monkeypatch, sensor, kind):
    robot = open_robot_session(load_cell(UR5E), Simulation(None))
    monkeypatch.setattr("core.sessions.opening.DRIVERS", {"ur_rtde": lambda _: robot})
    session = open_robot_session(cell_with(tmp_path, UR + sensor), Simulation(None))
    assert isinstance(session, ExternalSensorSession)
    assert session.inner is robot
    assert isinstance(session.sensor.inner, kind)
    np.testing.assert_array_equal(session.find_start(), robot.find_start())


@pytest.mark.parametrize(
    ("table", "key", "found"),
    [
        ('[session]\ndriver = "urx"\nhost = "a"\nmodel = "UR5e"', "session.driver", "'urx', expected one of simulated, ur_rtde"),
        ('[session]\nhost = "a"\nmodel = "UR5e"', "session.driver", "expected one of simulated, ur_rtde"),
        ('[session]\ndriver = "ur_rtde"\nmodel = "UR5e"', "session.host", ""),
        ('[session]\ndriver = "ur_rtde"\nhost = "a"', "session.model", ""),
        ('[session]\ndriver = "ur_rtde"\nhost = "a b"\nmodel = "UR5e"', "session.host", '"a b"'),
        ('[session]\ndriver = "ur_rtde"\nhots = "a"\nmodel = "UR5e"', "session.hots", "expected 'host'"),
        ('[session]\ndriver = "simulated"\nhost = "a"', "session.host", "unknown key"),
        (
            '[session]\ndriver = "ur_rtde"\nhost = "a"\nmodel = "UR5e"\nsensor = {driver = "x"}',
            "session.sensor.driver",
            "expected one of ati_net_ft, bota_serial, robotiq_ft300",
        ),
        (UR + 'driver = "ati_net_ft"', "session.sensor.host", ""),
        (UR + 'driver = "ati_net_ft"\nhost = "b"\nsign = 2', "session.sensor.sign", ""),
        (UR + 'driver = "bota_serial"\nport = "COM3"', "session.sensor.port", "COM3"),
    ],
)
def test_a_table_that_cannot_be_used_is_told_by_its_key(tmp_path, table, key, found):
    with pytest.raises(BadCell) as raised:
        cell_with(tmp_path, table)
    said = " ".join(str(flaw) for flaw in (raised.value, *raised.value.others))
    assert f"cell.toml: {key}: " in said
    assert found in said


def test_a_package_that_is_missing_is_told_with_the_extra_that_brings_it():
    with pytest.raises(MissingPackage, match=r'session.driver: .*no_such_vendor.* pip install "heft\[ur\]"') as raised:
        import_vendor("no_such_vendor", extra="ur", where="cell.toml: session.driver")
    assert raised.value.exit_code == 2
