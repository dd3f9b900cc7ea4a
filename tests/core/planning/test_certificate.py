from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.array import Array
from core.cell.cell import Pose
from core.cell.folder import load_cell
from core.planning.certificate import is_clear, least_margin
from core.planning.pair_margins import PairMargins
from core.planning.path import dense
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel

CELLS = Path(__file__).parents[3] / "cells"
GJK_M = 2e-6
"""GJK ends at a tolerance of 1e-6 m, and where it ends depends on the pair that it was asked for before."""
NAMES = st.sampled_from(["lwr4_bench", "ur5e_line"])


@cache
def model(name: str) -> tuple[RobotModel, CollisionModel, PairMargins]:
    cell = load_cell(CELLS / name)
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, cell.payload_box)
    return robot, collision, PairMargins(collision)


def random_line(name: str, seed: int, length: float) -> Array:
    robot, _, _ = model(name)
    rng = np.random.default_rng(seed)
    q = rng.uniform(np.maximum(robot.lower, -3), np.minimum(robot.upper, 3))
    return np.stack((q, q + length * rng.normal(size=robot.n) / np.sqrt(robot.n)))


@settings(max_examples=60, deadline=None)
@given(name=NAMES, seed=st.integers(0, 100_000))
def test_the_least_of_all_pairs_is_the_margin(name: str, seed: int) -> None:
    _, collision, margins = model(name)
    q = random_line(name, seed, 1.0)[0]
    assert margins(q).min() == pytest.approx(collision.margin(q), abs=GJK_M)


@settings(max_examples=100, deadline=None)
@given(name=NAMES, seed=st.integers(0, 100_000), length=st.floats(0.001, 1.0))
def test_no_pair_changes_faster_than_its_reach(name: str, seed: int, length: float) -> None:
    _, _, margins = model(name)
    a, b = random_line(name, seed, length)
    first, last = margins(a), margins(b)
    apart = (first > -0.01) & (last > -0.01)  # a depth of penetration is not a distance
    assert (np.abs(last - first) <= margins.reach @ np.abs(b - a) + 1e-6)[apart].all()


@settings(max_examples=40, deadline=None)
@given(name=NAMES, seed=st.integers(0, 100_000))
def test_the_certified_bound_holds_at_samples_that_it_never_saw(name: str, seed: int) -> None:
    _, collision, margins = model(name)
    line = random_line(name, seed, 0.8)
    least = least_margin(margins, line)
    seen = min(collision.margin(q) for q in dense(line, 0.01))
    if least.margin_m > 0.0:
        assert least.bound_m <= seen + GJK_M
        assert least.bound_m >= least.margin_m - 0.001 - GJK_M
        assert is_clear(margins, line)
    else:
        assert seen < 0.002
        assert not is_clear(margins, line)


def test_what_is_clear_with_something_to_spare_is_clear_without() -> None:
    _, _, margins = model("lwr4_bench")
    lines = [random_line("lwr4_bench", seed, 0.3) for seed in range(40)]
    clear, spare = ([is_clear(margins, line, wanted) for line in lines] for wanted in (0.0, 0.03))
    assert any(clear)
    assert sum(clear) > sum(spare)
    assert all(c for c, s in zip(clear, spare, strict=True) if s)


def test_an_obstacle_that_has_moved_counts_where_it_is_now() -> None:
    cell = load_cell(CELLS / "lwr4_bench")
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, cell.payload_box)
    home = np.array([cell.robot.home_rad])
    assert is_clear(PairMargins(collision), home)
    tip = robot.sensor_pose(home[0]).position
    collision.move("fixture", Pose(xyz_m=(float(tip[0]), float(tip[1]), float(tip[2]))))
    assert not is_clear(PairMargins(collision), home)
