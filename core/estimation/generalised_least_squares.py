"""All ten parameters, six offsets, drift, base tilt and delay from all samples: generalised least squares on the weak form.

Solved is, for the windowed wrench y and the windowed regressor V(delay, tilt),

    min over (phi, offset, tilt, delay, drift) of
        sum over channels |y - V(delay, tilt) phi - offset - drift|^2 in the metric C^-1  +  weak priors,
    C = noise of the wrench * Gram of the windows  +  noise of the kinematics * Gram of their second differences,

by Gauss-Newton. The noise of the kinematics enters the wrench through the payload's own spatial inertia, as `M(phi) (da, dalpha)`. It
also sits in the regressor, where it would shrink the parameters; that bias is subtracted (bias-compensated least squares).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from core.array import Array
from core.estimation.drift import STEP_STD, drift_basis, improve_variance, parts_of, steps_between
from core.estimation.noise import WrenchNoise
from core.estimation.weak_form import WeakForm, whiten
from core.payload.inertia import spatial_inertia

TILT = slice(10, 12)
DELAY = 12
OFFSET = slice(13, 19)
SHARED = 13
"""phi, tilt and delay; then come offsets and drift."""

PRIOR_STD = np.concatenate(([30.0], np.full(3, 3.0), np.full(6, 1.0), np.full(2, 0.05), [0.02], np.full(6, 1e3)))
"""Of phi, tilt (rad), delay (s), offsets: so wide that they matter only where the data are silent."""
ITERATIONS = 8
DRIFT_STEPS = 12
LARGEST_DELAY_S = 0.05
LARGEST_NOISE_SHARE = 0.9
"""Of the information in one direction; where noise alone makes up more, the direction counts as unknown."""
SMALLEST_SHARE = 1e-4


@dataclass(frozen=True)
class Fit:
    """Result of the least squares, before anything is judged.

    Args:
        x: (19,), `[phi, tilt, delay, offset]`.
        covariance: (19, 19), with drift marginalised.
        drift: (K, 6), at the windows' centres; `drift_std`: (6,), of its range.
        whitened: (6, K), residuals with unit variance when the model holds.
        scale: (6,), factor on the noise variance that the residuals asked for, 1 where the model holds.
        noise: of one sample.
    """

    x: Array
    covariance: Array
    centres: Array
    drift: Array
    drift_std: Array
    whitened: Array
    scale: Array
    noise: WrenchNoise

    @property
    def phi(self) -> Array:
        """(10,)."""
        return self.x[:10]


def fit(form: WeakForm, wrench: Array, noise: WrenchNoise) -> Fit:
    """Fits the raw wrench (N, 6), paper's sign.

    The noise is widened where the residuals exceed it, and the fit repeated with the new weights, so that the covariance stays honest where
    the model leaves something out.
    """
    problem = _Problem(form, wrench, noise)
    result = problem.solve(np.ones(6))
    if not noise.measured:
        # the channels weigh each other by their noise: the residual of the first fit, then that of the second
        for _ in range(2):
            noise = replace(noise, std=noise.std * np.sqrt(_misfit(result, noise)))
            result = _Problem(form, wrench, noise).solve(np.ones(6))
        return result
    scale = _misfit(result, noise)
    return result if (scale == 1.0).all() else replace(problem.solve(scale), scale=scale)


def refit(form: WeakForm, wrench: Array, found: Fit) -> Array:
    """`x` (19,) for a wrench (N, 6) that differs little from the fitted one: one step from what was found, with its weights."""
    _, x, _ = _Problem(form, wrench, found.noise).step(found.x, found.scale)
    return np.asarray(x[: OFFSET.stop])


_UNIT_REGRESSORS = np.stack([spatial_inertia(unit).T for unit in np.eye(10)], axis=2)
"""(6, 6, 10): V for a unit of each linear and angular acceleration."""


class _Problem:
    """The least-squares problem of one recording; what does not change between iterations is kept."""

    def __init__(self, form: WeakForm, wrench: Array, noise: WrenchNoise) -> None:
        self.form = form
        self.noise = noise
        self.y = form.average(wrench)
        self.wrench_gram, self.pose_gram = form.gram
        self.spectrum = form.spectrum
        t = form.poses.t
        parts = [] if form.static else parts_of(t)
        walk, steps = drift_basis(form.centres, parts), steps_between(form.centres, parts)
        self.ramps = np.concatenate((walk, steps), axis=1)
        """(K, n): what the offset does, first the walk, then a step for each pause."""
        self.walk = walk.shape[1]
        self.size = OFFSET.stop + 6 * self.ramps.shape[1]
        self.drift_variance = (0.1 * noise.std) ** 2
        self.drift_floor = (2e-4 * noise.std) ** 2

    def solve(self, scale: Array) -> Fit:
        """Gauss-Newton with the noise variance multiplied by `scale` (6,)."""
        x = np.zeros(self.size)
        for _ in range(ITERATIONS):
            previous = x
            normal, x, whitened = self.step(x, scale)
            moved = np.abs(x[:SHARED] - previous[:SHARED])
            if (moved < 0.01 * np.sqrt(np.diag(normal))[:SHARED]).all():
                break
        drift = np.column_stack([self.ramps @ x[self._drift_rows(c)] for c in range(6)])
        spread = [self._range_std(normal, c) for c in range(6)]
        covariance = normal[: OFFSET.stop, : OFFSET.stop]
        return Fit(x[: OFFSET.stop], covariance, self.form.centres, drift, np.array(spread), whitened, np.ones(6), self.noise)

    def _drift_rows(self, channel: int) -> slice:
        n = self.ramps.shape[1]
        return slice(OFFSET.stop + channel * n, OFFSET.stop + (channel + 1) * n)

    def _walk_rows(self, channel: int) -> slice:
        first = self._drift_rows(channel).start
        return slice(first, first + self.walk)

    def _range_std(self, covariance: Array, channel: int) -> float:
        rows = self._drift_rows(channel)
        ends = self.ramps[-1:] - self.ramps[:1]
        return float(np.sqrt(ends @ covariance[rows, rows] @ ends.T).item()) if self.ramps.shape[1] else 0.0

    def step(self, x: Array, scale: Array) -> tuple[Array, Array, Array]:
        """One linearisation at x: covariance, new x, whitened residuals."""
        phi, tilt, delay = x[:10], x[TILT], float(x[DELAY])
        features, rate = self.form.features(delay)
        V = features.regressor(tilt)
        shared = np.concatenate((V, features.tilt_columns(phi, tilt), (rate.regressor(tilt) @ phi)[..., None]), axis=2)
        target = self.y + shared[:, :, TILT] @ tilt + shared[:, :, DELAY] * delay
        K = self.form.poses.noise
        M = spatial_inertia(phi)
        kinematic = np.diag(M @ K @ M.T)
        size = self.size
        normal, right, bias = np.zeros((size, size)), np.zeros(size), np.zeros((10, 10))
        white = []
        for c in range(6):
            # slow windows see no noise of the pose: a little of the sensor's keeps the matrix regular when there is next to none
            sensor = max(self.noise.variance[c] * scale[c], 1e-7 * kinematic[c] * float(self.spectrum.max()))
            bands = sensor * self.wrench_gram + kinematic[c] * self.pose_gram
            own = np.column_stack((shared[:, c], np.ones(len(self.y)), self.ramps, target[:, c]))
            w = whiten(bands, own)
            white.append(w)
            columns = np.concatenate((np.arange(SHARED), [OFFSET.start + c], np.arange(size)[self._drift_rows(c)]))
            normal[np.ix_(columns, columns)] += w[:, :-1].T @ w[:, :-1]
            right[columns] += w[:, :-1].T @ w[:, -1]
            unit = _UNIT_REGRESSORS[:, c]
            # trace(C^-1 pose_gram): how much of the pose's noise the weighted windows let through
            passed = len(self.y) * np.mean(self.spectrum / (sensor + kinematic[c] * self.spectrum))
            bias += passed * unit.T @ K @ unit
        covariance, x = self._with_priors(normal, right, bias)
        residuals = [
            w[:, -1] - w[:, :-1] @ np.concatenate((x[:SHARED], [x[OFFSET.start + c]], x[self._drift_rows(c)])) for c, w in enumerate(white)
        ]
        x[DELAY] = np.clip(x[DELAY], -LARGEST_DELAY_S, LARGEST_DELAY_S)
        return covariance, x, np.array(residuals)

    def _with_priors(self, normal: Array, right: Array, bias: Array) -> tuple[Array, Array]:
        """Solves with the priors; the drift's strength is improved along the way."""
        prior = np.concatenate((PRIOR_STD**-2.0, np.zeros(self.size - OFFSET.stop)))
        for _ in range(DRIFT_STEPS if self.walk else 1):
            for c in range(6):
                prior[self._drift_rows(c)] = STEP_STD[c] ** -2.0
                prior[self._walk_rows(c)] = 1.0 / self.drift_variance[c]
            covariance = _without_bias(_inverse(normal + np.diag(prior)), bias)
            x = covariance @ right
            for c in range(6 if self.walk else 0):
                rows = self._walk_rows(c)
                self.drift_variance[c] = improve_variance(self.drift_variance[c], x[rows], covariance[rows, rows], self.drift_floor[c])
        return covariance, x


def _inverse(matrix: Array) -> Array:
    scale = 1.0 / np.sqrt(np.diag(matrix))
    return np.asarray(np.linalg.inv(matrix * np.outer(scale, scale)) * np.outer(scale, scale))


def _without_bias(covariance: Array, bias: Array) -> Array:
    """Inverse of `covariance^-1 - bias`, the bias (10, 10) standing for what noise alone has added to the information on phi.

    Where it stands for all of it, nothing is known: the little that rounding leaves is then replaced by next to nothing.
    """
    values, vectors = np.linalg.eigh(bias)
    root = vectors * np.sqrt(np.maximum(values, 0.0))
    share, directions = np.linalg.eigh(root.T @ covariance[:10, :10] @ root)
    gain = covariance[:, :10] @ root @ directions
    return np.asarray(covariance + (gain / np.where(share < LARGEST_NOISE_SHARE, 1.0 - share, SMALLEST_SHARE)) @ gain.T)


def _misfit(result: Fit, noise: WrenchNoise) -> Array:
    """(6,) factor on the variance: 1 within what chance allows, else mean square times correlation time of the residuals."""
    count = result.whitened.shape[1]
    freedom = max(count - 2, 1)
    scale = np.ones(6)
    for c, r in enumerate(result.whitened):
        mean_square = float(r @ r) / freedom
        # the excess that chance explains in about one run of a thousand, with the uncertainty of the measured noise on top
        limit = 3.0 * np.sqrt(2.0 / count) + 0.03
        spectrum = correlation_time(r)
        if not noise.measured or mean_square > 1.0 + limit:
            scale[c] = mean_square * spectrum
        elif spectrum > 1.3:
            scale[c] = spectrum
    return scale


def correlation_time(r: Array, longest: int = 200) -> float:
    """1 + 2 sum of the autocorrelation up to its first value within noise; 1 for white residuals."""
    n, total = len(r), 1.0
    power = float(r @ r)
    for lag in range(1, min(longest, n // 4)):
        rho = float(r[lag:] @ r[:-lag]) / power
        if rho < 2.0 / np.sqrt(n):
            break
        total += 2.0 * rho
    return total
