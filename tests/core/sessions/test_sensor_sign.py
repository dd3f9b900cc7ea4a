"""Sign and axes of a sensor from two poses; the forces are made here, by hand."""

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.cell.folder import load_cell
from core.errors import WrongSensor
from core.robot.model import RobotModel
from core.sessions.sensor_sign import SensorSign
from core.sessions.session import RobotState

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
ROBOT = RobotModel.of_cell(CELL)


def look_at(check, spoil, mass=1.0, turn=1.0, dq=0.0):
    """The robot stands at home, and then with its last but one joint turned."""
    q = np.array(CELL.robot.home_rad)
    for angle in (0.0, turn):
        there = q + angle * np.eye(7)[5]
        gravity = ROBOT.sensor_pose(there).rotation.T @ np.array([0.0, 0.0, -9.81])
        wrench = np.concatenate([spoil(-mass * gravity) + np.array([3.0, -20.0, 7.0]), np.zeros(3)])
        for k in range(60):
            check.look(RobotState(0.001 * k, there, np.full(7, dq), there, wrench))


def test_what_is_right_is_found_right():
    check = SensorSign(CELL, ROBOT)
    look_at(check, lambda f: f)
    assert check.decided


@pytest.mark.parametrize(
    ("spoil", "says"),
    [
        (lambda f: -f, "the other way round"),
        (lambda f: Rotation.from_rotvec([0.0, 0.0, np.pi / 2]).apply(f), "another direction|the other way round"),
        (lambda f: f[[1, 2, 0]], "another direction|the other way round"),
    ],
)
def test_another_sign_and_other_axes_are_told(spoil, says):
    with pytest.raises(WrongSensor, match=says):
        look_at(SensorSign(CELL, ROBOT), spoil)


@pytest.mark.parametrize("given", [{"mass": 0.05}, {"turn": 0.1}, {"dq": 0.1}])
def test_too_light_a_load_or_too_small_a_turn_tells_nothing(given):
    check = SensorSign(CELL, ROBOT)
    look_at(check, lambda f: -f, **given)
    assert not check.decided
