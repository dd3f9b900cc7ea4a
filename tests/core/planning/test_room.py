"""How much room a path is asked to keep, near a tight end of it and far from it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Box, Obstacle, Pose
from core.cell.folder import load_cell
from core.planning.joint_torques import HOLDING_SHARE, JointTorques, even_load
from core.planning.room import Room
from core.planning.throw import ThrowCheck
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.words.message import Message

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


def test_nothing_that_the_joints_cannot_hold_is_on_the_way_and_as_much_as_an_end_asks_for_is() -> None:
    """The load is a mass on a stretched arm that turns about a level axis: the lever is read off the pose."""
    cell = load_cell(ROOT / "cells" / "lwr4_bench").model_copy(update={"zones": (), "obstacles": ()})
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, cell.payload_box)
    torques = JointTorques(cell, robot, even_load(cell.payload_box, 5.0, Message.of("planning-load-guessed")))
    upright = np.zeros(robot.n)
    turned = np.array([upright + angle * np.eye(robot.n)[1] for angle in (0.2, 0.5, 0.9)])
    shares = np.array([torques.holding_share(row[None]) for row in turned])
    lever = np.linalg.norm(robot.sensor_poses(turned).position[:, :2], axis=1)
    assert (np.diff(shares) > 0.0).all()
    assert (np.diff(lever) > 0.0).all()
    as_strong = _Torques(torques, 0.999 * HOLDING_SHARE / shares[1])
    room = Room(robot, collision, ThrowCheck(cell), turned[:1], 0.001, as_strong)
    assert [room.has(row) for row in turned] == [True, True, False]
    assert not room.has_all(turned[[0, 2]])
    assert room.has_all(turned[:2])
    beyond = Room(robot, collision, ThrowCheck(cell), turned[[0, 2]], 0.001, as_strong)
    assert beyond.has_all(turned[[0, 2]])


class _Torques:
    """The same joints, stronger or weaker."""

    def __init__(self, torques: JointTorques, times: float) -> None:
        self._torques, self._times = torques, times

    def holding_share(self, q: np.ndarray) -> float:
        return self._times * self._torques.holding_share(q)
