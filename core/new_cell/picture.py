"""A picture of a new cell: the robot at home as its shapes are checked, with the payload box, in metres."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib as mpl

mpl.use("Agg")

import numpy as np
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from core.array import Array
from core.report.faces import body_faces, joint_poses, place_faces
from core.robot.bodies import PAYLOAD, Body
from core.robot.model import RobotModel
from core.words.catalogue import find_language
from core.words.message import Message

BASE, LINKS, TOOL, LOAD, FLOOR = "#8a8f98", ("#4f79a7", "#7fa3c7"), "#59a14f", "#e8963c", "#d9d9d9"
LIGHT = np.array([0.4, -0.5, 0.77])
VIEW = {"elev": 22.0, "azim": -58.0}
DPI = 130
FLOOR_SHOWN = 0.5  # times the robot's height below it


def draw_home(file: Path, robot: RobotModel, bodies: list[Body], q: Array, *, tool: tuple[str, ...], floor_z: float, name: str) -> None:
    """Writes a PNG, with words in the language of the terminal.

    Args:
        bodies: of the links, and the payload box.
        q: (n,), rad. tool: links behind the sensor. floor_z: in the world, m. name: of the cell.
    """
    poses = joint_poses(robot, q)
    figure = Figure(figsize=(7.0, 7.0))
    axes: Any = figure.add_subplot(projection="3d")
    points = []
    for body in bodies:
        faces = place_faces(place_faces(body_faces(body.geometry), body.placement.rotation, body.placement.translation), *poses[body.joint])
        points += faces
        for corners_each in sorted({len(face) for face in faces}):  # matplotlib pads unequal ones with whatever is in memory
            _draw_faces(axes, [face for face in faces if len(face) == corners_each], body, _colour(body, tool))
    corners = np.concatenate(points)
    low, high = corners.min(axis=0), corners.max(axis=0)
    if low[2] - floor_z < FLOOR_SHOWN * (high[2] - low[2]):
        low[2] = min(low[2], floor_z)
    middle, half = 0.5 * (low + high), 0.55 * float((high - low).max())
    if floor_z >= middle[2] - half:
        ground = np.array([[x, y, floor_z] for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]) * [half, half, 1.0] + [*middle[:2], 0.0]
        axes.add_collection3d(Poly3DCollection([ground], facecolors=FLOOR, alpha=0.35, zorder=-1), autolim=False)
    _draw_frame(axes, robot.sensor_pose(q).rotation, robot.sensor_pose(q).position, 0.2 * half)
    for setter, value in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), middle, strict=True):
        setter(value - half, value + half)
    axes.set_box_aspect((1, 1, 1))
    figure.subplots_adjust(left=0.0, right=0.94, bottom=0.05, top=0.94)
    axes.view_init(**VIEW)
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    axes.set_zlabel("z (m)")
    language = find_language()
    axes.set_title(Message.of("newcell-picture", name=name).say(language))
    figure.text(0.5, 0.02, Message.of("newcell-picture-colours").say(language), ha="center", fontsize=8)
    figure.savefig(file, dpi=DPI, metadata={"Software": None})


def _draw_faces(axes: Any, faces: list[Array], body: Body, colour: str) -> None:
    is_load = body.name == PAYLOAD
    shades = np.clip(np.array(mpl.colors.to_rgb(colour)) * _shades(faces)[:, None], 0.0, 1.0)
    axes.add_collection3d(
        Poly3DCollection(
            faces,
            facecolors=np.column_stack([shades, np.full(len(faces), 0.25 if is_load else 1.0)]),
            edgecolors=mpl.colors.to_rgba(LOAD, 0.9) if is_load else "none",
            linewidths=0.8,
        ),
        autolim=False,
    )


def _colour(body: Body, tool: tuple[str, ...]) -> str:
    if body.name == PAYLOAD:
        return LOAD
    if body.name in tool:
        return TOOL
    return BASE if body.joint == 0 else LINKS[body.joint % 2]


def _shades(faces: list[Array]) -> Array:
    """(n_faces,), how much of the light each face gets."""
    normals = np.array([np.cross(face[1] - face[0], face[2] - face[0]) for face in faces])
    lengths = np.linalg.norm(normals, axis=1)
    return np.asarray(0.75 + 0.3 * (normals @ LIGHT) / np.maximum(lengths, 1e-12))


def _draw_frame(axes: Any, rotation: Array, origin: Array, length: float) -> None:
    for axis, colour in zip(rotation.T, ("#d62728", "#2ca02c", "#1f77b4"), strict=True):
        end = origin + length * axis
        axes.plot(*np.column_stack([origin, end]), color=colour, linewidth=2.0, zorder=10)
