"""How good probabilities are: right names, unknown called unknown, calibration, and sets that hold the truth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from bench.calibration.learning import find_truth, group_of
from bench.calibration.trial import Trial
from core.array import Array
from core.gap.evidence import MATTERS

BINS = 5
HELD = 0.9


@dataclass(frozen=True)
class Scores:
    """Of one way to weigh.

    Args:
        named: single causes whose name the verdict is; pairs: exactly those two; unknown: called unknown; false alarms: a gap where
            nothing was planted. Each right, of so many that count: what was planted matters, or nothing was.
        log_loss: of the truth, mean over all trials: what was planted and does not matter is none.
        calibration: difference between first probabilities and how often they were right, over bins of equal counts.
    """

    named: tuple[int, int]
    pairs: tuple[int, int]
    unknown: tuple[int, int]
    false_alarms: tuple[int, int]
    log_loss: float
    calibration: float

    def say(self, name: str) -> str:
        """A line."""
        shares = [f"{right:3d} of {of:3d}" for right, of in (self.named, self.pairs, self.unknown, self.false_alarms)]
        return f"{name:22s}{''.join(f'{share:>13s}' for share in shares)}{self.log_loss:10.3f}{100 * self.calibration:8.1f} %"

    def as_numbers(self) -> dict[str, float]:
        """For a file."""
        shares = {"named": self.named, "pairs": self.pairs, "unknown": self.unknown, "false_alarms": self.false_alarms}
        counts = {f"{name}_of": float(of) for name, (_, of) in shares.items()}
        rights = {name: float(right) for name, (right, _) in shares.items()}
        return {**rights, **counts, "log_loss": round(self.log_loss, 3), "calibration": round(self.calibration, 3)}


HEADER = f"{'':22s}{'named':>13s}{'pairs':>13s}{'unknown':>13s}{'false alarms':>13s}{'log loss':>10s}{'ECE':>10s}"


def score(trials: Sequence[Trial], told: dict[int, Array]) -> Scores:
    """Scores of probabilities by seed."""
    counted = [trial for trial in trials if trial.matters or not trial.families]
    tally: dict[str, list[bool]] = {"named": [], "pairs": [], "unknown": [], "none": []}
    for trial in counted:
        kind = "none" if not trial.families else "unknown" if trial.truth == "unknown" else "named" if len(trial.families) == 1 else "pairs"
        tally[kind].append(is_right(trial, told[trial.seed]))
    truths = np.array([told[trial.seed][find_truth(trial)] for trial in trials])
    right, of = {kind: sum(each) for kind, each in tally.items()}, {kind: len(each) for kind, each in tally.items()}
    return Scores(
        (right["named"], of["named"]),
        (right["pairs"], of["pairs"]),
        (right["unknown"], of["unknown"]),
        (of["none"] - right["none"], of["none"]),
        float(-np.log(np.maximum(truths, 1e-9)).mean()) if len(truths) else 0.0,
        find_calibration_error(trials, told),
    )


def is_right(trial: Trial, p: Array) -> bool:
    """Whether the verdict is: no gap, unknown, or the name and nothing else, and that name is in the library's words."""
    if p[0] > 1.0 - MATTERS:
        return not trial.families
    k = int(np.argmax(p[1:])) + 1
    if k == 1:
        return trial.truth == "unknown"
    return sorted(trial.traces[k - 1].name.split("+")) == sorted(trial.families)


def find_calibration_error(trials: Sequence[Trial], told: dict[int, Array]) -> float:
    """Mean distance between the first probability and how often it was right, over bins of equal counts."""
    return compare_in_bins([(float(told[trial.seed].max()), int(np.argmax(told[trial.seed])) == find_truth(trial)) for trial in trials])


def compare_in_bins(first: Sequence[tuple[float, bool]]) -> float:
    """The same of first probabilities, with whether each was right."""
    bins = np.array_split(np.array(sorted(first), dtype=float), BINS)
    return sum(len(rows) * abs(float(rows[:, 0].mean() - rows[:, 1].mean())) for rows in bins if len(rows)) / max(1, len(first))


def find_outside(trials: Sequence[Trial], told: dict[int, Array]) -> float:
    """Probability below which answers are left out of the set, so that it holds the truth in 90 % (split conformal)."""
    return find_limit([float(told[trial.seed][find_truth(trial)]) for trial in trials])


def find_limit(truths: Sequence[float]) -> float:
    """Below which one in ten probabilities of the truth is, in expectation (split conformal)."""
    place = int(np.floor((1.0 - HELD) * (len(truths) + 1))) - 1
    return sorted(truths)[place] if place >= 0 else 0.0


def find_coverage(trials: Sequence[Trial], told: dict[int, Array]) -> tuple[float, float]:
    """How often sets hold the truth, and how large they are in the mean; their limit from the other groups."""
    held, sizes = [], []
    for trial in trials:
        limit = find_outside([other for other in trials if group_of(other) != group_of(trial)], told)
        p = told[trial.seed]
        held.append(p[find_truth(trial)] >= limit)
        sizes.append(int((p >= limit).sum()))
    return float(np.mean(held)), float(np.mean(sizes))
