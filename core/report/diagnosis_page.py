"""The report of one diagnosis: where the gap lies, which effect causes it, how far it shrinks; a single HTML file without a network."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.gap.answer import SIDES, Also, Diagnosis, GapPart, JointGap, Minor, Tied, Where
from core.gap.limits import GAP
from core.report.charts import CHANNELS, gap_chart, overlay_chart
from core.report.diagnosis_rows import (
    explanation_rows,
    find_leading_explanation,
    heat_map,
    parameter_texts,
    payload_rows,
    percent,
    rest_sentences,
    title_of,
)
from core.report.html_file import write_html
from core.report.rows import Fact, sentence
from core.version import code_version

Array = NDArray[np.float64]

HEADLINES = {
    "no_gap": "No gap that matters",
    "explained": "Gap explained",
    "ambiguous": "Gap explained in more than one way",
    "unknown": "Gap of unknown cause",
    "not_enough": "Too little to say anything",
}
DIRECTIONS = {"positive": "turning positively", "negative": "turning negatively", "still": "standing still"}
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


def write_diagnosis(file: Path, *, diagnosis: Diagnosis, overlay: Overlay | None) -> None:
    """Writes the report; the file appears complete or not at all, and replaces an older one of the same name.

    Args:
        diagnosis: the answer, whose parts may be lacking.
        overlay: what the worst motion is drawn from; None where there is nothing to draw.
    """
    write_html(file, "diagnosis.html", _content(diagnosis, overlay))


def _content(diagnosis: Diagnosis, overlay: Overlay | None) -> dict[str, Any]:
    titles = {effect.id: effect.title.text for effect in diagnosis.effects}
    return {
        "headline": HEADLINES[diagnosis.verdict],
        "verdict": diagnosis.verdict,
        "summary": sentence(diagnosis.summary.text),
        "facts": _facts(diagnosis),
        "to_do": _to_do(diagnosis),
        "consequence": "" if diagnosis.consequence is None else sentence(diagnosis.consequence.text),
        "where": None if diagnosis.where is None else _where(diagnosis.where),
        "has_closures": bool(diagnosis.effects or diagnosis.pairs),
        "explanations": [] if diagnosis.verdict == "not_enough" else explanation_rows(diagnosis, titles),
        "rest": rest_sentences(diagnosis, titles),
        "ties": [_tie(tie, titles) for tie in diagnosis.indistinguishable],
        "also": [_also(also) for also in diagnosis.also],
        "minor": [_minor(minor, titles) for minor in diagnosis.minor],
        "gap": None if diagnosis.gap is None else _gap(diagnosis.gap),
        "overlay": None if overlay is None else _overlay(overlay),
        "payload": [] if diagnosis.payload is None else payload_rows(diagnosis.payload),
        "payload_moved": diagnosis.payload is not None and diagnosis.payload.before != diagnosis.payload.after,
        "experiment": _experiment(diagnosis, titles),
        "twin": ", ".join(title_of(name, titles) for name in diagnosis.twin),
        "limits": [sentence(limit.text) for limit in diagnosis.limits if limit.text not in diagnosis.summary.text],
        "seconds": f"{diagnosis.seconds:.1f}",
        "version": code_version(),
    }


def _facts(diagnosis: Diagnosis) -> list[Fact]:
    gap, where = diagnosis.gap, diagnosis.where
    found = []
    first = find_leading_explanation(diagnosis)
    if gap is not None:
        found.append(Fact("Gap", f"{gap.before:.2f}", "noise alone is 1", alarm=gap.before > GAP * gap.floor))
        if first is not None:
            name = "Gap with the effect added" if diagnosis.verdict == "explained" else "Gap with the best effect"
            found.append(Fact(name, f"{gap.after:.2f}", "on unseen motions", alarm=gap.after > GAP * gap.floor))
    if first is not None:
        unknown = diagnosis.verdict == "unknown"
        of = "of an unknown effect" if unknown else f"of {first.title}"
        found.append(Fact("Probability", percent(diagnosis.unknown_probability if unknown else first.probability), of))
        interval = "" if first.interval is None else f"95 %: {100 * first.interval[0]:.0f} to {100 * first.interval[1]:.0f} %"
        found.append(Fact("Closure", f"{100 * first.closure:.0f} %", interval))
    if where is not None and diagnosis.verdict != "no_gap":
        known = diagnosis.verdict in ("explained", "ambiguous")
        found.append(Fact("Largest in", where.channel, f"during {where.phase}" + (f"; stage: {where.stage}" if known else "")))
    return found


def _to_do(diagnosis: Diagnosis) -> list[str]:
    """What a person should do, most urgent first; about the wrench, then about what is seen elsewhere and matters."""
    return [*_to_do_about_the_wrench(diagnosis), *(sentence(also.advice.text) for also in diagnosis.also if also.material)]


def _to_do_about_the_wrench(diagnosis: Diagnosis) -> list[str]:
    if diagnosis.verdict == "no_gap":
        return ["Nothing needs to be added to the simulation."]
    if diagnosis.verdict == "not_enough":
        return ["Record again, with what is lacking."]
    if diagnosis.verdict == "unknown":
        where = "" if diagnosis.where is None else f" Look at {diagnosis.where.channel} during {diagnosis.where.phase} first."
        return ["Add no effect to the simulation: none of them is the cause." + where]
    first = find_leading_explanation(diagnosis)
    ids = () if first is None else first.ids
    if diagnosis.verdict == "explained":
        return [sentence(effect.advice.text) for effect in diagnosis.effects if effect.id in ids]
    tied = {name for tie in diagnosis.indistinguishable for joined in tie.ids for name in joined.split("+")}
    likely = [effect for effect in diagnosis.effects if effect.id in tied or effect.id in ids or effect.probability > LIKELY]
    return [_settle(diagnosis), *(f"If it is {effect.title}: {sentence(effect.advice.text)}" for effect in likely[:NAMED])]


def _settle(diagnosis: Diagnosis) -> str:
    if diagnosis.next_experiment is not None:
        return "Settle first which it is: see the next experiment below."
    if diagnosis.indistinguishable:
        return sentence(f"Settle first which it is: {diagnosis.indistinguishable[0].splits}")
    return "Settle first which it is."


def _where(where: Where) -> dict[str, Any]:
    phases, blocks = heat_map(where.cells)
    most = max(where.by_time, default=0.0) or 1.0
    squares = {**where.by_direction, **where.by_pose}
    loud = {DIRECTIONS.get(name, _pose(name)): float(np.sqrt(max(0.0, square))) for name, square in squares.items()}
    loudest = max(loud.values(), default=0.0) or 1.0
    return {
        "sentence": sentence(where.message.text),
        "phases": phases,
        "blocks": blocks,
        "listed": len(where.cells),
        "share": f"{100 * sum(cell.share for cell in where.cells):.0f} %",
        "time": [(f"{100 * share:.0f}", f"{100 * max(0.0, share) / most:.1f}") for share in where.by_time],
        "direction": [(name, f"{value:.1f}", f"{100 * value / loudest:.1f}") for name, value in loud.items()],
        "joints": [_joint(joint) for joint in where.joints],
    }


def _pose(name: str) -> str:
    """`x+` in words."""
    return f"{name[0]} {'down' if name[1:] == '+' else 'up'}"


def _joint(joint: JointGap) -> tuple[str, str, str]:
    """Name, tracking error and torque of one joint, in everyday units."""
    tracking = "" if joint.tracking_rms_rad is None else f"{1e3 * joint.tracking_rms_rad:.3f} mrad"
    torque = "" if joint.torque_rms_n_m is None else f"{joint.torque_rms_n_m:.2f} N m"
    return joint.joint, tracking, torque


def _tie(tie: Tied, titles: dict[str, str]) -> dict[str, str]:
    return {
        "names": sentence(" or ".join(title_of(name, titles) for name in tie.ids)),
        "distance": f"{tie.distance_sigma:.1f} σ apart",
        "why": sentence(tie.why.text),
        "splits": sentence(tie.splits.text),
    }


def _minor(minor: Minor, titles: dict[str, str]) -> dict[str, Any]:
    return {
        "title": sentence(title_of(minor.id, titles)).rstrip("."),
        "sentence": sentence(minor.message.text),
        "parameters": parameter_texts(minor.parameters),
    }


def _also(also: Also) -> dict[str, Any]:
    return {
        "title": sentence(also.title.text).rstrip("."),
        "where": SIDES[also.side].text,
        "material": also.material,
        "times": "" if also.times_expected is None else f"{also.times_expected:.1f} times what is stated or tolerated",
        "sentence": sentence(also.message.text),
        "parameters": parameter_texts(also.parameters),
    }


def _gap(gap: GapPart) -> dict[str, Any]:
    gaps = {name: (change.before, change.after) for name, change in gap.by_channel.items()}
    return {
        "before": f"{gap.before:.2f}",
        "after": f"{gap.after:.2f}",
        "held_out": ", ".join(gap.held_out),
        "chart": gap_chart(gaps, gap.floor) if gaps else None,
    }


def _overlay(overlay: Overlay) -> dict[str, Any]:
    rows = worst_motion(overlay)
    excess = np.mean(((overlay.measured[rows] - overlay.before[rows]) / overlay.noise_std) ** 2, axis=0)
    channels = [int(k) for k in np.sort(np.argsort(-excess)[:DRAWN])]
    parts = (overlay.t, overlay.measured, overlay.before, overlay.after)
    t, measured, before, after = (part[rows] for part in parts)
    return {
        "chart": overlay_chart(t, measured, before, after, overlay.noise_std, channels),
        "phase": str(overlay.phase[rows][0]),
        "channels": " and ".join(CHANNELS[k] for k in channels),
        "changed": not np.array_equal(before, after),
    }


def worst_motion(overlay: Overlay) -> slice:
    """The rows of one motion, without a break in its label, in which the simulation without the effect leaves most."""
    edges = np.flatnonzero(overlay.phase[1:] != overlay.phase[:-1]) + 1
    motions = [slice(int(a), int(b)) for a, b in zip([0, *edges], [*edges, len(overlay.t)], strict=True)]
    left = np.sum(((overlay.measured - overlay.before) / overlay.noise_std) ** 2, axis=1)
    return max(motions, key=lambda rows: float(left[rows].sum()))


def _experiment(diagnosis: Diagnosis, titles: dict[str, str]) -> dict[str, Any] | None:
    experiment = diagnosis.next_experiment
    if experiment is None:
        return None
    splits = [" from ".join(title_of(name, titles) for name in pair) for pair in experiment.splits]
    return {
        "motion": sentence(experiment.motion.text),
        "seconds": f"{experiment.seconds:.0f} s" if experiment.seconds > 0.0 else "",
        "splits": "; ".join(splits),
        "sigma": f"{experiment.sigma_before:.1f} σ now, {experiment.sigma_after:.0f} σ expected with both recordings",
        "planned": "It is planned in the cell." if experiment.planned else sentence(f"It is not yet planned: {experiment.refused}"),
    }
