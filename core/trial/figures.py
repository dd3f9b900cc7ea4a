"""The figures of a score sheet, each from the outcomes alone."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize
from scipy.special import expit

from core.array import Array
from core.gap.limits import sizes
from core.trial.judgement import CLEAR_SIGMA, SIZED_SIGMA, TIE_SIGMA, counts, forecast, is_beside, names_truth_alone, right, truth_class
from core.trial.outcome import TrialOutcome

Z95 = 1.959964
SWINGS = frozenset(("payload_loose", "tool_flexibility"))
"""Faults by which the payload is no rigid body."""
DETERMINED = 0.1
"""A parameter counts for the error when its stated uncertainty is at most this share of it."""
RIDGE = 0.05
"""Prior of the logistic fit: enough for a finite answer where hits and misses do not overlap."""

DRAWN = 1000
"""Sets of answers by which chance is told."""


@dataclass(frozen=True)
class Share:
    """So many of so many."""

    hits: int
    of: int

    @classmethod
    def among(cls, answers: Iterable[bool]) -> Share:
        """Of yes and no."""
        answers = list(answers)
        return cls(sum(answers), len(answers))

    @property
    def value(self) -> float:
        """NaN of nothing."""
        return self.hits / self.of if self.of else float("nan")

    @property
    def interval(self) -> tuple[float, float]:
        """95 % (Wilson 1927)."""
        n, p, z = self.of, self.value, Z95
        middle, half = p + z * z / (2 * n), z * np.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
        return float(max(0.0, (middle - half) / (1 + z * z / n))), float(min(1.0, (middle + half) / (1 + z * z / n)))


@dataclass(frozen=True)
class Bin:
    """Answers of about the same probability."""

    mean: float
    share: Share


def share_right(outcomes: Sequence[TrialOutcome], kind: str) -> Share:
    """Of the trials of a kind that count."""
    return Share.among(right(o) for o in outcomes if o.sealed.kind == kind and counts(o))


def tie_honesty(outcomes: Sequence[TrialOutcome]) -> tuple[Share, Share]:
    """Truth in the declared set where the nearest rival is inseparable; one name, the right one, where it is far."""
    singles = [o for o in outcomes if o.sealed.kind == "single" and counts(o) and o.bound.nearest_rival_sigma is not None]
    near = [o for o in singles if (o.bound.nearest_rival_sigma or 0.0) < TIE_SIGMA]
    far = [o for o in singles if (o.bound.nearest_rival_sigma or 0.0) > CLEAR_SIGMA]
    declared = Share.among(right(o) for o in near)
    return declared, Share.among(not o.ties and names_truth_alone(o) for o in far)


def first_answers(outcomes: Sequence[TrialOutcome]) -> tuple[Array, NDArray[np.bool_]]:
    """Probability of the most probable class of each answer, and whether it was that."""
    answers = [(max(forecast(o).items(), key=lambda item: item[1]), truth_class(o)) for o in _in_the_wrench(outcomes)]
    return np.array([p for (_, p), _ in answers]), np.array([name == truth for (name, _), truth in answers], dtype=bool)


def all_answers(outcomes: Sequence[TrialOutcome], least: float) -> tuple[Array, NDArray[np.bool_]]:
    """The same for every class that was given at least this probability."""
    told = [(p, name == truth_class(o)) for o in _in_the_wrench(outcomes) for name, p in forecast(o).items() if p >= least]
    return np.array([p for p, _ in told]), np.array([hit for _, hit in told], dtype=bool)


def _in_the_wrench(outcomes: Sequence[TrialOutcome]) -> list[TrialOutcome]:
    """Answers whose probabilities have a truth: what is planted in the readings is none of the effects, and may be more than nothing."""
    return [o for o in outcomes if o.stopped is None and not is_beside(o)]


def reliability(probability: Array, hit: NDArray[np.bool_], bins: int = 10) -> list[Bin]:
    """Answers sorted into bins of equal width; empty ones are left out."""
    place = np.minimum((probability * bins).astype(int), bins - 1)
    return [Bin(float(probability[place == k].mean()), Share.among(hit[place == k].tolist())) for k in range(bins) if (place == k).any()]


def calibration_error(table: Sequence[Bin]) -> float:
    """Expected calibration error: mean distance of probability and share, weighted by answers; NaN of none."""
    total = sum(row.share.of for row in table)
    return sum(row.share.of * abs(row.mean - row.share.value) for row in table) / total if total else float("nan")


def calibration_error_by_chance(probability: Array) -> tuple[float, float]:
    """95 % range of the calibration error of so many answers that are right just as often as they say: few seem to be off by much.
    NaN of none."""
    if not len(probability):
        return float("nan"), float("nan")
    drawn = np.random.default_rng(0).uniform(size=(DRAWN, len(probability))) < probability
    low, high = np.quantile([calibration_error(reliability(probability, hit)) for hit in drawn], (0.025, 0.975))
    return float(low), float(high)


def closure_ratios(outcomes: Sequence[TrialOutcome]) -> list[tuple[float, float]]:
    """Closure of the true effect and of the first name, single faults that count; NaN in neither."""
    found = []
    for o in outcomes:
        true = [effect.closure for effect in o.effects if effect.id in o.sealed.ids]
        if o.sealed.kind == "single" and counts(o) and true and true[0] > 0.05:
            found.append((true[0], o.effects[0].closure))
    return found


def parameter_errors(outcomes: Sequence[TrialOutcome]) -> tuple[list[float], Share]:
    """Relative errors of the determined parameters of faults that are plain and of the model's shape, and how often 95 % intervals
    hold the truth (all of their parameters that have an interval)."""
    errors, inside = [], []
    for o in outcomes:
        if o.stopped is not None or (o.bound.fault_sigma or np.inf) < SIZED_SIGMA or len(o.sealed.ids) != 1:
            continue
        found_of = {effect.id: effect.parameters for effect in o.effects} | o.also
        for identifier, parameters in found_of.items():
            for name, true in o.truth.get(identifier, {}).items():
                found = parameters.get(name)
                if found is None or not found.std:
                    continue
                inside.append(abs(found.value - true) <= Z95 * found.std)
                if found.std <= DETERMINED * abs(true):
                    errors.append(abs(found.value / true - 1.0))
    return errors, Share.among(inside)


@dataclass(frozen=True)
class PayloadErrors:
    """Errors of the payload over all ten parameters, shares of the mass, of the first moment's norm and of the largest moment.

    Args:
        before, after: root mean square over the ten, median over trials, without and with the effect.
        stated: the same of the stated standard uncertainties, with the effect.
        covered: 95 % intervals that hold the truth, with the effect.
    """

    before: float
    after: float
    stated: float
    covered: Share


def payload_errors(outcomes: Sequence[TrialOutcome]) -> PayloadErrors:
    """Of trials with a fault that were answered rightly, counted or not; of a load that swings the mass alone, the rest depends on how it
    hangs."""
    rows = []
    inside: list[bool] = []
    for o in outcomes:
        if o.payload is None or not o.sealed.ids or not right(o):
            continue
        true, before, after, std = (np.array(x) for x in (o.payload.true, o.payload.before, o.payload.after, o.payload.after_std))
        seen = slice(1) if SWINGS & set(o.sealed.ids) else slice(None)
        size = sizes(true)[seen]
        true, before, after, std = true[seen], before[seen], after[seen], std[seen]
        rows.append([float(np.sqrt(np.mean((x / size) ** 2))) for x in (before - true, after - true, std)])
        inside += (np.abs(after - true) <= Z95 * std).tolist()
    before_, after_, stated = np.median(rows, axis=0) if rows else np.full(3, np.nan)
    return PayloadErrors(float(before_), float(after_), float(stated), Share.among(inside))


def fit_halfway_size(x: Sequence[float], hit: Sequence[bool]) -> float | None:
    """The x > 0 at which half of the answers are hits, by a logistic curve over log x; None where there are only hits or only misses."""
    if not (any(hit) and not all(hit)):
        return None
    u, y = np.log(np.array(x)), np.array(hit, dtype=float)
    middle = float(u.mean())

    def loss(theta: Array) -> float:
        p = np.clip(expit(theta[0] + np.exp(theta[1]) * (u - middle)), 1e-12, 1 - 1e-12)
        return float(-(y * np.log(p) + (1 - y) * np.log(1 - p)).sum() + RIDGE * theta @ theta)

    found = minimize(loss, np.zeros(2), method="Nelder-Mead").x
    return float(np.exp(middle - found[0] / np.exp(found[1])))
