"""The set points in the file are what the controller would command: all of it, in time, and no faster."""

from __future__ import annotations

import csv
import json
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.errors import BadInput
from core.events import drive
from core.planning.commanded_path import compute_joint_paths
from core.planning.plan import Plan, motions_of
from core.planning.search import plan_stops
from core.planning.set_points import SetPoints, check_set_points, set_points_of, write_set_points
from core.planning.settings import Scope, Timing
from core.planning.slow_run import limit_speed
from core.planning.stops import Stops
from core.planning.timing import MotionLimits
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from tests.independent_checker import IndependentChecker

CELL = Path(__file__).parents[3] / "cells" / "ur5e_line"
SLOW_M_S = 0.1
SHORT = Timing(hold_s=0.5, settle_s=0.4, robot_s=1.0)


@cache
def planned() -> tuple[Cell, RobotModel, CollisionModel, Plan]:
    """One axis, with its rotation, slower than the cell allows."""
    cell = limit_speed(load_cell(CELL), SLOW_M_S, "--speed")
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, cell.payload_box)
    home = np.array(cell.robot.home_rad)
    plan = plan_stops(cell, robot, collision, cell.payload_box, Stops.of_procedure(Scope("z"), SHORT).stops, start=home, timing=SHORT)
    return cell, robot, collision, drive(plan)


@cache
def at(milliseconds: int = 1) -> SetPoints:
    return set_points_of(*planned(), period_s=0.001 * milliseconds)


def all_rows(found: SetPoints) -> np.ndarray:
    return np.concatenate([motion.q for motion in found.motions])


def test_the_motions_are_those_of_the_controller_with_the_holds_between_them() -> None:
    cell, robot, collision, plan = planned()
    commanded = compute_joint_paths(cell, robot, collision, motions_of(plan.legs, plan.home), np.array(cell.robot.home_rad))
    found = at()
    names = [motion.name for motion in found.motions]
    assert names == ["transfer z-", "hold z-", "transfer z+", "hold z+", "rotation z", "hold z+", "home"]
    moving = [motion for motion in found.motions if not motion.name.startswith("hold")]
    for motion, path in zip(moving, commanded, strict=True):
        np.testing.assert_array_equal(motion.q, path.q if motion is moving[0] else path.q[1:])
    for before, hold in pairwise(found.motions):
        if hold.name.startswith("hold"):
            assert (hold.q == before.q[-1]).all()
    assert [len(motion.q) for motion in found.motions if motion.name.startswith("hold")] == [500, 500, 400]


@settings(max_examples=15, deadline=None)
@given(st.integers(1, 20))
def test_a_longer_period_takes_every_so_many_th_set_point_and_each_motion_ends_where_it_ends(milliseconds: int) -> None:
    for coarse, fine in zip(at(milliseconds).motions, at().motions, strict=True):
        np.testing.assert_array_equal(coarse.q[-1], fine.q[-1])
        skipped = milliseconds if fine is at().motions[0] else 0
        first = 0 if skipped else milliseconds - 1
        inner = fine.q[first::milliseconds]
        np.testing.assert_array_equal(coarse.q[: len(inner)], inner)
        assert len(coarse.q) - len(inner) in (0, 1)


@settings(max_examples=6, deadline=None)
@given(st.sampled_from([1, 2, 4, 5, 8, 12]))
def test_no_corner_is_faster_than_the_slow_limit_and_no_joint_than_its_own(milliseconds: int) -> None:
    """By finite differences of the set points, corners by the kinematics of the tests' own checker."""
    cell, robot, collision, _ = planned()
    found = at(milliseconds)
    rows = all_rows(found)
    checked = IndependentChecker(cell, cell.payload_box).check(rows, found.period_s)
    assert checked.speed_m_s <= SLOW_M_S * (1.0 + 1e-3)
    assert checked.speed_m_s > 0.5 * SLOW_M_S
    velocity = MotionLimits.of_cell(cell, robot, collision).velocity
    assert (np.abs(np.diff(rows, axis=0)) / found.period_s <= velocity * (1.0 + 1e-6)).all()


@pytest.mark.parametrize("ending", [".csv", ".json"])
def test_the_file_says_every_set_point_with_its_time_motion_and_joint(tmp_path: Path, ending: str) -> None:
    file, found = tmp_path / f"plan{ending}", at(8)
    write_set_points(file, found)
    if ending == ".csv":
        head, *rows = list(csv.reader(file.read_text().splitlines()))
        assert head == ["time_s", "motion", *(f"{joint}_rad" for joint in found.joints)]
        q = np.array([[float(value) for value in row[2:]] for row in rows])
        motions = [row[1] for row in rows]
        np.testing.assert_allclose([float(row[0]) for row in rows], 0.008 * np.arange(len(rows)), atol=1e-6)
    else:
        told = json.loads(file.read_text())
        assert (told["cell"], told["joints"], told["period_s"]) == (found.cell, list(found.joints), 0.008)
        q = np.concatenate([motion["q_rad"] for motion in told["motions"]])
        motions = [motion["name"] for motion in told["motions"] for _ in motion["q_rad"]]
        assert [motion["start_s"] for motion in told["motions"]] == pytest.approx([motion.start_s for motion in found.motions])
    np.testing.assert_allclose(q, all_rows(found), atol=1e-9)
    assert motions == [motion.name for motion in found.motions for _ in motion.q]
    assert list(tmp_path.iterdir()) == [file]


@pytest.mark.parametrize("period_s", [0.0, -0.001, 0.0005, 0.0015, 0.2, float("nan"), float("inf")])
def test_a_period_that_is_no_multiple_of_the_plans_is_refused(period_s: float) -> None:
    with pytest.raises(BadInput, match=r"a multiple of 0\.001 s"):
        check_set_points(Path("plan.csv"), period_s, 0.001)


@pytest.mark.parametrize(
    ("file", "period_s", "expected"),
    [
        (Path("plan.txt"), None, "ends with .csv or .json"),
        (Path("no/such/folder/plan.csv"), None, "an existing folder"),
        (None, 0.008, "--trajectory FILE"),
    ],
)
def test_a_file_that_cannot_be_written_is_refused_before_anything_is_planned(
    file: Path | None, period_s: float | None, expected: str
) -> None:
    with pytest.raises(BadInput, match=expected):
        check_set_points(file, period_s, 0.001)
