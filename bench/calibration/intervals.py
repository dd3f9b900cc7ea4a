"""By how much the payload's uncertainty has to be wider than the explanations say: learnt so that its intervals hold the truth."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.optimize import brentq

from bench.calibration.learning import FOLDS
from bench.calibration.trial import Trial
from core.array import Array
from core.gap.answer import INTERVAL
from core.gap.payload_after import HELD, average
from core.gap.weighing import find_left_share

LARGEST = 10.0
"""More would mean that intervals are wrong for another reason."""


def find_widened(trials: Sequence[Trial], told: dict[int, Array]) -> float:
    """The factor with which intervals hold the truth in 95 % of all parameters of trials with a gap, not below 1; 1 where none tells."""
    counted = [trial for trial in trials if _counts(trial)]

    def lacks(widened: float) -> float:
        return find_held(counted, told, widened) - HELD

    if not counted or lacks(1.0) >= 0.0:
        return 1.0
    return LARGEST if lacks(LARGEST) < 0.0 else float(brentq(lacks, 1.0, LARGEST, xtol=0.005))


def find_held(trials: Sequence[Trial], told: dict[int, Array], widened: float) -> float:
    """How often intervals hold the truth, of all parameters of those trials that have a payload and a gap."""
    return float(np.mean(np.concatenate([_is_held(trial, told[trial.seed], widened) for trial in trials if _counts(trial)])))


def find_held_left_out(trials: Sequence[Trial], told: dict[int, Array]) -> float | None:
    """The same with a factor that was learnt from other trials; None where too few have a payload."""
    counted = [trial for trial in trials if _counts(trial)]
    if len(counted) < FOLDS:
        return None
    parts = [counted[k::FOLDS] for k in range(FOLDS)]
    held = [find_held(part, told, find_widened([t for other in parts if other is not part for t in other], told)) for part in parts]
    return float(np.average(held, weights=[len(part) for part in parts]))


def _counts(trial: Trial) -> bool:
    """Whether there is a gap that matters, and the file has the payload."""
    return trial.material and bool(trial.traces[0].payload_error)


def _is_held(trial: Trial, p: Array, widened: float) -> Array:
    """(10,), 1 where the interval holds the truth."""
    nominal, *fits = trial.traces
    each = [*fits, nominal]
    error = np.array([fit.payload_error for fit in each])
    std, left = np.array([fit.payload_std for fit in each]), np.array([find_left_share(nominal, fit) for fit in each])
    middle, own = average(np.append(p[2:], p[0]), error, std, left, error[-1], widened)
    return np.asarray(np.abs(middle) <= INTERVAL * own, dtype=float)
