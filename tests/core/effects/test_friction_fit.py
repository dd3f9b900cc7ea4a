"""Coefficients of friction that are told: none gives energy."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import nnls

from core.effects.friction_fit import bound_friction


@pytest.mark.parametrize("friction", [(4.0, -0.5), (-0.2, 1.5), (2.0, 3.0), (-0.3, -0.4)])
def test_the_most_probable_coefficients_that_give_no_energy_are_told(friction: tuple[float, float]) -> None:
    covariance = np.array([[0.16, -0.06], [-0.06, 0.25]])
    value, std = bound_friction(np.array(friction), covariance)
    L = np.linalg.inv(np.linalg.cholesky(covariance))
    np.testing.assert_allclose(value, nnls(L, L @ friction)[0], atol=1e-12)
    assert (std > 0).all() and (std <= np.sqrt(np.diag(covariance)) + 1e-12).all()


def test_what_gives_energy_for_certain_is_not_determined() -> None:
    value, std = bound_friction(np.array([4.0, -2.0]), np.diag([0.16, 0.25]))
    assert np.isnan(value).all() and np.isnan(std).all()


def test_one_coefficient_alone_is_bounded_as_well() -> None:
    value, std = bound_friction(np.array([-0.1]), np.array([[0.04]]))
    np.testing.assert_allclose((value[0], std[0]), (0.0, 0.2))
