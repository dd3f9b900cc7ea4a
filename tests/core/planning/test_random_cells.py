"""The small version of `bench.random_cells`."""

from __future__ import annotations

import numpy as np
import pytest

from bench.brute_force import BruteForce
from bench.random_cells import judge, judge_refusal, summary
from core.cell.cell import Obstacle
from core.payload.shapes import Box, Pose
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from tests.independent_checker import IndependentChecker
from tests.random_cells import RandomCell, random_cell


@pytest.mark.parametrize("seed", [0, 1, *(pytest.param(seed, marks=pytest.mark.thorough) for seed in range(2, 6))])
def test_a_random_cell_is_valid_and_always_the_same(seed: int) -> None:
    drawn = random_cell(seed)
    assert random_cell(seed).cell == drawn.cell
    assert 3 <= len(drawn.cell.obstacles) <= 8
    assert 1 <= len(drawn.cell.zones) <= 3
    assert 0.3 <= drawn.cell.payloads["random"].mass_kg <= 6.0
    checker = IndependentChecker(drawn.cell, drawn.payload_box)
    assert all(margin > 0.0 for margin, _ in checker.margins(np.array(drawn.cell.robot.home_rad)).values())


@pytest.mark.parametrize("seed", [*(pytest.param(seed, marks=pytest.mark.thorough) for seed in (0, 5)), 6])
def test_a_random_cell_is_planned_without_violation(seed: int) -> None:
    judgement = judge(seed)
    assert judgement.violations == ()
    assert judgement.refusal == ""
    assert "solved / solvable       1 / 1" in summary([judgement])


@pytest.mark.parametrize("seed", [0, 1])
def test_the_checker_and_the_engine_agree_on_what_is_too_close(seed: int) -> None:
    drawn = random_cell(seed)
    robot = RobotModel.of_cell(drawn.cell)
    collision = CollisionModel(drawn.cell, robot, drawn.payload_box)
    checker = IndependentChecker(drawn.cell, drawn.payload_box)
    rng = np.random.default_rng(seed)
    home = np.array(drawn.cell.robot.home_rad)
    verdicts = set()
    for _ in range(150):
        q = np.clip(home + rng.normal(0.0, 0.7, robot.n), robot.lower, robot.upper)
        mine, theirs = collision.margin(q), min(margin for margin, _ in checker.margins(q).values())
        assert (mine >= 0.0) <= (theirs >= -1e-6)
        verdicts.add(mine >= 0.0)
    assert verdicts == {True, False}


def test_the_checker_sees_what_is_planted() -> None:
    """A motion through a zone, too fast, past a joint limit."""
    drawn = random_cell(0)
    checker = IndependentChecker(drawn.cell, drawn.payload_box)
    home = np.array(drawn.cell.robot.home_rad)
    there = home.copy()
    there[0] = 3.1
    q = home + np.sin(np.linspace(0.0, np.pi / 2, 2000))[:, None] ** 2 * (there - home)
    found = " ".join(checker.check(q, 0.001).violations)
    assert "beyond its position limit" in found
    assert "m/s, allowed 0.25 m/s" in found
    assert checker.check(np.tile(home, (50, 1)), 0.001).violations == []


def test_skipping_samples_gives_the_verdict_of_looking_at_all() -> None:
    drawn = random_cell(2)
    checker = IndependentChecker(drawn.cell, drawn.payload_box)
    home = np.array(drawn.cell.robot.home_rad)
    rng = np.random.default_rng(1)
    verdicts = []
    for _ in range(12):
        q = home + np.linspace(0.0, 1.0, 60)[:, None] * rng.normal(0.0, 0.4, len(home))
        every = min(margin for row in q for margin, _ in checker.margins(row).values())
        skipping = checker.check(q, 0.1).least_margin_m
        assert (every < 0.0) == (skipping < 0.0)
        verdicts.append(every < 0.0)
    assert set(verdicts) == {True, False}


def low_cell() -> RandomCell:
    """A tool 0.8 m long under a ceiling 1.05 m above the floor: it can lie, but neither stand nor hang."""
    drawn = random_cell(0)
    floor = Obstacle(name="floor", shape=Box(size_m=(4.0, 4.0, 0.1), pose=Pose(xyz_m=(0.0, 0.0, -0.05))))
    ceiling = Obstacle(name="ceiling", shape=Box(size_m=(4.0, 4.0, 0.5), pose=Pose(xyz_m=(0.0, 0.0, 1.3))))
    tool = Box(size_m=(0.1, 0.1, 0.8), pose=Pose(xyz_m=(0.0, 0.0, 0.4)))
    robot = drawn.cell.robot.model_copy(update={"home_rad": (0.0, -0.7, 0.0, -1.4, 0.0, 1.2, 0.0)})
    return RandomCell(0, drawn.cell.model_copy(update={"zones": (), "obstacles": (floor, ceiling), "robot": robot}), tool)


def test_brute_force_tells_what_can_be_solved_from_what_cannot() -> None:
    drawn = low_cell()
    search = BruteForce(drawn.cell, drawn.payload_box, candidates=100)
    assert search.answer("x-").reachable
    assert search.answer("z-").poses == 0


@pytest.mark.thorough
def test_a_refusal_is_confirmed_only_when_it_blames_the_right_axis() -> None:
    true = judge_refusal(low_cell(), "no room", ("z-",), 0.0, candidates=100)
    false = judge_refusal(low_cell(), "no room", ("x-",), 0.0, candidates=100)
    assert (true.confirmed, false.confirmed) == (True, False)
    assert not true.solvable
    assert not false.solvable  # another axis has no solution
    assert "wrong reason" in false.line
    assert "refused, reason held    1 / 2" in summary([true, false])
