"""Readings that are recorded more often than they are made: what is asked of them is asked at the rows where they were fresh."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.signal import lfilter

from core.effects.library import library
from core.estimation.identification import identify_recording
from core.gap.diagnosis import examine
from core.gap.fit_all import one_by_one
from core.recording.held_readings import drop_repeated_rows, find_dead_bands, find_fresh
from core.recording.recording import Recording, take_rows
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


def repeat_rows(recording: Recording, share: float, longest: int) -> Recording:
    """What a recorder makes of it that falls behind and writes its last row again, pose and wrench alike."""
    rng, rows = np.random.default_rng(5), np.arange(len(recording))
    while (rows[1:] == rows[:-1]).mean() < share:
        at, count = int(rng.integers(1, len(rows) - longest)), int(rng.integers(1, longest + 1))
        rows[at : at + count] = rows[at - 1]
    return replace(take_rows(recording, rows), t=recording.t)


@pytest.mark.parametrize("longest", [3, 12])
def test_rows_that_a_recorder_wrote_again_are_lost_and_no_contradiction_and_no_gap(longest: int) -> None:
    body = payload("steel_block")
    whole = record(run_of(repetitions=1, period=0.002), body, np.random.default_rng(3), Imperfections(resolution=None))
    again = repeat_rows(whole, 0.3, longest)
    kept = drop_repeated_rows(again)
    assert len(kept) == pytest.approx(0.7 * len(again), rel=0.02)
    assert np.isin(kept.t, again.t).all()
    told = identify_recording(again)
    assert told.estimate is not None
    assert told.estimate.determined.tolist() == [True] * 4 + [False] * 6
    assert [said.code for said in told.warnings if said.code == "estimation-motion-broken"]
    assert told.estimate.phi[0] == pytest.approx(body.mass, abs=4.0 * told.estimate.std[0])
    diagnosis, _ = examine(again, SOME, fit_all=one_by_one)
    assert diagnosis.verdict == "no_gap"
    assert [each.id for each in diagnosis.also if each.material] == ["sample_dropout"]


def test_readings_alone_that_repeat_leave_every_row_where_it_is() -> None:
    recording = polled(6)
    assert drop_repeated_rows(recording) is recording


def test_fresh_rows_are_kept_and_others_lie_between_them() -> None:
    w = np.random.default_rng(0).normal(size=(1000, 6))
    found = find_fresh(w[np.arange(1000) - np.arange(1000) % 5])
    assert found.every == pytest.approx(5.0)
    line = np.arange(1000.0)
    assert (found.between @ line)[:996] == pytest.approx(line[:996])
    assert (found.between @ np.where(line % 5 == 0, 1.0, 0.0))[:996] == pytest.approx(1.0)


@given(
    share=st.floats(0.0, 0.99),
    resolution=st.sampled_from([0.0, 0.3, 1.0, 3.0]),
    at_a_time=st.sampled_from([1, 2, 3, 6]),
    coloured=st.sampled_from([0.0, 0.9, 0.99]),
    seed=st.integers(0, 99),
)
def test_noise_that_is_held_rounded_or_read_channel_by_channel_has_to_move_by_a_step_at_most(
    share: float, resolution: float, at_a_time: int, coloured: float, seed: int
) -> None:
    """In multiples of the noise; a bus that sends so many channels at a time, in turn."""
    rng = np.random.default_rng(seed)
    read = lfilter([np.sqrt(1.0 - coloured**2)], [1.0, -coloured], rng.normal(size=(3000, 6)), axis=0)
    if resolution:
        read = np.round(read / resolution) * resolution
    rows = np.arange(len(read))
    fresh = rng.random(len(read)) >= share
    turns = [fresh & (rows % (6 // at_a_time) == k // at_a_time) for k in range(6)]
    last = [np.maximum.accumulate(np.where(turn, rows, 0)) for turn in turns]
    wrench = np.column_stack([read[when, k] for k, when in enumerate(last)])
    assert (find_dead_bands(wrench) <= 1.001 * resolution).all()


def test_readings_that_are_all_fresh_are_left_alone() -> None:
    assert find_fresh(np.random.default_rng(1).normal(size=(1000, 6))) is None
