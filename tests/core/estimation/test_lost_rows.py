"""Rows that were lost: filled in smoothly, with the noise of what they are made of, and with windows as narrow as motion allows."""

from __future__ import annotations

import numpy as np

from core.estimation.identification import identify_recording
from core.estimation.kinematics import Poses
from core.estimation.lost_rows import fill_lost_rows
from core.estimation.weak_form import WeakForm
from tests.foreign_bound import least_std
from tests.foreign_recordings import Condition, make

GRAVITY = np.array([0.0, 0.0, -9.81])


def lossy(share: float = 0.2, rows: int = 3000) -> np.ndarray:
    rng = np.random.default_rng(5)
    return np.arange(rows)[rng.random(rows) >= share] / 500.0


def test_lost_rows_are_those_of_the_cubic_and_measured_ones_stay() -> None:
    t = lossy()
    found = fill_lost_rows(t)
    assert found is not None
    np.testing.assert_array_equal(found.t[found.measured], t)
    near = np.diff(found.t) < 0.0021
    np.testing.assert_allclose(np.diff(found.t)[near], 0.002, rtol=1e-6)
    cubic = np.polynomial.Polynomial([0.3, -1.0, 2.0, 0.7])
    np.testing.assert_allclose(found.fill @ cubic(t), cubic(found.t), rtol=1e-9)


def test_long_gaps_stay_and_clocks_that_are_not_even_are_left_alone() -> None:
    t = np.concatenate((np.arange(100), np.arange(108, 200))) / 500.0
    assert fill_lost_rows(t) is None
    assert fill_lost_rows(np.cumsum(np.random.default_rng(0).uniform(0.001, 0.005, 500))) is None
    assert fill_lost_rows(np.arange(500) / 500.0) is None


def test_the_noise_of_windows_is_that_of_the_rows_they_are_made_of() -> None:
    t = lossy()
    n = len(t)
    form = WeakForm(Poses(t, np.tile(np.eye(3), (n, 1, 1)), np.zeros((n, 3)), GRAVITY, np.zeros((6, 6))))
    rng = np.random.default_rng(6)
    seen = np.column_stack([form.average(rng.normal(size=(n, 1)))[:, 0] for _ in range(400)])
    bands = form.gram[0]
    np.testing.assert_allclose((seen**2).mean(), bands[0].mean(), rtol=0.02)
    np.testing.assert_allclose((seen[1:] * seen[:-1]).mean(), bands[1, :-1].mean(), rtol=0.04)


def test_a_fifth_of_the_rows_lost_costs_little_more_than_their_number() -> None:
    condition = Condition(rate_hz=250.0, lost=0.2)
    made = make(condition, 0)
    estimate, least = identify_recording(made.recording).estimate, least_std(condition, made)
    assert estimate is not None and least is not None
    assert (np.abs(estimate.phi - made.phi) < 4.0 * estimate.std).all()
    assert (estimate.std < 1.5 * least).all()
