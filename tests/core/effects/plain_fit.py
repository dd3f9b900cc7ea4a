"""A fit of one effect that knows nothing of the product's."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from core.effects.effect import Effect
from core.effects.scene import Scene
from tests.core.effects.mechanical_truth import SIGMA, Array, change, scene, without_nuisance


@dataclass(frozen=True)
class Fit:
    theta: Array
    std: Array
    closure: float
    """Share of the power above the noise that is gone."""


def fitted(effect: Effect, measured: Array, noise: float, run: Scene | None = None) -> Fit:
    """Plain bounded least squares from each of the effect's starts, payload and offsets projected out, with the effect's prior."""
    run = scene() if run is None else run
    parameters = effect.parameters(run)
    absent, scale, lower, upper = np.array([[p.absent, p.scale, p.lower, p.upper] for p in parameters]).T
    residual = without_nuisance(((measured - run.nominal) / SIGMA).ravel())
    floor = noise**2 * (residual.size - 16)
    excess = residual @ residual - floor

    def cost(theta: Array) -> Array:
        return np.append(residual - without_nuisance((change(effect, theta, run) / SIGMA).ravel()), (theta - absent) / scale)

    fits = []
    for start in effect.starts(run, residual.reshape(-1, 6)):
        bounds = (lower - 1e-12, upper + 1e-12)
        fit = least_squares(cost, np.clip(start, lower, upper), bounds=bounds, x_scale=scale, max_nfev=30, ftol=1e-6, xtol=1e-6)
        closure = 1 - (2 * fit.cost - floor) / excess
        fits.append(Fit(fit.x, np.sqrt(np.diag(np.linalg.inv(fit.jac.T @ fit.jac))), closure))
        if closure > 0.97:
            break
    return max(fits, key=lambda fit: fit.closure)
