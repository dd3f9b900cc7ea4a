"""Noise of the wrench, from the motionless parts."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.segments import Segment

SHORTEST = 50
"""Samples that a hold needs for its variance to count."""
PIECE_S, LONGEST_PIECES = 0.15, 8
"""Shortest pieces that a hold is cut into to see how its mean moves, and how many at most."""
MEDIAN_OF_SQUARE = 0.455
"""Of chi-square with one degree of freedom."""
CAUTION = 8.0
"""Over the root of the number of squares: by how much their median may be too small."""
FASTEST_WALK = 2.0
"""Times the noise of a sample that the offset may move in a second where no hold has shown how it moves."""


@dataclass(frozen=True)
class WrenchNoise:
    """Noise of one sample of the wrench.

    Args:
        std: (6,), N and N m.
        long_run: (6,), factor on the variance of a mean over many samples that correlation between them causes; 1 for white noise.
        measured: whether the recording's motionless parts gave it; the sensor's nominal figure, or a residual, otherwise.
        fastest_walk: (6,), N²/s and N² m²/s, largest rate of a random walk of the offset that the motionless parts allow: what moves more
            than that while the robot moves is no walk of the sensor.
        seen_s: length of the neighbouring means whose differences say so, s: a walk gives them two thirds of it times its rate as variance.
    """

    std: Array
    long_run: Array
    measured: bool
    fastest_walk: Array = field(default_factory=lambda: np.full(6, np.inf))
    seen_s: float = 1.0

    @property
    def variance(self) -> Array:
        """(6,), of one sample, so that means over many samples come out right."""
        return self.std**2 * self.long_run


def sensor_noise(
    t: Array, wrench: Array, still: NDArray[np.bool_], segments: tuple[Segment, ...], *, nominal_std: Array | None = None
) -> WrenchNoise | None:
    """Noise after a straight line is taken out of every hold; the median over the holds, so that a disturbed one does not decide.

    Returns the nominal figure where no hold is long enough, and None where there is neither.
    """
    variances, products, rates, lengths = [], [], [], []
    for part in segments:
        rows = np.flatnonzero(still[part.rows]) + part.start
        if not part.is_hold or len(rows) < SHORTEST:
            continue
        x = _without_line(wrench[rows])
        variances.append((x**2).sum(axis=0) / (len(rows) - 2))
        products.append((x[1:] * x[:-1]).sum(axis=0) / (len(rows) - 2))
        pieces = np.array_split(rows, max(2, min(LONGEST_PIECES, int((t[rows[-1]] - t[rows[0]]) / PIECE_S))))
        rates.append(_rates_between_pieces(t, wrench, pieces))
        lengths.append(float(t[rows[-1]] - t[rows[0]]) / len(pieces))
    if variances:
        variance = np.maximum(np.median(variances, axis=0), 1e-18)
        correlation = np.median(products, axis=0) / variance
        samples = len(variances) * SHORTEST
        seen = np.where(correlation > 4.0 / np.sqrt(samples), np.minimum(correlation, 0.98), 0.0)
        return WrenchNoise(
            np.sqrt(variance), (1.0 + seen) / (1.0 - seen), True, _largest_rate(np.concatenate(rates)), float(np.median(lengths))
        )
    if nominal_std is None:
        return None
    std = np.asarray(nominal_std, dtype=float)
    return WrenchNoise(std, np.ones(6), False, (FASTEST_WALK * std) ** 2)


def _rates_between_pieces(t: Array, x: Array, pieces: list[NDArray[np.intp]]) -> Array:
    """(p, 6), rate of the walk that the change between two neighbouring pieces of a hold would be, noise included."""
    means, at = np.array([x[k].mean(axis=0) for k in pieces]), np.array([t[k].mean() for k in pieces])
    # the means of two pieces of equal length T of a walk differ by 2/3 T
    return np.asarray(np.diff(means, axis=0) ** 2 / (2.0 / 3.0 * np.diff(at)[:, None]))


def _largest_rate(rates: Array) -> Array:
    """(6,), bound on the rate from squares of one degree of freedom each (p, 6); the median, so that a disturbed hold does not decide."""
    return np.asarray(np.median(rates, axis=0) / MEDIAN_OF_SQUARE * (1.0 + CAUTION / np.sqrt(len(rates))))


def _without_line(x: Array) -> Array:
    s = np.linspace(-1.0, 1.0, len(x))
    centred = x - x.mean(axis=0)
    return np.asarray(centred - np.outer(s, s @ centred / (s @ s)))


def unknown_noise() -> WrenchNoise:
    """A start where nothing is known; the residual of the fit decides, channel by channel."""
    return WrenchNoise(np.repeat([0.1, 0.01], 3), np.ones(6), False)


def find_noise_factor(whitened: Array, noise: WrenchNoise) -> Array:
    """(6,), factor on the variance that whitened residuals (6, K) ask for.

    It is 1 within what chance allows, else their mean square times their correlation time.
    """
    count = whitened.shape[1]
    freedom = max(count - 2, 1)
    scale = np.ones(6)
    for c, r in enumerate(whitened):
        mean_square = float(r @ r) / freedom
        # the excess that chance explains in about one run of a thousand, with the uncertainty of the measured noise on top
        limit = 3.0 * np.sqrt(2.0 / count) + 0.03
        spectrum = correlation_time(r)
        if not noise.measured or mean_square > 1.0 + limit:
            scale[c] = mean_square * spectrum
        elif spectrum > 1.3:
            scale[c] = max(1.0, mean_square * spectrum)
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
