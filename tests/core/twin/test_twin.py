"""A cell's twin in memory."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest
from pydantic import ValidationError

from core.cell.folder import load_cell
from core.errors import BadTwin
from core.twin.twin import NOMINAL, Fitted, Twin
from tests.twin_entries import entry

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
DELAY = entry(CELL, "time_delay", delay_s=0.012)
TILT = entry(CELL, "base_tilt", about_x_rad=0.01)


def test_a_newer_entry_takes_the_place_of_the_older_one() -> None:
    twin = NOMINAL.with_entry(DELAY).with_entry(TILT).with_entry(entry(CELL, "time_delay", delay_s=0.02))
    assert sorted(twin.ids) == ["base_tilt", "time_delay"]
    assert twin.effects[-1].parameters["delay_s"].value == 0.02
    assert twin.without("time_delay").ids == ("base_tilt",)
    assert twin.without("sensor_gain") == twin


def test_directions_carry_the_whole_covariance() -> None:
    covariance = np.array([[4.0, 1.0], [1.0, 2.0]]) * 1e-8
    made = TILT.model_copy(update={"covariance": tuple(map(tuple, covariance.tolist()))})
    axes = np.array([list(direction.values()) for direction in made.directions])
    np.testing.assert_allclose(axes.T @ axes, covariance, rtol=1e-12)
    moved = made.move_parameters(made.directions[0])
    assert moved.parameters["about_x_rad"].value == pytest.approx(0.01 + axes[0, 0])


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_numbers_that_are_none_are_refused(value: float) -> None:
    with pytest.raises(ValidationError):
        Fitted(value=value, std=0.1, unit="s")


def test_what_is_found_takes_the_place_of_what_the_diagnosis_began_with() -> None:
    newer = entry(CELL, "time_delay", delay_s=0.02)
    began = Twin(effects=(TILT, DELAY))
    assert began.with_found([newer], began.hashes) == Twin(effects=(TILT, newer))
    replaced = began.with_entry(entry(CELL, "time_delay", delay_s=0.05))
    assert replaced.with_found([newer], began.hashes) == Twin(effects=(TILT, newer))
    assert NOMINAL.with_found([TILT, newer], {}) == Twin(effects=(TILT, newer))
    assert began.without("time_delay").with_found([newer], began.hashes) == Twin(effects=(TILT, newer))


def test_nothing_is_added_to_a_twin_that_the_diagnosis_did_not_count_with() -> None:
    moved = entry(CELL, "base_tilt", about_x_rad=0.02)
    for began, now in ((NOMINAL, TILT), (Twin(effects=(TILT,)), moved)):
        with pytest.raises(BadTwin, match=r"twin\.json: found a change of base_tilt since .*diagnose the recording again"):
            Twin(effects=(now, DELAY)).with_found([DELAY], began.hashes)
    with pytest.raises(BadTwin, match="base_tilt"):
        NOMINAL.with_found([DELAY], Twin(effects=(TILT,)).hashes)


def test_an_effect_is_the_same_whenever_and_from_wherever_it_came() -> None:
    later = DELAY.model_copy(update={"added": datetime(2027, 1, 1, tzinfo=UTC), "recording": "run-2", "sha256": "f" * 64})
    assert later.hash == DELAY.hash
    assert Twin.model_validate_json(Twin(effects=(DELAY,)).model_dump_json()).hashes == {"time_delay": DELAY.hash}
    assert entry(CELL, "time_delay", delay_s=0.0120001).hash != DELAY.hash
