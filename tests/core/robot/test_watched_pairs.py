"""Which pairs are watched is held against distances of another library, at joint positions that the rules have not looked at."""

from __future__ import annotations

import numpy as np
import pytest

from core.cell.cell import Box, Cell, Limits, Obstacle, Pose, Zone
from core.cell.folder import load_cell
from core.errors import BadCell, NoRoomAtHome
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.watched_pairs import CONTACT_M
from core.words.message import Message
from tests.core.conftest import ROOT

UR5E = load_cell(ROOT / "cells" / "ur5e_line")
BELONG = ("robot-pair-no-joint-between", "robot-pair-neighbours", "robot-pair-declared")


def model_of(cell: Cell, box: Box | None = None) -> CollisionModel:
    return CollisionModel(cell, RobotModel.of_cell(cell), box or cell.payload_box)


def names(collision: CollisionModel, group: int) -> set[tuple[str, str]]:
    return {(first.name, second.name) for first, second in collision.pairs[group]}


def left_out(collision: CollisionModel) -> dict[tuple[str, str], Message]:
    return {(pair.first, pair.second): pair.why for pair in collision.left_out}


def random_q(collision: CollisionModel, count: int, seed: int) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return rng.uniform(collision.robot.lower, collision.robot.upper, (count, collision.robot.n))


def test_every_pair_is_watched_or_left_out_for_a_reason(cell):
    collision = model_of(cell)
    groups = [*(names(collision, k) for k in range(2)), set(left_out(collision))]
    bodies = {body.name for group in collision.pairs for pair in group for body in pair if body.joint > 0}
    things = [*(item.name for item in (*cell.obstacles, *cell.zones)), "floor"]
    wanted = {frozenset((body, thing)) for body in bodies for thing in things}
    wanted |= {frozenset((a, b)) for a in bodies for b in bodies | {"base"} if a != b}
    assert {frozenset(pair) for group in groups for pair in group} == wanted
    assert sum(len(group) for group in groups) == len(wanted)


def test_bodies_of_the_arm_that_are_left_out_never_touch_where_they_do_not_belong_together(cell, fcl_scene):
    collision, scene = model_of(cell), fcl_scene(cell, cell.payload_box)
    things = {*(item.name for item in (*cell.obstacles, *cell.zones)), "floor"}
    found = [pair for pair, why in left_out(collision).items() if pair[1] not in things and why.code not in BELONG]
    assert found
    for q in random_q(collision, 150, seed=3):
        assert all(scene.between(q, *pair) > 0.9 * CONTACT_M for pair in found)


def test_a_payload_box_that_reaches_back_into_the_wrist_is_refused_with_the_link_and_what_would_change_it(cell):
    box = Box(size_m=(0.1, 0.1, 0.5), pose=Pose(xyz_m=(0.04, 0.0, -0.1)))
    with pytest.raises(NoRoomAtHome, match=r'tool\'s box reaches 0\.\d+ m into "\w+" at home\. Make the box smaller, choose another tool'):
        model_of(cell, box)


def test_a_payload_beside_the_wrist_is_watched_against_the_link_next_to_the_last(cell, fcl_scene):
    box = Box(size_m=(0.03, 0.03, 0.16), pose=Pose(xyz_m=(0.25, 0.0, -0.06)))
    collision, scene = model_of(cell, box), fcl_scene(cell, box)
    last = max(body.joint for body, _ in collision.pairs[0])
    unwatched = {second for (first, second) in left_out(collision) if first == "payload"}
    near = [second for first, second in collision.pairs[1] if first.name == "payload" and second.joint >= last - 2]
    for q in random_q(collision, 150, seed=4):
        for body in near:
            margin = scene.between(q, "payload", body.name) - cell.limits.self_clearance_m
            assert (collision.margin(q) > 1e-6) <= (margin > 0.0)
        assert all(scene.between(q, "payload", second) > 0.0 for second in unwatched)


def test_the_floor_is_an_obstacle(cell, fcl_scene):
    alone = cell.model_copy(update={"obstacles": (), "zones": (), "floor_z_m": float(cell.robot.base.translation[2])})
    collision, scene = model_of(alone), fcl_scene(alone, cell.payload_box)
    watched = [first for first, second in names(collision, 0) if second == "floor"]
    assert "payload" in watched
    for q in random_q(collision, 60, seed=6):
        heights = {first: height for (first, second), height in scene.to_environment(q).items() if first in watched}
        nearest = collision.obstacle_distance(q)
        assert nearest.second == "floor"
        assert nearest.distance_m == pytest.approx(min(heights.values()), abs=1e-6)
        assert not collision.is_free(q) or min(heights.values()) > alone.limits.clearance_m


def test_what_the_robot_is_mounted_on_may_be_near_its_first_links_but_a_zone_may_not():
    near = UR5E.model_copy(update={"zones": (), "limits": Limits(clearance_m=0.1)})
    table = Obstacle(name="table", shape=Box(size_m=(0.4, 0.4, 0.1), pose=Pose(xyz_m=(0.0, 0.0, -0.05))))
    collision = model_of(near.model_copy(update={"obstacles": (table,)}))
    assert left_out(collision)["shoulder", "table"].code == "robot-pair-mounted-there"
    assert ("forearm", "table") in names(collision, 0)
    zone = Zone(name="table", shape=table.shape)
    with pytest.raises(BadCell, match=r"'shoulder' 0\.\d+ m from 'table'"):
        model_of(near.model_copy(update={"obstacles": (), "zones": (zone,)}))


def test_what_is_declared_adjacent_is_left_out_and_told(cell):
    pair = next((a.name, b.name) for a, b in model_of(cell).pairs[1] if not a.carried)
    robot = cell.robot.model_copy(update={"adjacent": (pair[::-1],)})
    collision = model_of(cell.model_copy(update={"robot": robot}))
    assert pair not in names(collision, 1)
    assert left_out(collision)[pair].code == "robot-pair-declared"
