"""The picture of a start configuration."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.cell.folder import load_cell
from core.planning.start_configuration import StartConfiguration
from core.planning.throw import Throw
from core.report.scene import HEIGHT, WIDTH, Projection, scene
from core.robot.model import RobotModel

CELLS = Path(__file__).parents[3] / "cells"
NAMES = sorted(folder.name for folder in CELLS.iterdir() if folder.is_dir())


def start(q: np.ndarray, axis: str = "x+") -> StartConfiguration:
    return StartConfiguration(axis, q, 0.5, 0.2, 0.1, "bench", 0.04, Throw("operator", 0.4, 0.1, 0.3), 10)


@settings(max_examples=50, deadline=None)
@given(azimuth=st.floats(-np.pi, np.pi), seed=st.integers(0, 99))
def test_the_projection_is_a_right_handed_parallel_one_that_shows_everything(azimuth: float, seed: int) -> None:
    view = Projection(azimuth, np.array([-1.0, -2, 0]), np.array([1.0, 0.5, 2]))
    assert Rotation.from_matrix(view.axes).as_matrix() == pytest.approx(view.axes)
    points = np.random.default_rng(seed).uniform(view.low, view.high, (50, 3))
    pixels = view.pixels(points)
    assert (pixels >= 0).all() and (pixels <= [WIDTH, HEIGHT]).all()
    along = points + 0.7 * view.axes[2]
    np.testing.assert_allclose(view.pixels(along), pixels, atol=1e-9)
    assert (view.pixels(points + np.array([0, 0, 0.1]))[:, 1] < pixels[:, 1]).all()  # up is up


@pytest.mark.parametrize("name", NAMES)
def test_the_picture_stays_in_its_frame_and_names_what_stands_near(name: str) -> None:
    cell = load_cell(CELLS / name)
    robot = RobotModel.of_cell(cell)
    for q in np.random.default_rng(2).uniform(robot.lower / 3, robot.upper / 3, (4, robot.n)):
        picture = scene(cell, robot, cell.payload_box, start(q, "y+"))
        corners = [[float(v) for v in pair.split(",")] for points in re.findall(r'points="([^"]*)"', picture) for pair in points.split()]
        inside = (np.array(corners) >= -20).all(axis=1) & (np.array(corners) <= [WIDTH + 20, HEIGHT + 20]).all(axis=1)
        assert inside.mean() > 0.98
        assert picture.count('class="arm"') > 100
        assert picture.count('class="load"') == 3  # of a box one sees three faces
        assert ">throw<" in picture and all(f">{axis}<" in picture for axis in "xyz")
    assert any(f">{item.name}<" in picture for item in cell.obstacles)


def test_a_face_is_before_the_robot_only_when_it_stands_between_robot_and_viewer() -> None:
    cell = load_cell(CELLS / "lwr4_bench")
    robot = RobotModel.of_cell(cell)
    picture = scene(cell, robot, cell.payload_box, start(np.array(cell.robot.home_rad)))
    bench, front, arm = (picture.index(f'class="{name}"') for name in ("obstacle", "obstacle front", "arm"))
    assert bench < arm < front
