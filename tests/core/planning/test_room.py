"""How much room a path is asked to keep, near a tight end of it and far from it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Box, Obstacle, Pose
from core.cell.folder import load_cell
from core.planning.room import Room
from core.planning.throw import ThrowCheck
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel

ROOT = Path(__file__).parents[3]
WANTED_M = 0.03


def test_beside_a_tight_start_half_of_its_room_is_asked_for_and_more_the_farther_the_path_has_come(fcl_scene) -> None:
    cell = load_cell(ROOT / "cells" / "lwr4_bench")
    pillar = Obstacle(name="pillar", shape=Box(size_m=(0.1, 0.1, 3.0), pose=Pose(xyz_m=(0.0, 0.6, 0.75))))
    cell = cell.model_copy(update={"obstacles": (pillar,), "zones": ()})
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, cell.payload_box)
    away = np.eye(robot.n)[0]
    start = np.array(cell.robot.home_rad) + 1.24 * away
    least = min(d for (link, _), d in fcl_scene(cell, cell.payload_box).to_environment(start).items() if link not in ("base", "link1"))
    margin = least - cell.limits.clearance_m
    assert 0.005 < margin < WANTED_M
    room = Room(robot, collision, ThrowCheck(cell), start[None], WANTED_M)
    asked = np.array([room.spare(start - turned * away) for turned in (0.0, 0.05, 0.1, 0.2, 1.0)])
    assert asked[0] == pytest.approx(0.5 * margin, abs=2e-6)
    assert (np.diff(asked[:4]) > 0.001).all()
    assert asked[-1] == WANTED_M
