"""What the least squares of a recording have found, before anything is judged."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from core.array import Array, interpolate
from core.estimation.budget import Budget, Source
from core.estimation.noise import WrenchNoise
from core.estimation.nuisances import Nuisances
from core.estimation.trend import FoundTrend

TILT = slice(10, 12)
DELAY = 12
OFFSET = slice(13, 19)
"""Places among the unknowns, whose first ten are phi."""
SHARED = 13
"""phi, tilt and delay; then come offsets and nuisances."""


@dataclass(frozen=True)
class Fit:
    """Result of `core.estimation.generalised_least_squares`.

    Args:
        x: (19 + b,), `[phi, tilt, delay, offset]`, then the nuisances in units of their standard uncertainty.
        covariance: (19 + b, 19 + b), with drift marginalised and each nuisance as uncertain as its strength says.
        repeatability: (10, 10), covariance of phi with the nuisances as they are.
        directions: (10, b), how far phi is off when a nuisance is off by its standard uncertainty and the fit goes on as it did.
        drift: (K, 6), at the windows' centres; `drift_std`: (6,), of its range.
        trend: of the drift, what it does where there are no windows.
        sizes: (6, 5), of each channel's white noise, N² of a sample, the processes of its flicker, N², its walk, N²/s, and its trend, N².
        whitened: (6, K), residuals with unit variance when the model holds.
        scale: (6,), factor on the noise variance that the residuals asked for, 1 where the model holds.
        noise: of one sample.
        nuisances: that were fitted; None where nothing was.
        strength: (b,), variance of each nuisance that the data ask for, 1 for what is stated.
        converged: whether the iteration came to rest, and not at a bound.
    """

    x: Array
    covariance: Array
    repeatability: Array
    directions: Array
    centres: Array
    drift: Array
    drift_std: Array
    trend: FoundTrend
    sizes: Array
    whitened: Array
    scale: Array
    noise: WrenchNoise
    nuisances: Nuisances | None = None
    strength: Array = field(default_factory=lambda: np.zeros(0))
    converged: bool = True

    @property
    def phi(self) -> Array:
        """(10,)."""
        return self.x[:10]

    @property
    def misfit(self) -> float:
        """Mean square of the residuals over their noise, 1 when the model holds."""
        return float((np.square(self.whitened).mean(axis=1) * self.scale).mean())

    @property
    def b(self) -> Array:
        """(b,), nuisances in units of their standard uncertainty."""
        return self.x[OFFSET.stop :]

    def drift_at(self, t: Array) -> tuple[Array, Array]:
        """(N, 6) at times t (N,), and the variance (N, 6) that its trend has where there are no windows near."""
        lines = interpolate(t, self.centres, self.drift)
        bent, variance = self.trend.between(t, self.centres)
        return lines + bent, variance

    @property
    def budget(self) -> Budget:
        """Of phi, with all nuisances as uncertain as they are stated to be, whatever their strength in the fit."""
        groups = () if self.nuisances is None else self.nuisances.groups
        sources = (Source(group.name, group.stated, self.directions[:, group.rows]) for group in groups)
        return Budget(self.repeatability, tuple(sources))


class Beside(NamedTuple):
    """A fit whose weights are known, and what k further columns of the wrench would explain beside it.

    Args:
        x: (19 + b,), its unknowns. chi_square: of its residual; cost: the same with the priors. rows: how many equations there are.
        normal, right: (k, k) and (k,), equations of the columns' sizes, as far as the unknowns cannot follow them.
    """

    x: Array
    chi_square: float
    cost: float
    rows: int
    normal: Array
    right: Array
