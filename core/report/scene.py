"""The cell with the robot in one configuration as an SVG picture: parallel projection, painter's algorithm, shading.

Grey only; lines and letters take the page's colours, so that the picture fits a light, a dark and a printed page.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from html import escape
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.cell.cell import Box, Cell
from core.cell.tools import tool_boxes
from core.planning.start_configuration import StartConfiguration
from core.report.faces import Faces, Part, arm_faces, box_faces, place_faces, standing_faces
from core.robot.model import RobotModel, SensorPose
from core.words.wording import ENGLISH, Wording

WIDTH, HEIGHT, MARGIN = 360, 330, 14  # px
ELEVATION = np.radians(24.0)
LIGHT = np.array([0.35, -0.45, 0.82]) / np.linalg.norm([0.35, -0.45, 0.82])
ARROW_M = 0.28
AZIMUTHS = np.radians([-150.0, -120.0, -60.0, -30.0, 30.0, 60.0, 120.0, 150.0])  # never straight onto a wall

Thing = tuple[str, str, Faces]
"""Name, "obstacle" or "zone", and faces in the world."""


@dataclass(frozen=True)
class Projection:
    """A parallel projection onto the picture.

    Args:
        azimuth: direction from which one looks, rad about the world's z.
        low, high: (3,), corners of the part of the world that is to be seen, m.
    """

    azimuth: float
    low: Array
    high: Array

    @cached_property
    def axes(self) -> Array:
        """(3, 3), rows: right, up, towards the viewer."""
        ca, sa, ce, se = np.cos(self.azimuth), np.sin(self.azimuth), np.cos(ELEVATION), np.sin(ELEVATION)
        return np.array([[-sa, ca, 0.0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]])

    @cached_property
    def _frame(self) -> tuple[float, Array]:
        """Scale in px/m and the centre in projected coordinates."""
        corners = np.array(np.meshgrid(*np.column_stack([self.low, self.high]))).reshape(3, -1).T @ self.axes[:2].T
        low, high = corners.min(axis=0), corners.max(axis=0)
        room = np.array([WIDTH, HEIGHT]) - 2 * MARGIN
        return float(np.min(room / (high - low))), 0.5 * (low + high)

    def pixels(self, points: Array) -> Array:
        """(k, 2), px, of points (k, 3)."""
        scale, centre = self._frame
        right_up = (np.atleast_2d(points) @ self.axes[:2].T - centre) * scale
        return np.asarray(right_up * [1, -1] + [WIDTH / 2, HEIGHT / 2])


def scene(
    cell: Cell,
    robot: RobotModel,
    payload_box: Box,
    start: StartConfiguration,
    robot_parts: list[Part] | None = None,
    words: Wording = ENGLISH,
) -> str:
    """SVG of the robot in a start configuration among obstacles and zones, with the sensor's axes and the throw.

    Args:
        payload_box: in the sensor frame.
        robot_parts: as `arm_parts` reads them, for who draws more than one scene.
    """
    sensor = robot.sensor_pose(start.q)
    carried = (payload_box, *tool_boxes(cell).values())
    boxes = [place_faces(box_faces(np.array(box.size_m)), box.pose.rotation, box.pose.translation) for box in carried]
    arm = arm_faces(cell, robot, start.q, robot_parts)
    load = [face for box in boxes for face in place_faces(box, sensor.rotation, sensor.position)]
    body = np.concatenate([*arm, *load])
    zones = {zone.name for zone in cell.zones}
    standing = standing_faces(cell)
    things = [(name, "zone" if name in zones else "obstacle", [*chain.from_iterable(parts)]) for name, parts in standing.items()]
    seen = _near(things, cell.robot.base.translation, _reach(robot))
    sides = Sides.of(seen, body)
    view = _least_hidden(seen, sides, body)
    behind, before = _split(sides, view)
    parts = [*behind, *_solids(arm, load, view), *before, *_labels(seen, body, view)]
    parts += _sensor_axes(sensor, view) + _throw(start, payload_box, sensor, view, words)
    parts += _gravity(cell, view)
    label = words.say("report-scene", axis=start.axis, clearance_m=start.clearance_m, nearest=words.quote(start.nearest))
    head = f'<svg class="scene" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{escape(label)}">'
    return f"{head}{''.join(parts)}</svg>"


def _reach(robot: RobotModel) -> float:
    """Most of the stretched arm's length, m: the same part of the world is shown for every configuration."""
    return float(np.linalg.norm(robot.chain.placements[1:, :3, 3], axis=1).sum()) * 0.8


def _near(things: list[Thing], base: Array, reach: float) -> list[Thing]:
    """What is in the robot's reach: walls and zones are cut off there, or one would see a hall and no robot."""
    low, high = base - [reach, reach, 0.25 * reach], base + reach
    near: list[Thing] = []
    for name, kind, faces in things:
        corners = np.concatenate(faces)
        if len(faces) == 6:
            faces = [np.clip(face, low, high) for face in faces]  # noqa: PLW2901 - a box stays a box
            visible = bool((np.ptp(np.concatenate(faces), axis=0) > 0).all())
        else:
            visible = bool(((corners > low) & (corners < high)).all(axis=1).any())
        if visible:
            near.append((name, kind, faces))
    return near


@dataclass(frozen=True)
class Sides:
    """Faces of what stands around the robot, and on which side of each the robot is.

    Args:
        names: what each is drawn as.
        normals: (n, 3), outwards; as long as twice the area.
        above, below: (n,), share of the body's points on the outer side of each face's plane, and on the inner one.
    """

    faces: Faces
    names: list[str]
    normals: Array
    above: Array
    below: Array

    @classmethod
    def of(cls, things: list[Thing], body: Array) -> Sides:
        """Those with an area; body (k, 3)."""
        named = [(kind, face) for _, kind, faces in things for face in faces]
        normals = _normals([face for _, face in named])
        flat = np.linalg.norm(normals, axis=1) < 1e-9
        named, normals = [each for each, no_area in zip(named, flat, strict=True) if not no_area], normals[~flat]
        first = np.array([face[0] for _, face in named]).reshape(-1, 3)
        side = body @ normals.T - (first * normals).sum(axis=1)
        return cls([face for _, face in named], [kind for kind, _ in named], normals, (side > 0).mean(axis=0), (side < 0).mean(axis=0))

    def hide(self, view: Projection) -> NDArray[np.bool_]:
        """(n,), which ones stand between the viewer and the body: the two are on different sides of the plane."""
        towards = self.normals @ view.axes[2]
        return np.asarray(np.where(towards > 0, self.above, np.where(towards < 0, self.below, 0.0)) < 0.5)


def _normals(faces: Faces) -> Array:
    """(n, 3), Newell's normals, outwards; their lengths are twice the areas."""
    most = max(map(len, faces), default=1)
    # a last corner that is repeated adds nothing to the sum
    corners = np.array([[*face, *[face[-1]] * (most - len(face))] for face in faces]).reshape(-1, most, 3)
    return np.asarray(np.cross(corners, np.roll(corners, -1, axis=1)).sum(axis=1))


def _least_hidden(things: list[Thing], sides: Sides, body: Array) -> Projection:
    """The view with the least area of faces before the body."""
    points = np.concatenate([body, *[np.concatenate(faces) for _, _, faces in things]])
    low, high = points.min(axis=0), points.max(axis=0)

    def hidden(azimuth: float) -> float:
        view = Projection(azimuth, low, high)
        return float(np.abs(sides.normals @ view.axes[2])[sides.hide(view)].sum())

    return Projection(min(AZIMUTHS, key=hidden), low, high)


def _split(sides: Sides, view: Projection) -> tuple[list[str], list[str]]:
    """Obstacles and zones as polygons: those behind the robot, and those before it."""
    behind: list[tuple[float, str]] = []
    before: list[tuple[float, str]] = []
    for kind, face, front in zip(sides.names, sides.faces, sides.hide(view), strict=True):
        name = f"{kind} front" if front else kind
        (before if front else behind).append((float(face.mean(axis=0) @ view.axes[2]), _polygon(face, view, name)))
    return [part for _, part in sorted(behind)], [part for _, part in sorted(before)]


def _solids(arm: Faces, load: Faces, view: Projection) -> list[str]:
    """Robot and payload box, the farthest face first."""
    drawn: list[tuple[float, str]] = []
    for name, faces, shade in (("arm", arm, (105, 205)), ("load", load, (70, 150))):
        normals = _normals(faces)
        size = np.linalg.norm(normals, axis=1)
        shown = (size > 1e-12) & (normals @ view.axes[2] > 0)
        light = 0.5 + 0.5 * (normals @ LIGHT) / np.maximum(size, 1e-12)
        grey = np.rint(shade[0] + (shade[1] - shade[0]) * light).astype(int)
        for k in np.flatnonzero(shown):
            colour = f"rgb({grey[k]},{grey[k]},{grey[k]})"
            drawn.append((float(faces[k].mean(axis=0) @ view.axes[2]), _polygon(faces[k], view, name, colour)))
    return [part for _, part in sorted(drawn)]


def _polygon(face: Array, view: Projection, name: str, colour: str | None = None) -> str:
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in view.pixels(face))
    paint = f' fill="{colour}" stroke="{colour}"' if colour else ""  # the style sheet has the last word on the stroke
    return f'<polygon class="{name}" points="{points}"{paint}/>'


def _labels(things: list[Thing], body: Array, view: Projection) -> list[str]:
    """The names, each where it is farthest from the robot and from the names before it."""
    taken = view.pixels(body)
    labels = []
    for name, _, faces in things:
        places = np.array([corner for face in faces for corner in (*face, face.mean(axis=0))])
        spots = np.clip(view.pixels(places), [40, 12], [WIDTH - 40, HEIGHT - 6])
        room = np.linalg.norm(spots[:, None] - taken[None], axis=2).min(axis=1)
        x, y = spot = spots[np.argmax(np.minimum(room, 60.0))]
        taken = np.vstack([taken, spot + np.array([[-25, 0], [0, 0], [25, 0]])])
        labels.append(f'<text class="thing" x="{x:.1f}" y="{y:.1f}" text-anchor="middle">{escape(name)}</text>')
    return labels


def _arrow(tail: Array, tip: Array, view: Projection, name: str, text: str) -> str:
    (x0, y0), (x1, y1) = view.pixels(np.array([tail, tip]))
    length = max(float(np.hypot(x1 - x0, y1 - y0)), 1e-9)
    ux, uy = (x1 - x0) / length, (y1 - y0) / length
    size = min(6.0, length)
    head = " ".join(
        f"{x:.1f},{y:.1f}"
        for x, y in (
            (x1, y1),
            (x1 - size * ux + 0.45 * size * uy, y1 - size * uy - 0.45 * size * ux),
            (x1 - size * ux - 0.45 * size * uy, y1 - size * uy + 0.45 * size * ux),
        )
    )
    x, y = x1 + 8 * ux, y1 + 8 * uy + 3
    return (
        f'<line class="{name}" x1="{x0:.1f}" y1="{y0:.1f}" x2="{x1:.1f}" y2="{y1:.1f}"/>'
        f'<polygon class="{name} head" points="{head}"/>'
        f'<text class="{name}" x="{x:.1f}" y="{y:.1f}" text-anchor="middle">{escape(text)}</text>'
    )


def _sensor_axes(sensor: SensorPose, view: Projection) -> list[str]:
    tips = sensor.position + 0.7 * ARROW_M * sensor.rotation.T
    return [_arrow(sensor.position, tip, view, "axis", letter) for tip, letter in zip(tips, "xyz", strict=True)]


def _throw(start: StartConfiguration, box: Box, sensor: SensorPose, view: Projection, words: Wording) -> list[str]:
    """Where the load's centre would fly if it came off at the start, for either sense of the rotation."""
    about = start.about or start.axis[0]
    if start.throw is None or about not in "xyz":
        return []
    axis = sensor.rotation[:, "xyz".index(about)]
    velocity = np.cross(axis, sensor.rotation @ box.pose.translation)
    speed = float(np.linalg.norm(velocity))
    if speed < 1e-6:  # the box is centred on the axis
        return []
    flight = ARROW_M * velocity / speed
    return [
        _arrow(sensor.position, sensor.position + sign * flight, view, "throw", text)
        for sign, text in ((1.0, words.say("report-throw")), (-1.0, ""))
    ]


def _gravity(cell: Cell, view: Projection) -> list[str]:
    """Gravity's direction in a corner of the picture."""
    down = cell.gravity / np.linalg.norm(cell.gravity)
    x, y = (view.axes[:2] @ down) * [1, -1]
    x0, y0 = 22.0, HEIGHT - 44.0
    return [
        f'<line class="gravity" x1="{x0}" y1="{y0}" x2="{x0 + 24 * x:.1f}" y2="{y0 + 24 * y:.1f}"/>'
        f'<text class="gravity" x="{x0 + 34 * x:.1f}" y="{y0 + 34 * y + 3:.1f}" text-anchor="middle">g</text>'
    ]
