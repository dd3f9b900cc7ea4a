"""The score sheet of blind trials: Markdown with pictures, made to be committed as it is."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from functools import partial
from itertools import groupby
from pathlib import Path
from textwrap import fill

import numpy as np

from core.array import Array
from core.files.whole_file import write_whole
from core.trial import charts
from core.trial.figures import (
    Bin,
    Share,
    all_answers,
    calibration_error,
    calibration_error_by_chance,
    closure_ratios,
    first_answers,
    fit_halfway_size,
    parameter_errors,
    payload_errors,
    reliability,
    share_right,
    tie_honesty,
)
from core.trial.judgement import (
    CLEAR_SIGMA,
    NAMED_SIGMA,
    TIE_SIGMA,
    counts,
    find_named_effects,
    gives_right_verdict,
    material,
    names_truth_alone,
    right,
    tells_truth_outright,
)
from core.trial.outcome import TrialOutcome
from core.words.catalogue import Language
from core.words.wording import Wording

KINDS = {
    "none": "sheet-kind-none",
    "single": "sheet-kind-single",
    "double": "sheet-kind-double",
    "unknown": "sheet-kind-unknown",
}
VERDICTS = {
    "no_gap": "sheet-verdict-no-gap",
    "explained": "sheet-verdict-explained",
    "ambiguous": "sheet-verdict-ambiguous",
    "unknown": "sheet-verdict-unknown",
    "not_enough": "sheet-verdict-not-enough",
    "stopped": "sheet-verdict-stopped",
}
WIDTH = 120
"""Of the sheet's paragraphs, in characters."""
LEAST = 0.01
"""Probabilities below this are left out of the calibration of all classes: there are hundreds of them, all but zero."""


def score_sheet(outcomes: Sequence[TrialOutcome], language: Language = "en") -> str:
    """Markdown without the pictures."""
    words = Wording(language)
    parts = {
        "sheet-by-kind": _kinds(outcomes, words),
        "sheet-by-effect": _effects(outcomes, words),
        "sheet-not-right": _failures(outcomes, words),
    }
    lines = [*_head(outcomes, words), *_figures(outcomes, words), ""]
    for title, part in parts.items():
        lines += [f"## {words.say(title)}", "", *part, ""]
    return "\n".join(lines)


def write_sheet(folder: Path, outcomes: Sequence[TrialOutcome], language: Language = "en") -> None:
    """`trials.md` with its pictures; files of an earlier sheet are replaced."""
    words = Wording(language)
    lines = [score_sheet(outcomes, language)]
    for name, (title, picture) in _pictures(outcomes, words).items():
        write_whole(folder / f"{name}.svg", picture)
        lines += [f"## {title}", "", f"![{title}]({name}.svg)", ""]
    confusion = ["## " + words.say("sheet-confusion-numbers"), "", *_confusion(outcomes, words), ""]
    write_whole(folder / "trials.md", "\n".join([*lines, *confusion]))


def _pictures(outcomes: Sequence[TrialOutcome], words: Wording) -> dict[str, tuple[str, str]]:
    """Title and picture by name; none of what no trial shows."""
    first, every = reliability(*first_answers(outcomes)), reliability(*all_answers(outcomes, LEAST))
    confused, closures, seen = confusions(outcomes), closure_ratios(outcomes), detections(outcomes)
    drawn = {}
    if confused:
        pairs = Counter({(planted, _say_answer(answer, words)): count for (planted, answer), count in confused.items()})
        drawn["confusion"] = (words.say("sheet-confusion"), charts.confusion_chart(pairs, words))
    if first:
        drawn["reliability"] = (words.say("sheet-calibration"), charts.reliability_chart(first, every, words))
    if closures:
        drawn["closure"] = (words.say("sheet-closure"), charts.closure_chart(closures, words))
    if seen:
        drawn["detection"] = (words.say("sheet-detection"), charts.detection_chart(seen, words))
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


def _say_answer(answer: str, words: Wording) -> str:
    """A verdict in words, a name as it is."""
    return words.say(VERDICTS[answer]) if answer in VERDICTS else answer


def _head(outcomes: Sequence[TrialOutcome], words: Wording) -> list[str]:
    seeds, versions = _ranges([o.sealed.seed for o in outcomes]), sorted({o.version for o in outcomes})
    command = words.say("sheet-command", seeds=seeds, count=len(outcomes), versions=versions)
    how = words.say("sheet-how", sigma=NAMED_SIGMA)
    return [f"# {words.say('sheet-title')}", "", command, *fill(how, WIDTH, break_on_hyphens=False).splitlines(), ""]


def _ranges(seeds: Sequence[int]) -> str:
    """Seeds as they are given to the command."""
    parts = []
    for _, run in groupby(enumerate(sorted(seeds)), key=lambda item: item[1] - item[0]):
        block = [seed for _, seed in run]
        parts.append(str(block[0]) if len(block) == 1 else f"{block[0]}-{block[-1]}")
    return ",".join(parts)


def _figures(outcomes: Sequence[TrialOutcome], words: Wording) -> list[str]:
    counted = {kind: [o for o in outcomes if o.sealed.kind == kind and counts(o)] for kind in KINDS}
    near, far = tie_honesty(outcomes)
    errors, covered = parameter_errors(outcomes)
    payload = payload_errors(outcomes)
    closures = [first / true for true, first in closure_ratios(outcomes)]
    probability, hit = first_answers(outcomes)
    first, every = reliability(probability, hit), reliability(*all_answers(outcomes, LEAST))
    alarms = Share.among(not right(o) for o in counted["none"])
    verdicts = Share.among(gives_right_verdict(o) for part in counted.values() for o in part)
    outright, single = (Share.among(map(answered, counted["single"])) for answered in (tells_truth_outright, names_truth_alone))
    seconds = [o.seconds for o in outcomes if o.stopped is None]
    asked = sum(o.second is not None for o in counted["single"])
    say, share = words.say, partial(_say_share, words)
    percent, number = partial(_percent, words), partial(_number, words)
    rows = [
        (say("sheet-false-alarms"), "<= 0.5 %", share(alarms)),
        (say("sheet-one-fault-outright"), ">= 88 %", share(outright)),
        (say("sheet-one-fault"), ">= 88 %", share(single)),
        (say("sheet-one-fault-or-tie"), ">= 94 %", share(share_right(outcomes, "single"))),
        (say("sheet-one-fault-after", count=asked), ">= 97 %", share(share_right([o.final for o in outcomes], "single"))),
        (say("sheet-verdicts"), "-", share(verdicts)),
        (say("sheet-near-rival", sigma=TIE_SIGMA), ">= 98 %", share(near)),
        (say("sheet-far-rival", sigma=CLEAR_SIGMA), ">= 97 %", share(far)),
        (say("sheet-calibration-first"), "<= 0.02", _say_calibration(words, first, probability)),
        (say("sheet-calibration-all"), "<= 0.02", number(calibration_error(every))),
        (say("sheet-unknown-as-unknown"), ">= 93 %", share(share_right(outcomes, "unknown"))),
        (say("sheet-exact-pair"), ">= 85 %", share(share_right(outcomes, "double"))),
        (say("sheet-parameter-error", count=len(errors)), "<= 3 %", percent(_median(errors))),
        (say("sheet-parameters-covered"), "94-96 %", share(covered)),
        (say("sheet-closure-ratio"), ">= 0.98", number(_median(closures))),
        (say("sheet-closure-ratio-low"), ">= 0.9", number(_quantile(closures, 0.1))),
        (say("sheet-payload-before"), "-", percent(payload.before)),
        (say("sheet-payload-after"), say("sheet-the-noise", stated=percent(payload.stated)), percent(payload.after)),
        (say("sheet-payload-covered"), "94-96 %", share(payload.covered)),
        (say("sheet-seconds"), "-", f"{number(_median(seconds))} s"),  # what is wanted is of two quiet cores: `bench/diagnosis.py`
    ]
    head = (say("sheet-figure"), say("sheet-wanted"), say("sheet-here"))
    return _table(head, [(name, words.mark(wanted), here) for name, wanted, here in rows])


def _kinds(outcomes: Sequence[TrialOutcome], words: Wording) -> list[str]:
    rows = []
    for kind, name in KINDS.items():
        part = [o for o in outcomes if o.sealed.kind == kind]
        stopped = sum(o.stopped is not None for o in part)
        immaterial = sum(not material(o) and o.stopped is None for o in part) if kind != "none" else 0
        rows.append((words.say(name), str(len(part)), str(sum(counts(o) for o in part)), _say_share(words, share_right(outcomes, kind)),
                     _say_share(words, Share.among(right(o) for o in part)), str(immaterial), str(stopped)))  # fmt: skip
    head = (words.say("sheet-kind"), words.say("sheet-trials"), words.say("sheet-count"), words.say("sheet-right-of-counting"),
            words.say("sheet-right-of-all"), words.say("sheet-immaterial"), words.say("sheet-no-answer"))  # fmt: skip
    return _table(head, rows)


def _effects(outcomes: Sequence[TrialOutcome], words: Wording) -> list[str]:
    single = sorted((o for o in outcomes if o.sealed.kind == "single" and o.stopped is None), key=lambda o: o.sealed.ids[0])
    rows = []
    for name, group in groupby(single, key=lambda o: o.sealed.ids[0]):
        part = list(group)
        hits = [name in _names(o) for o in part]
        sigma = [(o.bound.fault_sigma, hit) for o, hit in zip(part, hits, strict=True) if o.bound.fault_sigma]
        rows.append((name, str(len(part)), _say_share(words, Share.among(hits)), _smallest([o.sealed.size for o in part], hits, words),
                     _smallest([s for s, _ in sigma], [hit for _, hit in sigma], words)))  # fmt: skip
    head = (words.say("sheet-effect"), words.say("sheet-trials"), words.say("sheet-named"), words.say("sheet-halfway-size"),
            words.say("sheet-halfway-sigma"))  # fmt: skip
    return _table(head, rows)


def _smallest(x: Sequence[float], hits: Sequence[bool], words: Wording) -> str:
    """The place of the logistic curve's middle, or the end of what was tried."""
    if not x:
        return "-"
    middle = fit_halfway_size(x, hits)
    if middle is None or not min(x) <= middle <= max(x):
        return words.say("sheet-below", size=min(x)) if 2 * sum(hits) > len(hits) else words.say("sheet-above", size=max(x))
    return words.mark(f"{middle:.2g}")


def _failures(outcomes: Sequence[TrialOutcome], words: Wording) -> list[str]:
    wrong = [o for o in outcomes if not right(o)]
    found = [_failure(o, words) for o in sorted(wrong, key=lambda o: (not counts(o), o.sealed.seed))]
    return found or [words.say("sheet-all-right")]


def _failure(o: TrialOutcome, words: Wording) -> str:
    faults, size, bound = o.sealed.in_words, o.sealed.size, o.bound
    if bound.fault_sigma is None or bound.material_sigma is None:
        fault = words.say("sheet-planted-faults", faults=faults, size=size)
    else:
        sigma, material_sigma = bound.fault_sigma, bound.material_sigma
        fault = words.say("sheet-planted-faults-at-sigma", faults=faults, size=size, sigma=sigma, material_sigma=material_sigma)
    named = (_say_answer(o.verdict, words), "+".join(sorted(find_named_effects(o))))
    answer = " ".join(part for part in named if part) if o.stopped is None else words.quote(o.stopped)
    if o.also:
        answer = words.say("sheet-answer-beside", answer=answer, effects=sorted(o.also))
    if o.gap_before is not None and o.gap_after is not None:
        answer = words.say("sheet-answer-gap", answer=answer, before=o.gap_before, after=o.gap_after)
    line = words.say("sheet-failure", fault=fault, cell=o.sealed.cell, payload=o.sealed.payload, answer=answer)
    return f"- `heft trial --seed {o.sealed.seed}`: " + (line if counts(o) else words.say("sheet-does-not-count", line=line))


def _confusion(outcomes: Sequence[TrialOutcome], words: Wording) -> list[str]:
    rows = [(planted, _say_answer(answer, words), str(count)) for (planted, answer), count in sorted(confusions(outcomes).items())]
    return _table((words.say("sheet-planted"), words.say("sheet-answered"), words.say("sheet-times")), rows)


def _table(head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> list[str]:
    return [f"| {' | '.join(row)} |" for row in (head, ("---",) * len(head), *rows)]


def _median(values: Sequence[float]) -> float:
    return _quantile(values, 0.5)


def _quantile(values: Sequence[float], share: float) -> float:
    return float(np.quantile(values, share)) if values else float("nan")


def _say_share(words: Wording, share: Share) -> str:
    if not share.of:
        return words.say("sheet-none-drawn")
    low, high = (100 * each for each in share.interval)
    return words.say("sheet-share", percent=100 * share.value, hits=share.hits, of=share.of, low_percent=low, high_percent=high)


def _say_calibration(words: Wording, table: Sequence[Bin], probability: Array) -> str:
    """The error, with what chance alone would make of it; none of no answers."""
    error, low, high = (_number(words, value) for value in (calibration_error(table), *calibration_error_by_chance(probability)))
    return words.say("sheet-error-by-chance", error=error, low=low, high=high) if table else error


def _percent(words: Wording, value: float) -> str:
    return words.say("sheet-none") if np.isnan(value) else words.mark(f"{100 * value:.3g} %")


def _number(words: Wording, value: float) -> str:
    return words.say("sheet-none") if np.isnan(value) else words.mark(f"{value:.3g}")
