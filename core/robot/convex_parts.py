"""Convex parts that together contain a solid's surface: one hull where that takes hardly more room than the solid, else several.

The surface is clipped by planes into pieces, and pieces whose common hull takes hardly more room are put together again: whatever is cut
and joined, every point of the surface is in the hull of its piece. What is inside is contained as far as hulls of the pieces close over it;
nothing gets there but through the surface. There is no chance in it.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError, cKDTree

from core.array import Array

Triangles = NDArray[np.int64]

STANDS_OFF_M = 0.03
"""A hull that nowhere stands farther off the surface is taken as it is."""

MOST_PARTS = 6
DEPTH = 3
"""Cuts one after the other: 8 pieces before some are joined."""
SLABS = 5
"""Of a piece along an axis; it may be cut between any two of them."""
HARDLY = 0.01
"""Room that joining two pieces may add, as a share of the whole hull's."""
FLAT = 1e-9
"""A hull of less than this share of the volume of the cube round its points is flat."""
_STEP_M = 0.005
_MOST_POINTS = 50_000


def hull_points(points: Array) -> Array | None:
    """(k, 3), corners of the convex hull of points (n, 3); None where they lie in a plane."""
    try:
        hull = ConvexHull(points)
    except (QhullError, ValueError):  # flat, or fewer than four
        return None
    return points[hull.vertices] if hull.volume > FLAT * float(np.ptp(points, axis=0).max()) ** 3 else None


def convex_parts(vertices: Array, triangles: Triangles) -> list[Array]:
    """The corners (k, 3) of each part; none where the mesh is flat.

    Args:
        vertices: (n, 3), m.
        triangles: (m, 3), numbers of vertices; the surface of a solid.
    """
    whole = hull_points(vertices)
    if whole is None:
        return []
    if not stands_off(vertices[triangles], whole, STANDS_OFF_M):
        return [whole]
    return _join_pieces(_pieces(vertices[triangles], 0), HARDLY * _volume(whole))


def stands_off(soup: Array, hull: Array, limit_m: float) -> bool:
    """Whether the surface of a hull of points (k, 3) is anywhere farther than `limit_m` from triangles (m, 3, 3).

    How far is not asked: before a flat wall a metre away half of its points are nearly the nearest one, and all would be looked at.
    """
    found = ConvexHull(hull)
    step = max(_STEP_M, float(np.sqrt(found.area / _MOST_POINTS)))
    surface = cKDTree(_sample_triangles(soup, step), balanced_tree=False)
    distance, _ = surface.query(_sample_triangles(hull[found.simplices], step), distance_upper_bound=np.nextafter(limit_m, np.inf))
    return bool(np.isinf(distance).any())  # what is not nearer than the bound


def _sample_triangles(soup: Array, step: float) -> Array:
    """Points of triangles (m, 3, 3), on each a grid that is not coarser than `step`."""
    lengths = np.linalg.norm(np.roll(soup, -1, axis=1) - np.roll(soup, 1, axis=1), axis=2)  # of the edge opposite each corner
    order = (lengths.argmin(axis=1)[:, None] + np.arange(3)) % 3
    apex, a, b = np.moveaxis(np.take_along_axis(soup, order[:, :, None], axis=1), 1, 0)  # a and b are the ends of the shortest edge
    needed = np.column_stack([lengths.max(axis=1), lengths.min(axis=1)]) / step
    counts = 2 ** np.ceil(np.log2(np.maximum(needed, 1.0))).astype(int)
    found = []
    for along, across in np.unique(counts, axis=0):
        these = (counts == [along, across]).all(axis=1)
        s, t = np.meshgrid(np.linspace(0.0, 1.0, along + 1), np.linspace(0.0, 1.0, across + 1))
        weights = np.column_stack([1.0 - s.ravel(), (s * (1.0 - t)).ravel(), (s * t).ravel()])
        found.append(np.einsum("wc,cmx->mwx", weights, np.stack([apex[these], a[these], b[these]])).reshape(-1, 3))
    return np.concatenate(found)


def _volume(points: Array) -> float:
    """Of the hull of points (k, 3), m3; zero where it is flat."""
    try:
        volume = float(ConvexHull(points).volume)
    except (QhullError, ValueError):
        return 0.0
    return volume if volume > FLAT * float(np.ptp(points, axis=0).max()) ** 3 else 0.0


def _pieces(soup: Array, depth: int) -> list[Array]:
    """Hulls' corners, or all points of a flat piece, of triangles (m, 3, 3) that have been cut `depth` times."""
    points = np.unique(soup.reshape(-1, 3), axis=0)
    corners = hull_points(points)
    if corners is None:
        return [points]
    if depth == DEPTH or (depth > 0 and not stands_off(soup, corners, STANDS_OFF_M)):
        return [corners]
    axis, height = _best_cut(soup, points)
    sides = [_clip(soup, axis, height, sign) for sign in (1.0, -1.0)]
    return [piece for side in sides if len(side) for piece in _pieces(side, depth + 1)]


def _best_cut(soup: Array, points: Array) -> tuple[int, float]:
    """The axis and the height at which a plane leaves the least room in the hulls of both sides."""
    best = np.inf, 0, 0.0
    for axis in range(3):
        heights = np.linspace(points[:, axis].min(), points[:, axis].max(), SLABS + 1)
        outlines = [np.empty((0, 3)), *(_outline(soup, axis, height) for height in heights[1:-1]), np.empty((0, 3))]
        slab = np.clip(np.searchsorted(heights, points[:, axis]) - 1, 0, SLABS - 1)
        slabs = [_corners(np.concatenate([points[slab == k], outlines[k], outlines[k + 1]])) for k in range(SLABS)]
        for k in range(1, SLABS):
            room = _volume(np.concatenate(slabs[:k])) + _volume(np.concatenate(slabs[k:]))
            best = min(best, (room, axis, float(heights[k])))
    return best[1:]


def _corners(points: Array) -> Array:
    """Those that a hull needs."""
    found = hull_points(points) if len(points) > 4 else None
    return points if found is None else found


def _outline(soup: Array, axis: int, height: float) -> Array:
    """(k, 3), where the edges of triangles (m, 3, 3) go through a plane."""
    a, b = soup.reshape(-1, 3), np.roll(soup, -1, axis=1).reshape(-1, 3)
    through = (a[:, axis] < height) != (b[:, axis] < height)
    a, b = a[through], b[through]
    share = (height - a[:, axis]) / (b[:, axis] - a[:, axis])
    return np.asarray(a + share[:, None] * (b - a))


def _clip(soup: Array, axis: int, height: float, sign: float) -> Array:
    """(k, 3, 3), what triangles (m, 3, 3) have on one side of a plane."""
    above = sign * (soup[:, :, axis] - height)
    inside = above >= 0.0
    count = inside.sum(axis=1)
    found = [soup[count == 3]]
    for alone in (True, False):  # the corner by itself is the one inside, or the one outside
        which = count == (1 if alone else 2)
        first = np.argmax(inside[which] == alone, axis=1)
        order = (first[:, None] + np.arange(3)) % 3
        a, b, c = np.moveaxis(np.take_along_axis(soup[which], order[:, :, None], axis=1), 1, 0)
        ha, hb, hc = np.take_along_axis(above[which], order, axis=1).T
        ab = a + (ha / (ha - hb))[:, None] * (b - a)
        ac = a + (ha / (ha - hc))[:, None] * (c - a)
        found += [np.stack([a, ab, ac], axis=1)] if alone else [np.stack([ab, b, c], axis=1), np.stack([ab, c, ac], axis=1)]
    return np.concatenate(found)


def _join_pieces(pieces: list[Array], room: float) -> list[Array]:
    """Pieces, of which two are joined as long as that adds at most `room`, one is flat, or they are too many."""
    volumes = [_volume(piece) for piece in pieces]
    here = set(range(len(pieces)))
    added: dict[tuple[int, int], float] = {}
    for i, k in combinations(here, 2):
        added[i, k] = _volume(np.concatenate([pieces[i], pieces[k]])) - volumes[i] - volumes[k]
    while added:
        flat = {i for i in here if volumes[i] == 0.0}
        cost, (i, k) = min((cost, pair) for pair, cost in added.items() if not flat or flat & {*pair})
        if cost > room and not flat and len(here) <= MOST_PARTS:
            break
        pieces.append(_corners(np.concatenate([pieces[i], pieces[k]])))
        volumes.append(_volume(pieces[-1]))
        here -= {i, k}
        added = {pair: each for pair, each in added.items() if here.issuperset(pair)}
        new = len(pieces) - 1
        for j in here:
            added[j, new] = _volume(np.concatenate([pieces[j], pieces[new]])) - volumes[j] - volumes[new]
        here.add(new)
    return [pieces[i] for i in sorted(here)]
