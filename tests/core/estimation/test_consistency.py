"""The nearest payload that can exist."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from core.estimation.consistency import nearest_consistent
from core.payload.inertia import is_consistent
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
