"""A second opinion on a motion, sharing nothing with the engine but the cell: certified distances of bodies of every geometry
(`tests.convex_distance`; the triangles themselves, by python-fcl, where a hull is too large), kinematics and torques in numpy read from the
URDF's XML (`tests.independent_arm`), flights of loads that come off (`tests.free_flight`), speeds by finite differences.

Any sequence of joint positions can be judged: commanded or measured, of a transfer or of a whole run.

What has to keep which distance is decided here anew. All that moves keeps the clearance to obstacles, protected zones and the floor; the
payload keeps the self-clearance to every link but those that the last joint carries; links keep it to each other. Less is asked of pairs
with at most two joints between them that touch at no angles of these joints: they may not touch; nor may a link that only the first joint
moves, and that cannot, touch an obstacle or the floor, nor a link that two joints move and that can never have the clearance: a robot
stands close to its table. Nothing is asked of links with a common joint, of pairs that the cell declares
adjacent, and of links with at most two joints between them that overlap at all angles: `left_out` lists them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import fcl
import numpy as np
import trimesh
from numba import njit

from core.array import Array
from core.cell.cell import Box, Cell, Mesh, Obstacle, Payload, Shape, Zone
from tests.convex_distance import EXACT_M, Convex, ball, bounds, box, capsule, packed
from tests.free_flight import deepest_flight
from tests.independent_arm import Arm, Body, Inertia, pose

NUMERICAL_M = 1e-6
NUMERICAL = 1e-6
CONTACT_M = 0.001
_MOST_POINTS = 1000
GRID = 25
"""Angles per joint, to tell bodies that cannot touch."""
NEVER, SOMETIMES, ALWAYS = "never", "sometimes", "always"
FLOOR = "floor"
PAYLOAD = "payload"
_FLOOR_SIZE_M = np.array([100.0, 100.0, 10.0])
_MOUNT_M = 0.002
"""The base is mounted on what is this near."""
_ANEW_M = 0.001
"""How far bodies that are too close move before they are looked at again."""


@dataclass(frozen=True)
class Findings:
    """What a motion does, against what it may.

    Args:
        margins_m: for each kind of pair ("obstacle", "zone", "floor", "self", "payload") the smallest distance minus what is required, and
            its pair; of the configurations that were looked at, which are all that can be too close.
        too_close_m: the same for each pair that is too close somewhere.
        speed_m_s, velocity, acceleration, torque, position: largest Cartesian speed of a corner, and largest ratio of a joint to its limit
            (for positions the excess, rad); no torque where the payload is not known.
        flight_m: smallest distance of a load that comes off to a protected zone, and the zone; negative where it gets into it.
    """

    margins_m: dict[str, tuple[float, str]]
    too_close_m: dict[tuple[str, str], float]
    speed_m_s: float
    speed_limit_m_s: float
    velocity: float
    acceleration: float
    position: float
    samples: int
    torque: float = 0.0
    torque_joint: str = ""
    flight_m: tuple[float, str] = field(default=(np.inf, ""))

    @property
    def violations(self) -> list[str]:
        """One sentence for each limit that is broken."""
        found = [f"{pair} {-margin * 1000:.3f} mm closer than allowed ({kind})" for (kind, pair), margin in self.too_close_m.items()]
        if self.speed_m_s > self.speed_limit_m_s * (1 + NUMERICAL):
            found.append(f"a corner moves at {self.speed_m_s:.5f} m/s, allowed {self.speed_limit_m_s} m/s")
        for name, ratio in (("velocity", self.velocity), ("acceleration", self.acceleration)):
            if ratio > 1 + 1e-4:
                found.append(f"a joint has {ratio:.5f} times its {name} limit")
        if self.torque > 1.0:
            found.append(f"{self.torque_joint} needs {self.torque:.3f} times its effort limit")
        if self.position > NUMERICAL:
            found.append(f"a joint is {self.position:.6f} rad beyond its position limit")
        if self.flight_m[0] < -NUMERICAL_M:
            found.append(f"a load that comes off flies {-self.flight_m[0] * 1000:.1f} mm into {self.flight_m[1]}")
        return found

    @property
    def least_margin_m(self) -> float:
        """Smallest of all margins."""
        return min(margin for margin, _ in self.margins_m.values())


@dataclass(frozen=True)
class Pair:
    """Two bodies, by their places in the list, and what they have to keep."""

    first: int
    second: int
    required_m: float
    kind: str
    name: str


class IndependentChecker:
    """Judges motions of one cell's robot with one payload box.

    Args:
        payload: what is carried, for the torques; None leaves them out.
    """

    def __init__(self, cell: Cell, payload_box: Box, payload: Payload | None = None) -> None:
        robot = cell.robot
        self._cell, self._box = cell, payload_box
        self.arm = Arm(cell.urdf, cell.folder, robot.base_frame, robot.sensor_frame, pose(robot.base.xyz_m, robot.base.rpy_rad))
        self._load = None if payload is None else _inertia(payload)
        self._velocity = self.arm.velocity if robot.velocity_rad_s is None else np.array(robot.velocity_rad_s)
        self._acceleration = np.array(robot.acceleration_rad_s2)
        at_sensor = self.arm.sensor @ pose(payload_box.pose.xyz_m, payload_box.pose.rpy_rad)
        self.payload = box(np.array(payload_box.size_m))
        moving = [*self.arm.bodies, Body(PAYLOAD, self.arm.n, self.payload.moved(at_sensor))]
        things = [(item, "obstacle") for item in cell.obstacles] + [(item, "zone") for item in cell.zones]
        standing = [(_standing(cell, item), kind) for item, kind in things]
        below = pose([0.0, 0.0, cell.floor_z_m - 0.5 * _FLOOR_SIZE_M[2]], np.zeros(3))
        standing.append((Body(FLOOR, 0, box(_FLOOR_SIZE_M).moved(below)), FLOOR))
        self._kinds = {body.name: kind for body, kind in standing}
        self._bodies = [*moving, *(body for body, _ in standing)]
        self._packed = packed([body.convex for body in self._bodies])
        self._corners = [body.convex.corners for body in self._bodies]
        self._fast = [_outermost(body.convex) for body in self._bodies]
        """Points of which one is the fastest of each body: its own corners, of fine meshes and round bodies those of a box."""
        self._groups = np.array([body.group for body in self._bodies])
        self._triangles = [_bvh(body) for body in self._bodies]
        self.left_out: list[tuple[str, str, str]] = []
        """Pairs of which nothing is asked, and why."""
        self.pairs = [*self._environment(len(moving)), *self._own(len(moving))]
        self._table = np.array([[pair.first, pair.second] for pair in self.pairs], dtype=np.int64)
        self._required = np.array([pair.required_m for pair in self.pairs])
        self._around = np.array([pair.kind not in ("self", PAYLOAD) and pair.required_m > 0.0 for pair in self.pairs])

    def check(self, q: Array, period: float) -> Findings:
        """Judges joint positions q (N, n) at constant period, s, taken to be at rest before and after.

        The distance of a pair is looked at whenever its bodies may have moved against each other by as much as was left at the last look:
        the verdict is that of looking at every sample, since no point of a body moves farther than its farthest corner.
        """
        q = np.concatenate((q[:1], np.asarray(q, dtype=float), q[-1:]))
        frames = self.arm.frames(q)
        dq = np.diff(q, axis=0) / period
        ddq = np.diff(dq, axis=0) / period
        speed = max(_fastest(frames[:, b.group], c) for b, c in zip(self._bodies, self._fast, strict=True) if b.group) / period
        margins, too_close = self._least_margins(frames)
        torque, joint = self._torque(q[1:-1], 0.5 * (dq[1:] + dq[:-1]), ddq)
        return Findings(
            margins_m=margins,
            too_close_m=too_close,
            speed_m_s=float(speed),
            speed_limit_m_s=self._cell.limits.cartesian_speed_m_s,
            velocity=float((np.abs(dq) / self._velocity).max()),
            acceleration=float((np.abs(ddq) / self._acceleration).max()),
            position=float(np.maximum(self.arm.lower - q, q - self.arm.upper).max()),
            samples=len(q) - 2,
            torque=torque,
            torque_joint=joint,
            flight_m=self.flights(q, period),
        )

    def margins(self, q: Array) -> dict[str, tuple[float, str]]:
        """Smallest margin at q (n,) for each kind of pair, and its pair."""
        frames = self.arm.frames(np.asarray(q, dtype=float)[None])[0]
        least: dict[str, tuple[float, str]] = {}
        for pair in self.pairs:
            found = self._margin(pair, frames), pair.name
            least[pair.kind] = min(least.get(pair.kind, found), found)
        return least

    def is_free(self, q: Array, extra_m: float = 0.0) -> bool:
        """Whether all pairs keep what they must at q (n,), `extra_m` more of what is around, and no joint is beyond its limits."""
        if (q < self.arm.lower).any() or (q > self.arm.upper).any():
            return False
        frames = self.arm.frames(np.asarray(q, dtype=float)[None])[0]
        least = self._required + extra_m * self._around
        close = _too_close(self._packed, self._groups, self._table, least, frames)
        return all(self._distance(self.pairs[k].first, self.pairs[k].second, least[k], frames) >= least[k] for k in close)

    def touches_base(self, name: str) -> bool:
        """Whether the robot's base is in, or touches, an obstacle or a zone of that name."""
        still = self.arm.frames(np.array(self._cell.robot.home_rad)[None])[0]
        bases = [i for i, body in enumerate(self._bodies) if body.group == 0 and body.name not in self._kinds]
        k = next(i for i, body in enumerate(self._bodies) if body.name == name)
        return any(self._distance(i, k, 0.0, still) <= 0.0 for i in bases)

    def flights(self, q: Array, period: float) -> tuple[float, str]:
        """How near a load that comes off anywhere along q (N, n) flies to a protected zone, m, and to which; see `tests.free_flight`."""
        poses = self.arm.sensor_poses(q)
        centres = [np.array(self._box.pose.xyz_m)]
        if self._load is not None:
            centres.append(self._load.first / self._load.mass)
        local = pose(self._box.pose.xyz_m, self._box.pose.rpy_rad)
        found = [
            (
                deepest_flight(
                    self.payload, local, centre, poses, period, _standing(self._cell, zone).convex, self._cell.gravity, self._cell.floor_z_m
                ),
                zone.name,
            )
            for zone in self._cell.zones
            for centre in centres
        ]
        return min(found, default=(np.inf, ""))

    def axis_direction(self, q: Array, axis: int) -> Array:
        """(3,), a sensor axis in the world at q (n,)."""
        return np.asarray(self.arm.sensor_poses(np.asarray(q, dtype=float)[None])[0, :3, axis])

    def weight_share(self, q: Array) -> float:
        """The largest share of a joint's effort that it needs to stand still at q (n,)."""
        still = np.zeros((1, self.arm.n))
        return self._torque(np.asarray(q, dtype=float)[None], still, still)[0]

    def _torque(self, q: Array, dq: Array, ddq: Array) -> tuple[float, str]:
        """The largest share of a joint's effort, and the joint."""
        if self._load is None:
            return 0.0, ""
        shares = np.abs(self.arm.torques(q, dq, ddq, self._cell.gravity, self._load)).max(axis=0) / self.arm.effort
        k = int(np.argmax(shares))
        return float(shares[k]), self.arm.moving[k].name

    def _least_margins(self, frames: Array) -> tuple[dict[str, tuple[float, str]], dict[tuple[str, str], float]]:
        least: dict[str, tuple[float, str]] = {}
        too_close: dict[tuple[str, str], float] = {}
        for pair in self.pairs:
            margin = self._least_of(pair, frames)
            least[pair.kind] = min(least.get(pair.kind, (np.inf, "")), (margin, pair.name))
            if margin < -NUMERICAL_M:
                too_close[pair.kind, pair.name] = margin
        return least, too_close

    def _least_of(self, pair: Pair, frames: Array) -> float:
        """The least margin of one pair along a motion, (N, n + 1, 4, 4)."""
        i, k = pair.first, pair.second
        first, second = frames[:, self._groups[i]], frames[:, self._groups[k]]
        least, at, margin = np.inf, 0, np.nan
        while at < len(frames):
            at, low, margin = _sweep(self._packed, i, k, first, second, self._corners[i], pair.required_m, at, margin)
            least = min(least, low)
            if at < len(frames):  # the hulls are too close there
                margin = self._margin(pair, frames[at])
                least = min(least, margin)
        return float(least)

    def _margin(self, pair: Pair, frames: Array) -> float:
        """At one configuration, `frames` (n + 1, 4, 4)."""
        return self._distance(pair.first, pair.second, pair.required_m, frames) - pair.required_m

    def _distance(self, i: int, k: int, enough_m: float, frames: Array) -> float:
        """Of two bodies: of their hulls, and where that is not enough and one of them is hollow, of their triangles."""
        first, second = frames[self._groups[i]], frames[self._groups[k]]
        low, high = bounds(self._packed, i, k, first, second)
        if low > 0.0 and high - low > EXACT_M * max(1.0, 10.0 * high):  # a millionth of what is far away will do
            raise ArithmeticError(f"{self._bodies[i].name} - {self._bodies[k].name}: a distance between {low} and {high} m")
        if low >= enough_m or (self._bodies[i].triangles is None and self._bodies[k].triangles is None):
            return float(low)
        placed = [fcl.CollisionObject(self._triangles[x], fcl.Transform(T[:3, :3], T[:3, 3])) for x, T in ((i, first), (k, second))]
        apart = float(fcl.distance(*placed, fcl.DistanceRequest(), fcl.DistanceResult()))
        return apart if apart > 0.0 else float(min(low, 0.0))

    def _environment(self, moving: int) -> Iterator[Pair]:
        mounts = [k for k in range(moving, len(self._bodies)) if self._is_mount(moving, k)]
        for i, body in enumerate(self._bodies[:moving]):
            for k, thing in enumerate(self._bodies[moving:], start=moving):
                if body.group == 0:
                    continue
                required = self._cell.limits.clearance_m
                if k in mounts and body.group == 1 and self._meet(i, k) == NEVER:
                    required = 0.0
                if k in mounts and body.group == 2 and body.name != PAYLOAD and not self._is_ever_apart(i, k, required):
                    required = 0.0
                yield Pair(i, k, required, self._kinds[thing.name], f"{body.name} - {thing.name}")

    def _is_mount(self, moving: int, k: int) -> bool:
        """Whether the robot's base stands on, hangs from or is let into something that is no protected zone."""
        if self._kinds[self._bodies[k].name] == "zone":
            return False
        bases = [i for i, body in enumerate(self._bodies[:moving]) if body.group == 0]
        still = self.arm.frames(np.array(self._cell.robot.home_rad)[None])[0]
        return any(self._distance(i, k, _MOUNT_M, still) <= _MOUNT_M for i in bases)

    def _own(self, moving: int) -> Iterator[Pair]:
        declared = {frozenset(pair) for pair in getattr(self._cell.robot, "adjacent", ())}
        keep = self._cell.limits.self_clearance_m
        for i, a in enumerate(self._bodies[:moving]):
            for k, b in enumerate(self._bodies[:moving]):
                if a.group <= b.group:
                    continue
                names, kind = frozenset((a.name, b.name)), PAYLOAD if PAYLOAD in (a.name, b.name) else "self"
                required, reason = keep, ""
                if names in declared:
                    reason = "declared adjacent"
                elif names in self.arm.joined:
                    reason = "they share a joint"
                elif a.group - b.group <= 2:
                    meet = self._meet(i, k)
                    required = 0.0 if meet == NEVER else keep
                    if meet == ALWAYS and kind == "self":
                        reason = "they overlap at all angles"
                if reason:
                    self.left_out.append((a.name, b.name, reason))
                else:
                    yield Pair(i, k, required, kind, f"{a.name} - {b.name}")

    def _meet(self, i: int, k: int) -> str:
        """Whether two bodies touch at no, some or all angles of a grid of the joints between them, which are one or two."""
        found: set[bool] = set()
        for frames in self._all_angles(i, k):
            found.add(self._distance(i, k, CONTACT_M, frames) <= CONTACT_M)
            if len(found) == 2:
                return SOMETIMES
        return ALWAYS if found == {True} else NEVER

    def _is_ever_apart(self, i: int, k: int, required_m: float) -> bool:
        """Whether two bodies are that far apart at any angles of the same grid."""
        return any(self._distance(i, k, required_m, frames) >= required_m for frames in self._all_angles(i, k))

    def _all_angles(self, i: int, k: int) -> Array:
        """(N, groups, 4, 4), the frames at a grid of the angles between two bodies."""
        between = list(range(self._groups[k], self._groups[i]))
        angles = [np.linspace(max(self.arm.lower[j], -np.pi), min(self.arm.upper[j], np.pi), GRID) for j in between]
        grid = np.stack(np.meshgrid(*angles), axis=-1).reshape(-1, len(between))
        q = np.tile(np.array(self._cell.robot.home_rad), (len(grid), 1))
        q[:, between] = grid
        return np.asarray(self.arm.frames(q))


def _outermost(body: Convex) -> Array:
    """Points of which one is the fastest of a body, however it moves."""
    exact = body.ball_m == 0.0 and body.axis is None and len(body.points) <= _MOST_POINTS
    return body.points if exact else body.corners


@njit(cache=True)
def _sweep(bodies, i, k, first, second, corners, required, start, margin):  # type: ignore[no-untyped-def]  # numba infers them
    """Goes along a motion from sample `start` until the hulls of a pair are too close.

    Args:
        first, second: (N, 4, 4), placements of the groups of the two bodies.
        corners: (8, 3), of the first body.
        margin: at `start`, NaN where it has not been looked at.

    Returns the sample where it stopped, N at the end, the least margin on the way and the last one.
    """
    least, at = np.inf, start
    while True:
        if np.isnan(margin):
            low, _ = bounds(bodies, i, k, first[at], second[at])
            margin = low - required
            if margin < 0.0:
                return at, least, margin
            least = min(least, margin)
        room = max(margin, 1e-9) if margin >= 0.0 else _ANEW_M
        inverse = np.ascontiguousarray(np.linalg.inv(second[at])) @ np.ascontiguousarray(first[at])
        here = corners @ np.ascontiguousarray(inverse[:3, :3].T) + inverse[:3, 3]
        while True:
            at += 1
            if at >= len(first):
                return at, least, margin
            R, T = second[at], first[at]
            moved = 0.0
            for c in range(8):
                square = 0.0
                x = T[0, 0] * corners[c, 0] + T[0, 1] * corners[c, 1] + T[0, 2] * corners[c, 2] + T[0, 3] - R[0, 3]
                y = T[1, 0] * corners[c, 0] + T[1, 1] * corners[c, 1] + T[1, 2] * corners[c, 2] + T[1, 3] - R[1, 3]
                z = T[2, 0] * corners[c, 0] + T[2, 1] * corners[c, 1] + T[2, 2] * corners[c, 2] + T[2, 3] - R[2, 3]
                for r in range(3):
                    step = R[0, r] * x + R[1, r] * y + R[2, r] * z - here[c, r]
                    square += step * step
                moved = max(moved, square)
            if moved > room * room:
                break
        margin = np.nan


@njit(cache=True)
def _too_close(bodies, groups, table, required, frames):  # type: ignore[no-untyped-def]  # numba infers them
    """Pairs of which the hulls are closer than required at one configuration."""
    found = []
    for p in range(len(table)):
        i, k = table[p]
        low, _ = bounds(bodies, i, k, frames[groups[i]], frames[groups[k]])
        if low < required[p]:
            found.append(p)
    return found


def _fastest(frames: Array, corners: Array) -> float:
    """The longest way of a corner between two samples, m; `frames` (N, 4, 4)."""
    places = corners @ np.swapaxes(frames[:, :3, :3], 1, 2) + frames[:, None, :3, 3]
    return float(np.linalg.norm(np.diff(places, axis=0), axis=2).max())


def _bvh(body: Body) -> Any:
    """The triangles of a body, of its hull where it is convex; None of what is round."""
    triangles = body.triangles
    if triangles is None:
        triangles = _hull_triangles(body.convex)
    model = fcl.BVHModel()
    model.beginModel(3 * len(triangles), len(triangles))
    model.addSubModel(triangles.reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3))
    model.endModel()
    return model


def _hull_triangles(body: Convex) -> Array:
    """(F, 3, 3), of the surface; what is round is taken as wide as a fine polyhedron that contains it."""
    points = body.points
    if body.ball_m > 0.0:
        sphere = trimesh.creation.icosphere(subdivisions=3, radius=1.003 * body.ball_m).vertices
        points = (points[:, None] + sphere).reshape(-1, 3)
    if body.disc_m > 0.0:
        assert body.axis is not None
        across = np.linalg.svd(body.axis[None])[2][1:]
        angle = np.linspace(0.0, 2.0 * np.pi, 96, endpoint=False)[:, None]
        rim = body.disc_m / np.cos(np.pi / 96) * (np.cos(angle) * across[0] + np.sin(angle) * across[1])
        points = (points[:, None] + rim).reshape(-1, 3)
    return np.array(trimesh.convex.convex_hull(points).triangles)


def _standing(cell: Cell, item: Obstacle | Zone) -> Body:
    """An obstacle or a zone; a mesh as trimesh reads it, with its triangles."""
    if not isinstance(item.shape, Mesh):
        return Body(item.name, 0, _convex(item.shape))
    mesh = trimesh.load_mesh(cell.folder / item.shape.file)
    place = pose(item.shape.pose.xyz_m, item.shape.pose.rpy_rad)
    points = mesh.vertices * item.shape.scale @ place[:3, :3].T + place[:3, 3]
    return Body(item.name, 0, Convex(np.array(trimesh.convex.convex_hull(points).vertices)), points[mesh.faces])


def _convex(shape: Shape) -> Convex:
    """An obstacle, a zone or a payload box where it is given."""
    made = {
        "box": lambda: box(np.array(shape.size_m)),  # type: ignore[union-attr]  # of the shape whose kind is asked for
        "sphere": lambda: ball(shape.radius_m),  # type: ignore[union-attr]  # of the shape whose kind is asked for
        "capsule": lambda: capsule(shape.radius_m, shape.length_m),  # type: ignore[union-attr]  # of the shape whose kind is asked for
    }[shape.kind]()
    return made.moved(pose(shape.pose.xyz_m, shape.pose.rpy_rad))


def _inertia(payload: Payload) -> Inertia:
    xx, xy, xz, yy, yz, zz = payload.inertia_kg_m2
    return Inertia(payload.mass_kg, np.array(payload.first_moment_kg_m), np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]))
