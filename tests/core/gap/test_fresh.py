"""Readings that are recorded more often than they are made: what is asked of them is asked at the rows where they were fresh."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.effects.library import library
from core.gap.diagnosis import examine
from core.gap.fit_all import one_by_one
from core.gap.fresh import find_fresh
from core.recording.recording import Recording
from tests.synthetic import Imperfections, payload, record, run_of

SOME = [effect for effect in library() if effect.id in ("base_tilt", "time_delay", "sensor_lowpass")]


def polled(every: int, tilt_rad: float = 0.0) -> Recording:
    """A recording whose sensor was asked every so many rows of 8 ms."""
    how = Imperfections(tilt_rad=(tilt_rad, 0.0), resolution=None)
    recording = record(run_of(repetitions=1, period=0.008), payload("steel_block"), np.random.default_rng(3), how)
    rows = np.arange(len(recording))
    return replace(recording, wrench=recording.wrench[rows - rows % every])


@pytest.mark.parametrize("every", [3, 8])
def test_a_sensor_that_is_asked_slowly_makes_no_gap_and_stands_beside_the_verdict(every: int) -> None:
    diagnosis, _ = examine(polled(every), SOME, fit_all=one_by_one)
    assert diagnosis.verdict == "no_gap"
    assert diagnosis.gap.before == pytest.approx(1.0, abs=0.05)
    assert [each.id for each in diagnosis.also if each.material] == ["sample_dropout"]


@pytest.mark.parametrize("seed", [3, 4])
def test_readings_that_are_held_at_random_leave_the_payload_as_sure_as_the_fresh_ones_make_it(seed: int) -> None:
    rng = np.random.default_rng(seed)
    body = payload("steel_block")
    recording = record(run_of(repetitions=1, period=0.002), body, rng, Imperfections(resolution=None))
    fresh = np.maximum.accumulate(np.where(rng.random(len(recording)) < 0.85, 0, np.arange(len(recording))))
    cable = [effect for effect in library() if effect.id in ("cable_drag", "time_delay")]
    diagnosis, _ = examine(replace(recording, wrench=recording.wrench[fresh]), cable, fit_all=one_by_one)
    assert diagnosis.verdict == "no_gap"
    assert diagnosis.payload is not None
    std = diagnosis.payload.after.std[0]
    assert std < 2e-3
    assert diagnosis.payload.after.phi[0] == pytest.approx(body.mass, abs=3.0 * std)


def test_behind_it_a_tilt_is_found_with_its_size() -> None:
    diagnosis, _ = examine(polled(6, 0.02), SOME, fit_all=one_by_one)
    best = diagnosis.effects[0]
    assert (diagnosis.verdict, best.id) == ("explained", "base_tilt")
    assert best.parameters["about_x_rad"].value == pytest.approx(0.02, abs=1e-3)


def test_fresh_rows_are_kept_and_others_lie_between_them() -> None:
    w = np.random.default_rng(0).normal(size=(1000, 6))
    found = find_fresh(w[np.arange(1000) - np.arange(1000) % 5])
    assert found.every == pytest.approx(5.0)
    line = np.arange(1000.0)
    assert (found.between @ line)[:996] == pytest.approx(line[:996])
    assert (found.between @ np.where(line % 5 == 0, 1.0, 0.0))[:996] == pytest.approx(1.0)


def test_readings_that_are_all_fresh_are_left_alone() -> None:
    assert find_fresh(np.random.default_rng(1).normal(size=(1000, 6))) is None
