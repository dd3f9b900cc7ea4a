"""The equations of motion averaged over windows: Eq. (2) without a smoothed derivative anywhere.

Multiply Eq. (1) by a window w and sum over time. The wrench and the raw second differences of the pose go through the *same* window,
so that there is neither lag nor smoothing bias (not even at the corners of a trapezoid), and because the sum is linear the window
damps the noise of the second differences as if its own second derivative had been applied to the pose (summation by parts; Shinbrot
1957, modulating functions). The windows are cubic B-splines: the whole set projects both sides on splines of knot spacing `SPACING_S`.

With `A = R^T p''` and `B = R^T R''` (sensor axes) Eq. (1) reads `f = m (A - g) + B mc`, `tau = mc x (A - g) + I alpha + omega x I omega`
where `alpha` is the axial vector of B and `omega omega^T - omega^2 1` its symmetric part.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array, diags_array

from core.array import Array
from core.estimation.banded import bands_of
from core.estimation.jitter import find_jittered
from core.estimation.kinematics import Poses, axial, smooth_rotation
from core.estimation.lost_rows import fill_lost_rows
from core.estimation.pose_gram import PoseGram
from core.estimation.splines import cubic_pieces, cubic_slopes
from core.payload.inertia import inertia_columns, symmetric
from core.payload.rotations import cross, rotation_of, skew

SPACING_S = 0.05
"""Between windows, at least: they show up to 8 Hz or so. What a payload asks for is slower; above it every arm swings on its gears in a way
that no model of it predicts to the noise."""
LEAST_SPACING_PERIODS = 8.0
"""The same in periods of the recording: slow ones have wider windows, of 100 Hz 80 ms."""
MOST_WINDOWS = 40_000
"""Half an hour with that spacing: longer recordings have wider windows, of an hour 0.09 s, up to 4.5 Hz."""
MARGIN_S = 0.06
"""Largest delay that the windows can be shifted by."""
SAME_DELAY_S = 1e-7
"""Two delays that differ by less see the same."""


@dataclass(frozen=True)
class Features:
    """What the regressor is linear in, averaged over the windows: (K, ...) each, sensor axes.

    Args:
        a: (K, 3), acceleration of the sensor origin.
        base: (K, 3, 3), R^T, which turns gravity of the base frame into the sensor's.
        B: (K, 3, 3), `R^T R''`.
        gravity: (3,), nominal, base frame.
    """

    a: Array
    base: Array
    B: Array
    gravity: Array

    def less(self, other: Features, step: float) -> Features:
        """Difference quotient of two: what the regressor is linear in may be subtracted."""
        return Features((self.a - other.a) / step, (self.base - other.base) / step, (self.B - other.B) / step, self.gravity)

    def turn(self, rotation: Array) -> Features:
        """The same motion of a sensor that is turned by a rotation (3, 3) in its mounting."""
        return Features(self.a @ rotation, rotation.T @ self.base, rotation.T @ self.B @ rotation, self.gravity)

    def regressor(self, tilt: Array) -> Array:
        """V (K, 6, 10) for gravity turned by the base tilt (2,), rad."""
        return regressor_of(self._against_gravity(tilt), self.B)

    def wrench(self, tilt: Array, phi: Array) -> Array:
        """(K, 6), `regressor(tilt) @ phi`, in a tenth of the time."""
        return wrench_of(self._against_gravity(tilt), self.B, phi)

    def tilt_columns(self, phi: Array, tilt: Array) -> Array:
        """Change of the wrench (K, 6, 2) per radian of base tilt."""
        axes = tilt_axes(self.gravity)
        v = axes @ tilt
        g = rotation_of(v) @ self.gravity
        zero = np.zeros_like(self.B)
        # to first order in the tilt a change of the rotation vector by e turns by e + v x e / 2
        change = [np.cross(e + 0.5 * np.cross(v, e), g) for e in axes.T]
        return np.stack([wrench_of(-self.base @ dg, zero, phi) for dg in change], axis=-1)

    def _against_gravity(self, tilt: Array) -> Array:
        """(K, 3), acceleration less gravity turned by the base tilt (2,), rad."""
        return self.a - self.base @ (rotation_of(tilt_axes(self.gravity) @ tilt) @ self.gravity)


def regressor_of(b: Array, B: Array) -> Array:
    """V (K, 6, 10) from `b = a - g` (K, 3) and `B = R^T R''` (K, 3, 3)."""
    V = np.zeros((len(b), 6, 10))
    V[:, :3, 0] = b
    V[:, :3, 1:4] = B
    V[:, 3:, 1:4] = -skew(b)
    V[:, 3:, 4:] = (B.reshape(-1, 9) @ _TORQUE_OF_B).reshape(-1, 3, 6)
    return V


def wrench_of(b: Array, B: Array, phi: Array) -> Array:
    """(K, 6), `regressor_of(b, B) @ phi`."""
    m, mc = phi[0], phi[1:4]
    force = m * b + B @ mc
    torque = cross(mc, b) + B.reshape(-1, 9) @ (_TORQUE_OF_B.reshape(9, 3, 6) @ phi[4:])
    return np.hstack((force, torque))


def _torque_columns(B: Array) -> Array:
    """(K, 3, 6), of the torque, for the moments of inertia."""
    S = 0.5 * (B + np.swapaxes(B, 1, 2))
    return np.asarray(inertia_columns(axial(B)) - 2.0 * np.moveaxis(axial(S[:, None] @ symmetric(np.eye(6))), 1, 2))


_TORQUE_OF_B = _torque_columns(np.eye(9).reshape(9, 3, 3)).reshape(9, 18)
"""They are linear in B."""


def tilt_axes(gravity: Array) -> Array:
    """(3, 2), base axes x and y made orthogonal to gravity: a rotation about gravity cannot be seen."""
    down = gravity / np.linalg.norm(gravity)
    order = np.argsort(np.abs(down), kind="stable")[:2]
    axes = np.eye(3)[:, np.sort(order)]
    return np.asarray(axes - np.outer(down, down @ axes))


class RawFeatures:
    """Second differences of the poses, sample by sample: far too noisy to look at, without bias once they are averaged.

    Attributes: `a` (N, 3), acceleration of the sensor origin; `B` (N, 3, 3), `R^T R''`; `difference` (N, N), the operator.

    Args:
        difference: of other poses at the same times, where there are any.
    """

    def __init__(self, poses: Poses, difference: csr_array | None = None) -> None:
        n = len(poses.t)
        self.difference = second_difference(poses.t) if difference is None else difference
        apart = smooth_rotation(poses)
        self.B = np.einsum("nji,njk->nik", apart, (self.difference @ poses.rotation.reshape(n, 9)).reshape(-1, 3, 3))
        self.a = np.zeros((n, 3))
        if poses.position is not None:
            self.a = np.einsum("nji,nj->ni", apart, self.difference @ poses.position)


class WeakForm:
    """Windows over a recording.

    Attributes: `poses`, where the recorder has lost rows with those that were filled in.

    Args:
        poses: of all samples.
        still_only: rows of averaged or motionless samples; each row is then a window of its own and nothing moves.
        within: (N,), the samples that windows may touch; all where absent.
    """

    def __init__(self, poses: Poses, *, still_only: NDArray[np.bool_] | None = None, within: NDArray[np.bool_] | None = None) -> None:
        self.static = still_only is not None
        self._filled = None if self.static else fill_lost_rows(poses.t)
        if self._filled is not None:
            poses = poses.fill(self._filled)
            within = None if within is None else within[self._filled.before]
        self.poses = poses
        self._within = np.ones(len(poses.t), dtype=bool) if within is None else within
        t = poses.t
        if still_only is not None:
            self._rows = np.flatnonzero(still_only)
            self.centres = t[self._rows]
        else:
            self._step = max(SPACING_S, LEAST_SPACING_PERIODS * poses.period, len(t) * poses.period / MOST_WINDOWS)
            self.centres = self._centres(t)
        self._samples = self._samples_of(poses)
        self._features: tuple[Features, Features] | None = None
        self._delay = 0.0

    def _samples_of(self, poses: Poses, difference: csr_array | None = None) -> Array:
        """(N, 21), what the windows average: acceleration, R^T and `R^T R''`."""
        base = np.swapaxes(poses.rotation, 1, 2).reshape(-1, 9)
        if self.static:
            return np.concatenate((np.zeros((len(base), 3)), base, np.zeros((len(base), 9))), axis=1)
        raw = RawFeatures(poses, difference)
        return np.concatenate((raw.a, base, raw.B.reshape(-1, 9)), axis=1)

    def __len__(self) -> int:
        return len(self.centres)

    @property
    def spacing(self) -> float:
        """s, of the knots; the windows stand on them."""
        return self._step

    def _centres(self, t: Array) -> Array:
        """Centres of the windows that lie inside the recording, with room for a delay, and hold no gap."""
        first, last = t[0] + MARGIN_S, t[-1] - MARGIN_S
        self._first = first
        count = max(0, int(np.floor((last - first) / self._step)) - 3)
        centres = first + self._step * (2 + np.arange(count))
        gaps = np.flatnonzero(np.diff(t) > 4.0 * self.poses.period)
        reach = 2.0 * self._step + MARGIN_S + 3.0 * self.poses.period
        keep = np.ones(count, dtype=bool)
        barred = [(t[k], t[k + 1]) for k in gaps] + [(t[part][0], t[part][-1]) for part in _runs(~self._within)]
        for start, stop in barred:
            keep &= (centres < start - reach) | (centres > stop + reach)
        self._kept = keep
        return np.asarray(centres[keep])

    def _windows(self, t: Array, delay: float, derivative: bool = False) -> csr_array:
        """(K, N) weights on samples at times t (N,) of the windows shifted by `-delay`; or their derivative by the delay."""
        u = (t + delay - self._first) / self._step
        knot = np.floor(u).astype(np.intp)
        weights = np.gradient(t)[:, None] / self._step * (cubic_slopes(u - knot) / self._step if derivative else cubic_pieces(u - knot))
        window = knot[:, None] - np.arange(4)
        row = np.where(self._kept, np.cumsum(self._kept) - 1, -1)
        row = np.concatenate(([-1, -1, -1], row, [-1, -1, -1]))[np.clip(window + 3, 0, len(row) + 5)]
        inside = row >= 0
        places = row[inside], np.broadcast_to(np.arange(len(t))[:, None], row.shape)[inside]
        return csr_array((weights[inside], places), shape=(len(self), len(t)))

    def average(self, x: Array) -> Array:
        """Windowed means (K, n) of samples (N, n)."""
        if self.static:
            return x[self._rows]
        W = self._windows(self.poses.t, 0.0)
        return np.asarray((W @ self._fill(x)) / (W.sum(axis=1))[:, None])

    def _fill(self, x: Array) -> Array:
        return x if self._filled is None else np.asarray(self._filled.fill @ x)

    def _on_measured(self, W: csr_array) -> csr_array:
        """Weights (K, M) on all rows as weights (K, N) on those that were measured."""
        return W if self._filled is None else csr_array(W @ self._filled.fill)

    def features(self, delay: float) -> tuple[Features, Features]:
        """Features at the times `centres - delay`, and their derivative by the delay; those of before where it has hardly changed."""
        if self._features is None or abs(delay - self._delay) > SAME_DELAY_S:
            self._features, self._delay = self._find_features(delay), delay
        return self._features

    def _find_features(self, delay: float) -> tuple[Features, Features]:
        gravity = self.poses.gravity
        if self.static:
            values = self._samples[self._rows]
            return _features(values, gravity), _features(np.zeros_like(values), gravity)
        W, dW = self._windows(self.poses.t, delay), self._windows(self.poses.t, delay, derivative=True)
        total = np.asarray(W.sum(axis=1))[:, None]
        rate = np.asarray(dW @ self._samples) / total
        return _features(np.asarray(W @ self._samples) / total, gravity), _features(rate, gravity)

    def features_of(self, t: Array, others: Iterable[Poses], delay: float) -> Iterator[Features]:
        """Features of other poses, all at some of the recording's times t, in the same windows at `centres - delay`."""
        if self.static:
            yield from (_features(self._samples_of(poses)[self._rows], poses.gravity) for poses in others)
            return
        W = self._windows(t, delay)
        W = csr_array(diags_array(1.0 / np.asarray(W.sum(axis=1))) @ W)
        difference = second_difference(t)
        yield from (_features(np.asarray(W @ self._samples_of(poses, difference)), poses.gravity) for poses in others)

    @cached_property
    def gram(self) -> tuple[Array, PoseGram]:
        """Covariances of the windowed noise: lower bands (5, K) for white noise of unit variance in the wrench, and that of the poses."""
        noise = self.poses.noise
        if self.static:
            return np.ones((1, len(self))), PoseGram(noise, np.zeros((1, len(self))), None)
        W = self._windows(self.poses.t, 0.0)
        W = csr_array(diags_array(1.0 / np.asarray(W.sum(axis=1))) @ W)
        difference = second_difference(self.poses.t)
        second, measured = self._on_measured(csr_array(W @ difference)), self._on_measured(W)
        jittered = [csr_array(W @ each) for each in find_jittered(self.poses, difference, self._filled)]
        return bands_of(measured @ measured.T), PoseGram.of(noise, second, jittered)


def second_difference(t: Array) -> csr_array:
    """(N, N) matrix of second derivatives of the quartics through five samples each (Fornberg 1988); zero rows at the ends.

    Three samples average the acceleration over two periods, which the wrench is not: at 100 Hz that is a tenth of a percent of inertia.
    """
    n = len(t)
    if n < 5:
        return csr_array((n, n))
    rows = np.arange(2, n - 2)
    beside = rows[:, None] + np.arange(-2, 3)
    step = 0.25 * (t[rows + 2] - t[rows - 2])
    away = (t[beside] - t[rows, None]) / step[:, None]
    weights = np.zeros_like(away)
    for j in range(5):
        others = np.delete(away, j, axis=1)
        pairs = others.sum(axis=1) ** 2 - (others**2).sum(axis=1)  # twice the sum of their products in pairs
        weights[:, j] = pairs / (away[:, j, None] - others).prod(axis=1)
    return csr_array(((weights / step[:, None] ** 2).ravel(), (np.repeat(rows, 5), beside.ravel())), shape=(n, n))


def _runs(flags: NDArray[np.bool_]) -> list[slice]:
    """Stretches of True."""
    edges = np.flatnonzero(np.diff(flags.astype(int), prepend=0, append=0))
    return [slice(a, b) for a, b in edges.reshape(-1, 2)]


def _features(values: Array, gravity: Array) -> Features:
    return Features(values[:, :3], values[:, 3:12].reshape(-1, 3, 3), values[:, 12:].reshape(-1, 3, 3), gravity)
