from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.planning.grid import Postures, draw_postures, first_grid, second_grid, shortest_turns
from core.robot.model import RobotModel

DOWN = np.array([0.0, 0.0, -1.0])
X = np.array([1.0, 0.0, 0.0])


def drawn(cell, near: np.ndarray | None = None, count: int = 3000) -> tuple[RobotModel, Postures]:
    robot = RobotModel.of_cell(cell)
    limits = robot.lower + 0.05, robot.upper - 0.05
    return robot, draw_postures(robot, np.random.default_rng(0), count, limits=limits, near=near, axis=X, gravity=DOWN)


@given(st.integers(0, 2**32 - 1))
def test_the_shortest_turn_takes_a_direction_where_it_is_wanted_by_the_angle_between_them(seed):
    rng = np.random.default_rng(seed)
    directions, onto = rng.normal(size=(4, 3)), rng.normal(size=3)
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    onto /= np.linalg.norm(onto)
    directions[0], directions[1] = onto, -onto
    turns = shortest_turns(directions, onto)
    assert np.einsum("nij,nj->ni", turns, directions) == pytest.approx(np.tile(onto, (4, 1)), abs=1e-9)
    assert np.einsum("nij,nkj->nik", turns, turns) == pytest.approx(np.tile(np.eye(3), (4, 1, 1)), abs=1e-9)
    assert np.linalg.det(turns) == pytest.approx(np.ones(4))
    angles = np.linalg.norm(Rotation.from_matrix(turns).as_rotvec(), axis=1)
    assert angles == pytest.approx(np.arccos(np.clip(directions @ onto, -1, 1)), abs=1e-6)


def test_postures_keep_the_limits_and_some_are_near_the_configuration_the_robot_comes_from(cell):
    home = np.array(cell.robot.home_rad)
    robot, postures = drawn(cell, near=home)
    assert ((postures.q >= robot.lower) & (postures.q <= robot.upper)).all()
    near = np.linalg.norm(postures.q - home, axis=1) < 0.6 * np.sqrt(robot.n) * 1.3
    assert 0.15 < near.mean() < 0.6
    pose = robot.sensor_pose(postures.q[7])
    assert postures.position[7] == pytest.approx(pose.position)
    assert postures.rotation[7] == pytest.approx(pose.rotation)


def test_the_first_grid_covers_what_the_robot_reaches_and_little_else(cell):
    robot, postures = drawn(cell)
    vertices, spacing = first_grid(postures, 300)
    assert 200 < len(vertices) < 400
    others = RobotModel.of_cell(cell).sensor_poses(np.random.default_rng(5).uniform(robot.lower, robot.upper, (500, robot.n))).position
    to_vertex = np.linalg.norm(others[:, None] - vertices[None], axis=2).min(axis=1)
    assert np.mean(to_vertex < spacing) > 0.97
    to_posture = np.linalg.norm(vertices[:, None] - postures.position[None], axis=2).min(axis=1)
    assert to_posture.max() <= 0.7 * spacing


def test_the_second_grid_is_centred_in_the_best_vertex_and_reaches_to_its_neighbours():
    vertices = second_grid(np.array([0.3, -0.2, 0.5]), 0.1, 5)
    assert len(np.unique(vertices.round(9), axis=0)) == 125
    assert vertices.mean(axis=0) == pytest.approx([0.3, -0.2, 0.5])
    assert np.ptp(vertices, axis=0) == pytest.approx([0.2, 0.2, 0.2])


def test_aligned_postures_have_the_axis_along_gravity_at_many_angles_about_it(cell):
    _, postures = drawn(cell)
    rotations = postures.align_with_gravity(np.arange(500))
    assert rotations @ X == pytest.approx(np.tile(DOWN, (500, 1)), abs=1e-9)
    yaw = np.arctan2(rotations[:, 1, 1], rotations[:, 0, 1])
    assert np.histogram(yaw, bins=8, range=(-np.pi, np.pi))[0].min() > 20


def test_the_nearest_postures_are_the_nearest(cell):
    _, postures = drawn(cell, count=500)
    vertex = np.array([[0.4, 0.1, 0.4]])
    cost = np.linalg.norm(postures.position - vertex, axis=1) ** 2 + 0.25 * np.linalg.norm(postures.rotation @ X - DOWN, axis=1) ** 2
    assert postures.nearest(vertex, 6)[0] == pytest.approx(np.argsort(cost)[:6])
