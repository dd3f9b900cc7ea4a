"""Shapes as faces: closed, outwards, and of the right volume."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.cell.cell import Capsule, Pose
from core.cell.folder import load_cell
from core.report.faces import (
    Faces,
    arm_faces,
    box_faces,
    capsule_faces,
    cylinder_faces,
    faces_of_points,
    mesh_faces,
    place_faces,
    shape_faces,
    sphere_faces,
)
from core.robot.model import RobotModel

CELLS = Path(__file__).parents[3] / "cells"


def area_vectors(faces: Faces) -> np.ndarray:
    """Half the sum of the cross products of a fan of triangles."""
    return np.array([sum(np.cross(face[k] - face[0], face[k + 1] - face[0]) for k in range(1, len(face) - 1)) / 2 for face in faces])


def volume(faces: Faces) -> float:
    """By the divergence theorem; positive only when the faces look outwards."""
    return float(sum(face.mean(axis=0) @ area for face, area in zip(faces, area_vectors(faces), strict=True)) / 3)


def ball(count: int) -> np.ndarray:
    """(count, 3), vertices of a fine mesh of a ball of radius 0.2 m."""
    points = np.random.default_rng(5).normal(size=(count, 3))
    return 0.2 * points / np.linalg.norm(points, axis=1, keepdims=True)


# a circle of 20 corners has 0.984 of the circle's area, a ball of 20 by 10 faces about 0.95 of the ball's volume
SOLIDS: dict[str, tuple[Callable[[], Faces], float, float]] = {
    "box": (lambda: box_faces(np.array([0.2, 0.3, 0.5])), 0.03, 1e-12),
    "cylinder": (lambda: cylinder_faces(0.1, 0.4), np.pi * 0.004, 0.02),
    "sphere": (lambda: sphere_faces(0.2), 4 / 3 * np.pi * 0.008, 0.06),
    "capsule": (lambda: capsule_faces(0.1, 0.4), np.pi * 0.004 + 4 / 3 * np.pi * 0.001, 0.03),
    "mesh": (lambda: mesh_faces(ball(20_000)), 4 / 3 * np.pi * 0.008, 0.15),
    "hull": (lambda: faces_of_points(np.vstack([np.eye(3), np.zeros(3)])), 1 / 6, 1e-12),
}


@pytest.mark.parametrize("name", SOLIDS)
def test_faces_are_closed_and_enclose_the_volume(name: str) -> None:
    make, expected, tolerance = SOLIDS[name]
    turn = Rotation.from_euler("xyz", [0.3, -0.7, 1.9]).as_matrix()
    for faces in (make(), place_faces(make(), turn, np.array([1.0, -2.0, 0.5]))):
        np.testing.assert_allclose(area_vectors(faces).sum(axis=0), 0, atol=1e-12)
        assert volume(faces) == pytest.approx(expected, rel=tolerance)


def test_a_shape_is_drawn_where_it_stands() -> None:
    shape = Capsule(kind="capsule", radius_m=0.1, length_m=0.4, pose=Pose(xyz_m=(1, 2, 3), rpy_rad=(np.pi / 2, 0, 0)))
    corners = np.concatenate(shape_faces(shape))
    np.testing.assert_allclose(corners.min(axis=0), [0.9, 1.7, 2.9], atol=2e-3)
    np.testing.assert_allclose(corners.max(axis=0), [1.1, 2.3, 3.1], atol=2e-3)


def test_the_arm_is_drawn_up_to_its_sensor() -> None:
    cell = load_cell(CELLS / "lwr4_bench")
    robot = RobotModel.of_cell(cell)
    corners = np.concatenate(arm_faces(cell, robot, np.zeros(7)))
    assert corners[:, 2].max() == pytest.approx(robot.sensor_pose(np.zeros(7)).position[2], abs=1e-3)
    assert corners[:, 2].min() == pytest.approx(0.0, abs=1e-9)
    assert np.abs(corners[:, :2]).max() == pytest.approx(0.085, abs=1e-9)


def test_a_mesh_is_drawn_with_few_faces_however_fine_it_is() -> None:
    fine, coarse = (mesh_faces(ball(count)) for count in (50_000, 500))
    capsule = capsule_faces(0.1, 0.4)
    assert len(fine) <= len(capsule)
    assert len(coarse) <= len(capsule)
    np.testing.assert_array_less(np.linalg.norm(np.concatenate(fine), axis=1), 0.2 + 1e-9)


def test_a_coarse_mesh_keeps_its_corners() -> None:
    corners = np.array(np.meshgrid([-1, 1], [-2, 2], [-3, 3]), dtype=float).reshape(3, -1).T
    assert volume(mesh_faces(np.repeat(corners, 5, axis=0))) == pytest.approx(48.0)


@pytest.mark.parametrize(
    "points", [np.zeros((9, 3)), np.eye(3), np.full((5, 3), np.nan), np.random.default_rng(0).normal(size=(30, 3)) * [1, 1, 0]]
)
def test_a_mesh_without_volume_is_not_drawn(points: np.ndarray) -> None:
    assert mesh_faces(points) == []
