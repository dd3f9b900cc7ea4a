"""The nearest payload that can exist."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.estimation.consistency import NO_SUCH_BODY, distance_from_bodies, nearest_consistent
from core.payload.inertia import InertialParameters, is_consistent
from tests.synthetic import random_payload

STD = np.array([1e-3, 1e-4, 1e-4, 1e-4, *[3e-4] * 6])


@given(st.integers(0, 2**32 - 1), st.floats(0.1, 30.0))
@settings(max_examples=40)
def test_the_result_is_always_a_body(seed: int, factor: float) -> None:
    rng = np.random.default_rng(seed)
    body = random_payload(rng)
    phi = body.phi + factor * STD * rng.normal(size=10)
    found = nearest_consistent(phi, np.diag(STD**2))
    assert is_consistent(found)
    if is_consistent(phi):
        np.testing.assert_array_equal(found, phi)
    else:
        # the truth is a body too, so that the nearest one cannot be farther away (the edge itself is left out by a hair)
        distance, to_truth = (np.linalg.norm((x - phi) / STD) for x in (found, body.phi))
        assert distance <= to_truth * 1.001 + 0.01


def test_the_nearest_body_is_on_the_edge_of_a_broken_triangle_inequality() -> None:
    phi = np.array([1.0, 0, 0, 0, 1e-3, 0, 0, 1e-3, 0, 2.3e-3])
    found = nearest_consistent(phi, np.diag(STD**2))
    # the closest point of the plane Ixx + Iyy = Izz with equal weights
    np.testing.assert_allclose(found[[4, 7, 9]], [1.1e-3, 1.1e-3, 2.2e-3], atol=2e-5)
    np.testing.assert_allclose(found[[0, 1, 2, 3]], phi[[0, 1, 2, 3]], atol=2e-5)


@pytest.mark.parametrize(("size", "directions"), [((0.06, 0.06, 0.0), 1), ((0.1, 0.0, 0.0), 3)], ids=["plate", "rod"])
def test_a_body_at_the_edge_of_what_can_exist_is_called_impossible_once_in_a_hundred(size: tuple[float, ...], directions: int) -> None:
    """The edge has so many directions to leave it by: the squared distance is no larger than chi-square with as many degrees of freedom."""
    rng = np.random.default_rng(directions)
    std = 0.1 * STD
    squares = []
    for _ in range(50):
        points = rng.normal(size=(8, 3)) * size @ Rotation.random(random_state=rng).as_matrix() + [0.0, 0.02, 0.08]
        com = points.mean(axis=0)
        body = InertialParameters.from_com(2.0, com, 0.25 * sum(r @ r * np.eye(3) - np.outer(r, r) for r in points - com))
        phi = body.phi + std * rng.normal(size=10)
        found = nearest_consistent(phi, np.diag(std**2))
        squares.append(distance_from_bodies(phi, found, np.diag(std**2)))
        assert squares[-1] < ((phi - body.phi) ** 2 / std**2).sum() * 1.01 + 0.01
    assert (np.array(squares) > NO_SUCH_BODY).sum() <= 2
    assert np.mean(squares) < directions
