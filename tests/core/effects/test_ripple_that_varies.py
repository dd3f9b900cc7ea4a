"""A ripple with an overtone that is stronger on one side, against the wrench of point masses on joints that go so."""

from __future__ import annotations

import numpy as np

from core.effects.gear_ripple import GearRipple
from core.effects.ripple_that_varies import RippleThatVaries
from tests.core.effects.mechanical_truth import SIGMA, Array, believed, change, rms, scene, truth, without_nuisance

EFFECT = RippleThatVaries()
RATIO = 12.5
SINE, OVERTONE, TURN = (4e-4, -3e-4), (1e-4, 8e-5), (0.5, -0.4)
THETA = np.concatenate((np.tile([RATIO, *SINE], 7), np.tile([*OVERTONE, *TURN], 7)))


def rippled(t: Array) -> Array:
    """(N, 7), true joints."""
    q = believed(t)
    x = 2.0 * RATIO * q
    wave = SINE[0] * np.cos(x) + SINE[1] * np.sin(x) + OVERTONE[0] * np.cos(2.0 * x) + OVERTONE[1] * np.sin(2.0 * x)
    return q + (1.0 + TURN[0] * np.cos(q) + TURN[1] * np.sin(q)) * wave


def test_it_does_to_the_wrench_what_such_gears_do() -> None:
    true = truth(rippled, h=2e-4).wrench() - truth(h=2e-4).wrench()
    assert rms(true) > 0.3, "nothing was planted"
    assert rms(change(EFFECT, THETA) - true) < 0.13 * rms(true)  # what its speed adds to velocities is left out
    assert rms(change(GearRipple(), THETA[:21]) - true) > 0.3 * rms(true)


def test_without_overtone_and_change_it_is_the_plain_ripple() -> None:
    np.testing.assert_allclose(change(EFFECT, np.concatenate((THETA[:21], np.zeros(28)))), change(GearRipple(), THETA[:21]), atol=1e-12)


def test_it_starts_from_the_plain_one_where_something_of_its_kind_is_left_and_else_not_at_all() -> None:
    run, noise = scene(), np.random.default_rng(3).normal(size=scene().nominal.shape)
    left = without_nuisance(((change(EFFECT, THETA) - change(GearRipple(), THETA[:21])) / SIGMA + 0.1 * noise).ravel()).reshape(-1, 6)
    assert EFFECT.starts(run, left) == []
    (start,) = EFFECT.starts_beside(run, left, THETA[:21])
    np.testing.assert_array_equal(start, np.concatenate((THETA[:21], np.zeros(28))))
    assert EFFECT.starts_beside(run, noise, THETA[:21]) == []


def test_the_advice_is_that_of_the_plain_one() -> None:
    assert EFFECT.advice(scene(), THETA).text == GearRipple().advice(scene(), THETA[:21]).text
