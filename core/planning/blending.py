"""Rounds the corners of a polyline in joint space, so that a robot need not stop at them.

Each corner is replaced by a quintic Bezier curve whose control points lie at d, 0.6 d and 0.2 d from the corner on both sides. Three of
them lie evenly on each side's straight line, so the curve joins it with equal tangent and no curvature (C2), and reduces to the straight
line where there is no corner. By the convex hull property it stays in the triangle that it cuts off.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.interpolate import BPoly, PPoly

from core.array import Array
from core.errors import NoPath

_SIDE = np.array([1.0, 0.6, 0.2])
_HALVINGS = 10


def corners(q: Array) -> Array:
    """(M, n) vertices of the polyline q (N, n): both ends, and every row at which the direction changes by more than 1e-6 rad."""
    steps = np.diff(q, axis=0)
    length = np.linalg.norm(steps, axis=1)
    q = q[np.concatenate(([True], length > 1e-9))]
    if len(q) < 3:
        return q
    directions = np.diff(q, axis=0)
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    turn = np.linalg.norm(np.diff(directions, axis=0), axis=1)
    return q[np.concatenate(([True], turn > 1e-6, [True]))]


def round_corners(q: Array, is_clear: Callable[[Array], bool] | None = None, *, step: float = 0.02) -> PPoly:
    """Smooth curve along a polyline.

    Args:
        q: (N, n), rad; the polyline, at least two distinct rows.
        is_clear: says whether samples (K, n) of a rounded corner are clear of everything; rounding starts with half of the shorter side and
            is halved until it is clear. None accepts everything.
        step: largest distance between those samples, rad.

    Returns:
        Curve (n values) over [0, length], twice continuously differentiable, with a parameter that is the arc length on straight parts.

    Raises:
        NoPath: a corner cannot be rounded at all.
    """
    vertices = corners(q)
    sides = np.diff(vertices, axis=0)
    length = np.linalg.norm(sides, axis=1)
    direction = sides / length[:, None]
    cut = np.zeros(len(vertices))
    for i in range(1, len(vertices) - 1):
        cut[i] = _cut(vertices[i], direction[i - 1], direction[i], 0.5 * min(length[i - 1], length[i]), is_clear, step)
    pieces: list[Array] = []
    extent: list[float] = []
    for i, side in enumerate(length):
        straight = side - cut[i] - cut[i + 1]
        if straight > 1e-9:
            first = vertices[i] + cut[i] * direction[i]
            pieces.append(first + straight * np.linspace(0.0, 1.0, 6)[:, None] * direction[i])
            extent.append(straight)
        if i + 1 < len(length):
            pieces.append(_corner(vertices[i + 1], direction[i], direction[i + 1], cut[i + 1]))
            extent.append(2.0 * cut[i + 1])
    breaks = np.concatenate(([0.0], np.cumsum(extent)))
    return PPoly.from_bernstein_basis(BPoly(np.stack(pieces, axis=1), breaks))


def _corner(vertex: Array, before: Array, after: Array, d: float) -> Array:
    """(6, n) Bezier control points of a corner between two directions."""
    return np.concatenate((vertex - d * _SIDE[:, None] * before, vertex + d * _SIDE[::-1, None] * after))


def _cut(vertex: Array, before: Array, after: Array, d: float, is_clear: Callable[[Array], bool] | None, step: float) -> float:
    for _ in range(_HALVINGS):
        if is_clear is None:
            return d
        s = np.linspace(0.0, 1.0, 2 + int(2.0 * d / step))
        if is_clear(np.asarray(BPoly(_corner(vertex, before, after, d)[:, None], [0.0, 1.0])(s))):
            return d
        d *= 0.5
    raise NoPath("planning-corner-too-tight", corner_rad=np.round(vertex, 3).tolist(), smallest_rad=2 * d)
