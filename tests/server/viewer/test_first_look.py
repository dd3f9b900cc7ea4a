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
from server.viewer.first_look import find_occluded, first_look, measure_occlusion

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
