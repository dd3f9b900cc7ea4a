"""`server.viewer.first_look` against lines of sight walked point by point."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.cell.folder import load_cell
from core.report.faces import arm_faces, box_faces
from core.robot.model import RobotModel
from server.viewer.first_look import FIELD_OF_VIEW_RAD, find_eye, find_occluded, first_look, measure_occlusion
from server.viewer.wish import Look

CELLS = Path(__file__).parents[3] / "cells"


@settings(max_examples=60)
@given(seed=st.integers(0, 10_000))
def test_a_line_crosses_a_box_where_one_of_its_points_lies_inside(seed: int) -> None:
    rng = np.random.default_rng(seed)
    size, eye, points = rng.uniform(0.2, 1.0, 3), rng.uniform(-2.0, 2.0, 3), rng.uniform(-2.0, 2.0, (20, 3))
    walked = eye + np.linspace(0.0, 1.0, 4001)[:, None, None] * (points - eye)
    depth = (0.5 * size - np.abs(walked)).min(axis=2).max(axis=0)  # m, how deep the line gets into the box
    clear = np.abs(depth) > 1e-3
    np.testing.assert_array_equal(find_occluded(box_faces(size), eye, points)[clear], (depth > 0.0)[clear])


@pytest.mark.parametrize("name", ["lwr4_bench", "ur5e_line"])
def test_the_arm_is_seen_and_looked_down_upon(name: str) -> None:
    cell = load_cell(CELLS / name)
    robot = RobotModel.of_cell(cell)
    eye, middle = first_look(cell, robot)
    arm = np.concatenate(arm_faces(cell, robot, np.array(cell.robot.home_rad)))
    assert measure_occlusion(cell, eye, arm) < 0.15
    assert eye[2] > middle[2]


@pytest.mark.parametrize("aspect", [0.5, 1.0, 2.0])
@pytest.mark.parametrize("look", ["front", "top", "operator", "fit", "reset"])
def test_from_every_side_the_whole_arm_is_in_the_middle_of_the_picture(look: Look, aspect: float) -> None:
    cell = load_cell(CELLS / "lwr4_bench")
    arm = np.concatenate(arm_faces(cell, RobotModel.of_cell(cell), np.array(cell.robot.home_rad)))
    eye, middle = find_eye(cell, look, arm, aspect, np.array([1.0, 2.0, 0.5]))
    forward = (middle - eye) / np.linalg.norm(middle - eye)
    right = np.cross(forward, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    seen = arm - eye
    depth, half = seen @ forward, np.tan(0.5 * FIELD_OF_VIEW_RAD)
    assert (depth > 0.0).all()
    assert np.abs(seen @ np.cross(right, forward) / depth).max() < half
    assert np.abs(seen @ right / depth).max() < aspect * half


def test_each_side_is_the_one_that_its_name_says() -> None:
    cell = load_cell(CELLS / "lwr4_bench")
    arm = np.concatenate(arm_faces(cell, RobotModel.of_cell(cell), np.array(cell.robot.home_rad)))
    toward = np.array([1.0, 2.0, 0.5])
    sides = {look: np.subtract(*find_eye(cell, look, arm, 1.5, toward)) for look in ("front", "top", "operator", "fit", "reset")}
    unit = {look: side / np.linalg.norm(side) for look, side in sides.items()}
    np.testing.assert_allclose(unit["front"], cell.robot.base.rotation[:, 0], atol=1e-9)
    assert unit["top"][2] > 0.99
    people = cell.zones[0].shape.pose.translation - arm.mean(axis=0)
    assert unit["operator"][:2] @ people[:2] / np.linalg.norm(people[:2]) > 0.7
    np.testing.assert_allclose(unit["fit"], toward / np.linalg.norm(toward))
