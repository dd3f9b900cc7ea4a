"""`core.gap.payload_after` against draws of the mixture, and on evidence whose fits are made up."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from core.effects.library import library
from core.gap.attribution import Attribution
from core.gap.effect_fit import EffectFit
from core.gap.evidence import Evidence
from core.gap.payload_after import average, describe_payload_after
from core.gap.weighing import read_figures

BY_ID = {effect.id: effect for effect in library()}
NONE = np.zeros(0)
WIDENED = read_figures().widened
PHI = np.array([2.0, 0.0, 0.0, 0.2, 0.03, 0.0, 0.0, 0.03, 0.0, 0.004])


def fit(name: str, mass: float, std: float, left_sigma2: float = 0.0) -> EffectFit:
    """One effect, or none, with a mass, a standard uncertainty of each parameter, and what it leaves over per row beyond the noise."""
    beta = np.concatenate(([mass], PHI[1:]))
    spread, flat = std**2 * np.eye(10), np.zeros((6, 2000))
    return EffectFit((BY_ID[name],) if name else (), (), NONE, beta, spread, spread, flat, 0.0, 0.0, flat + 1.0 + left_sigma2, flat)


def found(none: float, *explained: tuple[EffectFit, float], material: bool = True) -> Evidence:
    """Evidence with these explanations, the most probable first; the rest is unknown."""
    nominal = fit("", 2.5, 0.01, 100.0)
    unknown = 1.0 - none - sum(p for _, p in explained)
    attribution = Attribution(none, unknown, explained, (), 0.0)
    evidence = Evidence(None, nominal, tuple(each for each, _ in explained), (), attribution, ())  # type: ignore[arg-type]  # none are read
    evidence.__dict__["mattering"] = float(material)
    return evidence


@pytest.mark.parametrize("seed", range(4))
def test_the_interval_is_the_shortest_that_holds_19_of_20_draws(seed: int) -> None:
    rng = np.random.default_rng(seed)
    share, phi, std = rng.dirichlet(np.ones(5)), rng.normal(size=(5, 1)), 10.0 ** rng.uniform(-2.0, 0.0, (5, 1))
    (middle,), (found_std,) = average(share, phi, std, np.zeros(5), np.zeros(1), 1.0)
    kind = rng.choice(5, 400_000, p=share)
    drawn = np.sort(rng.normal(phi[kind, 0], std[kind, 0]))
    held = int(0.95 * len(drawn))
    inside = np.abs(drawn - middle) <= 1.96 * found_std
    assert inside.mean() == pytest.approx(0.95, abs=0.003)
    assert 2.0 * 1.96 * found_std == pytest.approx((drawn[held:] - drawn[:-held]).min(), rel=0.01)


def test_one_explanation_alone_is_taken_as_it_is() -> None:
    after = describe_payload_after(found(0.0, (fit("base_tilt", 2.0, 0.01), 0.9)))
    np.testing.assert_allclose(after.std, WIDENED * 0.01, rtol=0.002)
    np.testing.assert_allclose(after.phi, PHI, atol=2e-4)


def test_intervals_are_widened_only_where_the_gap_matters_as_it_did_in_the_trials_that_tell_by_how_much() -> None:
    minor = describe_payload_after(found(0.0, (fit("base_tilt", 2.0, 0.01), 0.9), material=False))
    np.testing.assert_allclose(minor.std, 0.01, rtol=0.002)
    assert WIDENED > 1.0


def test_an_improbable_rival_far_away_widens_the_interval_a_little_and_not_by_its_distance() -> None:
    after = describe_payload_after(found(0.0, (fit("base_tilt", 2.0, 0.01), 0.97), (fit("time_delay", 3.0, 0.01), 0.03)))
    assert after.phi[0] == pytest.approx(2.0, abs=1e-3)
    assert 1.05 < after.std[0] / (WIDENED * 0.01) < 1.25


def test_what_two_probable_explanations_disagree_about_is_left_open() -> None:
    after = describe_payload_after(found(0.0, (fit("base_tilt", 2.0, 0.01), 0.5), (fit("time_delay", 2.1, 0.01), 0.4)))
    low, high = after.phi[0] + np.array([-1.96, 1.96]) * after.std[0]
    assert low < 2.0
    assert high > 2.1


def test_what_is_left_of_the_gap_counts_as_it_moved_the_payload_before() -> None:
    """From 2.5 to 2.0 kg; 1 % of the gap's square is left, a tenth of the gap."""
    left = 100.0 * 0.01
    after = describe_payload_after(found(0.0, (fit("base_tilt", 2.0, 0.01, left), 0.9)))
    assert after.std[0] == pytest.approx(WIDENED * np.hypot(0.01, 0.1 * 0.5), rel=0.03)
    assert after.std[1] == pytest.approx(WIDENED * 0.01, rel=0.01)  # which no effect moved


def test_where_no_effect_is_probable_the_payload_stays_that_of_the_nominal_twin() -> None:
    after = describe_payload_after(found(0.7, (fit("base_tilt", 2.0, 0.01), 0.2)))
    assert (after.phi[0], after.std[0]) == (2.5, 0.01)


def test_what_is_uncertain_through_disagreement_is_not_called_determined() -> None:
    def told(mass: float) -> NDArray[np.bool_]:
        return np.array(
            describe_payload_after(found(0.0, (fit("base_tilt", 2.0, 1e-4), 0.5), (fit("time_delay", mass, 1e-4), 0.5))).determined
        )

    assert told(2.01)[0]
    assert not told(4.0).any()  # without a mass nothing is
