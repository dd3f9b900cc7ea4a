"""A second opinion on a motion, sharing nothing with the engine but the cell: python-fcl for distances (boxes, where it is exact),
kinematics in numpy read from the URDF's XML, speeds by finite differences.

Any sequence of joint positions can be judged: commanded or measured, of a transfer or of a whole run.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import dataclass
from typing import Any

import fcl
import numpy as np
from numpy.typing import NDArray

from core.cell import Box, Cell

Array = NDArray[np.float64]

NUMERICAL_M = 1e-6
NUMERICAL = 1e-6
CONTACT_M = 0.001
GRID = 40  # angles per joint, to tell links of one wrist that cannot touch


@dataclass(frozen=True)
class Findings:
    """What a motion does, against what it may.

    Args:
        margins_m: for each kind of pair ("obstacle", "zone", "self") the smallest distance minus what is required, and its pair.
        speed_m_s, velocity, acceleration, position: largest Cartesian speed of a corner, and largest ratio of a joint to its limit
            (for positions the excess, rad).
    """

    margins_m: dict[str, tuple[float, str]]
    speed_m_s: float
    speed_limit_m_s: float
    velocity: float
    acceleration: float
    position: float
    samples: int

    @property
    def violations(self) -> list[str]:
        """One sentence for each limit that is broken."""
        found = [
            f"{pair} {-margin * 1000:.3f} mm closer than allowed ({kind})"
            for kind, (margin, pair) in self.margins_m.items()
            if margin < -NUMERICAL_M
        ]
        if self.speed_m_s > self.speed_limit_m_s * (1 + NUMERICAL):
            found.append(f"a corner moves at {self.speed_m_s:.5f} m/s, allowed {self.speed_limit_m_s} m/s")
        for name, ratio in (("velocity", self.velocity), ("acceleration", self.acceleration)):
            if ratio > 1 + 1e-4:
                found.append(f"a joint has {ratio:.5f} times its {name} limit")
        if self.position > NUMERICAL:
            found.append(f"a joint is {self.position:.6f} rad beyond its position limit")
        return found

    @property
    def least_margin_m(self) -> float:
        """Smallest of all margins."""
        return min(margin for margin, _ in self.margins_m.values())


@dataclass(frozen=True)
class _Joint:
    placement: Array
    axis: Array | None
    parent: str
    lower: float
    upper: float
    velocity: float


@dataclass(frozen=True)
class _Body:
    name: str
    joint: int
    """Number of moving joints before it."""
    placement: Array
    """In the frame after that joint, or in the world."""
    shape: Any
    corners: Array
    """(8, 3) or (0, 3), in the same frame."""


class IndependentChecker:
    """Judges motions of one cell's robot with one payload box."""

    def __init__(self, cell: Cell, payload_box: Box) -> None:
        self._cell = cell
        root = ET.fromstring(cell.urdf)
        joints = {joint.find("child").get("link"): _joint(joint) for joint in root.findall("joint")}  # type: ignore[union-attr]  # a URDF that has been read has it
        base, sensor = cell.robot.base_frame, cell.robot.sensor_frame
        chain = _chain(joints, sensor)
        before_base = _chain(joints, base)
        self._root = _pose(cell.robot.base.xyz_m, cell.robot.base.rpy_rad) @ np.linalg.inv(_fixed(before_base))
        self._chain = [joint for _, joint in chain]
        moving = [joint for joint in self._chain if joint.axis is not None]
        self._lower, self._upper = np.array([j.lower for j in moving]), np.array([j.upper for j in moving])
        velocity = cell.robot.velocity_rad_s
        self._velocity = np.array([j.velocity for j in moving] if velocity is None else velocity)
        self._acceleration = np.array(cell.robot.acceleration_rad_s2)
        self._bodies = self._links(root, chain)
        self._bodies.append(self._payload(payload_box))
        self._things = [(_thing(item.shape), item.name, "obstacle") for item in cell.obstacles]
        self._things += [(_thing(item.shape), item.name, "zone") for item in cell.zones]
        self._frames_of_home = self._frames(np.array([cell.robot.home_rad]))[:, 0]
        self._pairs = [
            (i, k)
            for i, a in enumerate(self._bodies)
            for k, b in enumerate(self._bodies)
            if a.joint - b.joint >= 2 and self._can_touch(i, k)
        ]

    def check(self, q: Array, period: float) -> Findings:
        """Judges joint positions q (N, n) at constant period, s, taken to be at rest before and after.

        Distances are looked at whenever a corner may have moved by as much as was left at the last look: the verdict is that of looking at
        every sample, since no point of a body moves farther than its farthest corner.
        """
        q = np.concatenate((q[:1], np.asarray(q, dtype=float), q[-1:]))
        frames = self._frames(q)
        corners = np.concatenate(
            [
                np.einsum("nij,cj->nci", frames[b.joint][:, :3, :3], b.corners) + frames[b.joint][:, None, :3, 3]
                for b in self._bodies
                if b.joint
            ],
            axis=1,
        )
        dq = np.diff(q, axis=0) / period
        ddq = np.diff(dq, axis=0) / period
        speed = np.linalg.norm(np.diff(corners, axis=0), axis=2).max() / period
        margins = self._least_margins(frames, corners)
        return Findings(
            margins_m=margins,
            speed_m_s=float(speed),
            speed_limit_m_s=self._cell.limits.cartesian_speed_m_s,
            velocity=float((np.abs(dq) / self._velocity).max()),
            acceleration=float((np.abs(ddq) / self._acceleration).max()),
            position=float(np.maximum(self._lower - q, q - self._upper).max()),
            samples=len(q) - 2,
        )

    def margins(self, q: Array) -> dict[str, tuple[float, str]]:
        """Smallest margin at q (n,) for each kind of pair, and its pair."""
        return self._margins_at(self._frames(np.asarray(q, dtype=float)[None])[:, 0])

    def axis_direction(self, q: Array, axis: int) -> Array:
        """(3,), a sensor axis in the world at q (n,)."""
        frames = self._frames(np.asarray(q, dtype=float)[None])
        return np.asarray(frames[-1, 0, :3, axis])

    def _least_margins(self, frames: Array, corners: Array) -> dict[str, tuple[float, str]]:
        least: dict[str, tuple[float, str]] = {}
        k = 0
        while k < corners.shape[0]:
            here = self._margins_at(frames[:, k])
            for kind, found in here.items():
                least[kind] = min(least.get(kind, found), found)
            room = min(margin / (2.0 if kind == "self" else 1.0) for kind, (margin, _) in here.items())
            k = self._next_look(corners, k, room)
        return least

    @staticmethod
    def _next_look(corners: Array, k: int, room: float) -> int:
        """First sample after k at which a corner is farther than `room` from where it was at k."""
        if room <= 0.0:
            return k + 1
        start, width = k + 1, 64
        while start < len(corners):
            moved = np.linalg.norm(corners[start : start + width] - corners[k], axis=2).max(axis=1)
            beyond = np.flatnonzero(moved > room)
            if len(beyond):
                return start + int(beyond[0])
            start += width
            width *= 2
        return len(corners)

    def _margins_at(self, frames: Array) -> dict[str, tuple[float, str]]:
        """`frames`: (n + 2, 4, 4)."""
        objects = [self._object(body, frames) for body in self._bodies]
        limits = self._cell.limits
        least: dict[str, tuple[float, str]] = {}
        for body, thing_object in zip(self._bodies, objects, strict=True):
            if body.joint == 0:
                continue
            for (shape, placement), name, kind in self._things:
                margin = _distance(thing_object, fcl.CollisionObject(shape, placement)) - limits.clearance_m
                least[kind] = min(least.get(kind, (np.inf, "")), (margin, f"{body.name} - {name}"))
        for i, k in self._pairs:
            margin = _distance(objects[i], objects[k]) - limits.self_clearance_m
            least["self"] = min(least.get("self", (np.inf, "")), (margin, f"{self._bodies[i].name} - {self._bodies[k].name}"))
        return least

    def _object(self, body: _Body, frames: Array) -> Any:
        T = frames[body.joint] @ body.placement if body.joint else body.placement
        return fcl.CollisionObject(body.shape, fcl.Transform(T[:3, :3], T[:3, 3]))

    def _frames(self, q: Array) -> Array:
        """(n + 2, N, 4, 4): the world, the frame after each moving joint, and the sensor's."""
        T = np.broadcast_to(self._root, (len(q), 4, 4))
        frames = [np.broadcast_to(np.eye(4), (len(q), 4, 4))]
        moving = 0
        for joint in self._chain:
            T = T @ joint.placement
            if joint.axis is not None:
                T = T @ _turns(joint.axis, q[:, moving])
                frames.append(T)
                moving += 1
        return np.stack([*frames, T])

    def _links(self, root: ET.Element, chain: list[tuple[str, _Joint]]) -> list[_Body]:
        """Collision bodies of the links on the way to the sensor; those before the first moving joint in the world frame."""
        where = {chain[0][1].parent: (0, self._root)}
        number, T = 0, self._root
        for link, joint in chain:
            T = T @ joint.placement
            if joint.axis is not None:
                number, T = number + 1, np.eye(4)
            where[link] = (number, T)
        bodies = []
        for element in root.findall("link"):
            name = element.get("name", "")
            for collision in element.findall("collision"):
                if name in where:
                    number, T = where[name]
                    placement = T @ _origin(collision.find("origin"))
                    shape, size = _shape(collision.find("geometry"))
                    bodies.append(_Body(name, number, placement, shape, _corners(placement, size)))
        return bodies

    def _payload(self, box: Box) -> _Body:
        T = np.eye(4)
        for joint in reversed(self._chain):
            if joint.axis is not None:
                break
            T = joint.placement @ T
        placement = T @ _pose(box.pose.xyz_m, box.pose.rpy_rad)
        return _Body("payload", len(self._lower), placement, fcl.Box(*box.size_m), _corners(placement, np.array(box.size_m)))

    def _can_touch(self, i: int, k: int) -> bool:
        """Links with exactly two joints between them may be unable to touch, or overlap by the simplification of their shapes."""
        a, b = self._bodies[i], self._bodies[k]
        if a.joint - b.joint > 2:
            return True
        home = _distance(self._object(a, self._frames_of_home), self._object(b, self._frames_of_home))
        if home < self._cell.limits.self_clearance_m:
            return False
        first, second = b.joint, b.joint + 1
        q = np.tile(np.array(self._cell.robot.home_rad), (GRID * GRID, 1))
        angles = [np.linspace(max(self._lower[j], -np.pi), min(self._upper[j], np.pi), GRID) for j in (first, second)]
        q[:, [first, second]] = np.stack(np.meshgrid(*angles), axis=-1).reshape(-1, 2)
        frames = self._frames(q)
        return any(_distance(self._object(a, frames[:, r]), self._object(b, frames[:, r])) < CONTACT_M for r in range(len(q)))


def _distance(first: Any, second: Any) -> float:
    """Negative where they penetrate."""
    request = fcl.DistanceRequest(enable_signed_distance=True)
    return float(fcl.distance(first, second, request, fcl.DistanceResult()))


def _joint(joint: ET.Element) -> _Joint:
    axis, limit = joint.find("axis"), joint.find("limit")
    moves = joint.get("type") != "fixed"
    direction = np.array([float(x) for x in axis.get("xyz", "1 0 0").split()]) if axis is not None else np.array([1.0, 0, 0])
    value = {key: float(limit.get(key, "nan")) if limit is not None else np.nan for key in ("lower", "upper", "velocity")}
    parent = joint.find("parent").get("link", "")  # type: ignore[union-attr]  # a URDF that has been read has it
    unit = direction / np.linalg.norm(direction) if moves else None
    return _Joint(_origin(joint.find("origin")), unit, parent, value["lower"], value["upper"], value["velocity"])


def _chain(joints: dict[str | None, _Joint], tip: str) -> list[tuple[str, _Joint]]:
    """Links with the joint before each, from the root to the tip."""
    chain: list[tuple[str, _Joint]] = []
    while tip in joints:
        chain.insert(0, (tip, joints[tip]))
        tip = joints[tip].parent
    return chain


def _fixed(chain: list[tuple[str, _Joint]]) -> Array:
    T = np.eye(4)
    for _, joint in chain:
        T = T @ joint.placement
    return T


def _origin(origin: ET.Element | None) -> Array:
    if origin is None:
        return np.eye(4)
    xyz, rpy = ([float(x) for x in origin.get(key, "0 0 0").split()] for key in ("xyz", "rpy"))
    return _pose(xyz, rpy)


def _pose(xyz: Any, rpy: Any) -> Array:
    (cr, cp, cy), (sr, sp, sy) = np.cos(rpy), np.sin(rpy)
    T = np.eye(4)
    T[:3, :3] = [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
    T[:3, 3] = xyz
    return T


def _turns(axis: Array, angle: Array) -> Array:
    """(N, 4, 4), rotations about a unit axis (Rodrigues)."""
    x, y, z = axis
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    T = np.tile(np.eye(4), (len(angle), 1, 1))
    T[:, :3, :3] += np.sin(angle)[:, None, None] * K + (1 - np.cos(angle))[:, None, None] * (K @ K)
    return T


def _shape(geometry: ET.Element | None) -> tuple[Any, Array]:
    box = geometry.find("box") if geometry is not None else None
    if box is None:
        raise ValueError("this checker reads links made of boxes")
    size = np.array([float(x) for x in box.get("size", "").split()])
    return fcl.Box(*size), size


def _corners(placement: Array, size: Array) -> Array:
    signs = np.array([[a, b, c] for a in (-0.5, 0.5) for b in (-0.5, 0.5) for c in (-0.5, 0.5)])
    return np.asarray(signs * size @ placement[:3, :3].T + placement[:3, 3])


def _thing(shape: Any) -> tuple[Any, Any]:
    T = _pose(shape.pose.xyz_m, shape.pose.rpy_rad)
    geometry = {"box": lambda: fcl.Box(*shape.size_m), "sphere": lambda: fcl.Sphere(shape.radius_m)}[shape.kind]()
    return geometry, fcl.Transform(T[:3, :3], T[:3, 3])
