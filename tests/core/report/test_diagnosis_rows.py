"""The rows of a diagnosis' report: the heat map, sizes in everyday units, probabilities, the payload before and after."""

from __future__ import annotations

import numpy as np
import pytest

from core.gap.answer import PayloadPart, PhiPart, Value
from core.report.diagnosis_rows import heat_map, payload_rows, percent
from core.report.parameter_words import parameter_texts, value_text
from tests.core.report.made_up_diagnoses import CHANNELS, PHI, explained


def test_the_heat_map_takes_the_loudest_band_and_adds_the_shares() -> None:
    where = explained().where
    assert where is not None
    phases, blocks = heat_map(where.cells)
    assert phases == ("hold:x+", "rotate:y")
    assert [block.title for block in blocks] == ["all bands", "0 to 2 Hz", "2 to 8 Hz"]
    rows = {row.name: row for row in blocks[0].rows}
    assert list(rows) == list(CHANNELS)
    assert rows["tx"].entries == (("", 0, ""), ("14.2", 2, "60 %"))
    assert rows["tx"].share == "60 %"
    assert rows["fz"].entries[0] == ("1.5", 0, "5 %")  # below twice the noise: no tint
    assert [row.name for row in blocks[2].rows] == ["tx"]
    assert heat_map([]) == ((), ())


@pytest.mark.parametrize(
    ("name", "value", "text"),
    [
        ("delay_s", Value(value=0.0123, std=0.0004, unit="s"), "12.30 ± 0.40 ms"),
        ("time_constant_s", Value(value=120.0, std=5.0, unit="s"), "120.0 ± 5.0 s"),
        ("about_x_rad", Value(value=np.radians(0.5), std=np.radians(0.01), unit="rad"), "0.500 ± 0.010°"),
        ("z_m", Value(value=-0.0031, std=0.0002, unit="m"), "-3.10 ± 0.20 mm"),
        ("fx_creep_share", Value(value=0.003, std=0.0001, unit="1"), "0.300 ± 0.010 %"),
        ("damping_ratio", Value(value=0.05, std=None, unit="1"), "0.05"),
        ("stiffness_n_per_m", Value(value=3.0, std=0.5, unit="N/m"), "3.00 ± 0.50 N/m"),
        ("frequency_hz", Value(value=50.0, std=0.0, unit="Hz", at_bound=True), "50 Hz (at its bound)"),
    ],
)
def test_a_parameter_is_told_in_everyday_units(name: str, value: Value, text: str) -> None:
    assert value_text(name, value) == text


def test_of_many_parameters_the_clearest_are_told() -> None:
    many = {f"gain_{k}": Value(value=float(k), std=1.0, unit="1") for k in range(30)}
    texts = parameter_texts(many)
    assert [text.split(" ±")[0] for text in texts[:-1]] == [f"gain {k} {k}.0" for k in range(24, 30)]
    assert texts[-1] == "and 24 more, less clear"


@pytest.mark.parametrize(("share", "text"), [(0.0, "< 0.1 %"), (0.5, "50.0 %"), (1.0, "> 99.9 %"), (0.9987, "99.9 %")])
def test_no_probability_is_told_as_certain(share: float, text: str) -> None:
    assert percent(share) == text


def test_a_payload_that_moves_within_its_uncertainty_is_not_marked() -> None:
    before, after = [2.05, *PHI[1:]], PHI
    wide = payload_rows(PayloadPart(before=PhiPart(phi=before, std=[0.03] * 10), after=PhiPart(phi=after, std=[0.03] * 10)))
    narrow = payload_rows(PayloadPart(before=PhiPart(phi=before, std=[0.01] * 10), after=PhiPart(phi=after, std=[0.01] * 10)))
    assert [row.name for row in wide if row.material] == []
    assert [(row.name, row.change, row.times_interval) for row in narrow if row.material] == [("m", "-2.50 %", "1.8")]


def test_what_a_recording_does_not_determine_is_said_so_and_has_no_change() -> None:
    known = [True] * 4 + [False] * 6
    part = PhiPart(phi=PHI, std=[0.03] * 10, determined=known)
    rows = payload_rows(PayloadPart(before=PhiPart(phi=PHI, std=[0.03] * 10), after=part))
    assert [row.after == "not determined" for row in rows] == [not each for each in known]
    assert {(row.after_std, row.change, row.times_interval) for row in rows[4:]} == {("", "", "")}
    assert "not determined" not in {row.before for row in rows}
