"""Poses and motion without lag."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import nnls

from core.estimation.kinematics import find_jitter, find_level, poses_of, smooth_motion, white_noise_std
from core.recording.recording import take_rows
from tests.synthetic import payload, record, run_of


def test_the_noise_of_the_encoders_is_found_under_the_motion() -> None:
    run = run_of("lwr4_bench", 0)
    q = run.q + 2e-6 * np.random.default_rng(0).normal(size=run.q.shape)
    np.testing.assert_allclose(white_noise_std(run.t, q), 2e-6, rtol=0.05)


@pytest.mark.parametrize("jitter_s", [2e-4, 1e-3])
def test_instants_that_jitter_are_found_by_noise_that_goes_with_the_speed(jitter_s: float) -> None:
    rng, run = np.random.default_rng(0), run_of("lwr4_bench", 0)
    late = run.t + jitter_s * rng.normal(size=len(run.t))
    q = np.column_stack([np.interp(late, run.t, joint) for joint in run.q.T]) + 2e-6 * rng.normal(size=run.q.shape)
    found, white = find_jitter(run.t, q)
    assert found == pytest.approx(jitter_s, rel=0.15)
    assert white.max() < 1e-5


@pytest.mark.parametrize("slowness", [[5.0, 3.0, 2.0], [1.0, 1.0, 9.0], [0.1, 0.2, 50.0]])
@pytest.mark.parametrize("seen", [[3.0, 2.0, 1.0], [1.0, 2.0, 3.0], [1.0, 1.0, 8.0]])
def test_the_level_beside_what_falls_with_the_speed_is_never_negative(slowness: list[float], seen: list[float]) -> None:
    columns = np.column_stack((np.ones(3), slowness)) / np.array(seen)[:, None]
    (expected, _), _ = nnls(columns, np.ones(3))
    assert find_level(columns) == pytest.approx(expected, abs=1e-12)


def test_noise_steps_of_the_encoders_and_lost_rows_are_no_jitter() -> None:
    rng, run = np.random.default_rng(0), run_of("lwr4_bench", 0)
    q = run.q + 2e-6 * rng.normal(size=run.q.shape)
    kept = rng.random(len(q)) > 0.2
    assert find_jitter(run.t, q)[0] == 0.0
    assert find_jitter(run.t, np.round(run.q / 1e-4) * 1e-4)[0] == 0.0
    assert find_jitter(run.t[kept], q[kept])[0] == 0.0
    np.testing.assert_allclose(find_jitter(run.t[kept], q[kept])[1], 2e-6, rtol=0.1)


def test_smoothed_motion_has_no_lag() -> None:
    run = run_of("lwr4_bench", 0)
    poses = poses_of(record(run, payload("cylinder"), np.random.default_rng(0)))
    assert poses is not None
    motion, speed = smooth_motion(poses, window_s=0.05)
    for found, truth in ((motion.omega, run.omega), (motion.alpha, run.alpha)):
        k = int(np.argmax((truth**2).sum(axis=0)))
        shifts = range(-12, 13)
        errors = [np.mean((np.roll(found[:, k], -s) - truth[:, k]) ** 2) for s in shifts]
        assert shifts[int(np.argmin(errors))] == 0
    assert np.sqrt(np.mean((motion.omega - run.omega) ** 2)) < 0.01
    assert speed[run.phase == "transfer"].max() > 0.1


@pytest.mark.parametrize("lost", [0.05, 0.2])
def test_rows_that_a_recorder_lost_make_no_smoothed_motion_rough(lost: float) -> None:
    run = run_of("lwr4_bench", 0)
    rng = np.random.default_rng(0)
    recording = record(run, payload("cylinder"), rng)
    kept = rng.random(len(run.t)) >= lost
    poses, fewer = poses_of(recording), poses_of(take_rows(recording, kept))
    assert poses is not None and fewer is not None
    (whole, _), (found, _) = smooth_motion(poses, window_s=0.05), smooth_motion(fewer, window_s=0.05)
    for all_rows, some in ((whole.alpha, found.alpha), (whole.a, found.a)):
        rough = np.sqrt(np.mean((some - all_rows[kept]) ** 2))
        assert rough < 0.05 * np.sqrt(np.mean(all_rows**2))


def test_orientations_and_positions_serve_instead_of_joints() -> None:
    run = run_of("lwr4_bench", 0)
    recording = record(run, payload("cylinder"), np.random.default_rng(0))
    joints = poses_of(recording)
    assert joints is not None
    logged = replace(recording, q=None, robot=None, orientation=joints.rotation, position=joints.position)
    poses = poses_of(logged)
    assert poses is not None
    np.testing.assert_array_equal(poses.g, joints.g)
    assert poses_of(replace(logged, orientation=None)) is None
