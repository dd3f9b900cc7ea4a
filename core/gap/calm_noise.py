"""Noise of a reading where something goes on in the holds: what drifts, pulls, blows or rings there is a gap, not noise."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.noise import SHORTEST, WrenchNoise, sensor_noise
from core.estimation.segments import Segment

PIECE_S = 0.4
"""Longest stretch over which what a sensor adds by itself is looked at: what is slower than that lasts as long as motions do."""
SLOW = 4.0
"""Times the variance of a mean over such a stretch from which more is slow than a sensor's noise is."""
CALMEST, FEWEST = 0.2, 3
"""Share of those stretches that the noise is taken from, those with the least in all, and how many at least: what rings when the arm stops
has died down there."""


def find_noise(
    t: Array, wrench: Array, still: NDArray[np.bool_], segments: tuple[Segment, ...], *, nominal_std: Array | None = None
) -> WrenchNoise | None:
    """As `sensor_noise`; channels that wander or ring within the holds have the noise of short calm stretches, but no less than is stated
    (6,)."""
    whole = sensor_noise(t, wrench, still, segments, nominal_std=nominal_std)
    if whole is None or nominal_std is None:
        return whole
    calm = sensor_noise(t, wrench, still, _take_calmest(wrench, still, _cut_holds(t, segments), nominal_std))
    if calm is None:
        return whole
    least = np.maximum(calm.variance, np.square(nominal_std))
    slow = whole.variance > SLOW * least
    std = np.where(slow, np.sqrt(np.maximum(calm.std**2, least / calm.long_run)), whole.std)
    return replace(whole, std=std, long_run=np.where(slow, calm.long_run, whole.long_run))


def find_fresh_noise(
    t: Array,
    wrench: Array,
    still: NDArray[np.bool_],
    segments: tuple[Segment, ...],
    fresh: NDArray[np.intp],
    *,
    nominal_std: Array | None = None,
) -> WrenchNoise | None:
    """The same of the fresh rows (M,) alone: that others repeat them is no correlation of the noise."""
    edges = [np.searchsorted(fresh, (part.start, part.stop)).tolist() for part in segments]
    kept = tuple(Segment(a, b, part.phase) for part, (a, b) in zip(segments, edges, strict=True) if b > a)
    return find_noise(t[fresh], wrench[fresh], still[fresh], kept, nominal_std=nominal_std)


def _cut_holds(t: Array, segments: tuple[Segment, ...]) -> tuple[Segment, ...]:
    """Holds in pieces that are as short as may be."""
    period = float(np.median(np.diff(t)))
    rows = max(SHORTEST, round(PIECE_S / period))
    edges = ([*range(part.start, part.stop + 1, rows)] if part.is_hold else [part.start, part.stop] for part in segments)
    return tuple(Segment(a, b, part.phase) for part, cuts in zip(segments, edges, strict=True) for a, b in pairwise(cuts))


def _take_calmest(wrench: Array, still: NDArray[np.bool_], pieces: tuple[Segment, ...], nominal_std: Array) -> tuple[Segment, ...]:
    """Of the pieces of holds those in which the channels vary least, in units of what is stated for each."""
    held = [piece for piece in pieces if piece.is_hold and int(still[piece.rows].sum()) >= SHORTEST]
    varies = [float((wrench[piece.rows][still[piece.rows]] / nominal_std).var(axis=0).mean()) for piece in held]
    count = max(FEWEST, round(CALMEST * len(held)))
    return tuple(held[k] for k in sorted(np.argsort(varies)[:count].tolist()))
