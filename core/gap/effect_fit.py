"""Fits effects, singly or together, with the payload and the offsets estimated anew each time.

Minimised is `|y - X beta - D(theta, phi)|^2` over the whitened rows plus the priors, by Levenberg-Marquardt: beta holds payload,
offsets and the small imperfections, theta the effects' parameters. The evidence is Laplace's; the held-out gap leaves whole
motions out.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.effects.effect import Effect, Parameter
from core.gap.windows import BACKGROUND, PHI, Windows

Array = NDArray[np.float64]

ITERATIONS = 12
PRIOR_WIDTH = 2.0
"""Standard deviation of the prior in plausible sizes."""
STEP = 1e-3
"""Of the finite differences, in plausible sizes."""
CONVERGED = 0.02
"""Fall of the cost below which the fit has ended, in units of chi-square."""
SMALL = 2.5
"""Small imperfections stay within this many of their standard deviations; beyond, they are effects and have to be named."""
ACTIVE_SET_PASSES = 6
STAGES = ("mounting", "kinematics", "actuation", "payload", "environment", "timing", "sensor")
"""From the robot to the reading: the order in which effects act on the wrench."""


@dataclass(frozen=True)
class EffectFit:
    """Effects fitted to a recording.

    Args:
        effects: in the order in which they act; none for the nominal twin.
        theta: parameters of all of them; `parameters` says which is which.
        beta: payload, offsets, small imperfections.
        covariance: of beta and theta together.
        residual: (6, K), whitened.
        cost: chi-square plus the priors.
        log_evidence: Laplace's.
        held_out: (6, K), chi-square of each row predicted from the other motions, its own prediction's uncertainty counted.
        change: (6, K), what the effects add, whitened.
    """

    effects: tuple[Effect, ...]
    parameters: tuple[Parameter, ...]
    theta: Array
    beta: Array
    covariance: Array
    residual: Array
    cost: float
    log_evidence: float
    held_out: Array
    change: Array

    @property
    def name(self) -> str:
        """Identifiers joined by a plus sign."""
        return "+".join(effect.id for effect in self.effects) or "none"

    @property
    def phi(self) -> Array:
        """(10,)."""
        return self.beta[PHI]

    @property
    def phi_std(self) -> Array:
        """(10,)."""
        return np.sqrt(np.diag(self.covariance)[PHI])

    @property
    def theta_std(self) -> Array:
        """Standard uncertainty of theta."""
        return np.sqrt(np.diag(self.covariance)[len(self.beta) :])


class _Problem:
    """Rows and derivatives for one set of effects."""

    def __init__(self, windows: Windows, effects: tuple[Effect, ...]) -> None:
        self.windows = windows
        self.effects = tuple(sorted(effects, key=lambda effect: STAGES.index(effect.stage)))
        scene = windows.basis.scene
        self.counts = [len(effect.parameters(scene)) for effect in self.effects]
        self.parameters = tuple(p for effect in self.effects for p in effect.parameters(scene))
        self.absent = np.array([p.absent for p in self.parameters])
        self.scale = np.array([p.scale for p in self.parameters])
        self.lower = np.array([p.lower for p in self.parameters])
        self.upper = np.array([p.upper for p in self.parameters])
        self.X = windows.X.reshape(-1, windows.X.shape[2])
        self.XX = self.X.T @ self.X
        self.target = windows.target.ravel()
        self.precision = np.concatenate((windows.prior_std, PRIOR_WIDTH * self.scale)) ** -2.0
        free = np.full(BACKGROUND.start, np.inf)
        small = SMALL * windows.prior_std[BACKGROUND]
        self.bounds = np.array([np.concatenate((-free, -small, self.lower)), np.concatenate((free, small, self.upper))])

    def change(self, theta: Array, phi: Array) -> Array:
        """(N, 6) on the scene's grid."""
        scene = self.windows.basis.scene.carrying(phi)
        nominal = w = scene.nominal
        start = 0
        for effect, count in zip(self.effects, self.counts, strict=True):
            w = effect.wrench(scene, w, theta[start : start + count])
            start += count
        return w - nominal

    def linearised(self, theta: Array, phi: Array) -> tuple[Array, Array]:
        """Rows of the change (6K,), and their derivatives by theta (6K, n)."""
        here = self.change(theta, phi)
        steps = np.where(theta + STEP * self.scale <= self.upper, 1.0, -1.0) * STEP * self.scale
        moved = [self.change(theta + np.eye(len(theta))[k] * steps[k], phi) - here for k in range(len(theta))]
        rows = self.windows.rows_of(np.stack([here, *moved], axis=2))
        flat = rows.reshape(-1, rows.shape[2])
        return flat[:, 0], flat[:, 1:] / steps

    def cost(self, beta: Array, theta: Array) -> float:
        """Chi-square plus priors."""
        rows = self.windows.rows_of(self.change(theta, beta[PHI])[..., None]).ravel() if len(theta) else 0.0
        r = self.target - self.X @ beta - rows
        away = np.concatenate((beta, theta - self.absent))
        return float(r @ r + away @ (self.precision * away))

    def normal(self, J: Array) -> Array:
        """Normal matrix of beta and theta, with priors."""
        XJ = self.X.T @ J
        return np.block([[self.XX, XJ], [XJ.T, J.T @ J]]) + np.diag(self.precision)

    def step(self, beta: Array, theta: Array, damping: float) -> tuple[Array, Array]:
        """One damped step."""
        rows, J = self.linearised(theta, beta[PHI])
        r = self.target - self.X @ beta - rows
        right = np.concatenate(
            (self.X.T @ r - self.precision[: len(beta)] * beta, J.T @ r - self.precision[len(beta) :] * (theta - self.absent))
        )
        normal = self.normal(J)
        normal[np.diag_indices_from(normal)] *= 1.0 + damping
        here = np.concatenate((beta, theta))
        found = here + _bounded(normal, right, self.bounds - here)
        return found[: len(beta)], np.clip(found[len(beta) :], self.lower, self.upper)


def fit_nominal(windows: Windows) -> EffectFit:
    """The nominal twin with its small imperfections."""
    problem = _Problem(windows, ())
    beta = _bounded(problem.XX + np.diag(problem.precision), problem.X.T @ problem.target, problem.bounds)
    return _finished(problem, beta, np.zeros(0))


def fit_effects(windows: Windows, effects: tuple[Effect, ...], start: EffectFit, thetas: list[Array]) -> EffectFit:
    """The best fit from several starting values of theta, payload and offsets starting from another fit."""
    problem = _Problem(windows, effects)
    candidates = [_descended(problem, start.beta, np.clip(theta, problem.lower, problem.upper), iterations=2) for theta in thetas]
    _, beta, theta = min(candidates, key=lambda found: found[0])
    _, beta, theta = _descended(problem, beta, theta, iterations=ITERATIONS)
    return _finished(problem, beta, theta)


def _descended(problem: _Problem, beta: Array, theta: Array, *, iterations: int) -> tuple[float, Array, Array]:
    cost, damping = problem.cost(beta, theta), 1e-6
    for _ in range(iterations):
        new_beta, new_theta = problem.step(beta, theta, damping)
        new_cost = problem.cost(new_beta, new_theta)
        if new_cost < cost:
            fell, cost, beta, theta, damping = cost - new_cost, new_cost, new_beta, new_theta, damping * 0.1
            if fell < CONVERGED:
                break
        elif damping > 1e3:
            break
        else:
            damping = max(damping * 30.0, 1e-3)
    return cost, beta, theta


def _finished(problem: _Problem, beta: Array, theta: Array) -> EffectFit:
    rows, J = problem.linearised(theta, beta[PHI]) if len(theta) else (np.zeros(len(problem.target)), np.zeros((len(problem.target), 0)))
    r = problem.target - problem.X @ beta - rows
    normal = problem.normal(J)
    columns = np.column_stack((problem.X, J))
    cost = problem.cost(beta, theta)
    log_evidence = -0.5 * cost - 0.5 * float(np.linalg.slogdet(normal)[1] - np.log(problem.precision).sum())
    away = np.concatenate((beta, theta - problem.absent))
    here = np.concatenate((beta, theta))
    free = (here > problem.bounds[0]) & (here < problem.bounds[1])
    held_out = _held_out(problem.windows, columns[:, free], r, normal[np.ix_(free, free)], (problem.precision * away)[free])
    shape = problem.windows.target.shape
    return EffectFit(
        problem.effects,
        problem.parameters,
        theta,
        beta,
        _inverse(normal),
        r.reshape(shape),
        cost,
        log_evidence,
        held_out,
        rows.reshape(shape),
    )


def _held_out(windows: Windows, columns: Array, r: Array, normal: Array, pull: Array) -> Array:
    """(6, K), chi-square of each row when its whole motion is left out.

    With e the prediction error of a motion from all others and S its covariance (noise and what is left open by the others),
    `e^T S^-1 e = r^T e` where `e = r + Z (N - Z^T Z)^-1 Z^T r` (block form of the leave-one-out identity). That holds at the optimum of
    the linearised problem, so the last bit of the way there is gone first.

    Args:
        pull: gradient of the priors at the fit.
    """
    r = r - columns @ _solve(normal, columns.T @ r - pull)
    group = np.tile(windows.group, 6)
    result = np.empty_like(r)
    for g in np.unique(group):
        rows = group == g
        Z = columns[rows]
        result[rows] = r[rows] * (r[rows] + Z @ _solve(normal - Z.T @ Z, Z.T @ r[rows]))
    return result.reshape(windows.target.shape)


def _bounded(normal: Array, right: Array, bounds: Array) -> Array:
    """Minimum of the quadratic within bounds (2, n): what leaves them is held there, and the rest solved again."""
    d = np.zeros(len(right))
    free = np.ones(len(right), dtype=bool)
    for _ in range(ACTIVE_SET_PASSES):
        d[free] = _solve(normal[np.ix_(free, free)], right[free] - normal[np.ix_(free, ~free)] @ d[~free])
        outside = free & ((d < bounds[0]) | (d > bounds[1]))
        if not outside.any():
            break
        d = np.clip(d, bounds[0], bounds[1])
        free &= ~outside
    return np.clip(d, bounds[0], bounds[1])


def _solve(matrix: Array, right: Array) -> Array:
    scale = 1.0 / np.sqrt(np.maximum(np.diag(matrix), 1e-300))
    return np.asarray(np.linalg.solve(matrix * np.outer(scale, scale), right * scale) * scale)


def _inverse(matrix: Array) -> Array:
    scale = 1.0 / np.sqrt(np.diag(matrix))
    return np.asarray(np.linalg.inv(matrix * np.outer(scale, scale)) * np.outer(scale, scale))
