from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.planning.rotation_room import SHARE, Obstruction, RotationCheck, Turn, rotation_path
from core.robot.collision import CollisionModel
from core.robot.decoupling import decoupling_profile
from core.robot.model import RobotModel
from core.robot.trajectory import AngularProfile

AXES = np.eye(3)


def profile_of(cell: Cell, excursion: float = 0.25) -> AngularProfile:
    return decoupling_profile(cell.payload_box, cartesian_speed=0.25, period=0.001, excursion=excursion)


def pose_at(robot: RobotModel, q: np.ndarray) -> pin.SE3:
    pin.framesForwardKinematics(robot.model, robot.data, q)
    return robot.data.oMf[robot.sensor_frame_id].copy()


@cache
def models_of(name: str) -> tuple[RobotModel, CollisionModel]:
    cell = load_cell(Path(__file__).parents[3] / "cells" / name)
    robot = RobotModel.of_cell(cell)
    return robot, CollisionModel(cell, robot, cell.payload_box)


def check_of(cell: Cell, profile: AngularProfile, axis: np.ndarray) -> tuple[RobotModel, CollisionModel, Turn, RotationCheck]:
    robot, collision = models_of(cell.name)
    turn = Turn.of(profile, axis)
    return robot, collision, turn, RotationCheck(cell, robot, collision, turn, (robot.lower, robot.upper))


def test_a_turn_bounds_the_rate_at_every_angle_of_the_profile(cell):
    profile = profile_of(cell, excursion=0.6)
    turn = Turn.of(profile, AXES[0])
    assert turn.angle[turn.start] == 0.0
    assert turn.angle[0] <= profile.angle.min() and turn.angle[-1] >= profile.angle.max()
    below = np.clip(np.searchsorted(turn.angle, profile.angle, side="right") - 1, 0, len(turn.angle) - 2)
    bound = np.minimum(turn.rate[below], turn.rate[below + 1])
    assert (np.abs(profile.rate) <= bound + 1e-12).all()
    assert turn.acceleration == pytest.approx(4.8)


@settings(max_examples=25)
@given(st.integers(0, 2**32 - 1), st.sampled_from([0, 1, 2]))
def test_the_path_turns_the_sensor_about_its_axis_and_holds_its_origin(cell, seed, k):
    rng = np.random.default_rng(seed)
    robot = RobotModel.of_cell(cell)
    q = np.array(cell.robot.home_rad) + rng.uniform(-0.4, 0.4, robot.n)
    turn = Turn.of(AngularProfile(0.001, np.array([0.0, 0.2, -0.1, 0.0]), np.zeros(4)), AXES[k])
    found = rotation_path(robot.chain, q, turn)
    if found is None:
        return
    start = pose_at(robot, q)
    for angle, row in zip(turn.angle, found[0], strict=True):
        wanted = start * pin.SE3(pin.exp3(angle * AXES[k]), np.zeros(3))
        assert np.abs(pin.log6(wanted.actInv(pose_at(robot, row))).vector).max() < 1e-5


def test_the_slope_is_that_of_least_norm_and_the_derivative_of_the_path(cell):
    robot = RobotModel.of_cell(cell)
    q = np.array(cell.robot.home_rad)
    turn = Turn.of(AngularProfile(0.001, np.array([0.0, 0.3]), np.zeros(2)), AXES[0])
    path, slope = rotation_path(robot.chain, q, turn)
    for row, tangent in zip(path, slope, strict=True):
        J = pin.computeFrameJacobian(robot.model, robot.data, row, robot.sensor_frame_id, pin.LOCAL)
        assert tangent == pytest.approx(np.linalg.pinv(J) @ np.r_[np.zeros(3), AXES[0]], abs=1e-6)
    differences = (path[2:] - path[:-2]) / (turn.angle[2:] - turn.angle[:-2])[:, None]
    assert differences == pytest.approx(slope[1:-1], abs=5e-3)


def test_a_singular_arm_has_no_rotation():
    cell = load_cell(Path(__file__).parents[3] / "cells" / "ur5e_line")
    *_, check = check_of(cell, profile_of(cell), AXES[0])
    q = np.array(cell.robot.home_rad)
    q[4] = 0.0
    assert isinstance(check(q), Obstruction)


@settings(max_examples=25)
@given(st.integers(0, 2**32 - 1), st.sampled_from([0, 1, 2]))
def test_a_rotation_that_is_accepted_keeps_every_limit_sample_by_sample(cell, seed, k):
    """The path is timed by the profile at 1 ms and differentiated; speeds of points come from Pinocchio's placements."""
    profile = profile_of(cell)
    robot, collision, turn, check = check_of(cell, profile, AXES[k])
    q = np.array(cell.robot.home_rad) + np.random.default_rng(seed).uniform(-0.5, 0.5, robot.n)
    path = check(np.clip(q, robot.lower, robot.upper))
    if isinstance(path, Obstruction):
        return
    timed = CubicSpline(turn.angle, path)(profile.angle)
    dq = np.diff(timed, axis=0) / profile.period
    assert (np.abs(dq) <= SHARE * robot.velocity + 1e-6).all()
    ddq = np.diff(dq, axis=0) / profile.period
    assert (np.abs(ddq) <= np.array(cell.robot.acceleration_rad_s2)).all()
    fastest, before = 0.0, None
    bodies = list(zip(collision.points.joint + 1, collision.points.local, strict=True))
    for row in timed[::20]:
        pin.forwardKinematics(robot.model, robot.data, row)
        placed = np.array([robot.data.oMi[int(joint)].act(local) for joint, local in bodies])
        if before is not None:
            fastest = max(fastest, np.linalg.norm(placed - before, axis=1).max() / (20 * profile.period))
        before = placed
    assert fastest <= 0.95 * cell.limits.cartesian_speed_m_s + 1e-4


def test_a_rotation_that_runs_into_a_joint_limit_is_named_so(cell):
    profile = profile_of(cell)
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, cell.payload_box)
    q = np.array(cell.robot.home_rad)
    around = np.full(robot.n, 1e-3)
    check = RotationCheck(cell, robot, collision, Turn.of(profile, AXES[2]), (q - around, q + around))
    assert check(q) is Obstruction.JOINT_LIMIT


def test_a_rotation_that_would_be_too_fast_is_named_so(cell):
    """Steady turning, without acceleration: too fast for the payload box, far from too fast for the joints."""
    steady = AngularProfile(0.01, np.linspace(0.0, 0.02, 3), np.full(3, 2.2))
    *_, check = check_of(cell, steady, AXES[2])
    assert check(np.array(cell.robot.home_rad)) is Obstruction.CARTESIAN_SPEED
    faster = AngularProfile(0.01, np.linspace(0.0, 0.02, 3), np.full(3, 20.0))
    *_, check = check_of(cell, faster, AXES[2])
    assert check(np.array(cell.robot.home_rad)) is Obstruction.JOINT_SPEED


def test_a_rotation_that_accelerates_too_much_is_named_so(cell):
    jerky = AngularProfile(0.01, np.linspace(0.0, 0.02, 3), np.array([0.0, 0.5, 0.0]))
    *_, check = check_of(cell, jerky, AXES[2])
    assert check(np.array(cell.robot.home_rad)) is Obstruction.JOINT_ACCELERATION
