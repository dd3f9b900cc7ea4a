"""Rows that a recorder lost off an even clock, filled in: what is averaged over uneven rows lets the noise of the poses through.

On an even clock a window's second difference of the poses is its own second derivative, which damps their noise as far as the window is
wide. Over uneven rows the two no longer cancel. So a few rows lost at a time are filled in by the cubic through two neighbours on each
side, poses and wrench alike, and the noise of what was filled in is counted as that of the rows that it is made of.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from core.array import Array
from core.recording.recording import PAUSE_S

LONGEST = 4.5
"""Periods; across a longer step nothing is filled in."""
OFF = 0.1
"""Of a period that a stamp may be off an even clock; beyond it, or where more than `UNEVEN` of the steps are, the clock is not even."""
BROKEN = 0.05
"""Share of the time in gaps that cannot be filled in, from which a motion is not looked at: what second differences of the poses tell of it
over such gaps is mostly their noise."""
UNEVEN = 0.01


@dataclass(frozen=True)
class FilledRows:
    """An even clock of M rows, of which N were measured.

    Args:
        t: (M,), s. fill: (M, N), what each row is made of. measured: (N,), their places.
        before: (M,), the row measured at each of them or last before it.
    """

    t: Array
    fill: csr_array
    measured: NDArray[np.intp]
    before: NDArray[np.intp]


def is_broken(t: Array) -> bool:
    """Whether times (N,), s, have more than `BROKEN` in gaps that are too long to be filled in, and too short for a pause."""
    steps = np.diff(t)
    if not len(steps):
        return False
    long = (steps > LONGEST * np.median(steps)) & (steps < PAUSE_S)
    return float(steps[long].sum()) > BROKEN * float(np.ptp(t))


def fill_lost_rows(t: Array, longest_s: float = 0.0) -> FilledRows | None:
    """Of a recording's times (N,), s; None where nothing was lost, or the clock is not even.

    Args:
        longest_s: step across which is filled in although it is longer than `LONGEST` periods, where no more is asked than that what is
            smooth stays so.
    """
    if len(t) < 4:
        return None
    period = float(np.median(np.diff(t)))
    steps = np.diff(t) / period
    near = steps < max(LONGEST, longest_s / period)
    whole = np.where(near, np.maximum(np.rint(steps), 1.0), 1.0).astype(int)
    if not (whole > 1).any() or float((np.abs(steps - whole) > OFF)[near].mean()) > UNEVEN:
        return None
    measured = np.concatenate(([0], np.cumsum(whole)))
    before = np.repeat(np.arange(len(t)), np.append(whole, 1))
    since = np.arange(len(before)) - measured[before]
    share = since / np.append(whole, 1)[before]
    filled = t[before] + share * np.append(np.diff(t), 0.0)[before]
    return FilledRows(filled, _interpolation(t, filled, before, since > 0), measured, before)


def _interpolation(t: Array, filled: Array, before: NDArray[np.intp], lost: NDArray[np.bool_]) -> csr_array:
    """(M, N): measured rows as they are, lost ones by the cubic through four rows about them."""
    rows = np.flatnonzero(lost)
    nodes = np.clip(before[rows] - 1, 0, len(t) - 4)[:, None] + np.arange(4)
    away = t[nodes] - filled[rows, None]
    weights = np.ones_like(away)
    for j, m in np.ndindex(4, 4):
        if j != m:
            weights[:, j] *= -away[:, m] / (away[:, j] - away[:, m])
    kept = np.flatnonzero(~lost)
    values = np.concatenate((np.ones(len(kept)), weights.ravel()))
    places = np.concatenate((kept, np.repeat(rows, 4))), np.concatenate((before[kept], nodes.ravel()))
    return csr_array((values, places), shape=(len(filled), len(t)))
