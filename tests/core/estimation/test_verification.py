"""A motion that was left out is predicted as well as noise allows, unless something happens in it that the rest does not show."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.estimation.estimate import Verification
from core.estimation.identification import identify_recording
from core.estimation.result import SecondsPart, result_of
from core.recording.recording import Recording
from tests.synthetic import Imperfections, payload, record, run_of


def verified(recording: Recording) -> dict[str, Verification]:
    return {each.phase: each for each in identify_recording(recording).verification}


@pytest.fixture(scope="module")
def recordings() -> list[Recording]:
    how = Imperfections(tilt_rad=(0.004, -0.003), delay_s=0.003, drift_n=0.2)
    return [record(run_of("lwr4_bench", 0), payload("steel_block"), np.random.default_rng(seed), how) for seed in range(2)]


def test_every_rotation_is_predicted_from_the_rest_as_well_as_noise_allows(recordings: list[Recording]) -> None:
    found = [verified(recording) for recording in recordings]
    assert set(found[0]) == {"rotate:x", "rotate:y", "rotate:z"}
    for phase in found[0]:
        squares = [each[phase].ratio ** 2 for each in found]
        assert 0.7 < np.sqrt(np.mean(squares)) < 1.3, phase
        assert (found[0][phase].expected >= found[0][phase].noise).all()


@pytest.mark.thorough
def test_something_that_happens_in_one_motion_alone_shows_where_that_motion_is_left_out(recordings: list[Recording]) -> None:
    recording = recordings[0]
    assert recording.wrench is not None and recording.phase is not None
    rows = recording.phase == "rotate:y"
    pulled = recording.wrench.copy()
    pulled[rows, 4] += 0.05 * np.sin(np.linspace(0.0, np.pi, int(rows.sum())))
    found = verified(replace(recording, wrench=pulled))
    assert found["rotate:y"].ratio > 5.0
    assert found["rotate:y"].ratio > 3.0 * max(found["rotate:x"].ratio, found["rotate:z"].ratio)
    ty = found["rotate:y"].rms / found["rotate:y"].expected
    assert np.argmax(ty) == 4


@pytest.mark.thorough
def test_what_is_left_out_changes_nothing_of_the_prediction(recordings: list[Recording]) -> None:
    """The fit has not seen it: whatever stood there, the difference grows by exactly as much."""
    recording = recordings[1]
    assert recording.wrench is not None and recording.phase is not None
    rows = recording.phase == "rotate:z"
    lifted = recording.wrench.copy()
    lifted[rows, 2] += 1000.0
    before, after = verified(recording)["rotate:z"], verified(replace(recording, wrench=lifted))["rotate:z"]
    assert after.rms[2] == pytest.approx(1000.0, rel=1e-3)
    np.testing.assert_allclose(after.rms[[0, 1, 3, 4, 5]], before.rms[[0, 1, 3, 4, 5]], rtol=0.05)


@pytest.mark.thorough
def test_a_recording_without_rotations_has_nothing_to_leave_out(recordings: list[Recording]) -> None:
    recording = recordings[0]
    still = replace(recording, phase=np.full(len(recording), "transfer"))
    assert identify_recording(still).verification == ()


def test_the_answer_tells_it(recordings: list[Recording]) -> None:
    found = identify_recording(recordings[0])
    parts = result_of(found, recordings[0], seconds=SecondsPart(estimate=0.1)).verification
    assert [part.phase for part in parts] == [each.phase for each in found.verification]
    assert parts[0].ratio == found.verification[0].ratio
