"""Where a series jumps: candidates for the times of things that happen once."""

from __future__ import annotations

import numpy as np

from core.array import Array


def change_points(series: Array, *, count: int, apart: int) -> list[int]:
    """Rows before which the mean of `series` (N, n) most probably jumps, the most probable first.

    Half of the rows come from the likelihood ratio of one jump in an otherwise constant series, half from the same ratio within windows
    of `apart` rows to either side, which also finds a jump in a series that wanders.

    Args:
        count: at most so many rows.
        apart: two of them are at least so many rows apart, and as far from both ends.
    """
    N = len(series)
    apart = max(2, min(apart, N // 4))
    if N < 8:
        return []
    total = np.concatenate([np.zeros((1, series.shape[1])), np.cumsum(series - series.mean(axis=0), axis=0)])
    k = np.arange(apart, N - apart + 1)
    whole = (total[k] ** 2).sum(axis=1) * N / (k * (N - k))
    near = ((total[k + apart] - 2 * total[k] + total[k - apart]) ** 2).sum(axis=1) / (2 * apart)
    found: list[int] = []
    for ratio, wanted in ((whole, (count + 1) // 2), (near, count)):
        free = ratio.copy()
        for row in found:
            free[np.abs(k - row) < apart] = -np.inf
        while len(found) < wanted and np.isfinite(free.max()):
            row = int(k[free.argmax()])
            found.append(row)
            free[np.abs(k - row) < apart] = -np.inf
    return found
