"""A hose whose lifted part weighs, against its potential energy."""

from __future__ import annotations

import numpy as np
import pytest

from core.effects.cable_drag import CableDrag
from core.effects.cable_that_lies import LIFTED, START_N_PER_M, CableThatLies
from tests.core.effects.synthetic_scene import scene

RUN = scene()
EFFECT = CableThatLies()
LAMBDA = 4.0


def lying(pull: float = 0.0) -> np.ndarray:
    theta = np.zeros(len(EFFECT.parameters(RUN)))
    theta[3], theta[LIFTED] = pull, LAMBDA
    return theta


def test_its_force_is_the_slope_of_the_energy_of_what_is_lifted() -> None:
    assert RUN.position is not None
    height = RUN.position[:, 2] - RUN.position[0, 2]
    energy = 0.5 * LAMBDA * height**2
    force = -np.einsum("nij,nj->ni", RUN.rotation, EFFECT.wrench(RUN, np.zeros_like(RUN.nominal), lying())[:, :3])
    gained = -np.einsum("ni,ni->n", 0.5 * (force[1:] + force[:-1]), np.diff(RUN.position, axis=0))
    np.testing.assert_allclose(np.cumsum(gained), energy[1:], atol=1e-3 * max(energy.max(), 1e-6))
    np.testing.assert_allclose(force[:, :2], 0.0, atol=1e-12)


def test_without_weight_it_is_the_plain_cable_without_guides() -> None:
    theta = np.array([0.5 * p.scale for p in EFFECT.parameters(RUN)])
    theta[LIFTED] = 0.0
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, theta), CableDrag().wrench(RUN, RUN.nominal, theta), atol=1e-12)


def test_it_starts_lifted_without_a_spring_and_is_as_stiff_as_it_weighs() -> None:
    (start,) = EFFECT.starts(RUN, np.zeros((len(RUN), 6)))
    assert (start[0], start[LIFTED]) == (0.0, START_N_PER_M)
    assert EFFECT.advice(RUN, lying(2.0)).parameters["stiffness_n_per_m"] == pytest.approx(LAMBDA)
