"""The bound against the distances that it stands in for, and the order of candidates against that of all distances."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Capsule, Cylinder, Obstacle, Pose, Sphere
from core.cell.folder import load_cell
from core.planning.candidates import CandidateSearch, Weights
from core.planning.link_room import LinkRoom
from core.planning.room_bound import RoomBound
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel

ROOT = Path(__file__).parents[3]
BALL = Sphere(kind="sphere", radius_m=0.15, pose=Pose(xyz_m=(0.5, -0.6, 0.7)))
PIPE = Cylinder(kind="cylinder", radius_m=0.1, length_m=0.8, pose=Pose(xyz_m=(-0.7, 0.2, 0.6), rpy_rad=(0.4, 1.0, 0.2)))
RAIL = Capsule(kind="capsule", radius_m=0.05, length_m=0.9, pose=Pose(xyz_m=(0.1, 0.8, 0.5), rpy_rad=(1.2, 0.0, 0.3)))
ROUND_THINGS = tuple(Obstacle(name=name, shape=shape) for name, shape in (("ball", BALL), ("pipe", PIPE), ("rail", RAIL)))


@pytest.fixture(scope="module", params=["lwr4_bench", "ur5e_line"])
def scene(request):
    cell = load_cell(ROOT / "cells" / request.param)
    cell = cell.model_copy(update={"obstacles": (*cell.obstacles, *ROUND_THINGS)})
    robot = RobotModel.of_cell(cell)
    return cell, robot, CollisionModel(cell, robot, cell.payload_box)


def draw(robot: RobotModel, count: int, seed: int) -> np.ndarray:
    return np.random.default_rng(seed).uniform(robot.lower, robot.upper, (count, robot.n))


def least_of(robot: RobotModel, collision: CollisionModel, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The bound, and what it bounds."""
    room = LinkRoom(robot, collision, (robot.lower, robot.upper), 2.0)
    return RoomBound(robot.chain, collision, room).least(q), room.normalise(room.distances(q)).min(axis=1)


def test_no_configuration_has_more_room_than_its_bound_says(scene):
    _, robot, collision = scene
    bound, exact = least_of(robot, collision, draw(robot, 400, 3))
    assert (bound >= exact).all()
    assert np.median(bound - exact) < 0.1 * np.ptp(exact)  # so tight that it can tell candidates apart


def test_what_has_moved_counts_where_it_is_now(scene):
    cell, robot, _ = scene
    q = draw(robot, 200, 4)
    collision = CollisionModel(cell, robot, cell.payload_box)
    before, _ = least_of(robot, collision, q)
    zone = cell.zones[0]
    x, y, z = zone.shape.pose.xyz_m
    collision.move(zone.name, zone.shape.pose.model_copy(update={"xyz_m": (0.5 * x, 0.5 * y, z)}))
    after, exact = least_of(robot, collision, q)
    assert (after >= exact).all() and (after < before - 0.01).any()


def test_candidates_are_ranked_as_if_all_distances_were_known_but_few_are_computed(scene):
    cell, robot, collision = scene
    q = draw(robot, 300, 5)
    search = CandidateSearch(cell, robot, collision, limits=(robot.lower, robot.upper), near=q[0], diameter=2.0, weights=Weights())
    whole = search.of(q)
    best_first = np.argsort(-whole.score, kind="stable")
    np.testing.assert_array_equal(list(whole.rank()), best_first)
    late = search._evaluate(q, np.zeros(len(q), dtype=np.intp), len(q))
    ranked = late.rank()
    assert [next(ranked) for _ in range(5)] == best_first[:5].tolist()
    assert np.isfinite(late.score).sum() < 0.4 * len(q)
    above = float(whole.score[best_first[20]])
    np.testing.assert_array_equal(list(search._evaluate(q, np.zeros(len(q), dtype=np.intp), len(q)).rank(above)), best_first[:20])
