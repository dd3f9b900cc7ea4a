"""A diagnosis as words and rows: the heat map of where, the explanations, the payload."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from core.effects.effect import Effect, Symptom
from core.effects.library import library, symptoms
from core.gap.answer import Diagnosis, PatchPart, PayloadPart
from core.gap.limits import SHARES, sizes
from core.payload.channels import CHANNELS
from core.report.motions import name_motion
from core.report.parameter_words import parameter_texts
from core.report.rows import LABELS, round_to_uncertainty
from core.words.wording import ENGLISH, Wording

SHOWN = 0.005
"""Probability from which an explanation has a row of its own."""
CLOSED = 4
"""Of the effects without a row, how many are named with what they would have closed."""
ALIKE = 0.02
"""Closures that differ by less need a word on why only one is likely."""
TIMES_NOISE = (2.0, 5.0, 15.0, 40.0, 100.0)
"""Where the heat map's tints begin."""


@dataclass(frozen=True)
class HeatRow:
    """One channel of the heat map: for each phase the times noise, the tint and the share, empty where nothing is listed."""

    name: str
    entries: tuple[tuple[str, int, str], ...]
    share: str


@dataclass(frozen=True)
class HeatBlock:
    """The rows of one frequency band, or of all of them."""

    title: str
    rows: tuple[HeatRow, ...]


@dataclass(frozen=True)
class ExplanationRow:
    """One explanation with its probability and closure, as text and as widths of bars in per cent."""

    title: str
    id: str
    probability: str
    probability_width: float
    closure: str
    closure_width: float
    interval: str
    gap_after: str
    parameters: tuple[str, ...]
    kind: str


@dataclass(frozen=True)
class PayloadRow:
    """One of the ten parameters before and after the effect was added."""

    name: str
    unit: str
    before: str
    before_std: str
    after: str
    after_std: str
    change: str
    times_interval: str
    material: bool


@dataclass(frozen=True)
class Leading:
    """The most probable explanation, one effect or two."""

    ids: tuple[str, ...]
    title: str
    probability: float
    closure: float
    interval: tuple[float, float] | None


def find_leading_explanation(diagnosis: Diagnosis, words: Wording) -> Leading | None:
    """The most probable explanation; None where there is none."""
    titles = titles_of(diagnosis, words)
    singles = [Leading((e.id,), titles[e.id], e.probability, e.closure, e.closure_interval) for e in diagnosis.effects]
    pairs = [Leading(p.ids, title_of("+".join(p.ids), titles, words), p.probability, p.closure, None) for p in diagnosis.pairs]
    return max([*singles, *pairs], key=lambda one: one.probability, default=None)


def percent(share: float, words: Wording = ENGLISH) -> str:
    """A probability in per cent without false certainty."""
    if share < 0.001:
        return words.mark("< 0.1 %")
    if share > 0.999:
        return words.mark("> 99.9 %")
    return words.mark(f"{100 * share:.1f} %")


def titles_of(diagnosis: Diagnosis, words: Wording) -> dict[str, str]:
    """The words for every effect by its identifier: those of the library, and before them those of the diagnosis."""
    every: list[Effect | Symptom] = [*library(), *symptoms()]
    known = {effect.id: words.quote(effect.title) for effect in every}
    return known | {effect.id: words.quote(effect.title) for effect in diagnosis.effects}


def title_of(name: str, titles: Mapping[str, str], words: Wording) -> str:
    """The words for an effect, or for several joined by a plus sign."""
    return f" {words.say('report-and')} ".join(titles.get(part, part.replace("_", " ")) for part in name.split("+"))


def heat_map(cells: Iterable[PatchPart], words: Wording = ENGLISH) -> tuple[tuple[str, ...], tuple[HeatBlock, ...]]:
    """The phases, and one block for all bands (the largest of them) followed by one for each band."""
    listed = list(cells)
    phases = tuple(sorted({str(cell.phase) for cell in listed}, key=_phase_order))
    bands = sorted({cell.band_hz for cell in listed})
    blocks = [HeatBlock(words.say("report-gap-all-bands"), _heat_rows(listed, phases, CHANNELS, words))] if len(bands) > 1 else []
    for low, high in bands:
        own = [cell for cell in listed if cell.band_hz == (low, high)]
        channels = tuple(name for name in CHANNELS if len(bands) == 1 or any(cell.channel == name for cell in own))
        blocks.append(HeatBlock(words.say("report-gap-band", low_hz=low, high_hz=high), _heat_rows(own, phases, channels, words)))
    return tuple(name_motion(phase, words) for phase in phases), tuple(blocks)


def _phase_order(phase: str) -> tuple[int, str]:
    kinds = ("hold", "rotate", "transfer")
    kind = phase.partition(":")[0]
    return (kinds.index(kind) if kind in kinds else len(kinds), phase)


def _heat_rows(cells: list[PatchPart], phases: tuple[str, ...], channels: Iterable[str], words: Wording) -> tuple[HeatRow, ...]:
    rows = []
    for channel in channels:
        own = [cell for cell in cells if cell.channel == channel]
        entries = tuple(_entry([cell for cell in own if str(cell.phase) == phase], words) for phase in phases)
        rows.append(HeatRow(channel, entries, f"{100 * sum(cell.share for cell in own):.0f} %" if own else ""))
    return tuple(rows)


def _entry(cells: list[PatchPart], words: Wording) -> tuple[str, int, str]:
    if not cells:
        return "", 0, ""
    times = max(cell.times_noise for cell in cells)
    tint = sum(times >= limit for limit in TIMES_NOISE)
    return words.mark(f"{times:.1f}") if times < 99.5 else f"{times:.0f}", tint, f"{100 * sum(cell.share for cell in cells):.0f} %"


def explanation_rows(diagnosis: Diagnosis, titles: Mapping[str, str], words: Wording) -> list[ExplanationRow]:
    """Effects, pairs, none and unknown by probability; below 0.5 % only the first effect."""
    rows = []
    for k, effect in enumerate(diagnosis.effects):
        if effect.probability >= SHOWN or k == 0:
            low, high = effect.closure_interval
            interval = words.say("report-gap-percent-range", low=low, high=high)
            texts = parameter_texts(effect.parameters, words)
            found = (effect.probability, effect.closure, interval, effect.gap_after, texts)
            rows.append(_row(words, titles[effect.id], effect.id, *found))
    for pair in diagnosis.pairs:
        if pair.probability >= SHOWN:
            title = title_of("+".join(pair.ids), titles, words)
            texts = tuple(text for values in pair.parameters.values() for text in parameter_texts(values, words))
            rows.append(_row(words, title, " + ".join(pair.ids), pair.probability, pair.closure, "", pair.gap_after, texts, "pair"))
    rows.append(_row(words, words.say("report-gap-no-effect"), "none", diagnosis.none_probability, kind="none"))
    rows.append(_row(words, words.say("report-gap-not-in-library"), "unknown", diagnosis.unknown_probability, kind="unknown"))
    order = {"effect": 0, "pair": 0, "none": 1, "unknown": 1}
    return sorted(rows, key=lambda row: (-row.probability_width, order[row.kind]))


def _row(
    words: Wording,
    title: str,
    name: str,
    probability: float,
    closure: float | None = None,
    interval: str = "",
    gap_after: float | None = None,
    parameters: tuple[str, ...] = (),
    kind: str = "effect",
) -> ExplanationRow:
    return ExplanationRow(
        title=title[:1].upper() + title[1:],
        id=name,
        probability=percent(probability, words),
        probability_width=100 * min(1.0, max(0.0, probability)),
        closure="" if closure is None else f"{100 * closure:.0f} %",
        closure_width=0.0 if closure is None else 100 * min(1.0, max(0.0, closure)),
        interval=interval,
        gap_after="" if gap_after is None else words.mark(f"{gap_after:.2f}"),
        parameters=parameters,
        kind=kind,
    )


def rest_sentences(diagnosis: Diagnosis, titles: Mapping[str, str], words: Wording) -> list[str]:
    """Between which answers it lies, what the explanations without a row add up to, and what the best of them would have closed."""
    effects = [effect for effect in diagnosis.effects[1:] if effect.probability < SHOWN]
    pairs = [pair for pair in diagnosis.pairs if pair.probability < SHOWN]
    found = []
    if diagnosis.likely[1:]:
        others = {"none": words.say("report-gap-no-effect"), "unknown": words.say("report-gap-not-in-library")}
        likely = [others[name] if name in others else title_of(name, titles, words) for name in diagnosis.likely]
        found.append(words.say("report-gap-likely", effects=likely))
    if effects:
        best = sorted(effects, key=lambda effect: -effect.closure)[:CLOSED]
        closed = [words.say("report-gap-effect-closes", effect=titles[effect.id], closure=effect.closure) for effect in best]
        share = percent(sum(effect.probability for effect in effects), words)
        if len(effects) > len(best):
            found.append(words.say("report-gap-others-and-less", count=len(effects), share=share, closed=closed))
        else:
            found.append(words.say("report-gap-others", count=len(effects), share=share, closed=closed))
        if diagnosis.verdict != "unknown" and best[0].closure > diagnosis.effects[0].closure - ALIKE:
            found.append(words.say("report-gap-fewer-parameters"))
    if pairs:
        share = percent(sum(pair.probability for pair in pairs), words)
        closest = max(pairs, key=lambda pair: pair.closure)
        title = title_of("+".join(closest.ids), titles, words)
        found.append(words.say("report-gap-other-pairs", count=len(pairs), share=share, effects=title, closure=closest.closure))
    return found


def payload_rows(payload: PayloadPart, words: Wording = ENGLISH) -> list[PayloadRow]:
    """All ten parameters in kg, g m and g m² with standard deviations."""
    before, after = np.array(payload.before.phi), np.array(payload.after.phi)
    size = sizes(after)
    rows = []
    both = zip(before, payload.before.std, after, payload.after.std, payload.change_over_interval, strict=True)
    unknown = words.say("report-not-determined")
    for k, (a, a_std, b, b_std, times) in enumerate(both):
        known, both_known = payload.after.determined[k], payload.before.determined[k] and payload.after.determined[k]
        factor, unit = (1.0, "kg") if k == 0 else (1e3, "g m") if k < 4 else (1e3, "g m²")
        shift = float(b - a)
        share = abs(shift) / size[k] if size[k] > 0 else 0.0
        rows.append(
            PayloadRow(
                name=LABELS[k],
                unit=unit,
                before=words.mark(round_to_uncertainty(factor * float(a), factor * a_std)) if payload.before.determined[k] else unknown,
                before_std=words.mark(round_to_uncertainty(factor * a_std, factor * a_std)) if payload.before.determined[k] else "",
                after=words.mark(round_to_uncertainty(factor * float(b), factor * b_std)) if known else unknown,
                after_std=words.mark(round_to_uncertainty(factor * b_std, factor * b_std)) if known else "",
                change=words.mark(f"{100 * shift / size[k]:+.2f} %") if both_known and size[k] > 0 else "",
                times_interval=words.mark(f"{abs(times):.1f}") if both_known and times is not None else "",
                material=bool(both_known and share > SHARES[k] and times is not None and abs(times) > 1.0),
            )
        )
    return rows
