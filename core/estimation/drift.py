"""Slow changes of the sensor's offset: a trend, a random walk and flicker noise in the covariance of the windows.

With the offset o, the trend s, the walk w, the flicker f and white noise e the windowed wrench of one channel is

    y_k = x_k beta + o + s_k + w_k + f_k + e_k,

white noise, flicker (1/f) and walk being what the noise of sensors is usually taken to be made of (IEEE Std 952, Allan variance). Flicker
is a sum of Ornstein-Uhlenbeck processes whose time constants are a decade apart; what is slower than the slowest is the walk's. Behind an
annihilating filter over neighbouring windows these have a banded covariance, however long the recording is; what warms up or cools down
over all of it is a trend, of low rank (`core.estimation.trend`). The first row of the filter is the first window itself, where the walk
begins with zero. After a pause the offset may jump, since a sensor may be tared in one: that is a variance of its own, and tells nothing
about the sizes of the others, which the restricted likelihood finds (`core.estimation.variance_search`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray

from core.array import Array
from core.estimation.annihilating_filter import AnnihilatingFilter
from core.estimation.banded import BAND
from core.estimation.noise import WrenchNoise
from core.estimation.splines import cardinal
from core.estimation.trend import FoundTrend, Trend
from core.estimation.variance_search import Channel, VarianceSearch
from core.estimation.weak_form import WeakForm
from core.estimation.window_covariance import Factor, WindowCovariance
from core.recording.recording import PAUSE_S

STEP_STD = np.repeat([1.0, 0.05], 3)
"""N and N m, of the offsets of what was recorded after a pause against those before it."""
EULERIAN = np.array([156190.0, 88234.0, 14608.0, 502.0, 1.0]) / 362880.0
"""Covariances of the increments of a unit walk from window to window: quartic B-splines overlap as the ninth-degree one says."""
FLICKER_KNOTS = (2.0, 20.0)
"""Time constants of the processes that flicker is the sum of, in knots of the windows: 0.05 and 0.5 s, 3 and 0.3 Hz, mostly."""

FIRST_WALK, LEAST_WALK = 0.03, 1e-4
"""Times the noise of a sample that the offset walks in a second: where the search begins, and what counts as no walk."""
FIRST_FLICKER, LEAST_FLICKER = 0.03, 1e-3
"""Times the noise of a sample: standard deviation of each of the flicker's processes, likewise."""
FIRST_TREND, LEAST_TREND = 0.01, 1e-3
"""Times the noise of a sample: standard deviation of the trend's first order, likewise."""
SHORTEST_WAVE_AT_REST_S = 5.0
"""Of a trend in rows at rest, which have no inertia that could be taken for it."""
MOST_TREND = 10.0
"""Times `STEP_STD`, at most: 10 N, 0.5 N m."""


@dataclass(frozen=True)
class Drift:
    """What flicker, walk and trend of unit size and jumps of unit variance make of K windows behind a filter.

    Args:
        flicker: (2, b, K), lower bands of the covariances of its processes. walk: (b, K), likewise, in s.
        jumps: (b, K), the same of a unit jump at each pause.
        trend: between which instants it is smooth; `shared`: (K, p), its columns.
    """

    filter: AnnihilatingFilter
    flicker: Array
    walk: Array
    jumps: Array
    trend: Trend
    shared: Array

    def covariance(self, sizes: Array, channel: int) -> WindowCovariance:
        """Of a channel of these sizes (4,): variances of the flicker's processes, N², rate of the walk, variance of the trend."""
        *flicker, walk, trend = sizes
        bands = np.tensordot(flicker, self.flicker, 1) + walk * self.walk + STEP_STD[channel] ** 2 * self.jumps
        return WindowCovariance(np.asarray(bands), np.sqrt(trend) * self.shared)

    @property
    def parts(self) -> tuple[WindowCovariance, ...]:
        """Of unit size, in their order."""
        nothing, zero = self.shared[:, :0], np.zeros((1, len(self.shared)))
        banded = (WindowCovariance(bands, nothing) for bands in (*self.flicker, self.walk))
        return *banded, WindowCovariance(zero, self.shared)


def drift_in(form: WeakForm) -> Drift:
    """The drift in the windows of a recording."""
    if form.static:
        return _drift_of_rows(form.centres)
    trend = Trend(float(form.centres[0]), float(form.centres[-1]))
    knots = np.rint((form.centres - form.centres[0]) / form.spacing)
    filtering = AnnihilatingFilter.of(knots, FLICKER_KNOTS)
    count, seen = BAND + filtering.reach, BAND + 2 * filtering.reach
    lags = _lags(knots, seen)
    walk = filtering.covariance(-0.5 * form.spacing * variogram_of_walk(lags), count)
    walk[:, 0] = 0.0
    flicker = np.stack([filtering.covariance(covariance_of_exponential(lags, each), count) for each in FLICKER_KNOTS])
    starts = form.poses.t[1:][np.diff(form.poses.t) > PAUSE_S]
    part = np.searchsorted(starts, form.centres)
    jumps = _jumps_in(filtering, np.flatnonzero(np.diff(part, prepend=0)), count)
    return Drift(filtering, flicker, walk, jumps, trend, filtering.apply(trend.columns(form.centres)))


def _drift_of_rows(t: Array) -> Drift:
    """Of rows at rest, each a window by itself, at times t (K,): a walk and a trend; flicker is white from row to row, or walks."""
    trend, filtering = Trend(float(t[0]), float(t[-1]), SHORTEST_WAVE_AT_REST_S), AnnihilatingFilter.of(t, ())
    walk = filtering.covariance(-0.5 * _lags(t, 1 + 2 * filtering.reach), 1 + filtering.reach)
    walk[:, 0] = 0.0
    nothing = np.zeros_like(walk)
    return Drift(filtering, np.stack([nothing] * len(FLICKER_KNOTS)), walk, nothing, trend, filtering.apply(trend.columns(t)))


def _lags(knots: Array, count: int) -> Array:
    """(count, K), from each window to the d-th after it, in knots."""
    lags = np.zeros((count, len(knots)))
    for d in range(1, min(count, len(knots))):
        lags[d, :-d] = knots[d:] - knots[:-d]
    return lags


def _jumps_in(filtering: AnnihilatingFilter, at: NDArray[np.intp], count: int) -> Array:
    """(count, K), lower bands of the covariance of what passes of independent unit steps that begin at the windows `at` (n,)."""
    bands = np.zeros((count, filtering.weights.shape[1]))
    for first in at:
        step = filtering.weights[:, first : first + filtering.reach]
        passed = np.array([step[: k + 1, k].sum() for k in range(step.shape[1])])
        for d in range(len(passed)):
            bands[d, first : first + len(passed) - d] += passed[d:] * passed[: len(passed) - d]
    return bands


def variogram_of_walk(lag: Array) -> Array:
    """(...,), variance of the change of a unit walk between two windows, cubic B-splines that are so many knots apart; whole numbers."""
    n, c = np.abs(lag), EULERIAN
    near = sum(2.0 * c[d] * np.maximum(n - d, 0.0) for d in range(1, len(c)))
    return np.asarray(c[0] * n + near)


def covariance_of_exponential(lag: Array, time_constant: float) -> Array:
    """(...,), of a unit Ornstein-Uhlenbeck process in two windows, cubic B-splines, so many knots apart; whole numbers."""
    at, weight = leggauss(8)
    u = np.add.outer(np.arange(-4.0, 4.0), 0.5 + 0.5 * at)
    overlap = 0.5 * weight * cardinal(u, 7)
    table = np.array([(overlap * np.exp(-np.abs(n - u) / time_constant)).sum() for n in range(5)])
    n = np.abs(lag)
    near = table[np.minimum(n, 4.0).astype(int)]
    return np.asarray(near * np.exp(-np.maximum(n - 4.0, 0.0) / time_constant))


def flicker_between_means(length: float, spacing: float) -> Array:
    """(2,), variance of the difference of two neighbouring means over `length` s each of unit flicker, for knots `spacing` s apart."""
    a = length / spacing / np.array(FLICKER_KNOTS)
    fallen = 1.0 - np.exp(-a)
    return np.asarray(2.0 * (2.0 * (a - fallen) - fallen**2) / a**2)


def begin_search(form: WeakForm, noise: WrenchNoise) -> VarianceSearch:
    """Of white noise, flicker, walk and trend.

    White noise is between that of a sample and what correlation between the samples of a hold would make of it: how much of that is flicker
    is found. The holds bound the others, see `WrenchNoise.fastest_walk`.
    """
    variance = noise.std**2
    within = noise.seen_s * noise.fastest_walk * 2.0 / 3.0
    most_flicker = np.zeros((6, len(FLICKER_KNOTS)))
    if not form.static:
        most_flicker = within[:, None] / flicker_between_means(noise.seen_s, form.spacing)
    first_sizes = np.square([*[FIRST_FLICKER] * len(FLICKER_KNOTS), FIRST_WALK, FIRST_TREND])
    least_sizes = np.square([*[LEAST_FLICKER] * len(FLICKER_KNOTS), LEAST_WALK, LEAST_TREND])
    first = np.column_stack((noise.variance, *np.multiply.outer(first_sizes, variance)))
    least = np.column_stack((variance, *np.multiply.outer(least_sizes, variance)))
    return VarianceSearch(first, least, np.column_stack((noise.variance, most_flicker, noise.fastest_walk, (MOST_TREND * STEP_STD) ** 2)))


def variance_between(flicker: Array, walk: Array, noise: Array, t: Array, seen: Array, spacing: float) -> Array:
    """(N, 6), variance of all but the trend at times t (N,) about a straight line between the nearest times at which it was seen (K,).

    Args:
        flicker: (6, 2), variances of its processes. walk: (6,), rate. noise: (6,), spectral density of the white noise that they were
            seen through, N² s: a level that walks is known to `sqrt(rate noise)` where the data end (Kalman's filter at rest).
        spacing: s, of the knots.
    """
    after = np.searchsorted(seen, t)
    since = np.where(after > 0, t - seen[np.maximum(after - 1, 0)], np.inf)
    until = np.where(after < len(seen), seen[np.minimum(after, len(seen) - 1)] - t, np.inf)
    near, far = np.minimum(since, until), np.maximum(since, until)
    forgotten = 1.0 - np.exp(-2.0 * np.divide.outer(near, spacing * np.array(FLICKER_KNOTS)))
    walked = np.multiply.outer(near / (1.0 + near / far), walk) + np.sqrt(walk * noise)
    return np.asarray(walked + forgotten @ flicker.T)


@dataclass(frozen=True)
class Levelled:
    """Unknowns and their covariance with mean offsets, the drift (K, 6) about these, the uncertainty (6,) of its range, and its trend."""

    x: Array
    covariance: Array
    drift: Array
    drift_std: Array
    trend: FoundTrend


def level_offsets(x: Array, covariance: Array, channels: Sequence[Channel], drift: Drift, sizes: Array, offset: slice) -> Levelled:
    """Predicts the drift (best linear unbiased), and moves its mean into the offsets, which are those of the first window.

    Args:
        x, covariance: (m,) and (m, m), of all unknowns, of which the rows `offset` are the six offsets.
        sizes: (6, 4), flicker, walk and trend.
    """
    count, orders = drift.shared.shape
    to_mean, added, x = np.eye(len(x)), np.zeros(len(x)), x.copy()
    moved, spread = np.zeros((count, 6)), np.zeros(6)
    size, of_size = np.zeros((6, orders)), np.zeros((6, orders, orders))
    change = np.zeros((count, 2))
    change[:, 0], change[0, 1], change[-1, 1] = 1.0 / count, -1.0, 1.0
    change = drift.filter.undo_transposed(change)
    for c, channel in enumerate(channels):
        slow, rows, at = drift.covariance(sizes[c], c), channel.rows, offset.start + c
        known = covariance[np.ix_(rows, rows)]
        passed = slow.multiply(channel.factor.solve_transposed(channel.residual[:, None]))
        moved[:, c] = drift.filter.undo(passed)[:, 0]
        mean, mean_left = _predict(channel.factor, slow, change[:, 0])
        last, last_left = _predict(channel.factor, slow, change[:, 1])
        x[at] += moved[:, c].mean()
        to_mean[at, rows] -= mean @ channel.columns
        added[at] = mean_left
        along = last @ channel.columns
        spread[c] = np.sqrt(last_left + along @ known @ along)
        gain = sizes[c, -1] * channel.factor.whiten(drift.shared)
        size[c], missed = gain.T @ channel.residual, gain.T @ channel.columns
        of_size[c] = sizes[c, -1] * np.eye(orders) - gain.T @ gain + missed @ known @ missed.T
    trend = FoundTrend(drift.trend, size, of_size)
    return Levelled(x, to_mean @ covariance @ to_mean.T + np.diag(added), moved - moved.mean(axis=0), spread, trend)


def _predict(factor: Factor, slow: WindowCovariance, weights: Array) -> tuple[Array, float]:
    """The sum of weights (K,) times what passes of the drift: gain (K,) on whitened residuals, and the variance that is left."""
    of_sum = slow.multiply(weights[:, None])
    gain = factor.whiten(of_sum)[:, 0]
    return gain, max(float(weights @ of_sum[:, 0] - gain @ gain), 0.0)
