"""`core.gap.clustered` against the scatter of many fits whose errors are known."""

from __future__ import annotations

import numpy as np
import pytest

from core.array import Array
from core.gap.clustered import enlarge_covariance

T = np.arange(0.0, 60.0, 0.05)
COUNT = 6 * len(T)
MOTION = (T // 4.0).astype(np.int64)


def _columns() -> Array:
    """A constant, and something that changes from second to second."""
    rng = np.random.default_rng(1)
    wandering = np.repeat(rng.standard_normal((6, 60)), 20, axis=1).ravel()
    return np.column_stack((np.ones(COUNT), wandering))


def _errors(rng: np.random.Generator, misfit: float) -> Array:
    """Noise, and on it what goes on for a second in all channels alike."""
    repeated = np.repeat(rng.standard_normal((6, 60)), 20, axis=1).ravel()
    return np.asarray(rng.standard_normal(COUNT) + misfit * repeated)


@pytest.mark.parametrize("misfit", [1.0, 3.0])
def test_stated_uncertainties_are_the_scatter_of_the_estimates_where_the_misfit_repeats_itself(misfit: float) -> None:
    rng = np.random.default_rng(2)
    Z = _columns()
    covariance = np.linalg.inv(Z.T @ Z)
    found, stated = [], []
    for _ in range(300):
        e = _errors(rng, misfit)
        theta = covariance @ Z.T @ e
        found.append(theta)
        stated.append(np.sqrt(np.diag(enlarge_covariance(covariance, Z, e - Z @ theta, T, MOTION))))
    scatter = np.std(found, axis=0)
    np.testing.assert_allclose(np.mean(stated, axis=0), scatter, rtol=0.12)
    assert (scatter > 2.0 * np.sqrt(np.diag(covariance))).all()


def test_what_goes_on_for_a_motion_counts_once_for_each() -> None:
    rng = np.random.default_rng(5)
    Z = _columns()
    covariance = np.linalg.inv(Z.T @ Z)
    found, stated = [], []
    for _ in range(300):
        e = rng.standard_normal(COUNT) + np.repeat(rng.standard_normal((6, 15)), 80, axis=1).ravel()
        found.append(covariance @ Z.T @ e)
        stated.append(np.sqrt(np.diag(enlarge_covariance(covariance, Z, e - Z @ found[-1], T, MOTION))))
    np.testing.assert_allclose(np.mean(stated, axis=0)[0], np.std(found, axis=0)[0], rtol=0.15)


def test_white_noise_changes_little_and_never_makes_an_uncertainty_smaller() -> None:
    rng = np.random.default_rng(3)
    Z = _columns()
    covariance = np.linalg.inv(Z.T @ Z)
    raised = [np.sqrt(np.diag(enlarge_covariance(covariance, Z, _errors(rng, 0.0), T, MOTION)) / np.diag(covariance)) for _ in range(100)]
    assert np.min(raised) >= 1.0
    assert np.mean(raised) < 1.15


def test_correlations_stay() -> None:
    rng = np.random.default_rng(4)
    Z = _columns() @ np.array([[1.0, 0.4], [0.0, 1.0]])
    covariance = np.linalg.inv(Z.T @ Z)
    large = enlarge_covariance(covariance, Z, _errors(rng, 3.0), T, MOTION)
    std, before = np.sqrt(np.diag(large)), np.sqrt(np.diag(covariance))
    np.testing.assert_allclose(large / np.outer(std, std), covariance / np.outer(before, before), rtol=1e-12)


def test_a_recording_of_one_second_has_no_scatter_to_learn_from() -> None:
    Z = np.ones((6 * 10, 1))
    covariance = np.array([[1.0 / 60.0]])
    np.testing.assert_array_equal(
        enlarge_covariance(covariance, Z, np.full(60, 9.0), np.linspace(0.0, 0.9, 10), np.zeros(10, dtype=np.int64)), covariance
    )
