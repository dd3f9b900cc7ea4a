"""`core.estimation.still_poses` against the truth that made the readings, and against least squares at once."""

from __future__ import annotations

import numpy as np
import pytest

from core.array import Array
from core.estimation.still_poses import StillPoses

NOISE_STD = np.array([0.06, 0.06, 0.09, 0.003, 0.003, 0.003])
MASS, FIRST_MOMENT, OFFSET = 2.5, np.array([0.02, -0.05, 0.11]), np.array([3.0, -2.0, 5.0, 0.1, 0.2, -0.3])
G = 9.80665 * np.array([[1, 0, 0], [0, 1, 0], [0.6, 0, 0.8], [0, -0.6, 0.8]])


def _reading(g: Array) -> Array:
    """What a sensor under a payload reads, by Newton: it holds the weight up at the centre of mass."""
    return np.concatenate((-MASS * g, -np.cross(FIRST_MOMENT, g))) + OFFSET


def _after(poses: int, rng: np.random.Generator, samples: int = 200) -> StillPoses:
    still = StillPoses(NOISE_STD)
    for g in G[:poses]:
        for _ in range(samples):
            still.add(g, _reading(g) + NOISE_STD * rng.standard_normal(6))
    return still


def test_one_pose_tells_nothing_but_that_nothing_is_known() -> None:
    values, std = _after(1, np.random.default_rng(0)).found
    assert np.isnan(values[:4]).all()
    assert np.isnan(std[:4]).all()


def test_two_poses_give_the_mass_and_three_the_first_moment() -> None:
    two, _ = _after(2, np.random.default_rng(1)).found
    assert two[0] == pytest.approx(MASS, abs=0.01)
    three, _ = _after(3, np.random.default_rng(1)).found
    np.testing.assert_allclose(three, np.concatenate(([MASS], FIRST_MOMENT, OFFSET)), atol=0.02)


def test_stated_uncertainties_are_the_scatter_of_the_estimates() -> None:
    rng = np.random.default_rng(2)
    found = [_after(4, rng, samples=20).found for _ in range(300)]
    scatter = np.std([values for values, _ in found], axis=0)
    np.testing.assert_allclose(scatter, found[0][1], rtol=0.2)
