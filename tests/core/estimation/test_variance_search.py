"""The sizes of the parts of the noise against a scan of the dense restricted likelihood, which shares no code with the search."""

from __future__ import annotations

import numpy as np
import pytest

from core.estimation.annihilating_filter import AnnihilatingFilter
from core.estimation.variance_search import Channel, Slope, VarianceSearch, slope_of
from core.estimation.window_covariance import WindowCovariance

K, TIME = 120, 5.0
WHITE = np.ones((1, K))
STEPS = np.arange(float(K))
FILTER = AnnihilatingFilter.of(STEPS, (TIME,))
WALK, DECAY = np.minimum.outer(STEPS, STEPS), np.exp(-np.abs(np.subtract.outer(STEPS, STEPS)) / TIME)
SMOOTH = np.column_stack((np.linspace(-1.0, 1.0, K), np.linspace(-1.0, 1.0, K) ** 2))
LEAST, MOST = np.array([1e-3, 1e-8, 1e-8, 1e-8]), np.full(4, 10.0)
NOTHING = np.zeros((K, 0))


def bands_of(dense: np.ndarray) -> np.ndarray:
    D = FILTER.apply(np.eye(K))
    passed = D @ dense @ D.T
    return np.array([np.pad(np.diag(passed, -d), (0, d)) for d in range(3)])


PARTS = [WindowCovariance(bands, NOTHING) for bands in (FILTER.covariance(WHITE), bands_of(DECAY), bands_of(WALK))]
PARTS.append(WindowCovariance(np.zeros((1, K)), FILTER.apply(SMOOTH)))


def made(rng: np.random.Generator, sizes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Three columns, the last one an offset, and what was measured (K,)."""
    X = np.column_stack((np.sin(0.3 * STEPS), rng.normal(size=K), np.ones(K)))
    noise = np.linalg.cholesky(covariance_of(sizes) + 1e-12 * np.eye(K)) @ rng.normal(size=K)
    return X, X @ [2.0, -1.0, 5.0] + noise


def covariance_of(sizes: np.ndarray) -> np.ndarray:
    return np.asarray(sizes[0] * np.eye(K) + sizes[1] * DECAY + sizes[2] * WALK + sizes[3] * SMOOTH @ SMOOTH.T)


def restricted_likelihood(sizes: np.ndarray, X: np.ndarray, y: np.ndarray) -> float:
    C = covariance_of(sizes)
    information = X.T @ np.linalg.solve(C, X)
    r = y - X @ np.linalg.solve(information, X.T @ np.linalg.solve(C, y))
    return float(-0.5 * (np.linalg.slogdet(C)[1] + np.linalg.slogdet(information)[1] + r @ np.linalg.solve(C, r)))


def slope_at(sizes: np.ndarray, X: np.ndarray, y: np.ndarray, parts: np.ndarray) -> Slope:
    bands = sum(size * np.pad(part.bands, ((0, 3 - len(part.bands)), (0, 0))) for size, part in zip(sizes, PARTS, strict=True))
    factor = WindowCovariance(np.asarray(bands), np.sqrt(sizes[3]) * PARTS[3].columns).factorise()
    w = factor.whiten(FILTER.apply(np.column_stack((X, y))))
    covariance = np.linalg.inv(w[:, :-1].T @ w[:, :-1])
    residual = w[:, -1] - w[:, :-1] @ (covariance @ w[:, :-1].T @ w[:, -1])
    return slope_of(sizes[parts], [PARTS[k] for k in parts], Channel(factor, w[:, :-1], np.arange(3), residual), np.asarray(covariance))


def searched(X: np.ndarray, y: np.ndarray, most: np.ndarray) -> np.ndarray:
    search = VarianceSearch(np.array([[0.5, 1e-3, 1e-3, 1e-1]]), np.where(most > LEAST, LEAST, most)[None], most[None])
    for _ in range(25):
        search.improve(0, slope_at(search.sizes[0], X, y, search.sought(0)))
    return np.asarray(search.sizes[0])


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("truth", [(0.25, 0, 0, 0), (0.25, 0, 0.1, 0), (0.25, 0.5, 0, 0), (0.05, 0.5, 0.02, 0), (0.25, 0, 0, 2.0)])
def test_no_place_near_and_none_of_many_others_is_more_likely_than_what_was_found(seed: int, truth: tuple[float, ...]) -> None:
    rng = np.random.default_rng(seed)
    X, y = made(rng, np.array(truth))
    found = searched(X, y, MOST)
    best = restricted_likelihood(found, X, y)
    near = found * np.exp(0.3 * rng.normal(size=(40, 4)))
    far = np.exp(rng.uniform(np.log(LEAST), np.log(MOST), size=(200, 4)))
    others = np.clip(np.vstack((near, far)), LEAST, MOST)
    assert best > max(restricted_likelihood(each, X, y) for each in others) - 2e-2


def test_what_the_bounds_leave_no_room_stays_where_it_is() -> None:
    X, y = made(np.random.default_rng(5), np.array([0.25, 0.0, 0.1, 0.0]))
    most = np.array([0.5, 1e-9, 10.0, 1e-9])
    search = VarianceSearch(np.array([[0.5, 1e-3, 1e-3, 1e-3]]), np.array([[0.5, 1e-9, 1e-8, 1e-9]]), most[None])
    assert search.sought(0).tolist() == [2]
    search.improve(0, slope_at(search.sizes[0], X, y, search.sought(0)))
    assert search.sizes[0, :2].tolist() == [0.5, 1e-9]


def test_a_slope_is_the_derivative_of_the_dense_likelihood() -> None:
    """`ratio` above 1 where more of a part is likelier, and 1 nowhere else than where the derivative is zero."""
    X, y = made(np.random.default_rng(6), np.array([0.25, 0.2, 0.02, 1.0]))
    for sizes in np.exp(np.random.default_rng(7).uniform(-4.0, 0.0, size=(6, 4))):
        slope = slope_at(sizes, X, y, np.arange(4))
        for k in range(4):
            ahead, behind = (restricted_likelihood(sizes * np.where(np.arange(4) == k, f, 1.0), X, y) for f in (1.01, 0.99))
            assert (slope.ratio[k] > 1.0) == (ahead > behind)


def test_a_step_is_bounded() -> None:
    search = VarianceSearch(np.full((3, 1), 1e-3), np.full((3, 1), 1e-8), np.full((3, 1), 0.05))
    for c, (ratio, share) in enumerate(((1e9, 1e-9), (1e-9, 0.5), (1.0, 0.5))):
        search.improve(c, Slope(np.array([ratio]), np.array([[share]])))
    np.testing.assert_allclose(search.sizes[:, 0], [5e-3, 1e-5, 1e-3])


def test_steps_that_lead_past_the_maximum_and_back_come_to_rest_at_it() -> None:
    search, maximum = VarianceSearch(np.full((1, 1), 1e-3), np.full((1, 1), 1e-12), np.full((1, 1), 10.0)), 1e-5
    for _ in range(25):
        off = np.log(search.sizes[0, 0] / maximum)
        search.improve(
            0, Slope(np.array([np.exp(-0.2 * off)]), np.array([[0.1]]))
        )  # each of Newton's steps is twice as long as it should be
    assert search.sizes[0, 0] == pytest.approx(maximum, rel=0.01)
