"""A diagnosis as words and rows: the heat map of where, the explanations, parameters in everyday units, the payload."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from core.gap.answer import Diagnosis, PatchPart, PayloadPart, Value
from core.gap.limits import BEYOND_STD, SHARES, sizes
from core.report.charts import CHANNELS
from core.report.rows import LABELS, round_to_uncertainty

SHOWN = 0.005
"""Probability from which an explanation has a row of its own."""
PARAMETERS = 6
"""Of one effect; a cross-talk has thirty."""
CLOSED = 4
"""Of the effects without a row, how many are named with what they would have closed."""
ALIKE = 0.02
"""Closures that differ by less need a word on why only one is likely."""
TIMES_NOISE = (2.0, 5.0, 15.0, 40.0, 100.0)
"""Where the heat map's tints begin."""
UNIT_SUFFIX = re.compile(r"_(rad|s|m|n|nm|nms|kg|kgm|kgm2|hz|share)(_per_(m|nm|s|rad))?$|_per_s$")
SCALES = {"rad": (math.degrees(1.0), "°"), "m": (1e3, "mm"), "rad/(N m)": (1e3, "mrad/(N m)")}
SMALL = {"s": "ms", "kg": "g", "kg m": "g m", "kg m2": "g m²"}
"""Units that become a thousandth below 1."""


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
    sigmas: str
    material: bool


@dataclass(frozen=True)
class Leading:
    """The most probable explanation, one effect or two."""

    ids: tuple[str, ...]
    title: str
    probability: float
    closure: float
    interval: tuple[float, float] | None


def find_leading_explanation(diagnosis: Diagnosis) -> Leading | None:
    """The most probable explanation; None where there is none."""
    titles = {effect.id: effect.title.text for effect in diagnosis.effects}
    singles = [Leading((e.id,), e.title.text, e.probability, e.closure, e.closure_interval) for e in diagnosis.effects]
    pairs = [Leading(p.ids, title_of("+".join(p.ids), titles), p.probability, p.closure, None) for p in diagnosis.pairs]
    return max([*singles, *pairs], key=lambda one: one.probability, default=None)


def percent(share: float) -> str:
    """A probability in per cent without false certainty."""
    if share < 0.001:
        return "< 0.1 %"
    if share > 0.999:
        return "> 99.9 %"
    return f"{100 * share:.1f} %"


def title_of(name: str, titles: Mapping[str, str]) -> str:
    """The words for an effect, or for several joined by a plus sign."""
    return " and ".join(titles.get(part, part.replace("_", " ")) for part in name.split("+"))


def heat_map(cells: Iterable[PatchPart]) -> tuple[tuple[str, ...], tuple[HeatBlock, ...]]:
    """The phases, and one block for all bands (the largest of them) followed by one for each band."""
    listed = list(cells)
    phases = tuple(sorted({cell.phase for cell in listed}, key=_phase_order))
    bands = sorted({cell.band_hz for cell in listed})
    blocks = [HeatBlock("all bands", _heat_rows(listed, phases, CHANNELS))] if len(bands) > 1 else []
    for low, high in bands:
        own = [cell for cell in listed if cell.band_hz == (low, high)]
        channels = tuple(name for name in CHANNELS if len(bands) == 1 or any(cell.channel == name for cell in own))
        blocks.append(HeatBlock(f"{low:g} to {high:g} Hz", _heat_rows(own, phases, channels)))
    return phases, tuple(blocks)


def _phase_order(phase: str) -> tuple[int, str]:
    kinds = ("hold", "rotate", "transfer")
    kind = phase.partition(":")[0]
    return (kinds.index(kind) if kind in kinds else len(kinds), phase)


def _heat_rows(cells: list[PatchPart], phases: tuple[str, ...], channels: Iterable[str]) -> tuple[HeatRow, ...]:
    rows = []
    for channel in channels:
        own = [cell for cell in cells if cell.channel == channel]
        entries = tuple(_entry([cell for cell in own if cell.phase == phase]) for phase in phases)
        rows.append(HeatRow(channel, entries, f"{100 * sum(cell.share for cell in own):.0f} %" if own else ""))
    return tuple(rows)


def _entry(cells: list[PatchPart]) -> tuple[str, int, str]:
    if not cells:
        return "", 0, ""
    times = max(cell.times_noise for cell in cells)
    tint = sum(times >= limit for limit in TIMES_NOISE)
    return f"{times:.1f}" if times < 99.5 else f"{times:.0f}", tint, f"{100 * sum(cell.share for cell in cells):.0f} %"


def value_text(name: str, value: Value) -> str:
    """A parameter with its uncertainty in everyday units."""
    factor, unit = _scale(name, value)
    label = UNIT_SUFFIX.sub("", name).replace("_", " ")
    text = f"{label} {round_to_uncertainty(factor * value.value, None if value.std is None else factor * value.std)}"
    if value.std is not None and value.std > 0:
        text += f" ± {round_to_uncertainty(factor * value.std, factor * value.std)}"
    return text + (unit if unit == "°" else f" {unit}").rstrip() + (" (at its bound)" if value.at_bound else "")


def _scale(name: str, value: Value) -> tuple[float, str]:
    if value.unit == "1":
        return (100.0, "%") if name.endswith("share") else (1.0, "")
    if value.unit in SMALL and abs(value.value) < 1.0:
        return 1e3, SMALL[value.unit]
    factor, unit = SCALES.get(value.unit, (1.0, value.unit))
    return factor, unit.replace("m2", "m²")


def parameter_texts(parameters: Mapping[str, Value]) -> tuple[str, ...]:
    """The parameters in their order; of many, those that stand out most from their uncertainty."""
    names = list(parameters)
    if len(names) > PARAMETERS:
        clearest = sorted(names, key=lambda name: -_clearness(parameters[name]))[:PARAMETERS]
        names = [name for name in names if name in clearest]
    more = len(parameters) - len(names)
    return (*(value_text(name, parameters[name]) for name in names), *([f"and {more} more, less clear"] if more else []))


def _clearness(value: Value) -> float:
    return abs(value.value) / value.std if value.std else math.inf


def explanation_rows(diagnosis: Diagnosis, titles: Mapping[str, str]) -> list[ExplanationRow]:
    """Effects, pairs, none and unknown by probability; below 0.5 % only the first effect."""
    rows = []
    for k, effect in enumerate(diagnosis.effects):
        if effect.probability >= SHOWN or k == 0:
            low, high = effect.closure_interval
            interval = f"{100 * low:.0f} to {100 * high:.0f} %"
            texts = parameter_texts(effect.parameters)
            rows.append(_row(effect.title.text, effect.id, effect.probability, effect.closure, interval, effect.gap_after, texts))
    for pair in diagnosis.pairs:
        if pair.probability >= SHOWN:
            title = title_of("+".join(pair.ids), titles)
            texts = tuple(text for values in pair.parameters.values() for text in parameter_texts(values))
            rows.append(_row(title, " + ".join(pair.ids), pair.probability, pair.closure, "", pair.gap_after, texts, "pair"))
    rows.append(_row("no effect", "none", diagnosis.none_probability, None, "", None, (), "none"))
    rows.append(_row("something that the library does not have", "unknown", diagnosis.unknown_probability, None, "", None, (), "unknown"))
    order = {"effect": 0, "pair": 0, "none": 1, "unknown": 1}
    return sorted(rows, key=lambda row: (-row.probability_width, order[row.kind]))


def _row(
    title: str,
    name: str,
    probability: float,
    closure: float | None,
    interval: str,
    gap_after: float | None,
    parameters: tuple[str, ...],
    kind: str = "effect",
) -> ExplanationRow:
    return ExplanationRow(
        title=title[:1].upper() + title[1:],
        id=name,
        probability=percent(probability),
        probability_width=100 * min(1.0, max(0.0, probability)),
        closure="" if closure is None else f"{100 * closure:.0f} %",
        closure_width=0.0 if closure is None else 100 * min(1.0, max(0.0, closure)),
        interval=interval,
        gap_after="" if gap_after is None else f"{gap_after:.2f}",
        parameters=parameters,
        kind=kind,
    )


def rest_sentences(diagnosis: Diagnosis, titles: Mapping[str, str]) -> list[str]:
    """What the explanations without a row add up to, and what the best of them would have closed."""
    effects = [effect for effect in diagnosis.effects[1:] if effect.probability < SHOWN]
    pairs = [pair for pair in diagnosis.pairs if pair.probability < SHOWN]
    found = []
    if effects:
        best = sorted(effects, key=lambda effect: -effect.closure)[:CLOSED]
        closed = ", ".join(f"{effect.title} {100 * effect.closure:.0f} %" for effect in best)
        total = percent(sum(effect.probability for effect in effects))
        found.append(
            f"Not shown: {_count(len(effects), 'effect')}, together {total}. They would have closed: {closed}"
            + (", the rest less." if len(effects) > len(best) else ".")
        )
        if diagnosis.verdict != "unknown" and best[0].closure > diagnosis.effects[0].closure - ALIKE:
            found.append(
                "Closure alone does not decide: of explanations that predict alike, the one with fewer parameters is the likelier."
            )
    if pairs:
        total = percent(sum(pair.probability for pair in pairs))
        closest = max(pairs, key=lambda pair: pair.closure)
        words = title_of("+".join(closest.ids), titles)
        found.append(
            f"Not shown: {_count(len(pairs), 'pair')}, together {total}; the closest ({words}) closes {100 * closest.closure:.0f} %."
        )
    return found


def _count(number: int, noun: str) -> str:
    return f"{number} other {noun}{'' if number == 1 else 's'}"


def payload_rows(payload: PayloadPart) -> list[PayloadRow]:
    """All ten parameters in kg, g m and g m² with standard deviations."""
    before, after = np.array(payload.before.phi), np.array(payload.after.phi)
    size = sizes(after)
    rows = []
    for k, (a, a_std, b, b_std) in enumerate(zip(before, payload.before.std, after, payload.after.std, strict=True)):
        factor, unit = (1.0, "kg") if k == 0 else (1e3, "g m") if k < 4 else (1e3, "g m²")
        shift = float(a - b)
        share = abs(shift) / size[k] if size[k] > 0 else 0.0
        rows.append(
            PayloadRow(
                name=LABELS[k],
                unit=unit,
                before=round_to_uncertainty(factor * float(a), factor * a_std),
                before_std=round_to_uncertainty(factor * a_std, factor * a_std),
                after=round_to_uncertainty(factor * float(b), factor * b_std),
                after_std=round_to_uncertainty(factor * b_std, factor * b_std),
                change=f"{-100 * shift / size[k]:+.2f} %" if size[k] > 0 else "",
                sigmas=f"{-shift / b_std:+.1f}" if b_std > 0 else "",
                material=bool(share > SHARES[k] and abs(shift) > BEYOND_STD * b_std),
            )
        )
    return rows
