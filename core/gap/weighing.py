"""From what fits leave over to probabilities.

Fits compete by their predictions of motions that they did not see. No model is exact: what the best one leaves over beyond chance is its
own error, which repeats itself from sample to sample, so all of it is worth a few independent draws, and chi-square is counted in units of
that (a quasi-likelihood). Parameters cost by Schwarz's criterion, the further ones of a wrong model no more than what they can bend to.
What a fit leaves over says, too, how probable it is that nothing in the library is the cause though it predicts best, and what the best
one leaves, that the winner has only bent better than the truth. The figures of all this stand in `probabilities.json`, with where they come
from: `python -m bench.calibration` learns them from simulated trials, and `python -m bench.calibration.strangers` the doubts again from
recordings of strangers.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Literal, NamedTuple, Protocol

import numpy as np
from pydantic import BaseModel, ConfigDict
from scipy.special import expit, log_softmax

from core.array import Array

FILE = Path(__file__).with_name("probabilities.json")
CHANCE_SIGMA = 3.0
"""Chi-square within this many standard deviations of its mean is chance."""
STIFF = 6
"""Parameters that a model is stiff with: it takes more of them to bend."""
LEAST_SHARE = 1e-4
"""Of the gap: less than this is nothing left."""
EXACT_SHARE = 1e-6
"""Of the gap, by its square: no model is nearer to what it stands for, since every arm and sensor is off by a thousandth."""

DOUBTS = ("unknown", "unknown_left", "mimicked", "lapse", "lapse_left")
"""Figures that say how far the library is trusted where its best fit leaves something."""

MEASURES = ("gap", "moved", "reference")
"""By which what is there may matter."""
NOTHING = 0.2
"""Of what matters: less is nothing."""

Block = Literal["figures", "outside", "matters", "widened"]
"""Of what trials teach."""


class HeldOut(Protocol):
    """How well a fit predicts motions that it did not see: chi-square of so many rows, by so many free parameters of so many effects beyond
    the first."""

    @property
    def chi_square(self) -> float: ...
    @property
    def rows(self) -> int: ...
    @property
    def free(self) -> int: ...
    @property
    def further(self) -> int: ...


class Provenance(BaseModel):
    """Where figures come from: how many trials of which seeds, made by which versions, learnt when, and how they do on trials whose variant
    or cause they were not learnt from."""

    model_config = ConfigDict(frozen=True)

    date: str
    trials: int
    learnt_from: int
    seeds: tuple[int, int]
    versions: tuple[str, ...]
    scores: dict[str, float]


class Elsewhere(BaseModel):
    """The doubts learnt again from recordings of machines and causes that strangers to the library have made: real causes have shapes that
    it does not have, so that a right name leaves more than trials let expect.

    Args:
        doubts: `DOUBTS`, in the place of those that trials have taught.
        outside: as in `Figures`, where what is weighed is such a recording.
        scores: of recordings of one stranger after the other, with what was learnt from the others'.
    """

    model_config = ConfigDict(frozen=True)

    date: str
    recordings: int
    learnt_from: int
    doubts: dict[str, float]
    outside: float
    scores: dict[str, float]


class Figures(BaseModel):
    """What is learnt.

    Args:
        figures: `log_draws`, independent draws that a model's own error is worth, by its logarithm; `schwarz`, of the logarithm of draws
            that each of the first `STIFF` parameters costs (1/2 is Schwarz's); `log_bent`, share of the gap that each further one
            may take up by bending, by its logarithm; `none`, log odds of no effect against each single one; `further`, log odds against
            each further effect; `unknown`, `unknown_left`, `lapse`, `lapse_left`, logits of the two doubts where the best fit leaves 1 % of
            the gap, and what ten times as much adds to them; `mimicked`, logit that a cause which the library does not have is followed by
            what it has, whatever is left (0 % in figures that were learnt without it).
        outside: probability below which an answer is left out of the set that holds the truth in 90 % of all cases.
        matters: of what lifts the gap, of what an explanation moves in the payload, and of what puts it off its reference: the logit that
            it matters where it was found to be just what does, and what e times as much adds.
        widened: factor on the payload's uncertainty within each explanation of a gap that matters, by which intervals hold the truth as
            often as they say.
        provenance: of all blocks but those in `learnt_apart`; its scores are those of what was learnt with them.
        learnt_apart: provenance of blocks that are kept from another learning, by their names; empty where one has written all.
        elsewhere: what strangers' recordings have taught besides; None before they have.
    """

    model_config = ConfigDict(frozen=True)

    figures: dict[str, float]
    outside: float
    matters: dict[str, tuple[float, float]]
    widened: float
    provenance: Provenance
    learnt_apart: dict[Block, Provenance] = {}
    elsewhere: Elsewhere | None = None

    @property
    def everywhere(self) -> dict[str, float]:
        """Figures with the doubts that hold on any machine."""
        return self.figures if self.elsewhere is None else {**self.figures, **self.elsewhere.doubts}

    @property
    def left_out(self) -> float:
        """Probability below which an answer is left out of the set that is to hold the truth."""
        return self.outside if self.elsewhere is None else self.elsewhere.outside


@cache
def read_figures() -> Figures:
    """Those that are shipped."""
    return Figures.model_validate_json(FILE.read_text(encoding="utf-8"))


class Contest(NamedTuple):
    """One recording, or several behind each other: the nominal twin comes first, then the fits; infinite chi-square is no fit.

    Args:
        chi_square, free, further: (..., 1 + n), on unseen motions, parameters, effects beyond the first.
        least: (..., 1), the smallest chi-square; rows: (..., 1), equations.
    """

    chi_square: Array
    free: Array
    further: Array
    least: Array
    rows: Array

    @property
    def left(self) -> Array:
        """(..., 1 + n), share that each leaves of the nominal twin's excess over noise; at most 1."""
        beyond = find_beyond_chance(self.chi_square, self.rows)
        return np.minimum(1.0, beyond / np.maximum(self.chi_square[..., :1] / self.rows - 1.0, 1e-9))


def weigh(nominal: HeldOut, fits: Sequence[HeldOut]) -> Array:
    """(2 + n,), probabilities of no effect, of one that the library does not have, and of each of the n fits; they sum to 1."""
    return weigh_numbers(count(nominal, fits), read_figures().everywhere)


def is_in_doubt(nominal: HeldOut, *fits: HeldOut) -> bool:
    """Whether no fit is as probable as that nothing in the library is the cause, by what trials have taught of shapes that it has."""
    _, unknown, *shares = weigh_numbers(count(nominal, fits), read_figures().figures)
    return bool(unknown >= max(shares, default=0.0))


def count(nominal: HeldOut, fits: Sequence[HeldOut]) -> Contest:
    """The numbers of one recording."""
    every = (nominal, *fits)
    best = min(fits, key=lambda fit: fit.chi_square, default=nominal)
    return Contest(
        np.array([fit.chi_square for fit in every]),
        np.array([float(fit.free) for fit in every]),
        np.array([float(fit.further) for fit in every]),
        np.array([best.chi_square]),
        np.array([float(best.rows)]),
    )


def weigh_numbers(numbers: Contest, figures: Mapping[str, float]) -> Array:
    """(..., 2 + n), probabilities as `weigh` has them."""
    shares = np.exp(log_softmax(score(numbers, figures), axis=-1))
    unknown, lapse = find_doubts(numbers.left, figures)
    lapse = lapse[..., 1:].min(axis=-1, keepdims=True, initial=1.0)
    shares = (1.0 - lapse) * shares + lapse * np.exp(log_softmax(_score_nearness(numbers), axis=-1))
    none, fits, unknown = shares[..., :1], shares[..., 1:], unknown[..., 1:]
    return np.concatenate([none, (unknown * fits).sum(axis=-1, keepdims=True), (1.0 - unknown) * fits], axis=-1)


def score(numbers: Contest, figures: Mapping[str, float]) -> Array:
    """(..., 1 + n), log weights: how much worse than the best each predicts, less what its parameters cost, so that of two that predict
    alike the smaller one wins. The nominal twin is no approximation: what it predicts worse counts in full."""
    chi_square, free, further, least, rows = numbers
    beyond = np.maximum(find_beyond_chance(least, rows), EXACT_SHARE * (chi_square[..., :1] / rows - 1.0))
    scale, unit = 1.0 + beyond * rows / math.exp(figures["log_draws"]), np.maximum(1.0, least / rows)
    schwarz = figures["schwarz"] * np.log(rows * unit / scale)
    bent = 0.5 * math.exp(figures["log_bent"]) * np.maximum(0.0, chi_square[..., :1] - rows) / scale
    costs = np.minimum(free, STIFF) * schwarz + np.maximum(free - STIFF, 0.0) * np.minimum(schwarz, bent) + figures["further"] * further
    worse = chi_square - least
    return np.concatenate([figures["none"] - 0.5 * worse[..., :1] / unit, -0.5 * worse[..., 1:] / scale - costs[..., 1:]], axis=-1)


def find_doubts(left: Array, figures: Mapping[str, float]) -> tuple[Array, Array]:
    """That nothing in the library is the cause, where there is one, though a fit leaves no more than that share of the gap; and that the
    winner is not where the best fit leaves it."""
    powers = 2.0 + np.log10(left + LEAST_SHARE)
    unknown, lapse = (expit(figures[name] + figures[f"{name}_left"] * powers) for name in ("unknown", "lapse"))
    mimicked = expit(figures.get("mimicked", -math.inf))
    return mimicked + (1.0 - mimicked) * unknown, lapse


def find_mattering(margins: Array, matters: Mapping[str, tuple[float, float]], unknown: float = 0.0) -> Array:
    """(...), probability that what is there matters: by the gap, or by the payload, where the reference counts if there is one.

    Args:
        margins: (..., 3), each of `core.gap.materiality.Margins`.
        unknown: probability that no explanation is the cause: then what one moves in the payload says nothing.
    """
    gap, moved, reference = (
        expit(at + by * np.log(np.maximum(margins[..., k], NOTHING))) for k, (at, by) in enumerate(matters[name] for name in MEASURES)
    )
    return np.asarray(1.0 - (1.0 - gap) * (1.0 - np.where(np.isnan(reference), (1.0 - unknown) * moved, reference)))


def _score_nearness(numbers: Contest) -> Array:
    """(..., 1 + n), log weights of what may be the truth although another one predicts better: the nearer to the noise, the sooner."""
    nearness = -2.0 * np.log(np.maximum(numbers.chi_square / numbers.rows - 1.0, 1e-3)) - numbers.further
    any_fit = np.isfinite(numbers.chi_square[..., 1:]).any(axis=-1, keepdims=True)
    return np.concatenate([np.where(any_fit, -np.inf, nearness[..., :1]), nearness[..., 1:]], axis=-1)


def find_beyond_chance(chi_square: Array, rows: Array) -> Array:
    """Chi-square per row that is left over, less what chance may leave; not below 0."""
    return np.maximum(0.0, chi_square / rows - 1.0 - CHANCE_SIGMA * np.sqrt(2.0 / rows))


def find_left_share(nominal: HeldOut, fit: HeldOut) -> float:
    """Share of the nominal twin's excess over noise that a fit leaves on unseen motions; at most 1."""
    return float(count(nominal, [fit]).left[1])
