"""A motion that was stopped in the middle goes on from where the robot stands, along the same path, slowly at first."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline
from scipy.spatial import cKDTree

from core.control.resuming import BRAKING_S, LEAST_RAMP_S, OFF_PATH, resume_path
from core.errors import BadState

PERIOD = 0.001


def smooth_path(seed: int, seconds: float = 3.0) -> np.ndarray:
    """(K, 3) from standstill to standstill through some places."""
    rng = np.random.default_rng(seed)
    at = np.linspace(0.0, seconds, 6)
    path = CubicSpline(at, rng.uniform(-0.6, 0.6, (6, 3)), bc_type="clamped")
    return path(np.arange(0.0, seconds + PERIOD / 2, PERIOD))


def braked(path: np.ndarray, k: int, acceleration: float = 15.0) -> np.ndarray:
    """Where drives come to rest that brake along the tangent; where the path bends too much for that, there is no such case."""
    speed = (path[k] - path[k - 1]) / PERIOD
    fastest = np.abs(speed).max()
    q = path[k] + speed * fastest / (2 * acceleration)
    ahead = path[k : k + round(BRAKING_S / PERIOD)]
    assume(np.abs(ahead - q).max(axis=1).min() <= OFF_PATH)
    return q


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 10_000), st.floats(0.02, 0.98))
def test_the_rest_begins_where_the_robot_stands_keeps_to_the_path_and_ends_where_the_path_ends(seed, share):
    path = smooth_path(seed)
    k = max(1, round(share * (len(path) - 1)))
    q = braked(path, k)
    rest = resume_path(path, k, q, PERIOD)
    np.testing.assert_array_equal(rest[0], q)
    np.testing.assert_allclose(rest[-1], path[-1], atol=1e-12)
    away, _ = cKDTree(path).query(rest)
    first_away, _ = cKDTree(path).query(q)
    spacing = np.linalg.norm(np.diff(path, axis=0), axis=1).max()
    assert away.max() <= max(first_away, spacing) + 1e-6


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 10_000), st.floats(0.02, 0.98))
def test_nothing_is_faster_than_on_the_path_itself_and_the_command_starts_from_standstill_without_a_jump(seed, share):
    path = smooth_path(seed)
    k = max(1, round(share * (len(path) - 1)))
    rest = resume_path(path, k, braked(path, k), PERIOD)
    speed, planned = np.abs(np.diff(rest, axis=0)) / PERIOD, np.abs(np.diff(path, axis=0)) / PERIOD
    assert (speed.max(axis=0) <= planned.max(axis=0) * 1.001 + 0.021).all()
    assert speed[0].max() < 1e-3
    acceleration = np.abs(np.diff(rest, n=2, axis=0)) / PERIOD**2
    own = np.abs(np.diff(path, n=2, axis=0)).max(axis=0) / PERIOD**2
    assert (acceleration.max(axis=0) <= 1.5 * own + 2.0).all()


def test_the_speed_of_the_path_is_reached_again_smoothly():
    path = np.outer(np.linspace(0.0, 1.0, 4001), [1.0])
    rest = resume_path(path, 1000, path[1000], PERIOD)
    speed = np.diff(rest[:, 0]) / PERIOD
    assert (np.diff(speed) >= -1e-9).all()
    assert speed[-1] == pytest.approx(0.25)
    assert len(rest) - (4001 - 1000) >= 0.5 * LEAST_RAMP_S / PERIOD - 5


def test_a_robot_that_somebody_has_moved_meanwhile_is_not_driven_back():
    path = smooth_path(1)
    with pytest.raises(BadState, match="somebody has moved it"):
        resume_path(path, 1000, path[1000] + 2 * OFF_PATH, PERIOD)


def test_what_is_stopped_at_its_very_end_only_goes_there():
    path = smooth_path(2)
    q = path[-1] + 1e-4
    rest = resume_path(path, len(path) - 1, q, PERIOD)
    np.testing.assert_allclose(rest[-1], path[-1], atol=1e-12)
    assert np.abs(rest - path[-1]).max() <= 1e-4 + 1e-12
