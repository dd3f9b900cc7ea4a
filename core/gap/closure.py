"""How far: the gap on motions that a fit did not see, and the share of it that an effect closes."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.gap.effect_fit import EffectFit
from core.gap.windows import Windows

RESAMPLED = 300


def gap_of(windows: Windows, fit: EffectFit, channel: int | None = None) -> float:
    """Root mean square over samples of (measured - simulated) over noise, each motion predicted from the others."""
    squares = _find_squares(windows, fit.held_out.mean(axis=1))
    return float(np.sqrt(squares.mean() if channel is None else squares[channel]))


def closure_of(windows: Windows, nominal: EffectFit, fit: EffectFit) -> tuple[float, tuple[float, float]]:
    """(before - after) / (before - floor) with its 95 % interval, motions resampled."""
    rng = np.random.default_rng(0)
    groups = np.unique(windows.group)
    sums = np.array([[each.held_out[:, windows.group == g].sum(axis=1) for each in (nominal, fit)] for g in groups])
    counts = np.array([np.count_nonzero(windows.group == g) for g in groups])
    drawn = rng.integers(len(groups), size=(RESAMPLED, len(groups)))
    values = [_closure(_find_squares(windows, sums[rows].sum(axis=0) / counts[rows].sum())) for rows in drawn]
    low, high = np.percentile(values, [2.5, 97.5])
    return _closure(_find_squares(windows, sums.sum(axis=0) / counts.sum())), (float(low), float(high))


def _find_squares(windows: Windows, rows: Array) -> Array:
    """(..., 6), mean squares of samples over their noise, of those of windows: these average it out, the less the more it is correlated. A
    correlation that is taken for larger than it is leaves windows less than their noise, which says nothing of samples."""
    beyond = rows - 1.0
    return np.asarray(
        np.maximum(0.0, 1.0 + np.maximum(beyond, 0.0) / windows.samples_per_row + np.minimum(beyond, 0.0) / windows.readings_per_row)
    )


def _closure(squares: Array) -> float:
    before, after = np.sqrt(squares.mean(axis=-1))
    return float(np.clip((before - after) / (before - 1.0), -10.0, 10.0)) if before > 1.0 + 1e-9 else 0.0
