from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Cell, Pose
from core.cell.folder import load_cell
from core.errors import NoPath
from core.planning.path import one_turn_away
from core.planning.timing import MotionLimits, least_seconds
from core.planning.transfer import SPEED_FRACTION, Transfer, plan_transfer
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from tests.independent_checker import IndependentChecker

CELLS = Path(__file__).parents[3] / "cells"
GOALS = {
    "lwr4_bench": [1.2, -0.9, 0.4, 1.2, -1.0, -1.4, 1.0],
    "ur5e_line": [2.0, -1.3, 1.5, -0.5, -1.0, 1.2],
}


@cache
def bench(name: str) -> tuple[Cell, RobotModel, CollisionModel]:
    cell = load_cell(CELLS / name)
    robot = RobotModel.of_cell(cell)
    return cell, robot, CollisionModel(cell, robot, cell.payload_box)


@cache
def transfer(name: str) -> Transfer:
    cell, robot, collision = bench(name)
    return plan_transfer(cell, robot, collision, np.array(cell.robot.home_rad), np.array(GOALS[name]), period=0.001, seed=2)


@pytest.mark.parametrize("name", list(GOALS))
def test_an_independent_checker_finds_no_violation(name: str) -> None:
    cell, _, _ = bench(name)
    findings = IndependentChecker(cell, cell.payload_box).check(transfer(name).trajectory.q, 0.001)
    assert findings.violations == []
    assert findings.speed_m_s == pytest.approx(SPEED_FRACTION * cell.limits.cartesian_speed_m_s, rel=0.01)


@pytest.mark.parametrize("name", list(GOALS))
def test_a_transfer_joins_its_ends_exactly_with_a_margin_that_is_certified(name: str) -> None:
    cell, _, collision = bench(name)
    moved = transfer(name)
    np.testing.assert_array_equal(moved.trajectory.q[0], cell.robot.home_rad)
    np.testing.assert_array_equal(moved.goal, GOALS[name])
    assert 0.0 <= moved.certified_margin_m <= moved.least_margin_m
    assert min(collision.margin(q) for q in moved.trajectory.q[::20]) >= moved.certified_margin_m


@pytest.mark.parametrize("name", list(GOALS))
def test_a_transfer_is_hardly_slower_than_the_straight_line_would_be(name: str) -> None:
    cell, robot, collision = bench(name)
    straight = np.array([cell.robot.home_rad, GOALS[name]])
    limits = MotionLimits.of_cell(cell, robot, collision)
    assert transfer(name).trajectory.duration < 1.2 * least_seconds(straight, robot, limits) / SPEED_FRACTION + 0.5


def test_a_robot_that_is_there_already_stays() -> None:
    cell, robot, collision = bench("lwr4_bench")
    home = np.array(cell.robot.home_rad)
    assert len(plan_transfer(cell, robot, collision, home, home, period=0.001).trajectory) == 1


def test_a_robot_that_stands_too_close_is_told_so() -> None:
    cell = bench("lwr4_bench")[0]
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, cell.payload_box)
    home = np.array(cell.robot.home_rad)
    tip = robot.sensor_pose(home).position
    collision.move("fixture", Pose(xyz_m=(float(tip[0]), float(tip[1]), float(tip[2]))))
    for goal in (home, np.array(GOALS["lwr4_bench"])):
        with pytest.raises(NoPath, match='obstacle "fixture"'):
            plan_transfer(cell, robot, collision, home, goal, period=0.001)


def test_a_goal_behind_a_folded_wrist_is_reached_the_other_way_round() -> None:
    """The second wrist joint cannot pass half a turn with this payload box: the forearm is in the way."""
    cell, robot, collision = bench("ur5e_line")
    home = np.array(cell.robot.home_rad)
    goal = np.array([*home[:4], home[4] - np.pi - 0.1, 0.0])
    assert collision.margin(goal) > 0.0
    with pytest.raises(NoPath, match="no path found"):
        plan_transfer(cell, robot, collision, home, goal, period=0.001, iterations=150)
    moved = plan_transfer(cell, robot, collision, home, one_turn_away(robot, goal, home), period=0.001, iterations=300)
    np.testing.assert_allclose(moved.goal, goal + 2 * np.pi * np.eye(6)[4])
    np.testing.assert_allclose(robot.sensor_pose(moved.goal).rotation, robot.sensor_pose(goal).rotation, atol=1e-9)
