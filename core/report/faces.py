"""Shapes as flat faces in the world, for drawing."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import coal
import numpy as np
import pinocchio as pin
from scipy.spatial import ConvexHull

from core.array import Array
from core.cell.cell import Box, Capsule, Cell, Cylinder, Mesh, Shape, Sphere
from core.robot.bodies import LinkShape, collision_shapes, standing_parts, visual_shapes
from core.robot.model import RobotModel

Faces = list[Array]
"""Convex polygons, each (k, 3), counter-clockwise seen from outside, m."""

ROUND = 20  # corners of a circle
MESH_CORNERS = 48
"""Of a mesh as it is drawn: about as many faces as a cylinder with round ends has, however fine the mesh."""

Part = tuple[int, Faces]
"""A body of the robot: the number of the joint that carries it (0 for the base), and its faces in that joint's frame."""


def faces_of_points(points: Array) -> Faces:
    """Faces of the convex hull of points (k, 3); coplanar triangles stay triangles."""
    hull = ConvexHull(points)
    faces = []
    for corners, equation in zip(hull.simplices, hull.equations, strict=True):
        a, b, c = points[corners]
        outward = np.cross(b - a, c - a) @ equation[:3] > 0
        faces.append(np.array([a, b, c] if outward else [a, c, b]))
    return faces


def mesh_faces(points: Array) -> Faces:
    """About the convex hull of a mesh's vertices (k, 3), with `MESH_CORNERS` corners at most; no faces where it has no volume.

    The corners are the vertices that are farthest out in directions spread evenly over the sphere (a Fibonacci lattice).
    """
    points = points[np.isfinite(points).all(axis=1)]
    if len(points) < 4:
        return []
    k = np.arange(MESH_CORNERS) + 0.5
    up, turn = 1.0 - 2.0 * k / MESH_CORNERS, np.pi * (1.0 + np.sqrt(5.0)) * k
    level = np.sqrt(1.0 - up**2)
    directions = np.column_stack([level * np.cos(turn), level * np.sin(turn), up])
    outermost = np.unique(points[np.argmax(points @ directions.T, axis=0)], axis=0)
    if np.linalg.matrix_rank(outermost - outermost.mean(axis=0), tol=1e-9) < 3:
        return []
    return faces_of_points(outermost)


def box_faces(size: Array) -> Faces:
    """Six faces of a box about the origin; size (3,)."""
    h = 0.5 * np.asarray(size)
    faces = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for sign in (1.0, -1.0):
            corners = np.zeros((4, 3))
            corners[:, axis] = sign * h[axis]
            corners[:, u] = h[u] * np.array([-1, 1, 1, -1])
            corners[:, v] = h[v] * np.array([-1, -1, 1, 1]) * sign
            faces.append(corners)
    return faces


def revolve_profile(profile: Array) -> Faces:
    """A body of revolution about z; profile (k, 2) of radius and height from bottom to top, radius 0 at both ends."""
    angle = np.linspace(0.0, 2.0 * np.pi, ROUND + 1)
    circle = np.column_stack([np.cos(angle), np.sin(angle)])
    faces = []
    for (r0, z0), (r1, z1) in pairwise(profile):
        if r0 == 0.0 or r1 == 0.0:
            radius, z, up = max(r0, r1), (z1 if r0 == 0.0 else z0), r1 == 0.0
            if z0 == z1:
                ring = np.column_stack([radius * circle[:-1], np.full(ROUND, z)])
                faces.append(ring if up else ring[::-1])
                continue
        for k in range(ROUND):
            low, high = (np.column_stack([r * circle[k : k + 2], [z, z]]) for r, z in ((r0, z0), (r1, z1)))
            quad = np.array([low[0], low[1], high[1], high[0]])
            faces.append(np.array([corner for i, corner in enumerate(quad) if i == 0 or (corner != quad[i - 1]).any()]))
    return faces


def cylinder_faces(radius: float, length: float) -> Faces:
    """A cylinder along z about the origin."""
    h = length / 2
    return revolve_profile(np.array([[0, -h], [radius, -h], [radius, h], [0, h]], dtype=float))


def capsule_faces(radius: float, length: float) -> Faces:
    """A cylinder of the given length along z with round ends."""
    arc = np.linspace(0.0, np.pi / 2, 6)
    top = np.column_stack([radius * np.cos(arc), length / 2 + radius * np.sin(arc)])
    top[-1, 0] = 0.0
    return revolve_profile(np.concatenate([top[::-1] * [1, -1], top]))


def sphere_faces(radius: float) -> Faces:
    """A ball about the origin."""
    arc = np.linspace(-np.pi / 2, np.pi / 2, 11)
    profile = np.column_stack([radius * np.cos(arc), radius * np.sin(arc)])
    profile[[0, -1], 0] = 0.0
    return revolve_profile(profile)


def place_faces(faces: Faces, rotation: Array, position: Array) -> Faces:
    """Faces in the frame that rotation (3, 3) and position (3,) refer to."""
    return [face @ rotation.T + position for face in faces]


def shape_faces(shape: Shape) -> Faces:
    """The shape of a zone or an obstacle that is no mesh, in the world."""
    match shape:
        case Box():
            faces = box_faces(np.array(shape.size_m))
        case Sphere():
            faces = sphere_faces(shape.radius_m)
        case Capsule():
            faces = capsule_faces(shape.radius_m, shape.length_m)
        case Cylinder():
            faces = cylinder_faces(shape.radius_m, shape.length_m)
    return place_faces(faces, shape.pose.rotation, shape.pose.translation)


def standing_faces(cell: Cell) -> dict[str, list[Faces]]:
    """Obstacles, then zones, by their names: the faces of each, of a mesh those of each of its convex parts, in the world.

    Raises:
        BadRobot: a mesh that cannot be used.
    """
    parts = standing_parts(cell)
    return {
        item.name: [place_faces(mesh_faces(part), item.shape.pose.rotation, item.shape.pose.translation) for part in parts[item.name]]
        if isinstance(item.shape, Mesh)
        else [shape_faces(item.shape)]
        for item in cell.standing
    }


def arm_faces(cell: Cell, robot: RobotModel, q: Array, parts: list[Part] | None = None) -> Faces:
    """The robot at q (n,) as its URDF pictures it, or its collision shapes where it has no picture.

    Args:
        parts: what `arm_parts` has read, for who draws it more than once.
    """
    poses = joint_poses(robot, q)
    return [face for joint, faces in parts or arm_parts(cell, robot) for face in place_faces(faces, *poses[joint])]


def arm_parts(cell: Cell, robot: RobotModel) -> list[Part]:
    """The robot's bodies, each with the number of the joint that carries it (0 for the base) and its faces in that joint's frame."""
    return [_part(each) for each in _shapes(cell, robot)]


def link_parts(cell: Cell, robot: RobotModel, link: str) -> list[Part]:
    """Those of `arm_parts` that a link has; none where there is no link of that name."""
    return [_part(each) for each in _shapes(cell, robot) if each.link == link]


def _shapes(cell: Cell, robot: RobotModel) -> Sequence[LinkShape]:
    return visual_shapes(cell, robot) or collision_shapes(cell, robot)


def _part(each: LinkShape) -> Part:
    return each.joint, place_faces(_faces(each), each.placement.rotation, each.placement.translation)


def joint_poses(robot: RobotModel, q: Array) -> list[tuple[Array, Array]]:
    """Rotation (3, 3) and position (3,) of every joint's frame in the world at q (n,); the first is the world itself."""
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, q)
    return [(np.array(pose.rotation), np.array(pose.translation)) for pose in data.oMi]


def _faces(each: LinkShape) -> Faces:
    """Of a link's shape; of a mesh those of its hull or of its parts, none where it is flat."""
    sizes = each.shape.sizes
    match each.shape.kind:
        case "box":
            return box_faces(np.array(sizes))
        case "sphere":
            return sphere_faces(*sizes)
        case "cylinder":
            return cylinder_faces(*sizes)
        case "capsule":
            return capsule_faces(*sizes)
    return [face for part in each.parts for face in mesh_faces(part)]


def body_faces(geometry: Any) -> Faces:
    """Faces of one of Coal's shapes, convex hulls among them, in its own frame."""
    match geometry:
        case coal.Box():
            return box_faces(2.0 * np.asarray(geometry.halfSide))
        case coal.Sphere():
            return sphere_faces(float(geometry.radius))
        case coal.Cylinder():
            return cylinder_faces(float(geometry.radius), 2.0 * float(geometry.halfLength))
        case coal.Capsule():
            return capsule_faces(float(geometry.radius), 2.0 * float(geometry.halfLength))
    return mesh_faces(np.asarray(geometry.points()))
