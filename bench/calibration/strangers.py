"""The doubts where the best fit leaves something, learnt from recordings that strangers made: nobody gave these the library's shapes.

python -m bench.calibration.strangers FOLDER [FOLDER ...] [--write]

Each folder is one stranger's, as `python -m bench.stranger` leaves it. What trials have taught is the prior; the doubts are learnt anew,
and judged by leaving out one stranger after the other. `--write` puts them where the diagnosis reads them.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.optimize import minimize

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from bench.calibration.learning import PRIOR, stack_each
from bench.calibration.scores import compare_in_bins, find_limit
from bench.json_lines import read_results
from bench.stranger.answer import Answer
from bench.stranger.score import BESIDE, KINDS, Planted, count_right, read_planted
from core.array import Array
from core.gap.weighing import DOUBTS, FILE, Elsewhere, count, read_figures, weigh_numbers

FEWEST = 2
ByStranger = Mapping[str, Mapping[str, float]]
"""Figures for each stranger's recordings."""


class Case(NamedTuple):
    """A recording: what is planted, what was answered, and whose it is."""

    truth: Planted
    answer: Answer
    stranger: str

    def weigh(self, figures: Mapping[str, float]) -> Array:
        """(2 + n,), probabilities of none, unknown and the fits."""
        return weigh_numbers(count(self.answer.weighed[0], self.answer.weighed[1:]), figures)

    @property
    def place(self) -> int:
        """Of the truth among none, unknown and the fits."""
        planted = sorted(set(self.truth.families) - BESIDE)
        names = [sorted(fit.name.split("+")) for fit in self.answer.weighed[1:]]
        return 2 + names.index(planted) if planted in names else 1


def read_cases(folder: Path) -> list[Case]:
    """Those of which something could be fitted."""
    truths = read_planted(folder)
    return [Case(truths[answer.case], answer, str(folder)) for answer in read_results(folder / "diagnoses.jsonl", Answer) if answer.weighed]


def can_teach(case: Case, figures: Mapping[str, float]) -> bool:
    """Whether something is in the wrench that mattered, and the fits decided what is said of it."""
    in_wrench = case.truth.kind == "unknown" or bool(set(case.truth.families) - BESIDE)
    return in_wrench and case.answer.verdict not in ("no_gap", "not_enough") and is_decided_by_fits(case, figures)


def is_decided_by_fits(case: Case, figures: Mapping[str, float]) -> bool:
    """Whether it was, by these figures: where they say unknown and the answer does not, contacts or motions left out have decided."""
    return case.answer.verdict == "unknown" or int(np.argmax(case.weigh(figures)[1:])) != 0


def learn_doubts(cases: Sequence[Case], figures: Mapping[str, float]) -> dict[str, float]:
    """The most probable doubts, from what trials have taught and as wide as before any."""
    numbers, truths = stack_each([count(case.answer.weighed[0], case.answer.weighed[1:]) for case in cases], [case.place for case in cases])
    mean, std = np.array([figures.get(name, PRIOR[name][0]) for name in DOUBTS]), np.array([PRIOR[name][1] for name in DOUBTS])

    def cost(v: Array) -> float:
        p = weigh_numbers(numbers, {**figures, **dict(zip(DOUBTS, mean + std * v, strict=True))})
        return float(-np.log(np.maximum(p[np.arange(len(truths)), truths], 1e-12)).sum() + 0.5 * v @ v)

    return dict(zip(DOUBTS, (mean + std * minimize(cost, np.zeros(len(mean)), method="L-BFGS-B").x).tolist(), strict=True))


def answer_again(case: Case, before: Mapping[str, float], figures: Mapping[str, float]) -> Answer:
    """The answer with other figures, where fits have decided it."""
    if case.answer.verdict in ("no_gap", "not_enough") or not is_decided_by_fits(case, before):
        return case.answer
    _, unknown, *shares = case.weigh(figures).tolist()
    fits = list(zip(case.answer.weighed[1:], shares, strict=True))
    verdict = "unknown" if unknown >= max(shares, default=0.0) else "explained"
    effects = tuple((fit.name, share, 0.0) for fit, share in fits if fit.effects == 1)
    pairs = tuple((tuple(fit.name.split("+")), share, 0.0) for fit, share in fits if fit.effects > 1)
    return case.answer.model_copy(update={"verdict": verdict, "unknown": unknown, "effects": effects, "pairs": pairs})


def count_all(cases: Sequence[Case], before: Mapping[str, float], by_stranger: ByStranger) -> dict[str, tuple[int, int]]:
    """Right answers by kind, and of how many."""
    tallies = []
    for stranger, figures in by_stranger.items():
        own = [case for case in cases if case.stranger == stranger]
        answers = {case.answer.case: answer_again(case, before, figures) for case in own}
        tallies.append(count_right({case.answer.case: case.truth for case in own}, answers))
    return {kind: (sum(each[kind][0] for each in tallies), sum(each[kind][1] for each in tallies)) for kind in KINDS}


def judge(cases: Sequence[Case], before: Mapping[str, float], by_stranger: ByStranger) -> dict[str, float]:
    """Right answers of all cases by kind; of those that teach: mean log loss of the truth, calibration error, how many sets hold the truth
    whose limit is from the other strangers', and how large they are."""
    found: dict[str, float] = {}
    for kind, (right, of) in count_all(cases, before, by_stranger).items():
        found |= {kind: float(right), f"{kind}, of": float(of)}
    told = [(case, case.weigh(by_stranger[case.stranger])) for case in cases if can_teach(case, before)]
    first = [(float(p.max()), int(np.argmax(p)) == case.place) for case, p in told]
    truths = [float(p[case.place]) for case, p in told]
    limits = {
        stranger: find_limit([truth for truth, (case, _) in zip(truths, told, strict=True) if case.stranger != stranger])
        for stranger in by_stranger
    }
    held = [truth >= limits[case.stranger] for truth, (case, _) in zip(truths, told, strict=True)]
    sizes = [int((p >= limits[case.stranger]).sum()) for case, p in told]
    return found | {
        "log_loss": round(float(-np.log(np.maximum(truths, 1e-9)).mean()), 3),
        "calibration": round(compare_in_bins(first), 3),
        "covered": round(float(np.mean(held)), 3),
        "set_size": round(float(np.mean(sizes)), 2),
    }


def print_scores(name: str, scores: Mapping[str, float]) -> None:
    """A line."""
    shares = ", ".join(f"{kind} {scores[kind]:.0f} of {scores[f'{kind}, of']:.0f}" for kind in KINDS)
    print(f"{name}: {shares}; log loss {scores['log_loss']:.3f}, calibration error {100 * scores['calibration']:.1f} %,")
    print(f"    sets that are to hold the truth in 90 %: {100 * scores['covered']:.1f} %, {scores['set_size']:.1f} answers each")


def main() -> None:
    """Learns, judges, prints."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", type=Path, nargs="+")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    shipped = read_figures()
    cases = [case for folder in arguments.folders for case in read_cases(folder)]
    strangers = sorted({case.stranger for case in cases})
    if len(strangers) < FEWEST:
        sys.exit(f"{len(strangers)} folder with answers: at least {FEWEST} are needed, each is judged by what the others teach")
    teaching = [case for case in cases if can_teach(case, shipped.figures)]
    left_out = {
        stranger: {**shipped.figures, **learn_doubts([case for case in teaching if case.stranger != stranger], shipped.figures)}
        for stranger in strangers
    }
    scores = judge(cases, shipped.figures, left_out)
    print_scores("as trials have taught", judge(cases, shipped.figures, dict.fromkeys(strangers, shipped.figures)))
    print_scores("each stranger left out", scores)
    elsewhere = Elsewhere(
        date=f"{datetime.now(UTC):%Y-%m-%d}",
        recordings=len(cases),
        learnt_from=len(teaching),
        doubts={name: round(value, 4) for name, value in learn_doubts(teaching, shipped.figures).items()},
        outside=round(find_limit([float(case.weigh(left_out[case.stranger])[case.place]) for case in teaching]), 4),
        scores=scores,
    )
    print(elsewhere.model_dump_json(indent=2))
    if arguments.write:
        written = shipped.model_copy(update={"elsewhere": elsewhere})
        FILE.write_text(written.model_dump_json(indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
