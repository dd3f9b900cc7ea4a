"""How far: the gap on motions that a fit did not see, and the share of it that an effect closes."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.gap.effect_fit import EffectFit
from core.gap.windows import Windows

RESAMPLED = 300


def gap_of(windows: Windows, fit: EffectFit, channel: int | None = None) -> float:
    """Root mean square over samples of (measured - simulated) over noise, each motion predicted from the others."""
    rows = fit.held_out if channel is None else fit.held_out[channel]
    return float(np.sqrt(max(0.0, 1.0 + (float(rows.mean()) - 1.0) / windows.samples_per_row)))


def closure_of(windows: Windows, nominal: EffectFit, fit: EffectFit) -> tuple[float, tuple[float, float]]:
    """(before - after) / (before - floor) with its 95 % interval, motions resampled."""
    rng = np.random.default_rng(0)
    groups = np.unique(windows.group)
    sums = np.array([[f.held_out[:, windows.group == g].sum() for f in (nominal, fit)] for g in groups])
    counts = np.array([6 * np.count_nonzero(windows.group == g) for g in groups])
    drawn = rng.integers(len(groups), size=(RESAMPLED, len(groups)))
    values = [_closure(sums[rows].sum(axis=0) / counts[rows].sum(), windows.samples_per_row) for rows in drawn]
    low, high = np.percentile(values, [2.5, 97.5])
    return _closure(sums.sum(axis=0) / counts.sum(), windows.samples_per_row), (float(low), float(high))


def _closure(rows: Array, samples_per_row: float) -> float:
    before, after = np.sqrt(np.maximum(0.0, 1.0 + (rows - 1.0) / samples_per_row))
    return float(np.clip((before - after) / (before - 1.0), -10.0, 10.0)) if before > 1.0 + 1e-9 else 0.0
