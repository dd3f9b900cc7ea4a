from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.planning.candidate_checks import Attitude
from core.planning.link_room import LinkRoom
from core.planning.start_configuration import Grid, find_start_configuration
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel

ROOT = Path(__file__).parents[3]
DIAMETER = 2.0


def room_of(cell: Cell) -> LinkRoom:
    robot = RobotModel.of_cell(cell)
    return LinkRoom(robot, CollisionModel(cell, robot, cell.payload_box), (robot.lower, robot.upper), DIAMETER)


def postures(cell: Cell, count: int, seed: int) -> np.ndarray:
    robot = RobotModel.of_cell(cell)
    return np.random.default_rng(seed).uniform(robot.lower, robot.upper, (count, robot.n))


def test_the_distance_of_each_link_is_what_another_library_finds(cell, fcl_scene):
    room, scene = room_of(cell), fcl_scene(cell, cell.payload_box)
    q = postures(cell, 30, seed=4)
    found = room.distances(q)
    assert found.shape == (30, len(room.names)) and "payload" in room.names
    for row, own in zip(q, found, strict=True):
        theirs = scene.to_environment(row)
        for name, distance in zip(room.names, own, strict=True):
            least = min(each for (link, _), each in theirs.items() if link == name)
            assert distance == pytest.approx(least, abs=2e-6) or (distance <= 0.0 and least <= 0.0)


def test_each_link_is_seen_against_the_most_room_that_it_has(cell):
    room = room_of(cell)
    largest = int(np.argmax(room.most))
    at_most = room.normalise(room.most[None])[0]
    np.testing.assert_allclose(at_most, room.most[largest] / DIAMETER)
    half = room.normalise(0.5 * room.most[None])[0]
    np.testing.assert_allclose(half, 0.5 * at_most)
    assert room.normalise(np.full((1, len(room.names)), 100.0)).max() == 1.0


def test_hardly_any_posture_has_more_room_than_the_most(cell):
    room = room_of(cell)
    above = room.distances(postures(cell, 500, seed=5)) > 1.1 * room.most
    assert above.mean() < 0.01


def test_an_upper_arm_that_stays_near_its_table_does_not_hide_the_room_of_the_payload(fcl_scene, monkeypatch):
    cell = load_cell(ROOT / "cells" / "ur5e_line")
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, cell.payload_box)
    scene = fcl_scene(cell, cell.payload_box)

    def room_of_payload(axis: str) -> float:
        home = np.array(cell.robot.home_rad)
        found = find_start_configuration(cell, robot, collision, Attitude.of_axis(axis), seed=0, near=home, grid=Grid(vertices=200))
        return min(distance for (link, _), distance in scene.to_environment(found.q).items() if link == "payload")

    here = [room_of_payload(axis) for axis in ("x+", "y+", "z-")]
    monkeypatch.setattr(LinkRoom, "normalise", lambda _, distances: np.minimum(distances / (2.0 * collision.reach[0]), 1.0))
    as_printed = [room_of_payload(axis) for axis in ("x+", "y+", "z-")]
    assert min(here) > 1.3 * min(as_printed)
