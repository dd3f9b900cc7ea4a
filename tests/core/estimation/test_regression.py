"""Algorithms 1-5: recursion against batch against an independent least squares, and what they find."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.estimation.regression import RecursiveLeastSquares, RecursiveRegression, Thresholds, regress, regression
from core.estimation.segments import motionless, segments_of_phase
from core.payload.inertia import Motion
from tests.synthetic import GRAVITY, NOISE_STD, payload, run_of, wrench_of

THRESHOLDS = Thresholds((1e-3, 1e-3), fast=1.0, slow=0.2)
OFFSET = np.array([3.0, -2.0, 5.0, 0.1, -0.2, 0.3])


@given(st.integers(0, 2**32 - 1))
def test_the_recursion_gives_what_the_batch_gives(seed: int) -> None:
    rng = np.random.default_rng(seed)
    regr, truth = rng.normal(size=(40, 3, 3)), rng.normal(size=(3, 2))
    variance = rng.uniform(1e-6, 1e-4, 3)
    resp = regr @ truth + np.sqrt(variance)[:, None] * rng.normal(size=(40, 3, 2))
    recursive = RecursiveLeastSquares(3, 2, variance)
    for r, y in zip(regr, resp, strict=True):
        recursive.update(r, y)
    psi, covariance = regress(regr, resp, variance)
    np.testing.assert_allclose(recursive.psi, psi, rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(recursive.covariance, covariance, rtol=1e-5, atol=1e-14)
    stacked = (regr / np.sqrt(variance)[:, None]).reshape(-1, 3)
    independent = np.linalg.lstsq(stacked, (resp / np.sqrt(variance)[:, None]).reshape(-1, 2), rcond=None)[0]
    np.testing.assert_allclose(psi, independent, rtol=1e-6, atol=1e-9)


def test_on_line_and_batch_find_the_same_parameters_with_the_offset_given_afterwards() -> None:
    run, body = run_of("lwr4_bench", 0, repetitions=3), payload("steel_block")
    rows = slice(0, None, 5)
    R = run.rotation[rows]
    motion = Motion(GRAVITY @ R, np.einsum("nji,nj->ni", R, run.a[rows]), run.omega[rows], run.alpha[rows])
    raw = (wrench_of(run, body) + OFFSET)[rows]
    still = motionless(run.t, segments_of_phase(run.phase))[rows]
    speed = np.where(np.char.startswith(run.phase[rows], "transfer"), 0.1, 0.0)
    batch = regression(motion, speed, raw, still, thresholds=THRESHOLDS, variance=NOISE_STD**2)
    online = RecursiveRegression(THRESHOLDS, NOISE_STD**2)
    for k in range(len(raw)):
        v = np.zeros(3) if still[k] else np.array([max(speed[k], 0.005), 0.0, 0.0])
        online.update(motion.g[k], motion.omega[k], v, motion.alpha[k], raw[k])
    for found in (batch, online.found):
        phi, std = found.parameters(OFFSET, torque_std=NOISE_STD[3:], alpha_std=0.03)
        assert np.isnan(phi[[5, 6, 8]]).all()
        known = [0, 1, 2, 3]
        np.testing.assert_allclose(phi[known], body.phi[known], rtol=1e-3, atol=1e-5)
        np.testing.assert_allclose(phi[[4, 7, 9]], body.phi[[4, 7, 9]], rtol=0.02)
        assert (std[[0, 1, 2, 3, 4, 7, 9]] > 0).all()
    a, b = (f.parameters(OFFSET, torque_std=NOISE_STD[3:], alpha_std=0.03)[0] for f in (batch, online.found))
    np.testing.assert_allclose(a[[4, 7, 9]], b[[4, 7, 9]], rtol=1e-6)


def test_without_offsets_nothing_is_claimed() -> None:
    motion = Motion.still(np.array([[9.81, 0.0, 0.0]]))
    found = regression(motion, np.zeros(1), np.zeros((1, 6)), np.array([True]), thresholds=THRESHOLDS, variance=np.ones(6))
    phi, std = found.parameters(np.full(6, np.nan), torque_std=np.ones(3), alpha_std=0.1)
    assert np.isnan(phi).all()
    assert np.isnan(std).all()


@pytest.mark.parametrize(
    ("g", "v", "alpha", "axis"),
    [
        ([9.81, 0, 0], [0, 0, 0], [4.8, 0.1, 0.0], 0),
        ([0, 0, -9.81], [0, 0, 0], [0.1, 0.0, -4.8], 2),
        ([9.81, 0, 0], [0, 0, 0], [4.8, 0.3, 0.0], None),
        ([9.81, 0, 0], [0, 0, 0], [0.5, 0.0, 0.0], None),
        ([7.0, 7.0, 0], [0, 0, 0], [4.8, 0.0, 0.0], None),
        ([9.81, 0, 0], [0.1, 0, 0], [4.8, 0.0, 0.0], None),
    ],
)
def test_an_axis_counts_as_rotating_only_where_eq_4_holds(g: list, v: list, alpha: list, axis: int | None) -> None:
    assert THRESHOLDS.find_rotation_axis(np.array(g), np.array(v), np.array(alpha)) == axis
    motion = Motion(np.array([g]), np.zeros((1, 3)), np.zeros((1, 3)), np.array([alpha]))
    seen = [i for i in range(3) if THRESHOLDS.find_rotation_rows(motion, np.array([np.linalg.norm(v)]), i)[0]]
    assert seen == ([] if axis is None else [axis])
