"""Fits effects, singly or together, with the payload and the offsets estimated anew each time.

The `Problem` is minimised by Levenberg-Marquardt. The evidence is Laplace's; the held-out gap leaves whole motions out.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import accumulate
from operator import itemgetter

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.estimation.quadratic import find_bounded_minimum, inverse, solve_scaled
from core.gap.clustered import enlarge_covariance
from core.gap.problem import Problem
from core.gap.spared_noise import take_off_noise
from core.gap.weighing import find_beyond_chance
from core.gap.windows import PHI, Windows

ITERATIONS = 24
CONVERGED = 0.02
"""Fall of the cost below which the fit has ended, in units of chi-square,"""
CONVERGED_SHARE = 3e-4
"""or as a share of what it leaves over beyond chance, where the model is not exact."""


KEPT = 0.5
"""Share of the fall that a linearised problem promises which has to come true, or what it promises does not count."""


@dataclass(frozen=True)
class EffectFit:
    """Effects fitted to a recording.

    Args:
        effects: in the order in which they act; none for the nominal twin.
        theta: parameters of all of them; `parameters` says which is which.
        beta: payload, offsets, small imperfections.
        covariance: of beta and theta together, as far as noise goes.
        uncertainty: the same with what the model gets wrong.
        residual: (6, K), whitened.
        cost: chi-square plus the priors.
        log_evidence: Laplace's.
        held_out: (6, K), chi-square of each row predicted from the other motions, its own prediction's uncertainty counted, and what
            the effects spare themselves by smoothing noise given back.
        change: (6, K), what the effects add, whitened.
        following: how many parameters those are worth that merely follow the course of a run (`count_following`).
        kept_absent: how many of the parameters were kept absent: a smaller shape of the effect.
    """

    effects: tuple[Effect, ...]
    parameters: tuple[Parameter, ...]
    theta: Array
    beta: Array
    covariance: Array
    uncertainty: Array
    residual: Array
    cost: float
    log_evidence: float
    held_out: Array
    change: Array
    following: float = 0.0
    kept_absent: int = 0

    @property
    def free(self) -> int:
        """How many parameters were fitted; those that merely follow the course of a run count as far as their priors leave them free."""
        return len(self.theta) - self.kept_absent - sum(not p.shown for p in self.parameters) + round(self.following)

    @property
    def further(self) -> int:
        """Effects beyond the first."""
        return max(0, len(self.effects) - 1)

    @property
    def rows(self) -> int:
        """How many equations were predicted."""
        return self.held_out.size

    @property
    def chi_square(self) -> float:
        """Of all rows, each predicted from the other motions."""
        return float(self.held_out.sum())

    @property
    def name(self) -> str:
        """Identifiers joined by a plus sign."""
        return "+".join(effect.id for effect in self.effects) or "none"

    def judged_by(self, kept: NDArray[np.bool_]) -> EffectFit:
        """The same fit, of which only the rows kept (K,) are predicted."""
        return replace(self, held_out=self.held_out[:, kept])

    @property
    def phi(self) -> Array:
        """(10,)."""
        return self.beta[PHI]

    @property
    def phi_std(self) -> Array:
        """(10,)."""
        return np.sqrt(np.diag(self.uncertainty)[PHI])

    @property
    def theta_std(self) -> Array:
        """Standard uncertainty of theta."""
        return np.sqrt(np.diag(self.uncertainty)[len(self.beta) :])


def fit_nominal(windows: Windows) -> EffectFit:
    """The nominal twin with its small imperfections."""
    problem = Problem(windows, ())
    beta = find_bounded_minimum(problem.XX + np.diag(problem.precision), problem.X.T @ problem.target, problem.bounds)
    if problem.held:  # they depend on the payload
        _, beta, _ = descend(problem, beta, np.zeros(0), iterations=ITERATIONS)
    return _finish(problem, beta, np.zeros(0))


def fit_effects(windows: Windows, effects: tuple[Effect, ...], start: EffectFit, thetas: list[Array], smaller: bool = False) -> EffectFit:
    """The best fit from several starting values of theta, payload and offsets starting from another fit.

    Args:
        smaller: whether each effect is fitted in its smaller shape.
    """
    problem = Problem(windows, effects, smaller=smaller)
    thetas = [np.where(problem.fitted, theta, problem.absent) for theta in thetas]
    begun = [descend(problem, start.beta, theta, iterations=2) for theta in thetas]
    promising = sorted(begun, key=itemgetter(0))[: max((effect.followed for effect in effects), default=1)]
    _, beta, theta = min((descend(problem, beta, theta, iterations=ITERATIONS) for _, beta, theta in promising), key=itemgetter(0))
    return replace(_finish(problem, beta, theta), kept_absent=int((~problem.fitted).sum()))


def descend(problem: Problem, beta: Array, theta: Array, *, iterations: int) -> tuple[float, Array, Array]:
    """Least cost (Levenberg-Marquardt) within the bounds, with the beta and theta at which it is; from the nearest point within them."""
    beta, theta = np.split(np.clip(np.concatenate((beta, theta)), *problem.bounds), [len(beta)])
    cost, damping = problem.cost(beta, theta), 1e-6
    for _ in range(iterations):
        new_beta, new_theta = problem.step(beta, theta, damping)
        # where the load is absurd, derivatives overflow: no step then
        new_cost = problem.cost(new_beta, new_theta) if np.isfinite(new_theta).all() and np.isfinite(new_beta).all() else np.inf
        if new_cost < cost:
            fell, cost, beta, theta, damping = cost - new_cost, new_cost, new_beta, new_theta, damping * 0.1
            if fell < max(CONVERGED, CONVERGED_SHARE * (cost - len(problem.target))):
                break
        elif damping > 1e3:
            break
        else:
            damping = max(damping * 30.0, 1e-3)
    return cost, beta, theta


def _finish(problem: Problem, beta: Array, theta: Array) -> EffectFit:
    rows, J = np.zeros(len(problem.target)), np.zeros((len(problem.target), 0))
    if problem.effects or problem.held:
        rows, J = problem.linearise(theta, beta[PHI])
    r = problem.target - problem.X @ beta - rows
    X = problem.columns(theta, beta[PHI])
    normal = problem.normal(X, J)
    columns = np.column_stack((X, J))
    cost = problem.cost(beta, theta)
    log_evidence = -0.5 * cost - 0.5 * float(np.linalg.slogdet(normal)[1] - np.log(problem.precision).sum())
    here = np.concatenate((beta, theta))
    free = (here > problem.bounds[0]) & (here < problem.bounds[1])
    rest, owed = go_rest_of_way(problem, here, free, columns, r, cost)
    held_out = predict_held_out(problem.windows, columns[:, free], rest, problem.precision[free]) + owed / rest.size
    held_out = take_off_noise(held_out, problem, theta, beta)
    covariance = inverse(normal)
    hidden = [len(beta) + k for k, p in enumerate(problem.parameters) if not p.shown]
    shape = problem.windows.target.shape
    return EffectFit(
        problem.effects,
        problem.parameters,
        theta,
        beta,
        covariance,
        enlarge_covariance(covariance, columns, r, problem.windows.centres, problem.windows.group),
        r.reshape(shape),
        cost,
        log_evidence,
        held_out,
        rows.reshape(shape),
        count_following(problem.precision[hidden], np.diag(covariance)[hidden], held_out),
    )


def count_following(precision: Array, variance: Array, held_out: Array) -> float:
    """How many parameters n are worth, each as far as the recording and not its prior says what it is.

    MacKay, Bayesian Interpolation, 1992. What a fit leaves beyond chance is its own error, and all of it worth one draw, as explanations
    are weighed (`core.gap.weighing`): so much less says the recording.

    Args:
        precision: (n,), of the priors. variance: (n,), as far as noise goes. held_out: chi-square of each row.
    """
    told = np.maximum(0.0, 1.0 / (precision * variance) - 1.0)
    doubt = 1.0 + float(find_beyond_chance(held_out.sum(), np.asarray(held_out.size)) * held_out.size)
    return float((told / (told + doubt)).sum())


def go_rest_of_way(problem: Problem, here: Array, free: NDArray[np.bool_], columns: Array, r: Array, cost: float) -> tuple[Array, float]:
    """(6K,), the residual at the optimum of the problem as it is linearised at `here`, where r and the cost are; and how much of the fall
    of the cost that the linear problem promises on the way there is owed, where less than half of it comes true (a cost with steps, whose
    derivatives say little)."""
    count, Z, precision = problem.X.shape[1], columns[:, free], problem.precision[free]
    gradient = Z.T @ r - (problem.precision * np.concatenate((here[:count], here[count:] - problem.absent)))[free]
    step = solve_scaled(Z.T @ Z + np.diag(precision), gradient)
    promised, owed = float(gradient @ step), 0.0
    if promised > CONVERGED:
        there = here.copy()
        there[free] = np.clip(here[free] + step, problem.bounds[0][free], problem.bounds[1][free])
        fell = max(0.0, cost - problem.cost(there[:count], there[count:]))
        owed = promised - fell if fell < KEPT * promised else 0.0
    return np.asarray(r - Z @ step), owed


def predict_held_out(windows: Windows, columns: Array, r: Array, precision: Array) -> Array:
    """(6, K), chi-square of each row when its whole motion is left out.

    With e the prediction error of a motion from all others and S its covariance (noise and what is left open by the others),
    `e^T S^-1 e = r^T e` where `e = r + Z (N - Z^T Z)^-1 Z^T r` (block form of the leave-one-out identity).

    Args:
        r: at the optimum of the linearised problem.
        precision: of the priors.
    """
    group = np.tile(windows.group, 6)
    motions = [group == g for g in np.unique(group)]
    seen = [columns[rows].T @ columns[rows] for rows in motions]
    prior = np.diag(precision)
    result = np.empty_like(r)
    # summed from both ends: where one motion alone shows a parameter, the difference N - Z^T Z is nothing but rounding
    before, behind = accumulate(seen, initial=prior), [*accumulate(seen[:0:-1], initial=np.zeros_like(prior))][::-1]
    for rows, first, then in zip(motions, before, behind, strict=False):
        result[rows] = r[rows] * (r[rows] + columns[rows] @ solve_scaled(first + then, columns[rows].T @ r[rows]))
    return result.reshape(windows.target.shape)
