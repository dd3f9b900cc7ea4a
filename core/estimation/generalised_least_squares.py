"""All ten parameters, six offsets, drift, base tilt, delay and nuisances from all samples: generalised least squares on the weak form.

Solved is, for the windowed wrench y and the windowed regressor V(delay, tilt),

    min over (phi, offset, tilt, delay, b) of
        sum over channels |y - V(delay, tilt) phi - offset - G(phi) b|^2 in the metric C^-1  +  priors,
    C = noise of the wrench * Gram of the windows  +  noise of the kinematics * Gram of their second differences
        +  flicker noise, random walk and trend of the offset (`core.estimation.drift`),

by damped Gauss-Newton. The noise of the kinematics enters the wrench through the payload's own spatial inertia, as
`M(phi) (da, dalpha)`. It also sits in the regressor and in the columns of gains and cross-talk, where it would shrink the parameters; that
bias is subtracted (bias-compensated least squares). Joints' zeros and mounting turn it, which adds nothing on average. The nuisances b are
those of `core.estimation.nuisances`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.determination import SIZE_M, find_determined
from core.estimation.drift import Levelled, begin_search, drift_in, level_offsets
from core.estimation.fit import DELAY, OFFSET, SHARED, TILT, Beside, Fit
from core.estimation.noise import WrenchNoise, find_noise_factor
from core.estimation.noisy_columns import NoiseOfColumns, Solution, compensate
from core.estimation.nuisances import (
    BUDGETED,
    LEAST_EVIDENCE,
    LEAST_STRENGTH,
    NuisanceColumns,
    NuisanceGroup,
    Nuisances,
    find_evidence,
    improve_strength,
)
from core.estimation.quadratic import solve_scaled
from core.estimation.variance_search import Channel, slope_of
from core.estimation.weak_form import WeakForm
from core.estimation.window_covariance import WindowCovariance
from core.payload.inertia import InertialParameters, spatial_inertia

LEAST_SENSOR_SHARE = 5e-7
"""Of the sensor's noise in a window, beside that of the poses."""

PRIOR_STD = np.concatenate(([30.0], np.full(3, 3.0), np.full(6, 1.0), np.full(2, 0.05), [0.02], np.full(6, 1e3)))
"""Of phi, tilt (rad), delay (s), offsets: so wide that they matter only where the data are silent."""
ITERATIONS = 50
AT_REST = 0.02
"""Largest change of an unknown, in its standard uncertainty, and of that uncertainty, as a share, of an iteration that has converged."""
UNDAMPED = 10
"""Iterations that go the whole way after the model has changed; what has not come to rest by then goes half of it."""
STEPS_AGAIN = 3
"""From the solution of all motions to that of nearly all of them."""
SETTLED = 2
"""Iterations before the residuals are those of a payload, from which a walk can be told."""
VARIANCE_STEPS = 12
STRENGTH_AT_REST = 1e-3
"""Share by which a strength may still change."""
LARGEST_DELAY_S = 0.05
LARGEST_TILT_RAD = 0.3


def fit(form: WeakForm, wrench: Array, noise: WrenchNoise, nuisances: Nuisances | None = None) -> Fit:
    """Fits the raw wrench (N, 6), paper's sign.

    The noise is widened where the residuals exceed it, and the fit repeated with the new weights, so that the covariance stays honest where
    the model leaves something out.
    """
    problem = _Problem(form, wrench, noise, nuisances)
    result = problem.solve(np.ones(6))
    if not noise.measured:
        # the channels weigh each other by their noise: the residual of the first fit, then that of the second
        for _ in range(2):
            noise = replace(noise, std=noise.std * np.sqrt(find_noise_factor(result.whitened, noise)))
            result = _Problem(form, wrench, noise, nuisances).solve(np.ones(6))
        return result
    scale = find_noise_factor(result.whitened, noise)
    return result if (scale == 1.0).all() else replace(problem.solve(scale), scale=scale)


def refit(form: WeakForm, wrench: Array, found: Fit) -> Array:
    """`x` (19 + b,) for a wrench (N, 6) that differs little from the fitted one: one step from what was found, with its weights."""
    problem = _Problem.like(form, wrench, found)
    covariance, x = problem.step(found.x, found.scale)
    return problem.level(covariance, x).x


def fit_like(form: WeakForm, wrench: Array, found: Fit) -> Fit:
    """The fit to other windows of a recording that has been fitted: with its noise, walk and strengths of the nuisances."""
    problem, x = _Problem.like(form, wrench, found), found.x
    for _ in range(STEPS_AGAIN):
        covariance, x = problem.step(x, found.scale)
    return replace(problem.result(x, covariance, converged=True), scale=found.scale)


def look_beside(form: WeakForm, wrench: Array, found: Fit, columns: Sequence[Array] = ()) -> Beside:
    """One step from what was found, with its weights, for a wrench (N, 6) that differs little, and columns (N, 6) of it."""
    problem, k = _Problem.like(form, wrench, found), len(columns)
    _, x = problem.step(found.x, found.scale)
    seen = np.stack([form.average(column) for column in columns], axis=2) if k else np.zeros((*problem.y.shape, 0))
    chi_square, own, right, shared = 0.0, np.zeros((k, k)), np.zeros(k), np.zeros((problem.size, k))
    for c, at in enumerate(problem.channels):
        G = at.factor.whiten(problem.drift.filter.apply(seen[:, c]))
        chi_square += float(at.residual @ at.residual)
        own, right = own + G.T @ G, right + G.T @ at.residual
        shared[at.rows] += at.columns.T @ G
    known = problem.system[0] + np.diag(problem.prior)
    rows = sum(len(at.residual) for at in problem.channels)
    return Beside(x, chi_square, chi_square + float(problem.prior @ x**2), rows, own - shared.T @ solve_scaled(known, shared), right)


_UNIT_REGRESSORS = np.stack([spatial_inertia(unit).T for unit in np.eye(10)], axis=2)
"""(6, 6, 10): V for a unit of each linear and angular acceleration."""


@dataclass(frozen=True)
class _Linearised:
    """What the least squares are made of at one place.

    Args:
        shared: (K, 6, 13), change of the wrench with phi, tilt and delay; beside: (K, 6, b), with the nuisances that show in every channel.
        load: (K, 6), the wrench that gains and cross-talk act on; target: (K, 6), what is to be explained.
        likely: (10,), a payload that could be.
    """

    shared: Array
    beside: Array
    load: Array
    target: Array
    likely: Array


class _Problem:
    """The least-squares problem of one recording; what does not change between iterations is kept."""

    def __init__(self, form: WeakForm, wrench: Array, noise: WrenchNoise, nuisances: Nuisances | None) -> None:
        self.form = form
        self.noise = noise
        self.y = form.average(wrench)
        self.drift = drift_in(form)
        wrench_gram, pose_gram = form.gram
        self.white, self.pose_gram = self.drift.filter.covariance(wrench_gram), pose_gram.behind(self.drift.filter)
        self.search = begin_search(form, noise)
        self.nuisances = None if nuisances is None else NuisanceColumns(form, nuisances)
        self.size = OFFSET.stop + (0 if nuisances is None else nuisances.size)
        self.strength = np.ones(self.size - OFFSET.stop)
        groups = () if nuisances is None else nuisances.groups
        self.fitted = [group for group in groups if group.name != BUDGETED]
        for group in groups:
            self.strength[group.rows] = 1.0 if group in self.fitted else LEAST_STRENGTH
        self.prior = np.concatenate((PRIOR_STD**-2.0, np.zeros(self.size - OFFSET.stop)))
        self.system = np.zeros((0, 0)), np.zeros(0), np.zeros((0, 0))
        """Of the last linearisation: normal matrix, right-hand side, and how much of the former is noise of the poses."""
        self.std = PRIOR_STD[:10]
        """Of phi, after the last linearisation."""
        self.solution = Solution(*np.zeros((4, self.size, self.size)))
        self.start = np.zeros(self.size)
        """Where the iteration begins."""
        self.channels: list[Channel] = []
        """Of the last linearisation."""

    @classmethod
    def like(cls, form: WeakForm, wrench: Array, found: Fit) -> _Problem:
        """With the weights of a fit that is there, which stay as they are."""
        problem = cls(form, wrench, found.noise, found.nuisances)
        problem.strength[:], problem.fitted, problem.std = found.strength, [], np.sqrt(np.diag(found.covariance)[:10])
        problem.search.sizes[:] = found.sizes
        return problem

    def solve(self, scale: Array) -> Fit:
        """Gauss-Newton with the noise variance multiplied by `scale` (6,)."""
        converged, undamped = False, UNDAMPED
        self.search.begin()
        x = self.start
        for k in range(ITERATIONS):
            previous, before = x, self.std
            covariance, x = self.step(x, scale)
            moved = np.abs(x[:SHARED] - previous[:SHARED])
            rests = bool((np.abs(self.std - before) < AT_REST * before).all())
            converged = k > SETTLED and rests and bool((moved < AT_REST * np.sqrt(np.diag(covariance))[:SHARED]).all())
            if converged and not self._leave_out(x, covariance):
                break
            if converged:
                undamped = k + UNDAMPED
                self.search.begin()
            if k >= undamped:
                x = 0.5 * (x + previous)
            if k >= SETTLED:
                self._improve_sizes(scale)
        self.start = x
        return self.result(x, covariance, converged=converged)

    def result(self, x: Array, covariance: Array, *, converged: bool) -> Fit:
        """Of the last linearisation."""
        within = abs(x[DELAY]) < LARGEST_DELAY_S and bool((np.abs(x[TILT]) < LARGEST_TILT_RAD).all())
        held = None if self.nuisances is None else self.nuisances.nuisances
        repeatability, directions = self._split_uncertainty()
        level = self.level(covariance, x)
        whitened = np.array([at.residual for at in self.channels])
        return Fit(
            level.x, level.covariance, repeatability, directions,
            self.form.centres, level.drift, level.drift_std, level.trend, self.search.sizes.copy(), whitened, np.ones(6), self.noise,
            nuisances=held, strength=self.strength.copy(), converged=converged and within,
        )  # fmt: skip

    def _improve_sizes(self, scale: Array) -> None:
        """One step towards the sizes of the parts of the noise that maximise the restricted likelihood, where the model holds."""
        parts = WindowCovariance(self.white, self.drift.shared[:, :0]), *self.drift.parts
        for c, channel in enumerate(self.channels):
            sought = self.search.sought(c)
            if scale[c] == 1.0 and len(sought):
                self.search.improve(c, slope_of(self.search.sizes[c, sought], [parts[k] for k in sought], channel, self.solution.plain))

    def level(self, covariance: Array, x: Array) -> Levelled:
        """The drift, and the unknowns with the offsets' mean over the recording, where the last linearisation has their first value."""
        return level_offsets(x, covariance, self.channels, self.drift, self.search.sizes[:, 1:], OFFSET)

    def _rows_of_channel(self, c: int) -> NDArray[np.intp]:
        """Which unknowns show in one channel, in the order of its columns."""
        rows = [np.arange(SHARED), np.array([OFFSET.start + c])]
        if self.nuisances is not None:
            held = self.nuisances.nuisances
            rows += [OFFSET.stop + np.arange(held.of_loads, held.size), OFFSET.stop + held.rows_of_channel(c)]
        return np.concatenate(rows)

    def step(self, x: Array, scale: Array) -> tuple[Array, Array]:
        """One linearisation at x: covariance and new x; the whitened equations are in `channels`."""
        seen = self._linearise(x)
        M = spatial_inertia(seen.likely)
        normal, right, bias = np.zeros((self.size, self.size)), np.zeros(self.size), np.zeros((self.size, self.size))
        white = []
        for c in range(6):
            # slow windows see no noise of the pose: a little of the sensor's keeps the matrix regular when there is next to none
            kinematic = self.pose_gram.find_variance_through(M[c])
            sensor = max(self.search.sizes[c, 0] * scale[c], LEAST_SENSOR_SHARE * float((kinematic[0] / self.white[0]).max()))
            slow = self.drift.covariance(self.search.sizes[c, 1:], c)
            factor = WindowCovariance(sensor * self.white + kinematic + slow.bands, slow.columns).factorise()
            own = [seen.shared[:, c], np.ones((len(self.y), 1))]
            if self.nuisances is not None:
                own += [seen.beside[:, c], self.nuisances.of_channel(c, seen.load)]
            passed = self.drift.filter.apply(np.column_stack((*own, seen.target[:, c])))
            w, rows = factor.whiten(passed), self._rows_of_channel(c)
            white.append((factor, w, rows))
            normal[np.ix_(rows, rows)] += w[:, :-1].T @ w[:, :-1]
            right[rows] += w[:, :-1].T @ w[:, -1]
            self._add_bias(bias, c, seen.likely, self.pose_gram.trace_with(factor.inverse))
        self.system = normal, right, bias
        covariance, x = self._with_priors()
        self.std = np.sqrt(np.diag(covariance)[:10])
        self.channels = [Channel(factor, w[:, :-1], rows, w[:, -1] - w[:, :-1] @ x[rows]) for factor, w, rows in white]
        x[DELAY] = np.clip(x[DELAY], -LARGEST_DELAY_S, LARGEST_DELAY_S)
        x[TILT] = np.clip(x[TILT], -LARGEST_TILT_RAD, LARGEST_TILT_RAD)
        return covariance, x

    def _linearise(self, x: Array) -> _Linearised:
        phi, tilt, delay, b = x[:10], x[TILT], float(x[DELAY]), x[OFFSET.stop :]
        features, rate = self.form.features(delay)
        held = None if self.nuisances is None else self.nuisances.nuisances
        if held is not None:
            features, rate = features.turn(held.mounting(b)), rate.turn(held.mounting(b))
        V, likely = features.regressor(tilt), self._likely(phi)
        shared = np.concatenate((V, features.tilt_columns(phi, tilt), rate.wrench(tilt, phi)[..., None]), axis=2)
        target = self.y + shared[:, :, TILT] @ tilt + shared[:, :, DELAY] * delay
        beside = np.zeros((len(V), 6, 0))
        if self.nuisances is not None and held is not None:
            beside = self.nuisances.of_every_channel(features, likely, tilt, delay)
            target = target + beside[:, :, held.mount.start - held.of_loads : held.mount.stop - held.of_loads] @ b[held.mount]
        return _Linearised(shared, beside, V @ likely, target, likely)

    def _likely(self, phi: Array) -> Array:
        """(10,), a payload to weigh and to linearise with: where phi is not determined yet, that of a body of usual size in its place.

        What the noise makes of an inertia that nothing excites would change the weights from iteration to iteration, which would not rest.
        """
        m, mc = max(float(phi[0]), 0.0), phi[1:4]
        c = mc / m if m > 0.0 else np.zeros(3)
        usual = InertialParameters.from_com(m, c, m * SIZE_M**2 * np.eye(3)).phi
        return np.where(find_determined(phi, self.std), phi, usual) if m > 0.0 else phi

    def _add_bias(self, bias: Array, c: int, phi: Array, passed: Array) -> None:
        """Adds the information in one channel that is noise of the poses, of which the weighted windows let (6, 6) through."""
        noisy, rows = _UNIT_REGRESSORS[:, c], np.arange(10)
        if self.nuisances is not None:
            held = self.nuisances.nuisances
            noisy = np.hstack((noisy, self.nuisances.of_channel(c, _UNIT_REGRESSORS @ phi)))
            rows = np.concatenate((rows, OFFSET.stop + held.rows_of_channel(c)))
        bias[np.ix_(rows, rows)] += noisy.T @ passed @ noisy

    def _with_priors(self) -> tuple[Array, Array]:
        """Solves the last linearisation with the priors; the strengths of the nuisances are improved along the way."""
        normal, right, bias = self.system
        prior, noise = self.prior, NoiseOfColumns.of(bias)
        for _ in range(VARIANCE_STEPS if self.fitted else 1):
            prior[OFFSET.stop :] = 1.0 / self.strength
            self.solution = compensate(normal, noise, prior)
            covariance, x, strength = self.solution.covariance, self.solution.gain @ right, self.strength.copy()
            self._improve_strengths(x, covariance)
            if (np.abs(self.strength - strength) < STRENGTH_AT_REST * strength).all():
                break
        # the covariance is that of the strengths that it was made with
        self.strength = strength
        return covariance, x

    def _split_uncertainty(self) -> tuple[Array, Array]:
        """(10, 10) covariance of phi with the nuisances as they are, and (10, b) what each of them does to phi."""
        covariance, told, n = self.solution.covariance[:10], self.solution.told, 10
        error = covariance @ told - np.eye(n, self.size)
        """What the solution is off by, through its prior, per unit of each unknown."""
        random, variance = error[:, : OFFSET.stop], 1.0 / self.prior[: OFFSET.stop]
        repeatability = covariance @ told @ covariance.T + (random * variance) @ random.T
        return repeatability, error[:, OFFSET.stop :]

    def _improve_strengths(self, x: Array, covariance: Array) -> None:
        """One step towards the strengths of the nuisances that maximise the restricted likelihood."""
        for group in self.fitted:
            b, spread = self._nuisances_in(group, x, covariance)
            self.strength[group.rows] = improve_strength(float(self.strength[group.rows][0]), b, spread)

    def _nuisances_in(self, group: NuisanceGroup, x: Array, covariance: Array) -> tuple[Array, Array]:
        rows = slice(OFFSET.stop + group.rows.start, OFFSET.stop + group.rows.stop)
        return x[rows], covariance[rows, rows]

    def _leave_out(self, x: Array, covariance: Array) -> bool:
        """Leaves out, one by one, the groups of nuisances that the data do not ask for; whether there were any."""
        before = len(self.fitted)
        while self.fitted:
            evidence = [find_evidence(float(self.strength[g.rows][0]), *self._nuisances_in(g, x, covariance)) for g in self.fitted]
            least = int(np.argmin(evidence))
            if evidence[least] > LEAST_EVIDENCE:
                break
            self.strength[self.fitted.pop(least).rows] = LEAST_STRENGTH
            covariance, x = self._with_priors()
        return len(self.fitted) < before
