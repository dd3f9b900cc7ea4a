"""Distances of convex bodies with a certificate: between a bound that nothing can be below and one that nothing can be above.

The search is that of Gilbert, Johnson and Keerthi (IEEE J. Robotics and Automation 4(2), 1988), written anew for the tests. Whatever it
does, its answer needs no trust: the direction that it ends with separates the bodies by the gap of their supports, which is a lower bound,
and the point that it ends with is a point of their difference, whose norm is an upper bound.

A body is the hull of points, swept by a ball (spheres, capsules), or by a disc (cylinders).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.array import Array

EXACT_M = 1e-7
"""The two bounds are no farther apart than this."""

_ROUNDS = 400
_DIRECTIONS = 400


@dataclass(frozen=True)
class Convex:
    """The hull of points with what is swept along it.

    Args:
        points: (V, 3), m.
        ball_m: radius of a ball round each point.
        disc_m: radius of a disc round each point, with its normal along `axis` (3,), a unit vector.
    """

    points: Array
    ball_m: float = 0.0
    disc_m: float = 0.0
    axis: Array | None = None

    def moved(self, T: Array) -> Convex:
        """The same body placed by T (4, 4)."""
        axis = None if self.axis is None else T[:3, :3] @ self.axis
        return Convex(np.ascontiguousarray(self.points @ T[:3, :3].T + T[:3, 3]), self.ball_m, self.disc_m, axis)

    @property
    def corners(self) -> Array:
        """(8, 3), of a box round the body, along the axes that it is given in, m."""
        wide = np.zeros(3) if self.axis is None else self.disc_m * np.sqrt(np.maximum(1.0 - self.axis**2, 0.0))
        low, high = self.points.min(axis=0) - wide - self.ball_m, self.points.max(axis=0) + wide + self.ball_m
        return np.stack(np.meshgrid(*np.array([low, high]).T), axis=-1).reshape(-1, 3)


def box(size_m: Array) -> Convex:
    """A cuboid about the origin."""
    signs = np.array([[a, b, c] for a in (-0.5, 0.5) for b in (-0.5, 0.5) for c in (-0.5, 0.5)])
    return Convex(signs * np.asarray(size_m))


def ball(radius_m: float) -> Convex:
    """A ball about the origin."""
    return Convex(np.zeros((1, 3)), ball_m=radius_m)


def capsule(radius_m: float, length_m: float) -> Convex:
    """A capsule along z; `length_m` without its round ends."""
    return Convex(np.array([[0.0, 0.0, -0.5 * length_m], [0.0, 0.0, 0.5 * length_m]]), ball_m=radius_m)


def cylinder(radius_m: float, length_m: float) -> Convex:
    """A cylinder along z."""
    ends = np.array([[0.0, 0.0, -0.5 * length_m], [0.0, 0.0, 0.5 * length_m]])
    return Convex(ends, disc_m=radius_m, axis=np.array([0.0, 0.0, 1.0]))


def distance(first: Convex, second: Convex) -> float:
    """The certified distance of two bodies in one frame, m, at most `EXACT_M` too small; an estimate of minus the depth where they meet.

    Raises:
        ArithmeticError: the search ended with its two bounds apart.
    """
    arrays, still = packed([first, second]), np.eye(4)
    low, high = bounds(arrays, 0, 1, still, still)
    if low > 0.0 and high - low > EXACT_M:
        raise ArithmeticError(f"a distance between {low} and {high} m")
    return float(low)


def packed(bodies: list[Convex]) -> tuple[Array, NDArray[np.int64], Array, Array]:
    """The bodies as arrays for compiled code: points (V, 3), where each begins (B + 1,), its radii (B, 2) and axis (B, 3)."""
    begins = np.cumsum([0, *(len(body.points) for body in bodies)])
    axes = np.array([np.zeros(3) if body.axis is None else body.axis for body in bodies]).reshape(-1, 3)
    radii = np.array([[body.ball_m, body.disc_m] for body in bodies]).reshape(-1, 2)
    return np.concatenate([body.points for body in bodies]), begins.astype(np.int64), radii, axes


@njit(cache=True)
def _support(bodies, k, T, d):  # type: ignore[no-untyped-def]  # numba infers them
    """The farthest point along d of body k placed by T, its ball left out."""
    points, begins, radii, axes = bodies
    R = T[:3, :3]
    x = R[0, 0] * d[0] + R[1, 0] * d[1] + R[2, 0] * d[2]
    y = R[0, 1] * d[0] + R[1, 1] * d[1] + R[2, 1] * d[2]
    z = R[0, 2] * d[0] + R[1, 2] * d[1] + R[2, 2] * d[2]
    best, most = begins[k], -np.inf
    for i in range(begins[k], begins[k + 1]):
        along = points[i, 0] * x + points[i, 1] * y + points[i, 2] * z
        if along > most:
            best, most = i, along
    px, py, pz = points[best, 0], points[best, 1], points[best, 2]
    if radii[k, 1] > 0.0:
        ax, ay, az = axes[k, 0], axes[k, 1], axes[k, 2]
        along = x * ax + y * ay + z * az
        sx, sy, sz = x - along * ax, y - along * ay, z - along * az
        norm = np.sqrt(sx * sx + sy * sy + sz * sz)
        if norm > 1e-14:
            px, py, pz = px + radii[k, 1] * sx / norm, py + radii[k, 1] * sy / norm, pz + radii[k, 1] * sz / norm
    found = np.empty(3)
    for r in range(3):
        found[r] = R[r, 0] * px + R[r, 1] * py + R[r, 2] * pz + T[r, 3]
    return found


@njit(cache=True)
def _dot(a, b):  # type: ignore[no-untyped-def]  # numba infers them
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@njit(cache=True)
def _cross(a, b):  # type: ignore[no-untyped-def]  # numba infers them
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


@njit(cache=True)
def _try_triangle(a, b, c, weights):  # type: ignore[no-untyped-def]  # numba infers them
    """Weights of the foot of the origin on the plane of a triangle; False where it is outside."""
    normal = _cross(b - a, c - a)
    square = _dot(normal, normal)
    if square < 1e-30:
        return False
    weights[0], weights[1] = _dot(_cross(b, c), normal) / square, _dot(_cross(c, a), normal) / square
    weights[2] = 1.0 - weights[0] - weights[1]
    return weights[0] >= 0.0 and weights[1] >= 0.0 and weights[2] >= 0.0


@njit(cache=True)
def _nearest_of(simplex, count):  # type: ignore[no-untyped-def]  # noqa: PLR0912  # a branch for each kind of face
    """The point of a simplex nearest to the origin: every face is tried. Returns it and which corners it needs (a bit mask)."""
    best, mask, least = simplex[0].copy(), 1, np.inf
    for i in range(count):
        square = _dot(simplex[i], simplex[i])
        if square < least:
            best, mask, least = simplex[i].copy(), 1 << i, square
    for i in range(count):
        for j in range(i):
            edge = simplex[j] - simplex[i]
            length = _dot(edge, edge)
            if length < 1e-30:
                continue
            t = -_dot(simplex[i], edge) / length
            if 0.0 < t < 1.0:
                point = simplex[i] + t * edge
                square = _dot(point, point)
                if square < least:
                    best, mask, least = point, (1 << i) | (1 << j), square
    weights = np.empty(3)
    for i in range(count):
        for j in range(i):
            for k in range(j):
                if _try_triangle(simplex[i], simplex[j], simplex[k], weights):
                    point = weights[0] * simplex[i] + weights[1] * simplex[j] + weights[2] * simplex[k]
                    square = _dot(point, point)
                    if square < least:
                        best, mask, least = point, (1 << i) | (1 << j) | (1 << k), square
    if count == 4:
        a, b, c, d = simplex[0], simplex[1], simplex[2], simplex[3]
        volume = _dot(_cross(b - a, c - a), d - a)
        if abs(volume) > 1e-18:
            parts = np.array([_dot(b, _cross(c, d)), -_dot(a, _cross(c, d)), _dot(a, _cross(b, d)), -_dot(a, _cross(b, c))]) / volume
            if parts.min() >= 0.0:
                return np.zeros(3), 15
    return best, mask


@njit(cache=True)
def bounds(bodies, i, k, first, second):  # type: ignore[no-untyped-def]  # numba infers them
    """Bounds of the distance of bodies i and k placed by (4, 4) each, m; both minus an estimate of the depth where they meet."""
    radius = bodies[2][i, 0] + bodies[2][k, 0]
    simplex = np.empty((4, 3))
    d = np.array([1.0, 0.0, 0.0])
    simplex[0] = _support(bodies, i, first, -d) - _support(bodies, k, second, d)
    count, low, high = 1, -np.inf, np.inf
    for _ in range(_ROUNDS):
        v, mask = _nearest_of(simplex, count)
        norm = np.sqrt(_dot(v, v))
        high = min(high, norm)
        if norm < 1e-9:
            break
        kept = 0
        for bit in range(count):
            if mask >> bit & 1:
                simplex[kept] = simplex[bit]
                kept += 1
        w = _support(bodies, i, first, -v) - _support(bodies, k, second, v)
        low = max(low, _dot(v, w) / norm)
        if high - low < 1e-8 + 1e-7 * 0.1 * (high > 1.0):
            break
        repeated = False
        for s in range(kept):
            repeated = repeated or (simplex[s, 0] == w[0] and simplex[s, 1] == w[1] and simplex[s, 2] == w[2])
        if repeated:
            break
        simplex[kept] = w
        count = kept + 1
    if low <= 0.0:
        low = -_depth(bodies, i, k, first, second)
        high = low
    return low - radius, high - radius


@njit(cache=True)
def _depth(bodies, i, k, first, second):  # type: ignore[no-untyped-def]  # numba infers them
    """At least how far one body must be pushed to leave the other, estimated from above by many directions, m."""
    least = np.inf
    for s in range(_DIRECTIONS):
        z = 1.0 - (2.0 * s + 1.0) / _DIRECTIONS
        angle = s * 2.399963229728653
        r = np.sqrt(1.0 - z * z)
        d = np.array([r * np.cos(angle), r * np.sin(angle), z])
        least = min(least, _dot(d, _support(bodies, i, first, d) - _support(bodies, k, second, -d)))
    for frame in (first, second):
        for column in range(3):
            for sign in (-1.0, 1.0):
                d = sign * frame[:3, column].copy()
                least = min(least, _dot(d, _support(bodies, i, first, d) - _support(bodies, k, second, -d)))
    return max(least, 0.0)
