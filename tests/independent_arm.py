"""An arm read anew from its URDF for the independent checker: its joints, its bodies of every geometry, where they are, and the torques.

Nothing of the engine is used; meshes are read by trimesh, kinematics and dynamics are numpy, many configurations at a time.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import trimesh

from core.array import Array
from tests.convex_distance import Convex, ball, box, capsule, cylinder

FLAT = 1e-3
"""Relative volume by which a mesh and its hull may differ where the mesh counts as convex."""


@dataclass(frozen=True)
class Joint:
    """One joint of the chain.

    Args:
        placement: (4, 4) of the joint's frame in its parent's at zero.
        axis: (3,), a unit vector; None where the joint is fixed.
        lower, upper: rad. velocity: rad/s. effort: N m.
    """

    name: str
    placement: Array
    axis: Array | None
    parent: str
    lower: float
    upper: float
    velocity: float
    effort: float


@dataclass(frozen=True)
class Body:
    """One rigid body.

    Args:
        name: of the link.
        group: number of moving joints before it; it is given in the frame after that joint, or in the world.
        convex: its hull.
        triangles: (F, 3, 3) of a mesh that is not convex, None of everything else.
    """

    name: str
    group: int
    convex: Convex
    triangles: Array | None = None


@dataclass(frozen=True)
class Inertia:
    """Mass, kg, first moment (3,), kg m, and inertia (3, 3), kg m2, about the origin of the frame that it is given in."""

    mass: float
    first: Array
    second: Array

    def __add__(self, other: Inertia) -> Inertia:
        return Inertia(self.mass + other.mass, self.first + other.first, self.second + other.second)

    def moved(self, T: Array) -> Inertia:
        """The same body, given in the frame in which its own frame is placed by T (4, 4)."""
        if self.mass == 0.0:
            return self
        com = self.first / self.mass
        central = self.second - _steiner(self.mass, com)
        moved = T[:3, :3] @ com + T[:3, 3]
        return Inertia(self.mass, self.mass * moved, T[:3, :3] @ central @ T[:3, :3].T + _steiner(self.mass, moved))


NOTHING = Inertia(0.0, np.zeros(3), np.zeros((3, 3)))


class Arm:
    """An arm with hinges.

    Args:
        urdf, folder: its text, and where its meshes are.
        base_frame, sensor_frame: names of links.
        base: (4, 4), the base frame in the world.
    """

    def __init__(self, urdf: str, folder: Path, base_frame: str, sensor_frame: str, base: Array) -> None:
        root = ET.fromstring(urdf)
        joints = {_name(joint.find("child"), "link"): _joint(joint) for joint in root.findall("joint")}
        chain = _chain(joints, sensor_frame)
        before_base = np.eye(4)
        for _, joint in _chain(joints, base_frame):
            before_base = before_base @ joint.placement
        self._root = base @ np.linalg.inv(before_base)
        self._chain = [joint for _, joint in chain]
        self.moving = [joint for joint in self._chain if joint.axis is not None]
        self._axes = [joint.axis for joint in self._chain if joint.axis is not None]
        self.lower, self.upper = np.array([j.lower for j in self.moving]), np.array([j.upper for j in self.moving])
        self.velocity, self.effort = np.array([j.velocity for j in self.moving]), np.array([j.effort for j in self.moving])
        where = self._where(root, joints, chain)
        self.group = {link: number for link, (number, _) in where.items()}
        """Of each link: how many moving joints are before it."""
        self.behind = frozenset(_below(joints, sensor_frame) - {sensor_frame})
        """Links behind the sensor frame."""
        self.joined = {frozenset((joint.parent, link)) for link, joint in joints.items()}
        """Pairs of links with a joint between them."""
        self.bodies: list[Body] = []
        self.inertia = [NOTHING] * (len(self.moving) + 1)
        for element in root.findall("link"):
            name = element.get("name", "")
            number, T = where[name]
            for collision in element.findall("collision"):
                self.bodies.append(_body(collision, name, number, T, folder))
            if name not in self.behind:
                self.inertia[number] = self.inertia[number] + _inertia(element.find("inertial")).moved(T)
        self.sensor = where[sensor_frame][1]
        """(4, 4), the sensor frame in that of the last group."""

    @property
    def n(self) -> int:
        """Number of moving joints."""
        return len(self.moving)

    def frames(self, q: Array) -> Array:
        """(N, n + 1, 4, 4) at joint positions (N, n): the world, and the frame after each moving joint."""
        T = np.broadcast_to(self._root, (len(q), 4, 4))
        frames = [np.broadcast_to(np.eye(4), (len(q), 4, 4))]
        for joint in self._chain:
            T = T @ joint.placement
            if joint.axis is not None:
                T = T @ _turns(joint.axis, q[:, len(frames) - 1])
                frames.append(T)
        return np.ascontiguousarray(np.stack(frames, axis=1))

    def sensor_poses(self, q: Array) -> Array:
        """(N, 4, 4), the sensor frame in the world."""
        return np.asarray(self.frames(q)[:, -1] @ self.sensor)

    def jacobian(self, q: Array) -> Array:
        """(6, n), of the sensor origin, then angular, in the world, at q (n,)."""
        frames = self.frames(q[None])[0]
        axes = np.array([frames[k + 1, :3, :3] @ unit for k, unit in enumerate(self._axes)])
        to_tip = (frames[-1] @ self.sensor)[:3, 3] - frames[1:, :3, 3]
        return np.concatenate((np.cross(axes, to_tip), axes), axis=1).T

    def torques(self, q: Array, dq: Array, ddq: Array, gravity: Array, payload: Inertia) -> Array:
        """(N, n), N m, what the joints have to give: Newton and Euler in the world frame, from the tip to the base.

        Args:
            q, dq, ddq: (N, n), rad and s.
            gravity: (3,), world, m/s2.
            payload: about the sensor frame.
        """
        frames = self.frames(q)
        inertia = [*self.inertia[:-1], self.inertia[-1] + payload.moved(self.sensor)]
        R, p = frames[:, 1:, :3, :3], frames[:, 1:, :3, 3]
        axes = np.stack([R[:, k] @ unit for k, unit in enumerate(self._axes)], axis=1)
        force, moment = np.zeros_like(p), np.zeros_like(p)  # each about the origin of its own group
        w, dw = np.zeros((len(q), 3)), np.zeros((len(q), 3))
        a, here = np.tile(-gravity, (len(q), 1)), p[:, 0]
        for k in range(self.n):
            arm = p[:, k] - here
            a = a + np.cross(dw, arm) + np.cross(w, np.cross(w, arm))
            here = p[:, k]
            dw = dw + axes[:, k] * ddq[:, k, None] + np.cross(w, axes[:, k] * dq[:, k, None])
            w = w + axes[:, k] * dq[:, k, None]
            body = inertia[k + 1]
            first = R[:, k] @ body.first
            second = R[:, k] @ body.second @ np.swapaxes(R[:, k], 1, 2)
            force[:, k] = body.mass * a + np.cross(dw, first) + np.cross(w, np.cross(w, first))
            spin = np.einsum("nij,nj->ni", second, w)
            moment[:, k] = np.cross(first, a) + np.einsum("nij,nj->ni", second, dw) + np.cross(w, spin)
        torques = np.empty((len(q), self.n))
        total, about = np.zeros((len(q), 3)), np.zeros((len(q), 3))
        for k in reversed(range(self.n)):
            if k + 1 < self.n:
                about = about + np.cross(p[:, k + 1] - p[:, k], total)
            total, about = total + force[:, k], about + moment[:, k]
            torques[:, k] = np.einsum("ni,ni->n", axes[:, k], about)
        return torques

    def _where(self, root: ET.Element, joints: dict[str, Joint], chain: list[tuple[str, Joint]]) -> dict[str, tuple[int, Array]]:
        """Group and placement in it of every link; a joint beside the chain stands at zero."""
        moving = {link: number for number, link in enumerate((link for link, joint in chain if joint.axis is not None), start=1)}
        where: dict[str, tuple[int, Array]] = {}

        def find(link: str) -> tuple[int, Array]:
            if link not in where:
                if link not in joints:
                    where[link] = 0, self._root
                elif link in moving:
                    where[link] = moving[link], np.eye(4)
                else:
                    number, T = find(joints[link].parent)
                    where[link] = number, T @ joints[link].placement
            return where[link]

        for element in root.findall("link"):
            find(element.get("name", ""))
        return where


def pose(xyz: Any, rpy: Any) -> Array:
    """(4, 4), translation, then roll, pitch and yaw about fixed axes."""
    (cr, cp, cy), (sr, sp, sy) = np.cos(rpy), np.sin(rpy)
    T = np.eye(4)
    T[:3, :3] = [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
    T[:3, 3] = xyz
    return T


def _steiner(mass: float, at: Array) -> Array:
    return mass * (at @ at * np.eye(3) - np.outer(at, at))


def _name(element: ET.Element | None, key: str) -> str:
    return "" if element is None else element.get(key, "")


def _joint(joint: ET.Element) -> Joint:
    axis, limit = joint.find("axis"), joint.find("limit")
    moves = joint.get("type") != "fixed"
    direction = _floats(axis, "xyz", "1 0 0") if moves else None
    unit = None if direction is None else direction / np.linalg.norm(direction)
    numbers = {key: float(limit.get(key, "nan")) if limit is not None else np.nan for key in ("lower", "upper", "velocity", "effort")}
    return Joint(joint.get("name", ""), _origin(joint.find("origin")), unit, _name(joint.find("parent"), "link"), **numbers)


def _chain(joints: dict[str, Joint], tip: str) -> list[tuple[str, Joint]]:
    """Links with the joint before each, from the root to the tip."""
    chain: list[tuple[str, Joint]] = []
    while tip in joints:
        chain.insert(0, (tip, joints[tip]))
        tip = joints[tip].parent
    return chain


def _below(joints: dict[str, Joint], link: str) -> set[str]:
    return {link}.union(*(_below(joints, child) for child, joint in joints.items() if joint.parent == link))


def _floats(element: ET.Element | None, key: str, default: str) -> Array:
    text = default if element is None else element.get(key, default)
    return np.array([float(x) for x in text.split()])


def _origin(origin: ET.Element | None) -> Array:
    return pose(_floats(origin, "xyz", "0 0 0"), _floats(origin, "rpy", "0 0 0"))


def _inertia(inertial: ET.Element | None) -> Inertia:
    """About the link's frame."""
    if inertial is None:
        return NOTHING
    T, mass = _origin(inertial.find("origin")), float(_floats(inertial.find("mass"), "value", "0")[0])
    xx, xy, xz, yy, yz, zz = (float(_floats(inertial.find("inertia"), key, "0")[0]) for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
    return Inertia(mass, np.zeros(3), np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])).moved(T)


def _body(collision: ET.Element, name: str, group: int, T: Array, folder: Path) -> Body:
    T = T @ _origin(collision.find("origin"))
    geometry = collision.find("geometry")
    if geometry is None or len(geometry) != 1:
        raise ValueError(f"{name}: no geometry")
    shape = geometry[0]
    if shape.tag == "mesh":
        hull, triangles = _mesh(folder / shape.get("filename", ""), _floats(shape, "scale", "1 1 1"))
        if triangles is not None:
            triangles = triangles @ T[:3, :3].T + T[:3, 3]
        return Body(name, group, Convex(hull).moved(T), triangles)
    radius, length = (float(_floats(shape, key, "0")[0]) for key in ("radius", "length"))
    made = {
        "box": lambda: box(_floats(shape, "size", "")),
        "sphere": lambda: ball(radius),
        "capsule": lambda: capsule(radius, length),
        "cylinder": lambda: cylinder(radius, length),
    }[shape.tag]()
    return Body(name, group, made.moved(T))


_MESHES: dict[tuple[str, bytes], tuple[Array, Array | None]] = {}


def _mesh(file: Path, scale: Array) -> tuple[Array, Array | None]:
    """Corners (V, 3) of a mesh's hull, and its triangles (F, 3, 3) where it is not convex."""
    key = str(file), scale.tobytes()
    if key not in _MESHES:
        mesh: Any = trimesh.load(file, force="mesh")
        mesh.apply_scale(scale)
        hull = mesh.convex_hull
        convex = bool(mesh.is_watertight) and abs(mesh.volume - hull.volume) < FLAT * hull.volume
        _MESHES[key] = np.array(hull.vertices), None if convex else np.array(mesh.triangles)
    return _MESHES[key]


def _turns(axis: Array, angle: Array) -> Array:
    """(N, 4, 4), rotations about a unit axis (Rodrigues)."""
    x, y, z = axis
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    T = np.tile(np.eye(4), (len(angle), 1, 1))
    T[:, :3, :3] += np.sin(angle)[:, None, None] * K + (1 - np.cos(angle))[:, None, None] * (K @ K)
    return T
