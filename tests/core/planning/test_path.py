from __future__ import annotations

import time
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Box, Cell, Obstacle, Pose, Zone
from core.cell.folder import load_cell
from core.errors import NoPath
from core.planning.path import Path as JointPath
from core.planning.path import dense, one_turn_away, plan_path
from core.planning.room import LIMIT_ROOM_RAD, Room
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from tests.independent_checker import IndependentChecker

CELLS = Path(__file__).parents[3] / "cells"
LEFT = np.array([0.9, -0.9, 0.0, 1.2, 0.0, -1.0, 0.0])
RIGHT = np.array([-0.9, -0.9, 0.0, 1.2, 0.0, -1.0, 0.0])
POST = Obstacle(name="post", shape=Box(size_m=(0.1, 0.1, 1.2), pose=Pose(xyz_m=(0.55, 0.0, 0.6))))


def lwr_cell(*obstacles: Obstacle) -> Cell:
    cell = load_cell(CELLS / "lwr4_bench")
    home = (0.9, *cell.robot.home_rad[1:])
    robot = cell.robot.model_copy(update={"home_rad": home})
    return cell.model_copy(update={"robot": robot, "zones": (), "obstacles": (cell.obstacles[0], *obstacles)})


@cache
def cell_with_post() -> tuple[Cell, RobotModel, CollisionModel]:
    cell = lwr_cell(POST)
    robot = RobotModel.of_cell(cell)
    return cell, robot, CollisionModel(cell, robot, cell.payload_box)


@cache
def round_the_post(seed: int = 0) -> JointPath:
    return plan_path(*cell_with_post(), LEFT, RIGHT, seed=seed)


def test_a_straight_line_that_is_free_and_fast_stays_nearly_straight() -> None:
    cell = lwr_cell()
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, cell.payload_box)
    goal = LEFT + np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5])
    path = plan_path(cell, robot, collision, LEFT, goal)
    assert path.length_rad == pytest.approx(0.5, abs=0.02)


def test_the_straight_line_past_the_post_is_blocked() -> None:
    _, _, collision = cell_with_post()
    assert min(collision.margin(q) for q in dense(np.stack((LEFT, RIGHT)))) < -0.01


def test_a_path_joins_its_ends_in_small_steps() -> None:
    path = round_the_post()
    np.testing.assert_array_equal(path.q[0], LEFT)
    np.testing.assert_array_equal(path.q[-1], RIGHT)
    assert np.linalg.norm(np.diff(path.q, axis=0), axis=1).max() <= 0.02 + 1e-9


def test_another_collision_library_finds_no_violation_at_a_tenth_of_the_step() -> None:
    cell, _, _ = cell_with_post()
    checker = IndependentChecker(cell, cell.payload_box)
    margins = [min(margin for margin, _ in checker.margins(q).values()) for q in dense(round_the_post().q, 0.01)]
    assert min(margins) >= 0.0
    assert min(margins) == pytest.approx(round_the_post().least_margin_m, abs=0.002)


def test_a_path_stays_within_the_joint_limits() -> None:
    _, robot, _ = cell_with_post()
    q = round_the_post().q
    assert (q >= robot.lower + LIMIT_ROOM_RAD - 1e-9).all()
    assert (q <= robot.upper - LIMIT_ROOM_RAD + 1e-9).all()


def test_the_same_seed_gives_the_same_path() -> None:
    again = plan_path(*cell_with_post(), LEFT, RIGHT, seed=0)
    np.testing.assert_array_equal(again.q, round_the_post().q)


def test_a_machine_that_is_slower_finds_the_same_path(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each look at a piece of the way takes a whole control period more."""
    looked = Room.has_all
    looks = []

    def slowly(room: Room, q: np.ndarray) -> bool:
        looks.append(1)
        time.sleep(0.001)
        return looked(room, q)

    monkeypatch.setattr(Room, "has_all", slowly)
    np.testing.assert_array_equal(plan_path(*cell_with_post(), LEFT, RIGHT, seed=0, iterations=150).q, round_the_post().q)
    assert len(looks) > 20


def test_rrt_star_finds_a_way_too() -> None:
    _, _, collision = cell_with_post()
    path = plan_path(*cell_with_post(), LEFT, RIGHT, planner="rrt_star", seed=3, iterations=2000)
    assert min(collision.margin(q) for q in path.q) >= 0.0


def test_near_an_end_with_little_room_less_is_asked() -> None:
    cell, robot, collision = cell_with_post()
    low, high = 0.05, 0.9  # turning the base towards the post until only 1 mm is left
    for _ in range(60):
        middle = 0.5 * (low + high)
        close = np.array([middle, *LEFT[1:]])
        low, high = (low, middle) if collision.margin(close) > 0.001 else (middle, high)
    close = np.array([high, *LEFT[1:]])
    assert 0.0 < collision.margin(close) < 0.002
    path = plan_path(cell, robot, collision, close, RIGHT)
    assert min(collision.margin(q) for q in path.q) >= 0.0


@pytest.mark.parametrize("end", ["start", "goal"])
def test_an_end_in_collision_is_refused_with_the_pair_and_the_distance(end: str) -> None:
    cell, robot, collision = cell_with_post()
    inside = np.array([0.0, *LEFT[1:]])
    ends = (inside, RIGHT) if end == "start" else (LEFT, inside)
    nearest = collision.nearest(inside)
    with pytest.raises(
        NoPath, match=rf'at the {end} of the path "?{nearest.first}"? reaches {-nearest.distance_m:.2f} m into obstacle "post"'
    ) as refusal:
        plan_path(cell, robot, collision, *ends)
    assert refusal.value.in_the_way == "post"


def test_an_end_outside_the_joint_limits_is_refused_with_the_joint() -> None:
    cell, robot, collision = cell_with_post()
    with pytest.raises(NoPath, match=r"joint1 at 3.000 rad, outside its limits \[-2.967, 2.967\]"):
        plan_path(cell, robot, collision, np.array([3.0, *LEFT[1:]]), RIGHT)


@pytest.mark.parametrize("bad", [np.full(7, np.nan), np.zeros(6)])
def test_an_end_that_is_no_configuration_is_refused(bad: np.ndarray) -> None:
    with pytest.raises(NoPath, match="7 finite joint positions"):
        plan_path(*cell_with_post(), LEFT, bad)


def test_a_search_that_finds_nothing_says_how_much_was_tried_how_far_it_came_and_how_to_try_more() -> None:
    """A zone on either side and one above: the arm cannot get from the front to the back."""
    plain = load_cell(CELLS / "lwr4_bench")
    sides = [
        Zone(name="left", shape=Box(size_m=(0.9, 0.3, 3.0), pose=Pose(xyz_m=(0.0, 0.45, 1.5)))),
        Zone(name="right", shape=Box(size_m=(0.9, 0.3, 3.0), pose=Pose(xyz_m=(0.0, -0.45, 1.5)))),
        Zone(name="above", shape=Box(size_m=(3.0, 3.0, 0.2), pose=Pose(xyz_m=(0.0, 0.0, 1.0)))),
    ]
    bent = (0.0, -0.9, 0.0, 1.6, 0.0, -0.6, 0.0)
    cell = plain.model_copy(update={"zones": tuple(sides), "obstacles": (), "robot": plain.robot.model_copy(update={"home_rad": bent})})
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, cell.payload_box)
    start, goal = np.array(bent), np.array([2.9, *bent[1:]])
    with pytest.raises(
        NoPath, match=r"no path found in 150 iterations by rrt_connect: .* came within \d\.\d\d rad of the goal, 2\.90 rad away.*--effort"
    ):
        plan_path(cell, robot, collision, start, goal, iterations=150)


def test_the_nearest_whole_turn_comes_before_farther_ones_and_keeps_the_pose() -> None:
    robot = RobotModel.of_cell(load_cell(CELLS / "ur5e_line"))
    q = np.array([0.3, -1.5, 1.7, 2.0, -4.7, 3.0])
    goals = one_turn_away(robot, q, near=np.array([0.0, -1.6, 1.7, -1.65, 0.0, 0.0]))
    np.testing.assert_array_equal(goals[0], q)
    np.testing.assert_allclose(goals[1], q + 2 * np.pi * np.eye(6)[4])
    assert len(goals) == 5  # the elbow turns only once, the first joint would end at its limit
    for goal in goals:
        np.testing.assert_allclose(robot.sensor_pose(goal).position, robot.sensor_pose(q).position, atol=1e-12)


def test_of_several_goals_one_is_reached() -> None:
    cell, robot, collision = cell_with_post()
    near = np.array([0.7, *LEFT[1:]])
    path = plan_path(cell, robot, collision, LEFT, np.stack((RIGHT, near)))
    np.testing.assert_array_equal(path.q[-1], near)
