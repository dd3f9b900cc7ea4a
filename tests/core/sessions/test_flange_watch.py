"""The flange of the stand-in, whose kinematics are its own, against the cell's."""

from itertools import combinations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.errors import WrongKinematics
from core.fakes.ur_arm import UrArm
from core.robot.model import RobotModel
from core.sessions.controller import Kinematics
from core.sessions.flange_watch import FlangeWatch
from tests.core.sessions.test_ur import CELL, cell_at

PERIOD = 0.01
NOWHERE = (np.zeros(3), np.eye(3))
NAMES = ("shoulder_pan", "shoulder_lift", "elbow", "wrist1", "wrist2", "wrist3")
ARM = UrArm(CELL)
KINEMATICS = Kinematics(cell_at("127.0.0.1"), RobotModel.of_cell(CELL))


def drive(start, speed, mistake=lambda q: q, *, seconds=1.0, off=NOWHERE, late_s=0.0) -> None:
    """Moves joints at constant speeds; `drive.gone` is how far the fastest had gone, rad, when it was last found well."""
    watch = FlangeWatch(KINEMATICS, NAMES)
    for t in np.arange(0.0, seconds, PERIOD):
        q = start + speed * t
        position, rotation = ARM.flange(mistake(q - speed * late_s))
        watch.look(q, speed, position + rotation @ off[0], rotation @ off[1])
        drive.gone = float(np.abs(speed).max() * t)


@pytest.mark.parametrize(("i", "j"), list(combinations(range(6), 2)))
def test_two_joints_at_one_angle_are_found_swapped_as_soon_as_one_moves(i, j):
    def mistake(q):
        q = q.copy()
        q[[i, j]] = q[[j, i]]
        return q

    start = np.array(CELL.robot.home_rad)
    start[j] = start[i]
    for moving in (i, j):
        with pytest.raises(WrongKinematics, match=f"joints {NAMES[i]} and {NAMES[j]} swapped"):
            drive(start, 0.2 * np.eye(6)[moving], mistake)
        assert drive.gone < 0.02


@pytest.mark.parametrize("j", range(6))
def test_a_joint_at_zero_is_found_to_turn_the_other_way(j):
    start = np.array(CELL.robot.home_rad)
    start[j] = 0.0
    with pytest.raises(WrongKinematics, match=f"sign of joint {NAMES[j]} changed"):
        drive(start, 0.2 * np.eye(6)[j], lambda q: np.where(np.arange(6) == j, -q, q))
    assert drive.gone < 0.02


def test_an_arm_with_its_own_calibration_is_left_alone_however_it_moves():
    rng = np.random.default_rng(4)
    for _ in range(20):
        speed = rng.uniform(-1.0, 1.0, 6)
        off = rng.normal(size=3)
        tilt = Rotation.from_rotvec(0.008 * rng.normal(size=3) / np.sqrt(3)).as_matrix()
        drive(rng.uniform(-2.0, 2.0, 6), speed, off=(0.004 * off / np.linalg.norm(off), tilt), late_s=0.002)
    zeros = rng.normal(size=6) * 0.001
    drive(np.array(CELL.robot.home_rad), rng.uniform(-0.5, 0.5, 6), lambda q: q + zeros)
