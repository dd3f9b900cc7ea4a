"""`core.gap.addition`: from a diagnosis, made up here, to a twin."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

import pytest

from core.cell.folder import load_cell
from core.errors import BadTwin
from core.gap.addition import add_found
from core.gap.answer import Diagnosis, Origin, Pair
from core.twin.twin import NOMINAL, Entry, Fitted
from core.words.message import Message
from tests.core.report.made_up_diagnoses import explained

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
NOW = datetime(2026, 3, 1, tzinfo=UTC)
ORIGIN = Origin(recording="run-1", sha256="0" * 64, cell="lwr4_bench", joints=7, twin={})
TILT = ((1e-6, 2e-7, 0.0), (2e-7, 3e-6, -1e-7), (0.0, -1e-7, 4e-6))
BOTH = Pair(
    ids=("time_delay", "base_tilt"), probability=0.5, gap_after=1.0, closure=0.99, addable=True,
    parameters={each.id: each.parameters for each in explained().effects},
    covariance={"time_delay": [[1.6e-7]], "base_tilt": [[1e-6], [2e-7, 3e-6], [0.0, -1e-7, 4e-6]]},
)  # fmt: skip


def diagnosis(**changes: object) -> Diagnosis:
    """One that found a delay, read from JSON again."""
    delay, lag, tilt = explained().effects
    delay = delay.model_copy(update={"addable": True, "covariance": [[1.6e-7]]})
    tilt = tilt.model_copy(update={"why_not": Message.of("gap-earlier-version")})
    made = explained().model_copy(update={"effects": [delay, lag, tilt], "pairs": [BOTH], "origin": ORIGIN, **changes})
    return Diagnosis.model_validate_json(made.model_dump_json())


def test_an_entry_has_all_that_the_diagnosis_found() -> None:
    assert add_found(NOMINAL, CELL, diagnosis(), "time_delay", NOW).effects == (
        Entry(
            effect="time_delay",
            parameters={"delay_s": Fitted(value=0.0123, std=0.0004, unit="s")},
            covariance=((1.6e-7,),),
            recording="run-1",
            sha256="0" * 64,
            added=NOW,
            gap_before=9.8,
            gap_after=1.25,
        ),
    )


@pytest.mark.parametrize("both", ["time_delay+base_tilt", "base_tilt+time_delay"])
def test_two_effects_are_added_in_whatever_order_they_are_named(both: str) -> None:
    twin = add_found(NOMINAL, CELL, diagnosis(), both, NOW)
    assert [(entry.effect, entry.covariance) for entry in twin.effects] == [("time_delay", ((1.6e-7,),)), ("base_tilt", TILT)]


@pytest.mark.parametrize(
    ("changes", "effect", "code"),
    [
        ({"origin": None}, "time_delay", "gap-earlier-version"),
        ({}, "sensor_gain", "gap-not-named"),
        ({"effects": [], "pairs": []}, "time_delay", "gap-names-none"),
        ({}, "base_tilt", "gap-not-addable"),
        ({"origin": ORIGIN.model_copy(update={"cell": "ur5e_line"})}, "time_delay", "gap-not-addable"),
        ({"origin": ORIGIN.model_copy(update={"joints": 6})}, "time_delay", "gap-not-addable"),
        ({"origin": ORIGIN.model_copy(update={"robot": [[0.0] * 6] * 7})}, "time_delay", "gap-not-addable"),
        ({"origin": ORIGIN.model_copy(update={"sha256": "beef"})}, "time_delay", "schema-string-pattern-mismatch"),
        ({"origin": ORIGIN.model_copy(update={"twin": {"sensor_gain": "0" * 64}})}, "time_delay", "twin-changed"),
    ],
)
def test_what_cannot_be_added_is_refused_with_the_reason(changes: dict[str, object], effect: str, code: str) -> None:
    with pytest.raises(BadTwin) as refused:
        add_found(NOMINAL, CELL, diagnosis(**changes), effect, NOW)
    assert refused.value.message.code == code
