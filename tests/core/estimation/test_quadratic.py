"""The minimum within bounds is the minimum, whatever binds: against every active set, and against SciPy's interior-point method."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import least_squares, lsq_linear

from core.array import Array
from core.estimation.quadratic import Quadratic, descend, find_bounded_minimum, inverse, solve_scaled


def problem(seed: int, n: int) -> tuple[Array, Array, Array]:
    """Columns of very different sizes that are far from orthogonal, and bounds of which most bind."""
    rng = np.random.default_rng(seed)
    A = rng.normal(size=(3 * n, n)) @ (np.eye(n) + 0.9 * rng.normal(size=(n, n))) * 10.0 ** rng.uniform(-4, 4, n)
    b = rng.normal(size=3 * n)
    best = np.linalg.lstsq(A, b, rcond=None)[0]
    width = np.abs(best) * rng.uniform(0.01, 1.0, n)
    middle = best * rng.uniform(-0.5, 1.2, n)
    return A, b, np.array([middle - width, middle + width])


def cost(A: Array, b: Array, x: Array) -> float:
    return float(((A @ x - b) ** 2).sum())


def least_of_all_active_sets(A: Array, b: Array, bounds: Array) -> float:
    """Brute force: each parameter free, at its lower or at its upper bound."""
    least = np.inf
    for held in product((None, 0, 1), repeat=A.shape[1]):
        free = np.array([side is None for side in held])
        x = np.array([0.0 if side is None else bounds[side, k] for k, side in enumerate(held)])
        if free.any():
            x[free] = np.linalg.lstsq(A[:, free], b - A[:, ~free] @ x[~free], rcond=None)[0]
        if (x >= bounds[0] - 1e-12 * np.abs(bounds[0])).all() and (x <= bounds[1] + 1e-12 * np.abs(bounds[1])).all():
            least = min(least, cost(A, b, x))
    return least


@settings(max_examples=60, deadline=None)
@given(seed=st.integers(0, 2**31), n=st.integers(1, 5))
def test_the_minimum_is_that_of_the_best_active_set(seed: int, n: int) -> None:
    A, b, bounds = problem(seed, n)
    x = find_bounded_minimum(A.T @ A, A.T @ b, bounds)
    assert (x >= bounds[0]).all()
    assert (x <= bounds[1]).all()
    assert cost(A, b, x) <= least_of_all_active_sets(A, b, bounds) * (1.0 + 1e-6)


@pytest.mark.parametrize("seed", range(40))
def test_the_minimum_of_many_parameters_is_as_low_as_that_of_an_interior_point_method(seed: int) -> None:
    A, b, bounds = problem(seed, 20)
    sizes = np.linalg.norm(A, axis=0)
    other = lsq_linear(A / sizes, b, bounds * sizes, method="trf", tol=1e-14, max_iter=1000).x / sizes
    x = find_bounded_minimum(A.T @ A, A.T @ b, bounds)
    assert cost(A, b, x) <= cost(A, b, np.clip(other, *bounds)) * (1.0 + 1e-6)


def test_where_no_bound_binds_it_is_the_solution_of_the_normal_equations() -> None:
    A, b, _ = problem(3, 6)
    x = find_bounded_minimum(A.T @ A, A.T @ b, np.array([np.full(6, -1e9), np.full(6, 1e9)]))
    np.testing.assert_allclose(A.T @ A @ x, A.T @ b, rtol=1e-6, atol=1e-9 * np.abs(A.T @ b).max())


@settings(max_examples=60, deadline=None)
@given(seed=st.integers(0, 2**31), n=st.integers(1, 5))
def test_what_a_bound_holds_is_exactly_there_and_what_lies_between_bounds_is_free(seed: int, n: int) -> None:
    """Not a rounding off: who asks what is free compares."""
    A, b, bounds = problem(seed, n)
    x = find_bounded_minimum(A.T @ A, A.T @ b, bounds)
    slope = (A.T @ (A @ x - b)) / np.linalg.norm(A, axis=0)
    between = (x > bounds[0]) & (x < bounds[1])
    assert np.abs(slope[between]).max(initial=0.0) < 1e-6 * np.linalg.norm(b)


def test_a_bent_valley_is_descended_to_where_a_search_by_trust_regions_ends() -> None:
    def residual(x: np.ndarray) -> np.ndarray:
        return np.array([10.0 * (x[1] - x[0] ** 2), 1.0 - x[0]])

    def look(x: np.ndarray, best: Quadratic | None) -> Quadratic:
        assert best is None or best.cost >= 0.0
        r, J = residual(x), np.array([[-20.0 * x[0], 10.0], [-1.0, 0.0]])
        return Quadratic(float(r @ r), J.T @ J, -J.T @ r)

    bounds = np.array([[-2.0, -1.0], [0.6, 2.0]])  # the least of all is at (1, 1)
    found, best = descend(look, np.array([-1.2, 1.0]), bounds, steps=200, settled=1e-12)
    expected = least_squares(residual, [-1.2, 1.0], bounds=tuple(bounds), xtol=1e-14, ftol=1e-14, gtol=1e-14)
    np.testing.assert_allclose(found, expected.x, atol=1e-6)
    assert best.cost == pytest.approx(2.0 * expected.cost, rel=1e-6)


def test_what_rounding_has_made_singular_is_solved_and_hardly_known() -> None:
    matrix, right = 1e6 * np.ones((2, 2)), 2e6 * np.ones(2)
    with pytest.raises(np.linalg.LinAlgError):
        np.linalg.solve(matrix, right)
    np.testing.assert_allclose(matrix @ solve_scaled(matrix, right), right, rtol=1e-6)
    assert (np.diag(inverse(matrix)) > 1e3).all(), "either of the two alone is not known"
