"""Logs too slow for a motion, and lists of poses, of a generator that shares no code with the engine."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.estimation.identification import identify_recording
from core.estimation.kinematics import poses_of
from core.estimation.resting import find_resting
from core.recording.recording import Recording, SensorDescription, take_rows
from tests.foreign_recordings import Condition, make

G = np.array([0.0, 0.0, -9.81])
MASS, MOMENT = 2.0, np.array([0.05, -0.02, 0.2])
NOISE = np.repeat([0.1, 0.005], 3)


def list_of_poses(count: int, stated: bool) -> Recording:
    """One reading in each of so many attitudes, 2 s apart, by Newton's law."""
    rng = np.random.default_rng(count)
    R = Rotation.random(count, random_state=count).as_matrix()
    weight = np.hstack((-MASS * (G @ R), -np.cross(MOMENT, G @ R)))
    wrench = weight + [3.0, -2.0, 5.0, 0.1, 0.2, -0.3] + NOISE * rng.normal(size=(count, 6))
    return Recording(2.0 * np.arange(count), G, wrench=wrench, orientation=R, sensor=SensorDescription(noise_std=NOISE if stated else None))


@pytest.mark.parametrize("labelled", [False, True])
@pytest.mark.parametrize("stated", [False, True])
def test_gravity_that_changes_from_pose_to_pose_is_no_noise_however_many_they_are(stated: bool, labelled: bool) -> None:
    recording = list_of_poses(120, stated)
    answer = identify_recording(replace(recording, phase=np.full(120, "hold:free")) if labelled else recording)
    estimate = answer.estimate
    assert estimate is not None and estimate.determined[:4].all()
    np.testing.assert_allclose(estimate.noise_std, NOISE, rtol=0.3)
    assert np.sqrt(estimate.budget.repeatability[0, 0]) < 0.01
    assert (np.abs(estimate.phi[:4] - [MASS, *MOMENT]) < 3.0 * np.sqrt(np.diag(estimate.covariance))[:4]).all()
    assert not answer.warnings


@pytest.mark.parametrize("rate_hz", [10.0, 40.0])
def test_of_a_motion_that_is_logged_slowly_the_rows_at_rest_tell_the_payload(rate_hz: float) -> None:
    made = make(Condition(rate_hz=rate_hz), 3)
    answer = identify_recording(made.recording)
    estimate = answer.estimate
    assert estimate is not None and estimate.determined[:4].all() and not estimate.determined[4:].any()
    assert (np.abs(estimate.phi[:4] - made.phi[:4]) < 3.0 * np.sqrt(np.diag(estimate.covariance))[:4]).all()
    said = [each for each in answer.warnings if each.code == "estimation-rows-at-rest"]
    assert len(said) == 1 and said[0].parameters["rows"] == len(made.recording)
    assert {part.phase for part in answer.segments} == {"hold:free", "transfer"}
    assert answer.segments[-1].stop == len(made.recording)


@pytest.mark.parametrize("late_s", [0.08, *(pytest.param(late_s, marks=pytest.mark.thorough) for late_s in (0.3, -0.1))])
def test_where_the_wrench_is_late_or_early_only_rows_that_have_long_been_at_rest_are_used(late_s: float) -> None:
    off = []
    for seed in range(3):
        made = make(Condition(rate_hz=20.0, delay_s=late_s), seed)
        answer = identify_recording(made.recording)
        assert answer.estimate is not None and [said.code for said in answer.warnings] == ["estimation-rows-at-rest"]
        assert 20 < answer.warnings[0].parameters["used"] < 0.3 * len(made.recording)
        off.append((answer.estimate.phi[:4] - made.phi[:4]) / answer.estimate.std[:4])
    assert np.abs(off).max() < 3.5


def test_a_slow_log_that_never_rests_for_long_and_does_not_fit_stays_what_it_is() -> None:
    """Between rests of 0.3 s each it turns for as long, and its wrench comes 0.15 s late: of no row is known that it has settled."""
    rng = np.random.default_rng(0)
    stops = np.repeat(rng.normal(scale=0.8, size=(41, 3)), 6, axis=0)
    ways = np.diff(stops[::6], axis=0)[:, None] * (np.arange(1, 7) / 6.0)[:, None]
    turns = np.concatenate((stops[:-6].reshape(40, 6, 3), stops[:-6:6, None] + ways), axis=1).reshape(-1, 3)
    R = Rotation.from_rotvec(turns).as_matrix()
    weight = np.hstack((-MASS * (G @ R), -np.cross(MOMENT, G @ R)))
    recording = Recording(
        0.05 * np.arange(len(R)), G, wrench=np.roll(weight, 3, axis=0) + NOISE * rng.normal(size=(len(R), 6)), orientation=R
    )
    recording = replace(recording, sensor=SensorDescription(noise_std=NOISE))
    poses = poses_of(recording)
    assert poses is not None
    assert find_resting(poses).mean() > 0.1 and not find_resting(poses, 0.35).any()
    assert "estimation-rows-at-rest" not in {said.code for said in identify_recording(recording).warnings}


def test_rows_at_rest_are_those_whose_joints_stand_before_and_after() -> None:
    recording = make(Condition(rate_hz=20.0), 5).recording
    poses = poses_of(recording)
    assert poses is not None and recording.q is not None
    speed = np.abs(np.diff(recording.q, axis=0)).max(axis=1) * 20.0
    resting = find_resting(poses)
    around = np.maximum(np.append(np.inf, speed), np.append(speed, np.inf))
    assert around[resting].max() < 0.05 and resting[around < 1e-3].all()
    assert 0.1 < resting.mean() < 0.9


def test_a_slow_log_in_which_nothing_rests_stays_what_it_is() -> None:
    recording = make(Condition(rate_hz=20.0), 5).recording
    poses = poses_of(recording)
    assert poses is not None
    moving = take_rows(recording, ~find_resting(poses))
    assert all(said.code != "estimation-rows-at-rest" for said in identify_recording(moving).warnings)
