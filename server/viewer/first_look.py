"""From where a cell is looked at: first, and from the sides that have a name; the arm fills the picture, and little stands before it."""

from __future__ import annotations

from itertools import product

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.cell.cell import Cell
from core.report.faces import Faces, arm_faces, standing_faces
from core.robot.model import RobotModel
from server.viewer.wish import Look

AROUND_RAD = np.deg2rad(np.arange(-180.0, 180.0, 15.0) + 45.0)
DOWN_RAD = np.deg2rad([25.0, 40.0, 55.0])
AWAY = 2.0
"""Distance of the eye, times the arm's size."""
POINTS = 60
"""Of the arm, to which lines of sight are drawn."""
VEIL = 0.4
"""What a zone hides, through which the arm is seen, against what an obstacle does."""
FIELD_OF_VIEW_RAD = 0.8
"""Of the camera, from the lower to the upper edge of the picture."""
EYE_HEIGHT_M = 1.6
"""Of somebody who stands on the floor."""
FULL = 0.9
"""Distance at which what is looked at fills the picture, against that at which a ball around it does."""
ALMOST = 0.02
"""By how much a look from above is off the vertical, so that it has a side that is up."""


def first_look(cell: Cell, robot: RobotModel) -> tuple[Array, Array]:
    """Where the eye is, and what it looks at, (3,) each, m, world frame, with the robot at home."""
    arm = np.concatenate(arm_faces(cell, robot, np.array(cell.robot.home_rad)))
    low, high = arm.min(axis=0), arm.max(axis=0)
    middle, size = 0.5 * (low + high), float(np.linalg.norm(high - low))
    seen = select_points(arm)
    eyes = [middle + AWAY * size * _direction(around, down) for down, around in product(DOWN_RAD, AROUND_RAD)]
    return min(eyes, key=lambda eye: measure_occlusion(cell, eye, seen)), middle


def find_eye(cell: Cell, look: Look, points: Array, aspect: float, toward: Array) -> tuple[Array, Array]:
    """Where the eye is so that all points (k, 3) are in the picture, and what it looks at, (3,) each, m, world frame.

    Args:
        aspect: width of the picture by its height.
        toward: (3,), from what is looked at to the eye: for `fit` where it is now, for `reset` where it was at first.
    """
    low, high = points.min(axis=0), points.max(axis=0)
    middle, radius = 0.5 * (low + high), 0.5 * float(np.linalg.norm(high - low))
    half = min(0.5 * FIELD_OF_VIEW_RAD, float(np.arctan(aspect * np.tan(0.5 * FIELD_OF_VIEW_RAD))))
    distance = FULL * radius / np.sin(half)
    forward = cell.robot.base.rotation @ np.array([1.0, 0.0, 0.0])
    match look:
        case "front":
            toward = _level(forward)
        case "top":
            toward = np.array([0.0, 0.0, 1.0]) + ALMOST * _level(forward)
        case "operator":
            people = cell.zones[0].shape.pose.translation - middle if cell.zones else forward
            rise = cell.floor_z_m + EYE_HEIGHT_M - middle[2]
            toward = _level(people) * np.sqrt(max(distance**2 - rise**2, (0.5 * distance) ** 2)) + np.array([0.0, 0.0, rise])
    return middle + distance * toward / np.linalg.norm(toward), middle


def measure_occlusion(cell: Cell, eye: Array, points: Array) -> float:
    """Lines of sight from the eye (3,) to points (k, 3) that the cell's bodies cross, on average; a zone counts less."""
    weights = {it.name: 1.0 for it in cell.obstacles} | {it.name: VEIL for it in cell.zones}
    hidden = {name: np.any([find_occluded(part, eye, points) for part in parts], axis=0) for name, parts in standing_faces(cell).items()}
    return float(sum(weight * hidden[name].mean() for name, weight in weights.items()))


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


def select_points(corners: Array) -> Array:
    """Some of many corners (k, 3), to which lines of sight are drawn."""
    return corners[:: max(1, len(corners) // POINTS)]


def _direction(around: float, down: float) -> Array:
    return np.array([np.cos(down) * np.cos(around), np.cos(down) * np.sin(around), np.sin(down)])


def _level(toward: Array) -> Array:
    """The direction (3,) with nothing of it up or down; along x where nothing is left."""
    level = np.array([toward[0], toward[1], 0.0])
    length = float(np.linalg.norm(level))
    return level / length if length > 1e-6 else np.array([1.0, 0.0, 0.0])
