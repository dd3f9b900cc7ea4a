"""How late the wrench is against the motion, to some hundredths of a second: the shift of which the simplest model leaves least.

Two clocks or a queue can be up to a second apart, far more than a linearised delay can follow. Motion and wrench are laid on one even grid,
and for every shift the payload and the offsets explain what they can. What is then left of the delay the least squares find.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from core.array import Array, interpolate
from core.estimation.segments import smooth_by_average, stretches
from core.payload.inertia import Motion, regressor
from core.recording.recording import Recording, take_rows

GRID_S = 0.02
LARGEST_S = 1.0
SMOOTHED_S = 0.05
"""Of the wrench, as the motion is smoothed."""
MOST_ROWS = 4000
SMALL_S = 0.04
"""Delays up to this are found by the least squares alone."""
CLEARLY = 0.5
"""Share of what no shift leaves that a shift may leave to be believed."""
EXPLAINED = 0.2
"""Share of the wrench's change that it may leave."""
AS_GOOD = 1.2
"""Times the least, that another minimum may leave to be as good: of a motion that repeats itself the smallest shift is taken."""


def find_lateness(t: Array, motion: Motion, wrench: Array) -> float:
    """s, by which the wrench (N, 6) is late against the motion, negative where it is early; 0 where no large shift is clearly better.

    Args:
        t: (N,), s. motion: smoothed, of the same rows.
    """
    shifts = np.arange(-round(LARGEST_S / GRID_S), round(LARGEST_S / GRID_S) + 1)
    grid = np.arange(t[0], t[-1], GRID_S)
    rows = _rows_away_from_gaps(t, grid, len(shifts) // 2)
    if len(rows) < len(shifts):
        return 0.0
    smooth = smooth_by_average(wrench, round(SMOOTHED_S / float(np.median(np.diff(t)))))
    y = interpolate(grid, t, smooth)
    seen = Motion(*(interpolate(grid[rows], t, x) for x in (motion.g, motion.a, motion.omega, motion.alpha)))
    sizes = np.repeat([max(float(y[:, part].std(axis=0).max()), 1e-12) for part in (slice(0, 3), slice(3, 6))], 3)
    columns = np.concatenate((regressor(seen), np.broadcast_to(np.eye(6), (len(rows), 6, 6))), axis=2) / sizes[:, None]
    columns = columns.reshape(-1, 16)
    basis, strength, _ = np.linalg.svd(columns, full_matrices=False)
    basis = basis[:, strength > 1e-9 * strength[0]]
    left = np.array([_share_left(basis, y[rows + k] / sizes) for k in shifts])
    small = np.abs(shifts) * GRID_S <= SMALL_S
    minima = np.flatnonzero((left <= np.roll(left, 1)) & (left <= np.roll(left, -1)) & (left <= AS_GOOD * left.min()))
    best = int(minima[np.argmin(np.abs(shifts[minima]))])
    believed = not small[best] and left[best] < EXPLAINED and left[best] < CLEARLY * left[small].min()
    # a shift by half a turn makes a payload of the opposite sign as good
    mass = float(np.linalg.lstsq(columns, (y[rows + shifts[best]] / sizes).ravel(), rcond=1e-9)[0][0])
    return float(shifts[best] * GRID_S) if believed and mass > 0.0 else 0.0


def _rows_away_from_gaps(t: Array, grid: Array, reach: int) -> NDArray[np.intp]:
    """Of the grid, those around which it is filled with samples as far as shifts reach; at most `MOST_ROWS`."""
    filled = np.zeros(len(grid), dtype=bool)
    for part in stretches(t):
        filled |= (grid >= t[part.start]) & (grid <= t[part.stop - 1])
    run = np.cumsum(np.append(0, filled))
    rows = np.arange(reach, len(grid) - reach)
    rows = rows[run[rows + reach + 1] - run[rows - reach] == 2 * reach + 1]
    return np.asarray(rows[:: max(1, len(rows) // MOST_ROWS)])


def _share_left(basis: Array, y: Array) -> float:
    """Of the change of y (n, 6), what the columns of the basis (6 n, k) leave."""
    change = y - y.mean(axis=0)
    explained = basis.T @ change.ravel()
    total = float((change**2).sum())
    return 1.0 - float(explained @ explained) / total if total > 0.0 else 1.0


def advance_wrench(recording: Recording, late_s: float) -> tuple[Recording, float]:
    """The recording with the wrench of `late_s` later beside each row, rows that have none left out; and by how much it was, s.

    The shift is a whole number of sampling periods, so that on an even clock no stamp changes.
    """
    t, period = recording.t, float(np.median(np.diff(recording.t)))
    shift = period * round(late_s / period)
    nearest = np.clip(np.searchsorted(t, t + shift - 0.5 * period), 0, len(t) - 1)
    kept = np.abs(t[nearest] - t - shift) < 0.5 * period
    assert recording.wrench is not None
    return replace(take_rows(recording, kept), wrench=recording.wrench[nearest[kept]]), shift
