"""Slow drift of the sensor's offset: a random walk in the covariance of the windows, whose rate the data decide (restricted likelihood).

With the offset o, the walk w and white noise e the windowed wrench of one channel is

    y_k = x_k beta + o + w_k + e_k,     cov(w_k - w_(k-1), w_l - w_(l-1)) = rate * (bands next to the diagonal),

so that the *differences* of neighbouring windows have a banded covariance, however long the recording is. The first "difference" is the
first window itself, where the walk begins with zero. After a pause the offset may jump, since a sensor may be tared in one: that is a
variance of its own, and tells nothing about the rate.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.banded import BAND, invert, multiply, solve_transposed, trace, whiten
from core.estimation.weak_form import WeakForm
from core.recording.recording import PAUSE_S

STEP_STD = np.repeat([1.0, 0.05], 3)
"""N and N m, of the offsets of what was recorded after a pause against those before it."""
EULERIAN = np.array([156190.0, 88234.0, 14608.0, 502.0, 1.0]) / 362880.0
"""Covariances of the increments of a unit walk from window to window: quartic B-splines overlap as the ninth-degree one says."""
LONGEST_STEP = np.log(100.0)
"""By which the logarithm of a rate changes at once."""
LEAST = 1e-200
"""Of what is divided by."""


@dataclass(frozen=True)
class Walk:
    """What a walk of unit rate and the jumps of unit variance make of the differences of K windows.

    Args:
        bands: (b, K), lower bands of their covariance, s.
        jumps: (K,), 1 where a pause lies before a window.
    """

    bands: Array
    jumps: Array

    def covariance(self, rate: float, channel: int) -> Array:
        """(b, K), lower bands of a channel with a rate in N²/s, or N² m²/s."""
        found = rate * self.bands
        found[0] += STEP_STD[channel] ** 2 * self.jumps
        return np.asarray(found)


def walk_in(form: WeakForm) -> Walk:
    """The walk in the windows of a recording; where rows are poses of their own nobody knows what was between them, and there is none."""
    bands, jumps = np.zeros((len(form.gram[0]) + 1, len(form))), np.zeros(len(form))
    if not form.static:
        starts = form.poses.t[1:][np.diff(form.poses.t) > PAUSE_S]
        part = np.searchsorted(starts, form.centres)
        jumps[1:] = np.diff(part) > 0
        bands[:BAND] = increments_of_walk(form.centres / form.spacing) * form.spacing
    return Walk(bands, jumps)


def increments_of_walk(k: Array) -> Array:
    """(BAND, K), lower bands of the covariance of the increments of a unit walk, averaged over cubic B-splines at k (K,), in knots."""
    bands = np.zeros((BAND, len(k)))
    before, at = k[:-1], k[1:]
    for d in range(min(BAND, len(at))):
        a, b, c, e = before[: len(at) - d], at[: len(at) - d], before[d:], at[d:]
        bands[d, 1 : len(k) - d] = 0.5 * (_variogram(e - a) + _variogram(c - b) - _variogram(c - a) - _variogram(e - b))
    return bands


def _variogram(lag: Array) -> Array:
    """(N,), variance of the change of a unit walk between two windows that are so many knots apart; whole numbers."""
    n = np.abs(np.rint(lag))
    c = EULERIAN
    near = sum(2.0 * c[d] * np.maximum(n - d, 0.0) for d in range(1, len(c)))
    return np.asarray(c[0] * n + near)


@dataclass(frozen=True)
class Slope:
    """How the restricted likelihood changes with the rate of a channel's walk.

    Args:
        ratio: `r' P V P r / tr(P V)`, 1 where the likelihood is largest, more below.
        share: by which the logarithm of the ratio falls when that of the rate rises: how much of the walk the noise lets through, 0 to 1.
    """

    ratio: float
    share: float

    @property
    def step(self) -> float:
        """Newton's, of the logarithm of the rate towards the largest likelihood, no longer than `LONGEST_STEP`."""
        return float(np.clip(np.log(self.ratio) / max(self.share, 1e-3), -LONGEST_STEP, LONGEST_STEP))


class RateSearch:
    """The rates of the six walks on their way to the largest restricted likelihood.

    Where the noise hides most of a walk, the likelihood is flat and Newton's step leads past the maximum and back for ever. So a step that
    turns back halves how far the rate of this channel goes from now on: the search ends between two places, as a bisection does.

    Args:
        rate: (6,), where the search begins. least, most: (6,), bounds.
    """

    def __init__(self, rate: Array, least: Array, most: Array) -> None:
        self.rate, self._least, self._most = rate, least, most
        self._reach, self._last = np.full(len(rate), LONGEST_STEP), np.zeros(len(rate))

    def begin(self) -> None:
        """The search goes on in another model: nothing is known of where its maxima lie."""
        self._reach[:], self._last[:] = LONGEST_STEP, 0.0

    def improve(self, c: int, slope: Slope) -> None:
        """One step of one channel."""
        if slope.step * self._last[c] < 0.0:
            self._reach[c] *= 0.5
        self._last[c] = step = np.clip(slope.step, -self._reach[c], self._reach[c])
        self.rate[c] = np.clip(self.rate[c] * np.exp(step), self._least[c], self._most[c])


@dataclass(frozen=True)
class Channel:
    """One channel's equations for the differences of the windows, whitened.

    Args:
        factor: (b, K), of the covariance of the differences. columns: (K, n), of the unknowns `rows` (n,). residual: (K,).
    """

    factor: Array
    columns: Array
    rows: NDArray[np.intp]
    residual: Array


def slope_of(rate: float, bands: Array, channel: Channel, covariance: Array) -> Slope:
    """Of one channel, by the average information (Gilmour, Thompson and Cullis 1995, Biometrics 51).

    Args:
        bands: (b, K), share of a unit rate in the covariance of the differences. covariance: (m, m), of all unknowns.
    """
    known = covariance[np.ix_(channel.rows, channel.rows)]
    u = solve_transposed(channel.factor, np.column_stack((channel.residual, channel.columns)))
    moved = multiply(bands, u)
    seen = max(float(u[:, 0] @ moved[:, 0]), LEAST)
    expected = max(float(trace(invert(channel.factor), bands)) - float(np.sum(u[:, 1:] * (moved[:, 1:] @ known))), LEAST)
    walked = whiten(channel.factor, moved[:, :1])[:, 0]
    along = walked @ channel.columns
    return Slope(seen / expected, rate * float(walked @ walked - along @ known @ along) / seen)


def variance_between(rate: Array, noise: Array, t: Array, seen: Array) -> Array:
    """(N, 6), variance of the walk at times t (N,) about a straight line between the nearest of the times at which it was seen (K,).

    Args:
        rate: (6,), of the walk. noise: (6,), spectral density of the white noise that it was seen through, N² s: a level that walks
            is known to `sqrt(rate noise)` where the data end (Kalman's filter at rest).
    """
    after = np.searchsorted(seen, t)
    since = np.where(after > 0, t - seen[np.maximum(after - 1, 0)], np.inf)
    until = np.where(after < len(seen), seen[np.minimum(after, len(seen) - 1)] - t, np.inf)
    near, far = np.minimum(since, until), np.maximum(since, until)
    return np.multiply.outer(near / (1.0 + near / far), rate) + np.sqrt(rate * noise)


@dataclass(frozen=True)
class Levelled:
    """Unknowns and their covariance with mean offsets, the drift (K, 6) about these, and the uncertainty (6,) of its range."""

    x: Array
    covariance: Array
    drift: Array
    drift_std: Array


def level_offsets(x: Array, covariance: Array, channels: Sequence[Channel], walk: Walk, rate: Array, offset: slice) -> Levelled:
    """Predicts the walk (best linear unbiased), and moves its mean into the offsets, which are those of the first window.

    Args:
        x, covariance: (m,) and (m, m), of all unknowns, of which the rows `offset` are the six offsets. rate: (6,).
    """
    count = len(walk.jumps)
    to_mean, added, x = np.eye(len(x)), np.zeros(len(x)), x.copy()
    drift, spread = np.zeros((count, 6)), np.zeros(6)
    for c, channel in enumerate(channels):
        bands, rows, at = walk.covariance(rate[c], c), channel.rows, offset.start + c
        drift[:, c] = np.cumsum(multiply(bands, solve_transposed(channel.factor, channel.residual[:, None]))[:, 0])
        mean, mean_left = _predict(channel.factor, bands, 1.0 - np.arange(count) / count)
        last, last_left = _predict(channel.factor, bands, np.ones(count))
        x[at] += drift[:, c].mean()
        to_mean[at, rows] -= mean @ channel.columns
        added[at] = mean_left
        along = last @ channel.columns
        spread[c] = np.sqrt(last_left + along @ covariance[np.ix_(rows, rows)] @ along)
    return Levelled(x, to_mean @ covariance @ to_mean.T + np.diag(added), drift - drift.mean(axis=0), spread)


def _predict(factor: Array, bands: Array, weights: Array) -> tuple[Array, float]:
    """The sum of weights (K,) times the differences of the walk: gain (K,) on whitened residuals, and the variance that is left."""
    of_sum = multiply(bands, weights[:, None])
    gain = whiten(factor, of_sum)[:, 0]
    return gain, max(float(weights @ of_sum[:, 0] - gain @ gain), 0.0)
