"""Quadratic minima, scaled so that parameters of very different units do not spoil the arithmetic."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from core.array import Array

Bools = NDArray[np.bool_]

EXCHANGES = 12
"""Of what is held at its bounds, before it is taken to go round in circles."""
LEAST_EIGENVALUE = 1e-15
"""Of the scaled matrix, relative to the largest; what is smaller is rounding."""


class Linearised(Protocol):
    """A sum of squares at some x (n,): half its second derivatives (n, n), and half its slope downhill (n,)."""

    @property
    def cost(self) -> float: ...
    @property
    def normal(self) -> Array: ...
    @property
    def right(self) -> Array: ...


class Quadratic(NamedTuple):
    """The same in numbers."""

    cost: float
    normal: Array
    right: Array


Look = TypeVar("Look", bound=Linearised)


def descend(look: Callable[[Array, Look | None], Look], x: Array, bounds: Array, *, steps: int, settled: float) -> tuple[Array, Look]:
    """The x (n,) within bounds (2, n) at which a sum of squares is least (Gauss-Newton; a step that goes too far is halved), and the look
    there.

    Args:
        look: at some x; it is given the best look so far.
        steps: looks, at most. settled: share of the cost by which it still falls where the search is done.
    """
    best = look(x, None)
    step = find_bounded_minimum(best.normal, best.right, bounds - x)
    for _ in range(steps - 1):
        at = look(np.clip(x + step, *bounds), best)
        if at.cost >= best.cost:
            step = 0.5 * step
            continue
        fell, x, best = best.cost - at.cost, np.clip(x + step, *bounds), at
        if fell < settled * at.cost:
            break
        step = find_bounded_minimum(best.normal, best.right, bounds - x)
    return x, best


def find_bounded_minimum(normal: Array, right: Array, bounds: Array) -> Array:
    """The x (n,) within bounds (2, n) that minimises x' normal x / 2 - right' x; what is held at a bound is exactly there.

    Args:
        normal: (n, n), symmetric positive definite.

    Where bounds bind, all that are on the wrong side change it at once (Portugal, Judice and Vicente 1994); there is one minimum, so
    what meets the conditions of Kuhn and Tucker is it. Where that goes round in circles, by the active sets of Stark and Parker 1995
    (`scipy.optimize.lsq_linear`).
    """
    scale = 1.0 / np.sqrt(np.maximum(np.diag(normal), 1e-300))
    A, b, (low, high) = normal * np.outer(scale, scale), right * scale, bounds / scale
    below, above = np.zeros(len(b), dtype=bool), np.zeros(len(b), dtype=bool)
    for _ in range(EXCHANGES):
        free = ~(below | above)
        x = np.where(below, low, np.where(above, high, 0.0))
        x[free] = np.linalg.solve(A[np.ix_(free, free)], b[free] - A[np.ix_(free, ~free)] @ x[~free])
        slope = A @ x - b
        new_below, new_above = (free & (x < low)) | (below & (slope >= 0.0)), (free & (x > high)) | (above & (slope <= 0.0))
        if np.array_equal(new_below, below) and np.array_equal(new_above, above):
            return _put_on_bounds(x * scale, below, above, bounds)
        below, above = new_below, new_above
    return _search_active_sets(A, b, bounds, scale)


def _search_active_sets(A: Array, b: Array, bounds: Array, scale: Array) -> Array:
    from scipy.optimize import lsq_linear  # noqa: PLC0415 - hardly ever asked, and slow to load

    values, vectors = np.linalg.eigh(A)
    root = np.sqrt(np.maximum(values, LEAST_EIGENVALUE * values[-1]))
    found = lsq_linear(
        root[:, None] * vectors.T,
        (vectors.T @ b) / root,
        (bounds[0] / scale, bounds[1] / scale),
        method="bvls",
        tol=1e-14,
        max_iter=100 * len(b),
    )
    return _put_on_bounds(found.x * scale, found.active_mask < 0, found.active_mask > 0, bounds)


def _put_on_bounds(x: Array, below: Bools, above: Bools, bounds: Array) -> Array:
    """(n,), what is held at a bound exactly there: scaling rounds to either side."""
    return np.select([below, above], list(bounds), np.clip(x, *bounds))


def solve_scaled(matrix: Array, right: Array) -> Array:
    """Solution (n,) or (n, k) of a symmetric positive definite system."""
    scale = 1.0 / np.sqrt(np.maximum(np.diag(matrix), 1e-300))
    A, b = matrix * np.outer(scale, scale), (right.T * scale).T
    try:
        x = np.linalg.solve(A, b)
    except np.linalg.LinAlgError:  # singular by rounding: the shortest of all solutions
        x = np.linalg.lstsq(A, b, rcond=LEAST_EIGENVALUE)[0]
    return np.asarray((x.T * scale).T)


def inverse(matrix: Array) -> Array:
    """Inverse of a symmetric positive definite matrix."""
    scale = 1.0 / np.sqrt(np.diag(matrix))
    A = matrix * np.outer(scale, scale)
    try:
        inverted = np.linalg.inv(A)
    except np.linalg.LinAlgError:  # what rounding has lost is hardly known
        values, vectors = np.linalg.eigh(A)
        inverted = (vectors / np.maximum(values, LEAST_EIGENVALUE * values[-1])) @ vectors.T
    return np.asarray(inverted * np.outer(scale, scale))
