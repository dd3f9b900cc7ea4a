"""Segments from labels and from the motion."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.ndimage import uniform_filter1d

from core.estimation.kinematics import poses_of, smooth_motion
from core.estimation.segments import (
    Segment,
    cut_at_gaps,
    motionless,
    segments_of_motion,
    segments_of_phase,
    smooth_by_average,
    stretches,
)
from tests.synthetic import payload, record, run_of


def test_runs_of_equal_labels_are_segments() -> None:
    parts = segments_of_phase(np.array(["hold:x-", "hold:x-", "transfer", "hold:x+", "rotate:x", "rotate:x"]))
    assert [(p.start, p.stop, p.phase) for p in parts] == [
        (0, 2, "hold:x-"),
        (2, 3, "transfer"),
        (3, 4, "hold:x+"),
        (4, 6, "rotate:x"),
    ]
    assert [p.axis for p in parts] == ["x", None, "x", "x"]
    assert [p.sign for p in parts] == [-1, 0, 1, 0]
    assert Segment(0, 1, "hold:free").axis is None


def test_without_labels_the_motion_tells_holds_and_rotations() -> None:
    run = run_of("lwr4_bench", 0)
    poses = poses_of(record(run, payload("cylinder"), np.random.default_rng(0)))
    assert poses is not None
    motion, speed = smooth_motion(poses, window_s=0.05)
    found = segments_of_motion(run.t, motion.omega, speed, motion.g, threshold=np.array([0.01, 0.005]))
    labels = np.concatenate([np.full(p.stop - p.start, p.phase, dtype="<U10") for p in found])
    assert len(labels) == len(run.t)
    assert (labels == run.phase).mean() > 0.95
    assert {p.phase for p in found} >= {"hold:x+", "hold:x-", "hold:z+", "rotate:x", "rotate:y", "rotate:z", "transfer"}


def test_the_first_and_last_moments_of_a_hold_do_not_count_as_motionless() -> None:
    t = 1e-3 * np.arange(3000)
    parts = (Segment(0, 1000, "transfer"), Segment(1000, 3000, "hold:x+"))
    still = motionless(t, parts)
    assert not still[:1140].any()
    assert still[1160:2930].all()
    assert not still[2945:].any()


def test_a_gap_in_time_parts_a_recording_and_its_motions_but_a_lost_sample_does_not():
    t = np.concatenate((0.001 * np.arange(100), 0.003 + 0.001 * np.arange(100, 200), 60.0 + 0.001 * np.arange(50)))
    assert stretches(t) == (slice(0, 200), slice(200, 250))
    whole = segments_of_phase(np.array(["hold:x+"] * 150 + ["transfer"] * 100))
    assert cut_at_gaps(whole, t) == (Segment(0, 150, "hold:x+"), Segment(150, 200, "transfer"), Segment(200, 250, "transfer"))


@pytest.mark.parametrize("samples", [0, 1, 2, 7, 30, 600])
def test_a_moving_average_is_scipys(samples: int) -> None:
    x = np.random.default_rng(0).normal(5.0, 1.0, (400, 3))
    np.testing.assert_allclose(smooth_by_average(x, samples), uniform_filter1d(x, max(1, samples), axis=0, mode="nearest"), atol=1e-11)
