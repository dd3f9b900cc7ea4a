"""The Kalman filter behind the paper's estimate: on line, over a whole recording, and its noise."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.estimation.kinematic_filter import ALPHA_VARIANCE, SETTLING_S, filter_motion, find_pose_noise, pose_noise_std
from core.estimation.kinematics import Poses, poses_of
from core.estimation.online_filter import KinematicFilter
from tests.synthetic import GRAVITY, Imperfections, payload, record, run_of

STD = 5e-6


@pytest.fixture(scope="module")
def filtered() -> tuple[np.ndarray, np.ndarray, KinematicFilter]:
    run = run_of("lwr4_bench", 0)
    rows = slice(0, 9000)
    noisy = run.robot.sensor_poses(run.q[rows] + 2e-6 * np.random.default_rng(0).normal(size=run.q[rows].shape))
    kf = KinematicFilter(1e-3, position_std=STD, orientation_std=STD)
    found, true = [], []
    for k in range(9000):
        kf.update(noisy.rotation[k], noisy.position[k])
        motion = kf.motion(GRAVITY)
        found.append(np.concatenate((motion.omega[0], motion.alpha[0], motion.a[0])))
        true.append(np.concatenate((run.omega[k], run.alpha[k], run.rotation[k].T @ run.a[k])))
    return np.array(found), np.array(true), kf


def test_the_filter_follows_the_motion_with_a_lag_of_its_bandwidth(
    filtered: tuple[np.ndarray, np.ndarray, KinematicFilter],
) -> None:
    found, true, _ = filtered
    error = (found - true)[500:]
    assert np.sqrt(np.mean(error[:, :3] ** 2)) < 0.02
    signal = np.sqrt(np.mean(true[500:, 3:6] ** 2))
    assert np.sqrt(np.mean(error[:, 3:6] ** 2)) < 0.25 * signal


def test_at_rest_the_filter_is_quieter_than_it_says_of_itself_for_motion(
    filtered: tuple[np.ndarray, np.ndarray, KinematicFilter],
) -> None:
    found, _, kf = filtered
    at_rest = found[500:1400]
    omega_std, alpha_std, _, a_std = kf.steady_std
    for rows, std in ((slice(0, 3), omega_std), (slice(3, 6), alpha_std), (slice(6, 9), a_std)):
        # what it says counts the jerk that it allows for, the thresholds are built on it
        assert 0.02 * std < at_rest[:, rows].std() < std
    np.testing.assert_allclose(kf.rotation @ kf.rotation.T, np.eye(3), atol=1e-9)


def poses_of_run(**changes: object) -> Poses:
    """Those of a synthetic recording with encoders of 2e-6 rad."""
    recording = record(run_of("lwr4_bench", 0), payload("cylinder"), np.random.default_rng(0), Imperfections())
    poses = poses_of(recording)
    assert poses is not None
    return replace(poses, **changes)


def test_over_a_whole_recording_it_gives_what_it_gives_sample_by_sample() -> None:
    poses = poses_of_run()
    assert poses.position is not None
    kf = KinematicFilter(poses.period, position_std=2 * STD, orientation_std=STD)
    motion, speed, settled = filter_motion(poses, position_std=2 * STD, orientation_std=STD)
    rows = 4000
    for k in range(rows):
        kf.update(poses.rotation[k], poses.position[k])
        if k % 250 == 249:
            now = kf.motion(poses.gravity)
            for name in ("g", "a", "omega", "alpha"):
                np.testing.assert_allclose(getattr(motion, name)[k], getattr(now, name)[0], atol=1e-7)
            assert speed[k] == pytest.approx(np.linalg.norm(kf.twist[:3]), abs=1e-8)
    assert not settled[poses.t - poses.t[0] < SETTLING_S - 1e-9].any() and settled[rows:].all()


@pytest.mark.parametrize("encoder_std", [1e-6, 2e-6, 1e-5])
def test_whatever_the_encoders_noise_its_angular_acceleration_has_the_variance_of_table_2(encoder_std: float) -> None:
    std = pose_noise_std(encoder_std, 7)
    alpha_std = KinematicFilter(1e-3, position_std=std, orientation_std=std).steady_std[1]
    assert alpha_std**2 == pytest.approx(ALPHA_VARIANCE, rel=0.05)


def test_lost_rows_are_longer_steps_and_a_gap_is_a_new_beginning() -> None:
    poses = poses_of_run()
    kept = np.random.default_rng(1).random(len(poses.t)) > 0.2
    kept &= (poses.t < 5.0) | (poses.t > 5.5)
    assert poses.position is not None
    lossy = replace(poses, t=poses.t[kept], rotation=poses.rotation[kept], position=poses.position[kept])
    whole, _, _ = filter_motion(poses, position_std=STD, orientation_std=STD)
    found, _, settled = filter_motion(lossy, position_std=STD, orientation_std=STD)
    for start, end in ((lossy.t[0], 5.0), (lossy.t[lossy.t > 5.0][0], lossy.t[-1])):
        part = (lossy.t >= start) & (lossy.t <= end)
        np.testing.assert_array_equal(settled[part], lossy.t[part] - start >= SETTLING_S)
    off = (found.alpha - whole.alpha[kept])[settled]
    assert np.sqrt(np.mean(off**2)) < 0.05 * np.sqrt(np.mean(whole.alpha**2))


def test_its_noise_is_what_the_recording_shows_and_no_less_than_the_cell_states() -> None:
    poses = poses_of_run()
    seen = 2e-6 * np.sqrt(7)
    for std in find_pose_noise(poses, None):
        assert 0.1 * seen < std < 2.0 * seen
    assert find_pose_noise(poses, 1e-4)[1] == pytest.approx(1e-4 * np.sqrt(7))
    assert min(find_pose_noise(replace(poses, noise=np.zeros((6, 6))), None)) > 0.0
