"""When something jumped several times: the rows from which on steps of given directions explain most of a residual together."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.scene import Scene
from core.effects.window_search import columns_of_payload_and_offsets

ROWS, FEWEST = 600, 60
"""The search looks at about so many rows at most, and finds nothing among fewer."""
EDGE = 3
"""Rows that two jumps are apart at least, and that they keep from both ends."""
RIDGE = 1e-9
"""Of jumps that no row tells from payload and offsets."""


def find_jumps(scene: Scene, residual: Array, directions: Array, count: int) -> tuple[Array, Array] | None:
    """Jumps that take most out of a residual beside payload and offsets; None where there are too few rows.

    Each is placed where it takes most beside those before it, then once more beside all others. Unlike `best_steps` it tells jumps that
    follow each other within a second.

    Args:
        residual: (N, 6), in standard deviations of the noise.
        directions: (6, k), what may jump, in the same unit up to a factor.
        count: how many.

    Returns:
        Times (count,), s since the first sample, rising, and sizes (count, k).
    """
    rows = slice(0, None, max(1, len(scene) // ROWS))
    wanted = residual[rows]
    n = len(wanted)
    if n < FEWEST:
        return None
    known = columns_of_payload_and_offsets(scene, rows)
    jumps: list[int] = []
    for _ in range(2 * count):
        others = jumps[1 - count :] if count > 1 else []
        columns = np.concatenate((known, _step_at(others, n, directions)), axis=2)
        jumps = [*others, _find_jump(columns, wanted, directions, others)]
    jumps.sort()
    columns = np.concatenate((known, _step_at(jumps, n, directions)), axis=2).reshape(6 * n, -1)
    sizes = np.linalg.lstsq(columns, wanted.ravel(), rcond=None)[0][known.shape[2] :]
    return scene.elapsed[rows][jumps] - 0.5 * scene.period, np.asarray(sizes.reshape(count, -1), dtype=np.float64)


def _find_jump(columns: Array, wanted: Array, directions: Array, others: list[int]) -> int:
    """The row from which on a jump takes most out of `wanted` (n, 6) beside columns (n, 6, m)."""
    n = len(wanted)
    Q = np.linalg.qr(columns.reshape(6 * n, -1))[0]
    rest = (wanted.ravel() - Q @ (Q.T @ wanted.ravel())).reshape(n, 6)
    along, taken = (np.cumsum(x[::-1], axis=0)[::-1] for x in (rest @ directions, directions.T @ Q.reshape(n, 6, -1)))
    free = np.arange(EDGE, n - EDGE)
    free = free[(np.abs(free[:, None] - np.array(others, dtype=int)) >= EDGE).all(axis=1)]
    square = directions.T @ directions
    normal = (n - free)[:, None, None] * square - taken[free] @ taken[free].transpose(0, 2, 1)
    b = along[free, :, None]
    return int(free[np.argmax((b * np.linalg.solve(normal + RIDGE * n * np.trace(square) * np.eye(len(square)), b)).sum(axis=(1, 2)))])


def _step_at(jumps: list[int], n: int, directions: Array) -> Array:
    """(n, 6, j k), the directions from each jump on."""
    on = np.arange(n)[:, None] >= np.array(jumps, dtype=int)
    return np.asarray(np.einsum("nj,ck->ncjk", on, directions).reshape(n, 6, -1))
