"""The score sheet of blind trials: Markdown with pictures, made to be committed as it is."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import groupby
from pathlib import Path

import numpy as np

from core.files.whole_file import write_whole
from core.trial import charts
from core.trial.figures import (
    Share,
    all_answers,
    best_share,
    calibration_error,
    closure_ratios,
    first_answers,
    fit_halfway_size,
    parameter_errors,
    payload_errors,
    reliability,
    share_right,
    tie_honesty,
)
from core.trial.judgement import CLEAR_SIGMA, NAMED_SIGMA, counts, find_named_effects, material, names_truth_first, right
from core.trial.outcome import TrialOutcome

KINDS = ("none", "single", "double", "unknown")
LEAST = 0.01
"""Probabilities below this are left out of the calibration of all classes: there are hundreds of them, all but zero."""


def score_sheet(outcomes: Sequence[TrialOutcome]) -> str:
    """Markdown without the pictures."""
    return "\n".join([*_head(outcomes), *_figures(outcomes), "", "## By kind", "", *_kinds(outcomes), "", "## By effect", "",
                      *_effects(outcomes), "", "## Not right", "", *_failures(outcomes), ""])  # fmt: skip


def write_sheet(folder: Path, outcomes: Sequence[TrialOutcome]) -> None:
    """`trials.md` with its pictures; files of an earlier sheet are replaced."""
    lines = [score_sheet(outcomes)]
    for name, (title, picture) in _pictures(outcomes).items():
        write_whole(folder / f"{name}.svg", picture)
        lines += [f"## {title}", "", f"![{title}]({name}.svg)", ""]
    write_whole(folder / "trials.md", "\n".join([*lines, "## Confusion in numbers", "", *_confusion(outcomes), ""]))


def _pictures(outcomes: Sequence[TrialOutcome]) -> dict[str, tuple[str, str]]:
    """Title and picture by name; none of what no trial shows."""
    first, every = reliability(*first_answers(outcomes)), reliability(*all_answers(outcomes, LEAST))
    confused, closures, seen = confusions(outcomes), closure_ratios(outcomes), detections(outcomes)
    drawn = {}
    if confused:
        drawn["confusion"] = ("Planted against answered, single faults that count", charts.confusion_chart(confused))
    if first:
        drawn["reliability"] = ("Calibration", charts.reliability_chart(first, every))
    if closures:
        drawn["closure"] = ("How far the gap closes", charts.closure_chart(closures))
    if seen:
        drawn["detection"] = ("What can be seen, and was", charts.detection_chart(seen))
    return drawn


def confusions(outcomes: Sequence[TrialOutcome]) -> Counter[tuple[str, str]]:
    """Planted and answered of single faults that count; without a name the verdict."""
    return Counter((o.sealed.ids[0], _describe_answer(o)) for o in outcomes if o.sealed.kind == "single" and counts(o))


def detections(outcomes: Sequence[TrialOutcome]) -> dict[str, list[tuple[float, bool]]]:
    """Distance from nothing of single faults, and whether they were named, by effect."""
    single = [o for o in outcomes if o.sealed.kind == "single" and o.bound.fault_sigma is not None]
    single.sort(key=lambda o: o.sealed.ids[0])
    return {
        name: [(o.bound.fault_sigma or 0.0, bool(_names(o) & set(o.sealed.ids))) for o in part]
        for name, part in groupby(single, key=lambda o: o.sealed.ids[0])
    }


def _describe_answer(outcome: TrialOutcome) -> str:
    return "+".join(sorted(find_named_effects(outcome) or outcome.also)) or outcome.verdict


def _names(outcome: TrialOutcome) -> frozenset[str]:
    """Whatever was named, material or not, alone or in a declared tie, in the verdict or beside it."""
    return find_named_effects(outcome) | outcome.tied | set(outcome.minor) | set(outcome.also)


def _head(outcomes: Sequence[TrialOutcome]) -> list[str]:
    versions = ", ".join(sorted({o.version for o in outcomes}))
    seeds = _ranges([o.sealed.seed for o in outcomes])
    return [
        "# Blind trials",
        "",
        f"`heft trial --seeds {seeds}` ({len(outcomes)} trials, Heft {versions}).",
        "Faults are planted by code that shares nothing with the effects; every answer was sealed (its hash printed) before the first",
        "diagnosis. Shares stand with their 95 % intervals (Wilson). A fault counts when it is material and at least",
        f"{NAMED_SIGMA:.0f} sigma from nothing (`core/trial/judgement.py`). The bound is what the best possible method could reach",
        "on the same recordings; the distances that it rests on come from simulating each run again without its fault.",
        "",
    ]


def _ranges(seeds: Sequence[int]) -> str:
    """Seeds as they are given to the command."""
    parts = []
    for _, run in groupby(enumerate(sorted(seeds)), key=lambda item: item[1] - item[0]):
        block = [seed for _, seed in run]
        parts.append(str(block[0]) if len(block) == 1 else f"{block[0]}-{block[-1]}")
    return ",".join(parts)


def _figures(outcomes: Sequence[TrialOutcome]) -> list[str]:
    counted = {kind: [o for o in outcomes if o.sealed.kind == kind and counts(o)] for kind in KINDS}
    near, far = tie_honesty(outcomes)
    errors, covered = parameter_errors(outcomes)
    payload = payload_errors(outcomes)
    closures = [first / true for true, first in closure_ratios(outcomes)]
    first, every = (reliability(*answers) for answers in (first_answers(outcomes), all_answers(outcomes, LEAST)))
    alarms = Share.among(not right(o) for o in counted["none"])
    rivals = [o.bound.nearest_rival_sigma for o in counted["single"]]
    clear = [distance for distance in rivals if distance is not None and distance > CLEAR_SIGMA]
    unknown, second = [o.bound.undescribed_sigma for o in counted["unknown"]], [o.bound.second_sigma for o in counted["double"]]
    single = Share.among(names_truth_first(o) for o in counted["single"])
    seconds = [o.seconds for o in outcomes if o.stopped is None]
    rows = [
        ("false alarms on runs without effect", "<= 0.5 %", str(alarms), "-"),
        ("one fault: first name right, declared ties count", ">= 93 %", str(share_right(outcomes, "single")), "-"),
        ("one fault: first name right, ties or not", "-", str(single), _percent(best_share(rivals))),
        (f"the same after the proposed motion ({sum(o.second is not None for o in counted['single'])} asked for one)", ">= 98 %",
         str(share_right([o.final for o in outcomes], "single")), "-"),
        ("nearest rival below 3 sigma: truth in the declared set", ">= 99 %", str(near), "-"),
        ("nearest rival above 6 sigma: one name, the right one", ">= 95 %", str(far), _percent(best_share(clear))),
        ("calibration error of the first answer", "<= 0.02", _number(calibration_error(first)), "-"),
        ("calibration error of all classes from 1 %", "<= 0.02", _number(calibration_error(every)), "-"),
        ("unknown called unknown", ">= 95 %", str(share_right(outcomes, "unknown")), _percent(best_share(unknown))),
        ("two at once: the exact pair", ">= 92 %", str(share_right(outcomes, "double")), _percent(best_share(second))),
        (f"parameter error, median of {len(errors)}", "<= 3 %", _percent(_median(errors)), "-"),
        ("95 % intervals of parameters hold the truth", "94-96 %", str(covered), "95 %"),
        ("closure over the true effect's, median", ">= 0.98", _number(_median(closures)), "1"),
        ("payload error before, median over answered trials", "-", _percent(payload.before), "-"),
        ("payload error after", "the noise", _percent(payload.after), _percent(payload.stated)),
        ("95 % intervals of the payload hold the truth", "95 %", str(payload.covered), "95 %"),
        ("diagnosis on one core, median", "15 s (2 cores)", f"{_number(_median(seconds))} s", "-"),
    ]  # fmt: skip
    return _table(("figure", "wanted", "here", "bound"), rows)


def _kinds(outcomes: Sequence[TrialOutcome]) -> list[str]:
    rows = []
    for kind in KINDS:
        part = [o for o in outcomes if o.sealed.kind == kind]
        stopped = sum(o.stopped is not None for o in part)
        immaterial = sum(not material(o) and o.stopped is None for o in part) if kind != "none" else 0
        rows.append((kind, str(len(part)), str(sum(counts(o) for o in part)), str(share_right(outcomes, kind)),
                     str(Share.among(right(o) for o in part)), str(immaterial), str(stopped)))  # fmt: skip
    return _table(("kind", "trials", "count", "right of those that count", "right of all", "immaterial", "no answer"), rows)


def _effects(outcomes: Sequence[TrialOutcome]) -> list[str]:
    single = sorted((o for o in outcomes if o.sealed.kind == "single" and o.stopped is None), key=lambda o: o.sealed.ids[0])
    rows = []
    for name, group in groupby(single, key=lambda o: o.sealed.ids[0]):
        part = list(group)
        hits = [name in _names(o) for o in part]
        sigma = [(o.bound.fault_sigma, hit) for o, hit in zip(part, hits, strict=True) if o.bound.fault_sigma]
        rows.append((name, str(len(part)), str(Share.among(hits)), _smallest([o.sealed.size for o in part], hits),
                     _smallest([s for s, _ in sigma], [hit for _, hit in sigma])))  # fmt: skip
    return _table(("effect", "trials", "named, material or not", "size named in half the trials", "the same in sigma from nothing"), rows)


def _smallest(x: Sequence[float], hits: Sequence[bool]) -> str:
    """The place of the logistic curve's middle, or the end of what was tried."""
    if not x:
        return "-"
    middle = fit_halfway_size(x, hits)
    if middle is None or not min(x) <= middle <= max(x):
        return f"below {min(x):.2g}" if 2 * sum(hits) > len(hits) else f"above {max(x):.2g}"
    return f"{middle:.2g}"


def _failures(outcomes: Sequence[TrialOutcome]) -> list[str]:
    wrong = [o for o in outcomes if not right(o)]
    return [_failure(o) for o in sorted(wrong, key=lambda o: (not counts(o), o.sealed.seed))] or ["None."]


def _failure(o: TrialOutcome) -> str:
    sigma = "" if o.bound.fault_sigma is None else f", {o.bound.fault_sigma:.0f} sigma (material from {o.bound.material_sigma:.0f})"
    gap = "" if o.gap_before is None or o.gap_after is None else f", gap {o.gap_before:.2f} to {o.gap_after:.2f}"
    answer = o.stopped or " ".join(part for part in (o.verdict, "+".join(sorted(find_named_effects(o)))) if part)
    answer += f", beside it {', '.join(sorted(o.also))}" if o.also else ""
    where = f"{o.sealed.cell}, {o.sealed.payload}"
    asked = "" if counts(o) else " (does not count)"
    return f"- `heft trial --seed {o.sealed.seed}`: {o.sealed.in_words}, size {o.sealed.size:.2f}{sigma}, {where}: {answer}{gap}{asked}"


def _confusion(outcomes: Sequence[TrialOutcome]) -> list[str]:
    return _table(("planted", "answered", "times"), [(a, b, str(n)) for (a, b), n in sorted(confusions(outcomes).items())])


def _table(head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> list[str]:
    return [f"| {' | '.join(row)} |" for row in (head, ("---",) * len(head), *rows)]


def _median(values: Sequence[float]) -> float:
    return float(np.median(values)) if values else float("nan")


def _percent(value: float) -> str:
    return "none" if np.isnan(value) else f"{100 * value:.3g} %"


def _number(value: float) -> str:
    return "none" if np.isnan(value) else f"{value:.3g}"
