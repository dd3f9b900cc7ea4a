"""The sign of a tilt, from what is planted to what a person does: one rotation, the same numbers everywhere."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.effects.base_tilt import BaseTilt
from core.gap.answer import Diagnosis
from core.gap.diagnosis import diagnose
from core.report.diagnosis_rows import explanation_rows, titles_of
from core.words.wording import Wording
from tests.synthetic import Imperfections, payload, record, run_of

TILT_RAD = (0.02, -0.01)
"""Rotation vector that takes nominal into true gravity, about the base's x and y."""


@cache
def diagnosed() -> Diagnosis:
    tilted = Imperfections(tilt_rad=TILT_RAD)
    recording = record(run_of(repetitions=1), payload("steel_block"), np.random.default_rng(1), tilted)
    return diagnose(recording, [BaseTilt()])


def test_table_and_advice_have_the_planted_rotation_with_its_sign() -> None:
    (found,) = diagnosed().effects
    about = {name: value.value for name, value in found.parameters.items()}
    assert about == pytest.approx({"about_x_rad": TILT_RAD[0], "about_y_rad": TILT_RAD[1]}, abs=5e-4)
    said = found.advice.parameters
    assert (said["first_axis"], said["second_axis"]) == ("x", "y")
    assert (said["first_rad"], said["second_rad"]) == (about["about_x_rad"], about["about_y_rad"])
    assert "turn it by 1.1" in found.advice.text


def test_a_base_that_is_turned_as_advised_is_level() -> None:
    said = diagnosed().effects[0].advice.parameters
    nominal = np.array([0.0, 0.0, -9.81])
    true_in_base = Rotation.from_rotvec([*TILT_RAD, 0.0]).apply(nominal)
    stands = Rotation.align_vectors([nominal], [true_in_base])[0]  # takes the base's axes into the room's
    advised = Rotation.from_rotvec([said["first_rad"], said["second_rad"], 0.0])  # about the base's own axes
    levelled = (stands * advised).inv().apply(nominal)
    assert np.degrees(np.arccos(levelled @ nominal / 9.81**2)) < 0.05


def test_the_report_prints_the_same_numbers_in_advice_and_table() -> None:
    words = Wording("en")
    (row,) = [row for row in explanation_rows(diagnosed(), titles_of(diagnosed(), words), words) if row.id == "base_tilt"]
    table = [float(text.split("±")[0].split()[-1]) for text in row.parameters]
    said = diagnosed().effects[0].advice.parameters
    assert table == pytest.approx(np.degrees([said["first_rad"], said["second_rad"]]), abs=0.006)
    assert str(diagnosed().instruction.sentence) == "Level the base"
    assert f"{np.hypot(*table):.2f}°" in diagnosed().instruction.next.text
