"""Tools take room: their boxes and links move with the last joint, keep clear of everything and count for speeds."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Box, Cell, Pose
from core.cell.folder import load_cell
from core.cell.tools import find_tools, tool_boxes, widest_box
from core.events import drive
from core.planning.search import plan_stops
from core.planning.settings import Scope
from core.planning.stops import Stops
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.second_opinion.opinion import JointPath, second_opinion
from core.second_opinion.pairs import PairKind
from tests.core.handed import GRIPPER, HAND_AS_TOOL, cell_folder

SMALL = Box(size_m=(0.02, 0.02, 0.02), pose=Pose(xyz_m=(0.0, 0.0, 0.01)))
LONG = "box = { size_m = [0.06, 0.06, 0.3], pose.xyz_m = [0.02, 0.0, 0.15] }"


def with_long_gripper(folder: Path) -> Cell:
    start = GRIPPER.index("box = ")
    return load_cell(cell_folder(folder, toml=GRIPPER[:start] + LONG + "\n"))


def margins_of(cell: Cell, payload_box: Box, name: str, q: np.ndarray) -> list[float]:
    collision = CollisionModel(cell, RobotModel.of_cell(cell), payload_box)
    pairs = [pair for group in collision.pairs for pair in group]
    found = collision.margins(q)[collision.watched]
    return sorted(margin for pair, margin in zip(pairs, found, strict=True) if pair[0].name == name)


def test_a_tools_box_keeps_clear_as_the_payloads_box_does_in_its_place(tmp_path: Path) -> None:
    tooled, bare = with_long_gripper(tmp_path / "a"), load_cell(cell_folder(tmp_path / "b"))
    box = tool_boxes(tooled)["gripper"]
    for q in np.array(bare.robot.home_rad) + np.random.default_rng(2).uniform(-0.3, 0.3, (5, 7)):
        expected = margins_of(bare, box, "payload", q)
        assert len(expected) > 5
        np.testing.assert_allclose(margins_of(tooled, SMALL, "gripper", q), expected, atol=1e-9)


def test_the_second_opinion_sees_the_tool_where_the_planner_has_it(tmp_path: Path) -> None:
    """The tip of the long gripper is what comes nearest to a wall right before it."""
    cell = with_long_gripper(tmp_path)
    home = np.array(cell.robot.home_rad)
    robot = RobotModel.of_cell(cell)
    at = robot.sensor_pose(home)
    tip = at.rotation @ np.array([0.02, 0.0, 0.3]) + at.position
    plate = cell.obstacles[0].model_copy(
        update={"name": "plate", "shape": Box(size_m=(0.2, 0.2, 0.02), pose=Pose(xyz_m=tuple((tip - [0.0, 0.0, 0.09]).tolist())))}
    )
    cell = cell.model_copy(update={"obstacles": (*cell.obstacles, plate)})
    nearest = CollisionModel(cell, robot, SMALL).obstacle_distance(home)
    opinion = second_opinion(cell, SMALL, [JointPath("still", np.stack([home] * 3))], 0.001)
    assert (nearest.first, nearest.second) == ("gripper", "plate")
    seen = next(each for each in opinion.approaches if each.kind == PairKind.ENVIRONMENT)
    assert (seen.first, seen.second) == ("gripper", "plate")
    assert seen.distance_m == pytest.approx(nearest.distance_m, abs=1e-5)


@pytest.mark.thorough
def test_a_tools_corners_keep_the_speed_limit(tmp_path: Path) -> None:
    cell = with_long_gripper(tmp_path)
    assert widest_box(cell, SMALL) == tool_boxes(cell)["gripper"]
    robot = RobotModel.of_cell(cell)
    home = np.array(cell.robot.home_rad)
    plan = drive(plan_stops(cell, robot, CollisionModel(cell, robot, SMALL), SMALL, Stops.of_procedure(Scope("z")).stops, start=home))
    assert plan.opinion.passes
    fastest = plan.opinion.fastest
    assert fastest.speed_m_s <= cell.limits.cartesian_speed_m_s * (1 + 1e-6)
    profile = plan.legs[1].profile
    assert profile is not None
    farthest = float(np.linalg.norm(tool_boxes(cell)["gripper"].corners, axis=1).max())
    assert np.abs(profile.rate).max() * farthest <= cell.limits.cartesian_speed_m_s
    assert np.abs(profile.rate).max() * farthest > 0.5 * cell.limits.cartesian_speed_m_s


def test_links_of_a_tool_have_the_urdfs_shapes_and_move_with_the_last_joint(tmp_path: Path) -> None:
    cell = load_cell(cell_folder(tmp_path, toml=HAND_AS_TOOL, hand=True))
    robot = RobotModel.of_cell(cell)
    points = CollisionModel(cell, robot, SMALL).points
    for link in ("hand", "finger"):
        assert [int(points.joint[k]) for k, owner in enumerate(points.owner) if owner == link] == [robot.n - 1] * 8


def test_the_inertia_of_links_is_that_of_their_masses_about_the_sensor_origin(tmp_path: Path) -> None:
    """The finger as the URDF has it, with its joint at zero, written out by hand: two fixed turns about z and the shifts along them."""
    urdf_hand = '<origin xyz="0.002 -0.003 0.01" rpy="0.1 -0.2 0.7"/>'
    folder = cell_folder(tmp_path, toml=HAND_AS_TOOL, hand=True)
    text = (folder / "robot.urdf").read_text()
    assert urdf_hand in text
    plain = text.replace(urdf_hand, '<origin xyz="0.1 0 0" rpy="0 0 1.5707963267948966"/>')
    plain = plain.replace('<origin xyz="0 0.02 0.06" rpy="0 0 0.4"/>', '<origin xyz="0 0.02 0.06" rpy="0 0 0"/>')
    (folder / "robot.urdf").write_text(plain)
    found = find_tools(load_cell(folder))[0]
    # a quarter turn about z: (x, y) of the hand is (-y, x) of the sensor
    hand, finger = np.array([0.1, 0.01, 0.03]), np.array([0.1 - 0.025, 0.0, 0.08])
    assert found.parameters.mass == pytest.approx(0.75)
    np.testing.assert_allclose(found.parameters.first_moment, 0.7 * hand + 0.05 * finger, atol=1e-12)
    assert np.isnan(found.std).all()
    assert found.parameters.consistent


def test_a_cell_without_tools_has_none(tmp_path: Path) -> None:
    cell = load_cell(cell_folder(tmp_path))
    assert find_tools(cell) == ()
    assert tool_boxes(cell) == {}
    assert widest_box(cell, SMALL) is SMALL
