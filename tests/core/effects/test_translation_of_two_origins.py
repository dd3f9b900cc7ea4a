"""Torques about origins of their own, against torques that are moved to each of these points one by one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.effects.library import wider_shapes
from core.effects.sensor_translation import SensorTranslation
from core.effects.translation_of_two_origins import TranslationOfTwoOrigins
from core.payload.inertia import Motion
from tests.core.effects.mechanical_truth import SIGMA, Array, change, rms, scene, truth
from tests.core.effects.plain_fit import fitted
from tests.core.effects.planted_mechanics import SHIFT

EFFECT = TranslationOfTwoOrigins()
SPLIT_M = 0.004
THETA = np.array([*SHIFT, 0.0, 0.0, SPLIT_M])


def take_about(W: Array, point: list[float]) -> Array:
    """(N, 3), torques about a point, m."""
    return np.asarray(W[:, 3:] - np.cross(point, W[:, :3]))


def measured() -> Array:
    """(N, 6), with the torque about x taken above the origin, that about y as far below it."""
    W = truth(shift=SHIFT).wrench()
    above, below = take_about(W, [0.0, 0.0, SPLIT_M]), take_about(W, [0.0, 0.0, -SPLIT_M])
    return np.column_stack((W[:, :3], above[:, 0], below[:, 1], W[:, 5]))


def test_it_is_what_torques_about_points_of_their_own_are() -> None:
    true = measured() - truth().wrench()
    assert rms(change(EFFECT, THETA) - true) < 0.01 * rms(true)
    assert rms(change(SensorTranslation(), THETA[:3]) - true) > 0.3 * rms(true)


@pytest.mark.parametrize("axis", range(3))
def test_along_each_axis_two_torques_are_split(axis: int) -> None:
    W, theta = scene().nominal, np.zeros(6)
    theta[3 + axis] = SPLIT_M
    point = (SPLIT_M * np.eye(3)[axis]).tolist()
    ahead, behind = take_about(W, point), take_about(W, [-x for x in point])
    first, second = ((axis + 1) % 3, (axis + 2) % 3)
    expected = W.copy()
    expected[:, 3 + first], expected[:, 3 + second] = ahead[:, first], behind[:, second]
    np.testing.assert_allclose(change(EFFECT, theta), expected - W, atol=1e-12)


def test_a_plain_fit_finds_where_the_origins_are() -> None:
    noise = SIGMA * np.random.default_rng(3).normal(size=(len(scene()), 6))
    fit = fitted(EFFECT, measured() + noise, 1.0, scene())
    assert (np.abs(fit.theta - THETA) < 4.0 * fit.std + 2e-4).all()
    assert fit.std[-1] < 0.1 * SPLIT_M


def test_other_than_where_the_origin_is_a_split_shows_in_what_rests() -> None:
    still = replace(scene(), motion=Motion.still(scene().motion.g))
    assert SensorTranslation().explain_absence(still) is not None
    assert EFFECT.explain_absence(still) is None
    assert TranslationOfTwoOrigins in map(type, wider_shapes())


def test_the_advice_says_how_far_apart_the_origins_are() -> None:
    said = EFFECT.advice(scene(), THETA).text
    assert "8.0 mm apart along z" in said
