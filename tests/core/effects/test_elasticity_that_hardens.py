"""Springs that harden, against the equations of motion of point masses on them, written down elsewhere."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import least_squares

from core.array import Array
from core.effects.elasticity_that_hardens import ElasticityThatHardens
from core.effects.joint_elasticity import JointElasticity
from tests.core.effects.mechanical_truth import SIGMA, brisk_scene, change, rms, truth
from tests.core.effects.planted_mechanics import SOFT, SWING, swung

LOADED, WIND_UP = 1.5, 3e-3
EFFECT, THETA = ElasticityThatHardens(), np.array([*SOFT, 1.0, SWING, LOADED, WIND_UP])


@pytest.fixture(scope="module")
def planted() -> Array:
    """(N, 6), N and N m."""
    return np.asarray(swung(LOADED, WIND_UP) - truth().wrench())


def test_springs_that_harden_do_to_the_wrench_what_physics_does(planted: Array) -> None:
    run = brisk_scene()
    assert rms(planted) > 0.3, "nothing was planted"
    assert rms(change(EFFECT, THETA, run) - planted) < 0.15 * rms(planted)  # swings of 3 to 8 Hz in rows at 62.5 Hz
    assert rms(change(JointElasticity(), THETA[:-2], run) - planted) > 0.8 * rms(planted)


def test_a_fit_that_starts_beside_springs_that_do_not_harden_finds_from_where_on_they_do(planted: Array) -> None:
    run = brisk_scene()

    def fit(effect: JointElasticity, begun: Array) -> tuple[float, Array]:
        scale, lower, upper = (np.array([getattr(p, name) for p in effect.parameters(run)]) for name in ("scale", "lower", "upper"))

        def left(x: Array) -> Array:
            return np.asarray(((change(effect, x, run) - planted) / SIGMA).ravel())

        found = least_squares(left, np.clip(begun, lower, upper), bounds=(lower, upper), x_scale=scale)
        return 2.0 * float(found.cost), found.x

    left, plain = fit(JointElasticity(), np.array([*[4e-4] * len(SOFT), 1.0, 0.2]))
    begun = EFFECT.starts_beside(run, planted / SIGMA, plain)
    best, theta = min((fit(EFFECT, start) for start in begun), key=lambda each: each[0])
    assert best < 0.1 * left
    assert theta[-2:] == pytest.approx([LOADED, WIND_UP], rel=0.15)


def test_springs_that_do_not_harden_are_the_plain_ones_and_twins_keep_these() -> None:
    run = brisk_scene()
    same = np.array([*THETA[:-2], 0.0, WIND_UP])
    np.testing.assert_array_equal(EFFECT.wrench(run, run.nominal, same), JointElasticity().wrench(run, run.nominal, THETA[:-2]))
    assert EFFECT.explain_tie_to_run(run) is not None
    assert EFFECT.starts(run, run.nominal) == []
