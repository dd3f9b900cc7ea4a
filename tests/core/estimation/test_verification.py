"""A motion that was left out is predicted as well as noise allows, unless something happens in it that the rest does not show."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.estimation.estimate import Verification
from core.estimation.generalised_least_squares import fit
from core.estimation.identification import identify_recording
from core.estimation.kinematics import poses_of
from core.estimation.noise import sensor_noise
from core.estimation.result import SecondsPart, result_of
from core.estimation.segments import motionless, segments_of_phase
from core.estimation.verification import LeaveOneOut
from core.estimation.weak_form import WeakForm
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


def lift(recording: Recording) -> Recording:
    """1000 N more along z while the robot rotates about z."""
    assert recording.wrench is not None and recording.phase is not None
    lifted = recording.wrench.copy()
    lifted[recording.phase == "rotate:z", 2] += 1000.0
    return replace(recording, wrench=lifted)


def test_what_is_left_out_changes_nothing_of_the_prediction(recordings: list[Recording]) -> None:
    """With the same weights: whatever stood there, the difference grows by exactly as much."""
    recording = recordings[1]
    lifted = lift(recording).wrench
    assert recording.wrench is not None and lifted is not None and recording.phase is not None
    poses, segments = poses_of(recording), segments_of_phase(recording.phase)
    noise = sensor_noise(recording.t, recording.wrench, motionless(recording.t, segments), segments)
    assert poses is not None and noise is not None
    whole = LeaveOneOut(poses, recording.wrench, fit(WeakForm(poses), recording.wrench, noise), segments)
    before, after = ({each.phase: each for each in those.verifications()} for those in (whole, replace(whole, wrench=lifted)))
    others = [0, 1, 3, 4, 5]
    np.testing.assert_allclose(after["rotate:z"].rms[others], before["rotate:z"].rms[others], rtol=1e-9)
    assert after["rotate:z"].rms[2] == pytest.approx(1000.0, rel=1e-4)
    assert after["rotate:x"].rms[2] > 10.0 * before["rotate:x"].rms[2]


@pytest.mark.thorough
def test_a_motion_that_spoils_the_weights_is_told_by_its_own_size(recordings: list[Recording]) -> None:
    """The weights are those of all motions, so they change with it; the prediction stays as good as it was said to be."""
    before, after = (verified(each)["rotate:z"] for each in (recordings[1], lift(recordings[1])))
    others = [0, 1, 3, 4, 5]
    assert after.rms[2] == pytest.approx(1000.0, rel=1e-3)
    assert (after.rms[others] < 1.3 * before.expected[others]).all()


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
