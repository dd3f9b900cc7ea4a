"""Which trial looks like a residual: a slide among slides, in noise, and behind what payload and offsets take up."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.array import Array
from core.effects.likeness import AXES, find_most_alike
from core.effects.loose_between_stops import LooseBetweenStops
from core.payload.inertia import regressor
from tests.core.effects.synthetic_scene import NOISE, scene

RUN, EFFECT = replace(scene(seconds=40.0, seed=7), noise=NOISE), LooseBetweenStops()
TRIALS = [np.array([*(0.005 * axis), 1.0, friction]) for axis in AXES for friction in (0.0, 3.0)]
STILL = np.zeros(5)


def residual(theta: Array, beside: Array | float = 0.0) -> Array:
    """(N, 6), in standard deviations of the noise."""
    change = EFFECT.wrench(RUN, np.zeros((len(RUN), 6)), theta) + beside
    return np.asarray(change / NOISE + np.random.default_rng(1).normal(size=change.shape))


@pytest.mark.parametrize("k", [7, 8, 17])
def test_the_one_that_is_there_comes_first_however_large_it_is_and_whatever_payload_and_offsets_do(k: int) -> None:
    taken_up = regressor(RUN.motion) @ (0.2 * RUN.phi) + np.array([3.0, -1.0, 2.0, 0.1, 0.2, -0.1])
    planted = TRIALS[k] * np.array([0.4, 0.4, 0.4, 1.0, 1.0])
    first, *others = find_most_alike(EFFECT, RUN, residual(planted, taken_up), TRIALS, STILL, 3)
    np.testing.assert_array_equal(first, TRIALS[k])
    assert len(others) <= 2


def test_it_is_moved_to_where_it_looks_more_alike_but_never_what_stays() -> None:
    planted = np.array([0.004, -0.0025, 0.0005, 1.0, 4.0])
    (found,) = find_most_alike(EFFECT, RUN, residual(planted), TRIALS, np.array([0.002, 0.002, 0.002, 0.0, 1.0]), 1)
    assert found[:3] @ planted[:3] > 0.99 * np.linalg.norm(found[:3]) * np.linalg.norm(planted[:3])
    assert found[4] == pytest.approx(4.0, abs=0.6)
    assert found[3] == 1.0


def test_what_only_makes_it_worse_is_none() -> None:
    opposite = -residual(TRIALS[0])
    assert find_most_alike(EFFECT, RUN, opposite, TRIALS[:1], STILL, 1) == []
