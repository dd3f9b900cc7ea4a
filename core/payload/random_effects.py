"""Several identifications of one payload as one: what they agree on, and how much they scatter beyond what each says of itself.

    phi_i = mu + b_i + D_i s + e_i,      b_i ~ N(0, T),   s ~ N(0, 1),   e_i ~ N(0, A_i)

A_i is what run i knows of its own scatter; D_i s is what several runs have in common (gains of the sensor, zeros of the joints), which no
number of runs averages away; b_i is what nobody has stated. T has one variance for the mass, one for the first moment and one for the
inertia, estimated by restricted maximum likelihood (Harville 1977, J. Am. Stat. Assoc. 72; DerSimonian and Laird's moments where it
starts). With few runs T is hardly known: intervals are Student's, and widened where the runs scatter more than that (Knapp and Hartung
2003, Stat. Med. 22).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from core.array import Array
from core.payload.uncertain_parameters import UncertainParameters

GROUPS = (slice(0, 1), slice(1, 4), slice(4, 10))
"""Mass, first moment, inertia."""
ITERATIONS = 60
SETTLED = 1e-6


@dataclass(frozen=True)
class Measured:
    """One identification.

    Args:
        own: parameters with the covariance that nothing else shares.
        shared: name of each cause that other runs may have in common -> (10, n), change of the parameters per standard deviation of each of
            its n independent parts, in one order. Causes of one name are one cause.
    """

    own: UncertainParameters
    shared: Mapping[str, Array] = field(default_factory=dict)


@dataclass(frozen=True)
class Pooled:
    """What several identifications say together.

    Args:
        parameters: mean with its covariance; NaN where no run determines it.
        common_std: (10,), the part of the mean's standard uncertainty that the runs have in common.
        between_std: (10,), of b; `widening`: factor on the standard uncertainties of the mean that their scatter asks for, included.
        freedom: degrees of freedom of the intervals, runs less one.
        excess: chi-square of the runs' differences were T zero; `excess_freedom`: its degrees of freedom.
        weights: (R, 10), share of each run in each parameter of the mean; `prior_weight`: (10,), that of the prior.
    """

    parameters: UncertainParameters
    common_std: Array
    between_std: Array
    widening: float
    freedom: int
    excess: float
    excess_freedom: int
    weights: Array
    prior_weight: Array


def pool(runs: Sequence[Measured], prior: UncertainParameters | None = None) -> Pooled:
    """Pools runs of one payload in one frame.

    Args:
        runs: one at least.
        prior: what was known before; entries with NaN say nothing.
    """
    problem = _Problem(runs)
    variances = problem.find_variances()
    V = problem.covariance(variances)
    excess = problem.scatter(problem.covariance(np.zeros(len(GROUPS))))
    information, right = problem.X.T @ np.linalg.solve(V, problem.X), problem.X.T @ np.linalg.solve(V, problem.y)
    widening = max(1.0, problem.scatter(V) / problem.freedom) if problem.freedom else 1.0
    known = problem.seen
    of_prior, of_prior_right = _prior_information(prior, known)
    total = information / widening + of_prior
    covariance = np.linalg.inv(total)
    mean = covariance @ (right / widening + of_prior_right)
    gain = covariance @ problem.X.T @ np.linalg.inv(V) / widening
    weights = np.zeros((len(runs), 10))
    for k, (run, parameter) in enumerate(problem.places):
        row = int(np.searchsorted(known, parameter))
        weights[run, parameter] = gain[row, k]
    common = np.zeros(10)
    common[known] = np.sqrt(np.diag(gain @ problem.common @ gain.T))
    phi, spread = np.full(10, np.nan), np.full((10, 10), np.nan)
    phi[known] = mean
    spread[np.ix_(known, known)] = covariance
    prior_weight = np.zeros(10)
    prior_weight[known] = np.diag(covariance @ of_prior)
    between = np.concatenate([np.full(len(range(*g.indices(10))), np.sqrt(v)) for g, v in zip(GROUPS, variances, strict=True)])
    return Pooled(
        parameters=UncertainParameters(phi, spread),
        common_std=common,
        between_std=between,
        widening=float(np.sqrt(widening)),
        freedom=len(runs) - 1,
        excess=excess,
        excess_freedom=problem.freedom,
        weights=weights,
        prior_weight=prior_weight,
    )


def find_excess(runs: Sequence[Measured]) -> tuple[float, int]:
    """Chi-square of what scatters about the mean beyond what the runs state, and its degrees of freedom."""
    problem = _Problem(runs)
    return problem.scatter(problem.covariance(np.zeros(len(GROUPS)))), problem.freedom


def _prior_information(prior: UncertainParameters | None, known: Array) -> tuple[Array, Array]:
    n = len(known)
    if prior is None:
        return np.zeros((n, n)), np.zeros(n)
    stated = np.flatnonzero(np.isfinite(prior.phi[known]) & np.isfinite(prior.std[known]))
    rows = known[stated]
    information = np.zeros((n, n))
    information[np.ix_(stated, stated)] = np.linalg.inv(prior.covariance[np.ix_(rows, rows)])
    return information, information @ np.where(np.isfinite(prior.phi[known]), prior.phi[known], 0.0)


def difference_covariance(first: Measured, second: Measured) -> Array:
    """(10, 10), of the difference of two runs: what they have in common moves both, and only the rest of it parts them."""
    covariance = first.own.covariance + second.own.covariance
    for name in sorted({*first.shared, *second.shared}):
        size = max(run.shared[name].shape[1] for run in (first, second) if name in run.shared)
        apart = _widen(second.shared.get(name), size) - _widen(first.shared.get(name), size)
        covariance = covariance + apart @ apart.T
    return np.asarray(covariance)


def _widen(directions: Array | None, columns: int) -> Array:
    known = np.zeros((10, 0)) if directions is None else directions
    return np.concatenate((known, np.zeros((10, columns - known.shape[1]))), axis=1)


class _Problem:
    """All numbers of all runs in a column, scaled by group so that kilograms and kg m2 meet as equals."""

    def __init__(self, runs: Sequence[Measured]) -> None:
        self.places = [(i, k) for i, run in enumerate(runs) for k in range(10) if np.isfinite(run.own.phi[k])]
        self.y = np.array([runs[i].own.phi[k] for i, k in self.places])
        self.seen = np.unique([k for _, k in self.places]).astype(int)
        self.X = np.array([[float(k == known) for known in self.seen] for _, k in self.places])
        n = len(self.y)
        self.fixed, self.common = np.zeros((n, n)), np.zeros((n, n))
        run_of = np.array([i for i, _ in self.places])
        for i, run in enumerate(runs):
            rows = np.flatnonzero(run_of == i)
            columns = [self.places[row][1] for row in rows]
            self.fixed[np.ix_(rows, rows)] = run.own.covariance[np.ix_(columns, columns)]
        for cause in sorted({name for run in runs for name in run.shared}):
            D = _column_of(cause, runs, self.places)
            self.common += D @ D.T
        self.fixed += self.common
        parameter = np.array([k for _, k in self.places])
        self.components = [np.diag(((parameter >= g.start) & (parameter < g.stop)).astype(float)) for g in GROUPS]

    @property
    def freedom(self) -> int:
        """Numbers less parameters."""
        return len(self.y) - len(self.seen)

    def covariance(self, variances: Array) -> Array:
        """Of all numbers."""
        return np.asarray(self.fixed + sum(v * K for v, K in zip(variances, self.components, strict=True)))

    def scatter(self, V: Array) -> float:
        """Chi-square of what the mean leaves."""
        return float(self.y @ self._projection(V) @ self.y)

    def find_variances(self) -> Array:
        """(3,), by Fisher's scoring of the restricted likelihood, never below zero."""
        variances = self._moments()
        if not variances.any() or not self.freedom:
            return np.zeros(len(GROUPS))
        for _ in range(ITERATIONS):
            P = self._projection(self.covariance(variances))
            parts = [P @ K for K in self.components]
            score = np.array([self.y @ part @ P @ self.y - np.trace(part) for part in parts])
            information = np.array([[np.sum(a * b.T) for b in parts] for a in parts])
            scale = 1.0 / np.sqrt(np.maximum(np.diag(information), 1e-300))
            step = np.linalg.lstsq(information * np.outer(scale, scale), score * scale, rcond=1e-9)[0] * scale
            after = np.maximum(variances + step, 0.2 * variances)
            settled = np.abs(after - variances) <= SETTLED * np.maximum(after, variances)
            variances = after
            if settled.all():
                break
        return variances

    def _moments(self) -> Array:
        """DerSimonian and Laird for each group by itself."""
        found = []
        for K in self.components:
            rows = np.flatnonzero(np.diag(K))
            X = self.X[rows]
            X = X[:, X.any(axis=0)]
            freedom = len(rows) - X.shape[1]
            if freedom < 1:
                found.append(0.0)
                continue
            P = _projection(self.fixed[np.ix_(rows, rows)], X)
            found.append(max(float(self.y[rows] @ P @ self.y[rows]) - freedom, 0.0) / float(np.trace(P)))
        return np.array(found)

    def _projection(self, V: Array) -> Array:
        return _projection(V, self.X)


def _column_of(cause: str, runs: Sequence[Measured], places: Sequence[tuple[int, int]]) -> Array:
    """(N, n), what one cause does to each number; runs that do not know it are not moved by it."""
    n = max(run.shared[cause].shape[1] for run in runs if cause in run.shared)
    rows = np.zeros((len(places), n))
    for row, (i, k) in enumerate(places):
        directions = runs[i].shared.get(cause)
        if directions is not None:
            rows[row, : directions.shape[1]] = directions[k]
    return rows


def _projection(V: Array, X: Array) -> Array:
    """P = V^-1 - V^-1 X (X^T V^-1 X)^-1 X^T V^-1, scaled on the way so that units do not matter."""
    scale = 1.0 / np.sqrt(np.diag(V))
    W = np.linalg.inv(V * np.outer(scale, scale)) * np.outer(scale, scale)
    WX = W @ X
    of_columns = 1.0 / np.sqrt(np.diag(X.T @ WX))
    inner = np.linalg.inv((X.T @ WX) * np.outer(of_columns, of_columns)) * np.outer(of_columns, of_columns)
    return np.asarray(W - WX @ inner @ WX.T)
