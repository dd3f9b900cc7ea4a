"""From where a cell is looked at first: the arm fills the picture, and as little as can be stands before it."""

from __future__ import annotations

from itertools import product

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.cell.cell import Cell
from core.report.faces import Faces, arm_faces, shape_faces
from core.robot.model import RobotModel

AROUND_RAD = np.deg2rad(np.arange(-180.0, 180.0, 15.0) + 45.0)
DOWN_RAD = np.deg2rad([25.0, 40.0, 55.0])
AWAY = 2.0
"""Distance of the eye, times the arm's size."""
POINTS = 60
"""Of the arm, to which lines of sight are drawn."""
VEIL = 0.4
"""What a zone hides, through which the arm is seen, against what an obstacle does."""


def first_look(cell: Cell, robot: RobotModel) -> tuple[Array, Array]:
    """Where the eye is, and what it looks at, (3,) each, m, world frame, with the robot at home."""
    arm = np.concatenate(arm_faces(cell, robot, np.array(cell.robot.home_rad)))
    low, high = arm.min(axis=0), arm.max(axis=0)
    middle, size = 0.5 * (low + high), float(np.linalg.norm(high - low))
    seen = arm[:: max(1, len(arm) // POINTS)]
    eyes = [middle + AWAY * size * _direction(around, down) for down, around in product(DOWN_RAD, AROUND_RAD)]
    return min(eyes, key=lambda eye: measure_occlusion(cell, eye, seen)), middle


def measure_occlusion(cell: Cell, eye: Array, points: Array) -> float:
    """Lines of sight from the eye (3,) to points (k, 3) that the cell's bodies cross, on average; a zone counts less."""
    weights = [(it.shape, 1.0) for it in cell.obstacles] + [(it.shape, VEIL) for it in cell.zones]
    return float(sum(weight * find_occluded(shape_faces(shape), eye, points).mean() for shape, weight in weights))


def find_occluded(faces: Faces, eye: Array, points: Array) -> NDArray[np.bool_]:
    """(k,), whether the lines from the eye to points (k, 3) go through a convex body."""
    normals = np.array([np.cross(face[1] - face[0], face[2] - face[1]) for face in faces])
    beyond = np.einsum("fj,fj->f", normals, np.array([face[0] for face in faces]))
    at_eye, along = normals @ eye - beyond, (points - eye) @ normals.T
    with np.errstate(divide="ignore", invalid="ignore"):
        share = -at_eye / along
    into = np.where(along < 0.0, share, np.where((along == 0.0) & (at_eye > 0.0), np.inf, 0.0)).max(axis=1)
    out = np.where(along > 0.0, share, 1.0).min(axis=1)
    return np.asarray(np.maximum(into, 0.0) < np.minimum(out, 1.0))


def _direction(around: float, down: float) -> Array:
    return np.array([np.cos(down) * np.cos(around), np.cos(down) * np.sin(around), np.sin(down)])
