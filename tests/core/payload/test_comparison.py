"""Two runs differ when chance would not make such a difference; scipy and repetition are the judges."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import chi2, kstest

from core.payload.comparison import SIGNIFICANT, Comparison, chance_of, chi_square_tail, compare_payloads
from core.payload.uncertain_parameters import UncertainParameters
from tests.core.export.cloud import cloud, covariance

OFFSET = np.zeros(6), np.full(6, 0.1)


@given(st.floats(0.0, 200.0), st.integers(1, 12))
def test_the_tail_of_the_chi_square_distribution_is_scipys(x: float, freedom: int):
    assert chi_square_tail(x, freedom) == pytest.approx(chi2.sf(x, freedom), rel=1e-9, abs=1e-15)


def repeated(seed: int, change: float = 0.0) -> Comparison:
    """Two identifications of one body with the noise that they state; the second body is heavier by `change`, kg."""
    rng = np.random.default_rng(seed)
    truth, S = cloud(0).parameters(covariance(0)).phi, covariance(0)
    first, second = (rng.multivariate_normal(truth, S) for _ in range(2))
    second[0] += change
    return compare_payloads(UncertainParameters(first, S), UncertainParameters(second, S), OFFSET, OFFSET)


def test_runs_with_one_payload_differ_as_often_as_is_said():
    chances = [repeated(seed).chance for seed in range(400)]
    assert kstest(chances, "uniform").pvalue > 0.001
    assert np.mean([chance < SIGNIFICANT for chance in chances]) < 0.03


def test_another_mass_is_found_and_named():
    found = repeated(1, change=0.1)
    assert found.differ
    assert "in m by 0.1" in found.verdict.text
    assert "am deutlichsten in m um 0,1" in found.verdict.say("de")
    mass = found.parameters[0]
    assert mass.value == pytest.approx(0.1, abs=5 * mass.std)
    assert mass.std == pytest.approx(np.sqrt(2 * covariance(0)[0, 0]))
    assert mass.times_std == pytest.approx(mass.value / mass.std)
    assert not repeated(1).differ
    assert repeated(1).verdict.code == "payload-runs-agree"


def test_what_one_run_does_not_determine_is_left_out():
    known = cloud(0).parameters(covariance(0))
    phi, S = known.phi.copy(), known.covariance.copy()
    phi[4:], S[4:, :], S[:, 4:] = np.nan, np.nan, np.nan
    found = compare_payloads(known, UncertainParameters(phi, S), OFFSET, OFFSET)
    assert [each.name for each in found.parameters] == ["m", "mc_x", "mc_y", "mc_z"]
    assert found.inertia_com == []
    assert found.chance == pytest.approx(1.0)
    nothing = UncertainParameters(np.full(10, np.nan), np.full((10, 10), np.nan))
    alone = compare_payloads(known, nothing, OFFSET, OFFSET)
    assert (alone.chance, alone.differ) == (None, False)
    assert alone.verdict.code == "payload-runs-nothing-in-common"


def test_a_drift_of_the_offset_is_told_with_its_uncertainty():
    known = cloud(0).parameters(covariance(0))
    later = np.array([0.5, 0, 0, 0, 0, 0]), np.full(6, 0.1)
    drift = compare_payloads(known, known, OFFSET, later).offset[0]
    assert (drift.name, drift.value, drift.unit) == ("fx", 0.5, "N")
    assert drift.times_std == pytest.approx(0.5 / np.hypot(0.1, 0.1))


def test_correlated_parameters_are_judged_together():
    S = np.array([[1.0, 0.99], [0.99, 1.0]])
    along, across = chance_of(np.array([1.0, 1.0]), S), chance_of(np.array([1.0, -1.0]), S)
    assert along > 0.5
    assert across < 1e-6
