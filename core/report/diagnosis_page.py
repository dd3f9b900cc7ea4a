"""The report of one diagnosis: where the gap lies, which effect causes it, how far it shrinks; a single HTML file without a network."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.effects.sides import Side
from core.gap.answer import Also, Diagnosis, GapPart, JointGap, Minor, Tied, Where
from core.gap.instruction import Instruction, Level, find_advice
from core.gap.limits import GAP
from core.payload.channels import CHANNELS
from core.report.charts import gap_chart, overlay_chart
from core.report.diagnosis_rows import (
    explanation_rows,
    find_leading_explanation,
    heat_map,
    payload_rows,
    percent,
    rest_sentences,
    title_of,
    titles_of,
)
from core.report.html_file import write_html
from core.report.motions import name_motion
from core.report.parameter_words import parameter_texts
from core.report.rows import Fact, sentence
from core.version import code_version
from core.words.catalogue import Language
from core.words.wording import Wording

HEADLINES = {
    "no_gap": "report-gap-none",
    "explained": "report-gap-explained",
    "ambiguous": "report-gap-ambiguous",
    "unknown": "report-gap-unknown",
    "not_enough": "report-gap-not-enough",
}
SIGNS: dict[Level, str] = {"nothing": "✓", "act": "▲", "measure": "↻", "ask": "?"}
DIRECTIONS = {"positive": "report-gap-positive", "negative": "report-gap-negative", "still": "report-gap-still"}
STAGES = {
    "sensor": "report-gap-stage-sensor",
    "timing": "report-gap-stage-timing",
    "mounting": "report-gap-stage-mounting",
    "kinematics": "report-gap-stage-kinematics",
    "payload": "report-gap-stage-payload",
    "environment": "report-gap-stage-environment",
    "actuation": "report-gap-stage-actuation",
}
SIDES: dict[Side, str] = {
    "joints": "report-gap-side-joints",
    "reading": "report-gap-side-reading",
    "reference": "report-gap-side-reference",
}
LIKELY = 0.1
"""Probability from which an explanation that is not settled has its advice."""
NAMED = 3
"""Explanations with their advice, at most."""
DRAWN = 2
"""Channels of the overlay."""


@dataclass(frozen=True)
class Overlay:
    """Measured and simulated wrench of the windowed rows, offsets taken off.

    Args:
        t: (K,), s.
        phase: (K,), labels.
        measured, before, after: (K, 6), N and N m; simulated without and with the effect.
        noise_std: (6,), of one row.
    """

    t: Array
    phase: NDArray[np.str_]
    measured: Array
    before: Array
    after: Array
    noise_std: Array


def write_diagnosis(file: Path, *, diagnosis: Diagnosis, overlay: Overlay | None, language: Language = "en") -> None:
    """Writes the report; the file appears complete or not at all, and replaces an older one of the same name.

    Args:
        diagnosis: the answer, whose parts may be lacking.
        overlay: what the worst motion is drawn from; None where there is nothing to draw.
        language: of the page.
    """
    words = Wording(language)
    write_html(file, "diagnosis.html", _content(diagnosis, overlay, words), words)


def _content(diagnosis: Diagnosis, overlay: Overlay | None, words: Wording) -> dict[str, Any]:
    titles = titles_of(diagnosis, words)
    return {
        "instruction": _instruction(diagnosis.instruction, words),
        "headline": words.say(HEADLINES[diagnosis.verdict]),
        "verdict": diagnosis.verdict,
        "summary": sentence(diagnosis.summary, words),
        "facts": _facts(diagnosis, words),
        "to_do": _to_do(diagnosis, titles, words),
        "consequence": "" if diagnosis.consequence is None else sentence(diagnosis.consequence, words),
        "where": None if diagnosis.where is None else _where(diagnosis.where, words),
        "has_closures": bool(diagnosis.effects or diagnosis.pairs),
        "explanations": [] if diagnosis.verdict == "not_enough" else explanation_rows(diagnosis, titles, words),
        "rest": rest_sentences(diagnosis, titles, words),
        "ties": [_tie(tie, titles, words) for tie in diagnosis.indistinguishable],
        "also": [_also(also, words) for also in diagnosis.also],
        "minor": [_minor(minor, titles, words) for minor in diagnosis.minor],
        "gap": None if diagnosis.gap is None else _gap(diagnosis.gap, words),
        "overlay": None if overlay is None else _overlay(overlay, words),
        "payload": [] if diagnosis.payload is None else payload_rows(diagnosis.payload, words),
        "payload_moved": diagnosis.payload is not None and diagnosis.payload.before != diagnosis.payload.after,
        "experiment": _experiment(diagnosis, titles, words),
        "twin": [title_of(name, titles, words) for name in diagnosis.twin],
        "limits": [sentence(limit, words) for limit in diagnosis.limits if words.quote(limit) not in words.quote(diagnosis.summary)],
        "seconds": diagnosis.seconds,
        "version": code_version(),
    }


def _instruction(instruction: Instruction, words: Wording) -> dict[str, Any]:
    """What stands above everything else, for everybody."""
    return {
        "level": instruction.level,
        "sign": SIGNS[instruction.level],
        "sentence": words.quote(instruction.sentence),
        "next": sentence(instruction.next, words),
        "further": [words.quote(each) for each in instruction.further],
    }


def _facts(diagnosis: Diagnosis, words: Wording) -> list[Fact]:
    gap, where = diagnosis.gap, diagnosis.where
    found = []
    first = find_leading_explanation(diagnosis, words)
    if gap is not None:
        note = words.say("report-gap-noise-is-one")
        found.append(Fact(words.say("report-gap"), words.mark(f"{gap.before:.2f}"), note, alarm=gap.before > GAP * gap.floor))
        if first is not None:
            explained = diagnosis.verdict == "explained"
            name = words.say("report-gap-with-effect") if explained else words.say("report-gap-with-best-effect")
            note = words.say("report-gap-on-unseen")
            found.append(Fact(name, words.mark(f"{gap.after:.2f}"), note, alarm=gap.after > GAP * gap.floor))
    if first is not None:
        unknown = diagnosis.verdict == "unknown"
        note = words.say("report-gap-of-unknown") if unknown else words.say("report-gap-of-effect", effect=first.title)
        probability = diagnosis.unknown_probability if unknown else first.probability
        found.append(Fact(words.say("report-gap-probability"), percent(probability, words), note))
        low, high = first.interval or (0.0, 0.0)
        interval = "" if first.interval is None else words.say("report-gap-closure-interval", low=low, high=high)
        found.append(Fact(words.say("report-gap-closure"), f"{100 * first.closure:.0f} %", interval))
    if where is not None and diagnosis.verdict != "no_gap":
        phase = name_motion(where.phase, words)
        at = words.say("report-gap-during", phase=phase)
        if where.stage is not None and diagnosis.verdict in ("explained", "ambiguous"):
            stage = words.say(STAGES[where.stage]) if where.stage in STAGES else words.quote(where.stage)
            at = words.say("report-gap-during-at-stage", phase=phase, stage=stage)
        found.append(Fact(words.say("report-gap-largest-in"), where.channel, at))
    return found


def _to_do(diagnosis: Diagnosis, titles: dict[str, str], words: Wording) -> list[str]:
    """What a person should do, most urgent first; about the wrench, then about what is seen elsewhere and matters."""
    beside = (sentence(also.advice, words) for also in diagnosis.also if also.material)
    return [*_to_do_about_the_wrench(diagnosis, titles, words), *beside]


def _to_do_about_the_wrench(diagnosis: Diagnosis, titles: dict[str, str], words: Wording) -> list[str]:
    if diagnosis.verdict == "no_gap":
        return [words.say("report-gap-do-nothing")]
    if diagnosis.verdict == "not_enough":
        return [words.say("report-gap-record-again")]
    if diagnosis.verdict == "unknown":
        where = diagnosis.where
        if where is None:
            return [words.say("report-gap-add-none")]
        return [words.say("report-gap-add-none-look", channel=where.channel, phase=name_motion(where.phase, words))]
    first = find_leading_explanation(diagnosis, words)
    ids = () if first is None else first.ids
    own = find_advice(diagnosis, ids)
    if diagnosis.verdict == "explained":
        return [sentence(advice, words) for advice in own.values()]
    tied = {name for tie in diagnosis.indistinguishable for joined in tie.ids for name in joined.split("+")}
    likely = [effect for effect in diagnosis.effects if effect.id in tied or effect.id in ids or effect.probability > LIKELY]
    advice = [(titles[effect.id], sentence(own.get(effect.id, effect.advice), words)) for effect in likely[:NAMED]]
    return [_settle(diagnosis, words), *(words.say("report-gap-if-it-is", effect=title, advice=what) for title, what in advice)]


def _settle(diagnosis: Diagnosis, words: Wording) -> str:
    if diagnosis.next_experiment is not None:
        return words.say("report-gap-settle-by-motion")
    if diagnosis.indistinguishable:
        return sentence(words.say("report-gap-settle-by", splits=words.quote(diagnosis.indistinguishable[0].splits)), words)
    return words.say("report-gap-settle")


def _where(where: Where, words: Wording) -> dict[str, Any]:
    phases, blocks = heat_map(where.cells, words)
    most = max(where.by_time, default=0.0) or 1.0
    squares = {**where.by_direction, **where.by_pose}
    loud = {_name_direction(name, words): float(np.sqrt(max(0.0, square))) for name, square in squares.items()}
    loudest = max(loud.values(), default=0.0) or 1.0
    return {
        "sentence": sentence(where.message, words),
        "phases": phases,
        "blocks": blocks,
        "listed": len(where.cells),
        "share": sum(cell.share for cell in where.cells),
        "time": [(f"{100 * share:.0f}", f"{100 * max(0.0, share) / most:.1f}") for share in where.by_time],
        "direction": [(name, words.mark(f"{value:.1f}"), f"{100 * value / loudest:.1f}") for name, value in loud.items()],
        "joints": [_joint(joint, words) for joint in where.joints],
    }


def _name_direction(name: str, words: Wording) -> str:
    """A sense of turning, or a pose such as `x+`, in words."""
    if name in DIRECTIONS:
        return words.say(DIRECTIONS[name])
    return words.say("report-gap-axis-down", axis=name[0]) if name[1:] == "+" else words.say("report-gap-axis-up", axis=name[0])


def _joint(joint: JointGap, words: Wording) -> tuple[str, str, str]:
    """Name, tracking error and torque of one joint, in everyday units."""
    tracking = "" if joint.tracking_rms_rad is None else words.mark(f"{1e3 * joint.tracking_rms_rad:.3f} mrad")
    torque = "" if joint.torque_rms_n_m is None else words.mark(f"{joint.torque_rms_n_m:.2f} N m")
    return joint.joint, tracking, torque


def _tie(tie: Tied, titles: dict[str, str], words: Wording) -> dict[str, str]:
    names = f" {words.say('report-or')} ".join(title_of(name, titles, words) for name in tie.ids)
    return {
        "names": sentence(names, words),
        "distance": words.say("report-gap-apart", sigma=tie.distance_sigma),
        "why": sentence(tie.why, words),
        "splits": sentence(tie.splits, words),
    }


def _minor(minor: Minor, titles: dict[str, str], words: Wording) -> dict[str, Any]:
    return {
        "title": sentence(title_of(minor.id, titles, words), words).rstrip("."),
        "sentence": sentence(minor.message, words),
        "parameters": parameter_texts(minor.parameters, words),
    }


def _also(also: Also, words: Wording) -> dict[str, Any]:
    side, times = words.say(SIDES[also.side]), also.times_expected
    return {
        "title": sentence(also.title, words).rstrip("."),
        "where": side if times is None else words.say("report-gap-times-expected", side=side, times=times),
        "material": also.material,
        "sentence": sentence(also.message, words),
        "parameters": parameter_texts(also.parameters, words),
    }


def _gap(gap: GapPart, words: Wording) -> dict[str, Any]:
    gaps = {name: (change.before, change.after) for name, change in gap.by_channel.items()}
    return {
        "before": gap.before,
        "after": gap.after,
        "moved": f"{gap.before:.2f}" != f"{gap.after:.2f}",
        "held_out": [name_motion(motion, words) for motion in gap.held_out],
        "chart": gap_chart(gaps, gap.floor, words) if gaps else None,
    }


def _overlay(overlay: Overlay, words: Wording) -> dict[str, Any]:
    rows = worst_motion(overlay)
    excess = np.mean(((overlay.measured[rows] - overlay.before[rows]) / overlay.noise_std) ** 2, axis=0)
    channels = [int(k) for k in np.sort(np.argsort(-excess)[:DRAWN])]
    parts = (overlay.t, overlay.measured, overlay.before, overlay.after)
    t, measured, before, after = (part[rows] for part in parts)
    return {
        "chart": overlay_chart(t, measured, before, after, overlay.noise_std, channels, words),
        "phase": name_motion(str(overlay.phase[rows][0]), words),
        "channels": f" {words.say('report-and')} ".join(CHANNELS[k] for k in channels),
        "changed": not np.array_equal(before, after),
    }


def worst_motion(overlay: Overlay) -> slice:
    """The rows of one motion, without a break in its label, in which the simulation without the effect leaves most."""
    edges = np.flatnonzero(overlay.phase[1:] != overlay.phase[:-1]) + 1
    motions = [slice(int(a), int(b)) for a, b in zip([0, *edges], [*edges, len(overlay.t)], strict=True)]
    left = np.sum(((overlay.measured - overlay.before) / overlay.noise_std) ** 2, axis=1)
    return max(motions, key=lambda rows: float(left[rows].sum()))


def _experiment(diagnosis: Diagnosis, titles: dict[str, str], words: Wording) -> dict[str, Any] | None:
    experiment = diagnosis.next_experiment
    if experiment is None:
        return None
    pairs = [[title_of(name, titles, words) for name in pair] for pair in experiment.splits]
    if experiment.planned:
        planned = words.say("report-gap-planned")
    else:
        planned = sentence(words.say("report-gap-not-planned", reason=experiment.refused or ""), words)
    return {
        "motion": sentence(experiment.motion, words),
        "seconds": experiment.seconds,
        "pairs": "; ".join(words.say("report-gap-pair", first=first, second=second) for first, second in pairs),
        "sigma_before": experiment.sigma_before,
        "sigma_after": experiment.sigma_after,
        "planned": planned,
    }
