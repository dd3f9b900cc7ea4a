"""The parameters of effects in words and everyday units."""

from __future__ import annotations

import math
from collections.abc import Mapping

from core.effects.parameter_title import find_title
from core.gap.answer import Value
from core.report.rows import round_to_uncertainty
from core.words.wording import ENGLISH, Wording

SHOWN = 6
"""Of one effect on a page; a cross-talk has thirty."""
SCALES = {"rad": (math.degrees(1.0), "°"), "m": (1e3, "mm"), "rad/(N m)": (1e3, "mrad/(N m)")}
SMALL = {"s": "ms", "kg": "g", "kg m": "g m", "kg m2": "g m²"}
"""Units that become a thousandth below 1."""


def parameter_texts(parameters: Mapping[str, Value], words: Wording = ENGLISH, shown: int = SHOWN) -> tuple[str, ...]:
    """The parameters in their order; of many, those that stand out most from their uncertainty."""
    names = list(parameters)
    if len(names) > shown:
        clearest = sorted(names, key=lambda name: -_clearness(parameters[name]))[:shown]
        names = [name for name in names if name in clearest]
    more = len(parameters) - len(names)
    told = tuple(f"{words.quote(find_title(name))} {value_text(name, parameters[name], words)}" for name in names)
    return (*told, words.say("report-gap-more-parameters", count=more)) if more else told


def _clearness(value: Value) -> float:
    return abs(value.value) / value.std if value.std else math.inf


def value_text(name: str, value: Value, words: Wording = ENGLISH) -> str:
    """The value of the parameter of that name with its uncertainty, in everyday units."""
    factor, unit = _scale(name, value)
    number = round_to_uncertainty(factor * value.value, None if value.std is None else factor * value.std)
    if value.std is not None and value.std > 0:
        number += f" ± {round_to_uncertainty(factor * value.std, factor * value.std)}"
    text = words.mark(number) + (unit if unit == "°" else f" {unit}").rstrip()
    return words.say("report-gap-at-bound", parameter=text) if value.at_bound else text


def _scale(name: str, value: Value) -> tuple[float, str]:
    if value.unit == "1":
        return (100.0, "%") if name.endswith("share") else (1.0, "")
    if value.unit in SMALL and abs(value.value) < 1.0:
        return 1e3, SMALL[value.unit]
    factor, unit = SCALES.get(value.unit, (1.0, value.unit))
    return factor, unit.replace("m2", "m²").replace("s2", "s²")
