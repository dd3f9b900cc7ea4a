"""Eq. (6): of candidates that differ in their room alone, the roomier is the better one."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Box, Cell, Obstacle, Pose
from core.cell.folder import load_cell
from core.planning.candidates import CandidateSearch, Weights
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel

ROOT = Path(__file__).parents[3]
TURNS = np.array([0.3, 0.5, 0.7, 0.9, 1.1])
"""Of the first joint, rad, from the side of the free space towards the pillar."""


def beside_a_pillar() -> Cell:
    """The arm of the bench with nothing about it but the floor and a pillar at its left."""
    cell = load_cell(ROOT / "cells" / "lwr4_bench")
    pillar = Obstacle(name="pillar", shape=Box(size_m=(0.1, 0.1, 3.0), pose=Pose(xyz_m=(0.0, 0.6, 0.75))))
    return cell.model_copy(update={"obstacles": (pillar,), "zones": ()})


def test_of_candidates_that_differ_in_their_room_alone_the_roomier_is_preferred(fcl_scene) -> None:
    """All of them are one posture turned about the vertical, so that nothing but the distance to the pillar changes."""
    cell = beside_a_pillar()
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, cell.payload_box)
    q = np.tile(cell.robot.home_rad, (len(TURNS), 1))
    q[:, 0] = TURNS
    scene = fcl_scene(cell, cell.payload_box)
    room = np.array([min(d for (link, _), d in scene.to_environment(row).items() if link not in ("base", "link1")) for row in q])
    assert (np.diff(room) < -0.03).all()  # another library finds them ordered so
    limits, diameter = (robot.lower, robot.upper), 2.0 * float(collision.reach[0])
    found = {
        distance: CandidateSearch(
            cell, robot, collision, limits=limits, near=None, diameter=diameter, weights=Weights(distance=distance)
        ).of(q)
        for distance in (0.0, 1.0, 2.0)
    }
    for candidates in found.values():
        np.testing.assert_allclose(candidates.manipulability, candidates.manipulability[0])
        np.testing.assert_allclose(candidates.clearance, room, atol=2e-6)
        np.testing.assert_array_equal(candidates.score, candidates.objective)
    np.testing.assert_allclose(found[0.0].objective, 0.3 / np.linalg.cond(robot.sensor_jacobian(q[0])))
    assert (np.diff(found[1.0].score) < -0.01).all()
    np.testing.assert_allclose(np.diff(found[2.0].score), 2.0 * np.diff(found[1.0].score))
    assert found[1.0].score[0] - found[0.0].score[0] == pytest.approx(0.5 * (found[2.0].score[0] - found[0.0].score[0]))
