"""The small version of `bench.real_robots`, and that its cells are what they should be."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest

from bench.independent_search import IndependentSearch
from bench.real_robots import Judgement, judge, summary
from core.cell.cell import Box, Obstacle, Pose, Zone
from core.cell.folder import load_cell
from core.cell.urdf import check_urdf
from tests.independent_checker import IndependentChecker
from tests.real_robots import ROBOTS, SENSOR, random_real_cell, robot_folder

CELLS = Path(__file__).parents[3] / "cells"


@pytest.mark.parametrize("robot", ROBOTS)
def test_a_description_becomes_a_robot_that_can_be_read(robot: str, tmp_path: Path) -> None:
    folder = robot_folder(robot, tmp_path / robot)
    text = (folder / "robot.urdf").read_text()
    urdf = check_urdf(text, "robot.urdf")
    urdf.check_bodies(ROBOTS[robot].base, SENSOR)
    urdf.check_meshes(folder)
    moved = {hinge.child for hinge in urdf.hinges(ROBOTS[robot].base, SENSOR)}
    assert len(moved) in (6, 7)
    with_body = {link.get("name") for link in ET.fromstring(text).findall("link") if link.find("collision") is not None}
    assert moved <= with_body


@pytest.mark.parametrize(
    ("robot", "seed"), [("tiago", 0), *(pytest.param(*each, marks=pytest.mark.thorough) for each in (("ur10", 1), ("z1", 2)))]
)
def test_a_random_cell_is_free_at_home_and_always_the_same(robot: str, seed: int, tmp_path: Path) -> None:
    cell = random_real_cell(robot, seed, tmp_path / "first")
    again = random_real_cell(robot, seed, tmp_path / "second")
    assert again.model_dump() == cell.model_dump()
    checker = IndependentChecker(cell, cell.payload_box, cell.payloads["random"])
    home = np.array([cell.robot.home_rad])
    assert checker.check(home.repeat(3, axis=0), 0.001).too_close_m == {}


@pytest.mark.parametrize("robot", ["panda", *(pytest.param(robot, marks=pytest.mark.thorough) for robot in ("ur5", "kinova", "tiago"))])
def test_a_real_robot_is_planned_without_violation_or_cannot_be_planned(robot: str) -> None:
    judgement = judge(robot, 0, candidates=300)
    assert judgement.violations == ()
    assert not (judgement.refusal and judgement.solvable), judgement.line


@pytest.mark.thorough
def test_an_arm_that_finds_a_centimetre_of_room_nowhere_is_planned_with_less() -> None:
    """Between its own bodies: Talos with a box that reaches back beside the wrist."""
    judgement = judge("talos", 4)
    assert judgement.refusal == ""
    assert judgement.violations == ()
    assert 0.0 < judgement.least_margin_m < 0.01


def test_the_search_tells_what_can_be_solved_from_what_cannot() -> None:
    """A tool 0.8 m long under a zone 1.05 m above the floor: it can lie, but neither stand nor hang."""
    cell = load_cell(CELLS / "lwr4_bench")
    ceiling = Zone(name="ceiling", shape=Box(size_m=(4.0, 4.0, 0.5), pose=Pose(xyz_m=(0.0, 0.0, 1.3))))
    bench = Obstacle(name="bench", shape=Box(size_m=(4.0, 4.0, 0.1), pose=Pose(xyz_m=(0.0, 0.0, -0.05))))
    tool = Box(size_m=(0.1, 0.1, 0.8), pose=Pose(xyz_m=(0.0, 0.0, 0.4)))
    home = cell.robot.model_copy(update={"home_rad": (0.0, -0.7, 0.0, -1.4, 0.0, 1.2, 0.0)})
    low = cell.model_copy(update={"zones": (ceiling,), "obstacles": (bench,), "robot": home})
    assert not IndependentSearch(low, tool, None, candidates=60).answer("z-").reachable
    open_above = cell.model_copy(update={"zones": (), "obstacles": (bench,), "robot": home})
    assert IndependentSearch(open_above, open_above.payload_box, None, candidates=300).answer("x-").reachable


def test_the_summary_counts_what_matters() -> None:
    solved, bad = Judgement("a", 0, 1.0), Judgement("a", 1, 3.0, violations=("through the floor",))
    lost, hopeless = Judgement("b", 2, 2.0, "NoPath: none"), Judgement("b", 3, 2.0, "BadCell: no", solvable=False)
    text = summary([solved, bad, lost, hopeless])
    assert "violations         1 in 2 plans" in text
    assert "solved / solvable  2 / 3 = 66.7 %" in text.replace("%", " %").replace("  %", " %")
    assert "SOLVABLE" in lost.line
    assert "VIOLATION through the floor" in bad.line
