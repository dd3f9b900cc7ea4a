"""How narrow an interval can be: the Cramér-Rao bound of a foreign recording, whose motion, noise and errors are known.

Derivatives of the noise-free wrench by payload, offsets, tilt, delay, gravity and whatever the condition draws are taken numerically on the
exact motion, whitened with the true covariance of the noise. Who has to find the motion from encoders can only do worse.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np
from scipy.linalg import cholesky_banded, solve_banded

from core.array import Array
from core.payload.site import GRAVITY_STD_M_S2
from tests.foreign_arm import rotation_of
from tests.foreign_recordings import GRAVITY, NOISE_STD, RESOLUTION, Condition, Made, Truth, phi_of, wrench_of

STEP = 1e-5
TILT_STD_RAD, DELAY_STD_S = 0.05, 0.02
"""As unknown as the base and the clock are to the engine."""
PHI = 10


def least_std(condition: Condition, made: Made) -> Array | None:
    """(10,), standard uncertainties below which no unbiased estimate gets, NaN where nothing is told; None where not worked out.

    Unknown instants of the samples (jitter) are too many unknowns.
    """
    if condition.jitter_s:
        return None
    truth, rows = made.truth, _rows(condition, made)
    columns, variance = _columns(condition, truth, rows)
    count = _samples_of_holds(truth) if condition.averaged else np.ones(len(rows))
    count = count[count > 0]
    information = np.diag(1.0 / variance)
    ramp = (1.0 - np.exp(-2.0 * rows / rows[-1]))[:, None]
    for c in range(6):
        own = [columns[:, c], np.ones((len(rows), 1)), *([ramp] if condition.drift_n else [])]
        white = _whiten(condition, c, np.hstack(own) * np.sqrt(count)[:, None], rows)
        told = white.T @ white
        # offset, and size of the drift, of this channel alone
        p = len(variance)
        information += told[:p, :p] - told[:p, p:] @ np.linalg.pinv(told[p:, p:]) @ told[p:, :p]
    seen = np.diag(information) > 1e-12
    scale = 1.0 / np.sqrt(np.diag(information)[seen])
    share, directions = np.linalg.eigh(information[np.ix_(seen, seen)] * np.outer(scale, scale))
    known = share > 1e-11
    variance = (directions[:, known] ** 2 / share[known]).sum(axis=1) * scale**2
    std = np.full(len(seen), np.nan)
    std[seen] = np.where((directions[:, ~known] ** 2).sum(axis=1) < 1e-6, np.sqrt(variance), np.nan)
    return std[:PHI]


def _rows(condition: Condition, made: Made) -> Array:
    """(n,), s, of the wrenches that tell something: all of them, or those at rest where nothing is known of the motion."""
    truth = made.truth
    if condition.averaged:
        return np.asarray(truth.path.holds().mean(axis=1)[_samples_of_holds(truth) > 0])
    assert truth.kept is not None
    t = truth.t[truth.kept]
    return t[~truth.path.at(t)[1].any(axis=1)] if condition.poses else t


def _samples_of_holds(truth: Truth) -> Array:
    """(H,), in the mean of each hold."""
    return np.array([((truth.t > begin + 0.1) & (truth.t < end - 0.05)).sum() for begin, end in truth.path.holds()], dtype=float)


def _columns(condition: Condition, truth: Truth, t: Array) -> tuple[Array, Array]:
    """(n, 6, p), change of the wrench with each unknown, and (p,), variance that is known of it before."""
    n, static = truth.arm.n, condition.poses or condition.averaged
    columns = [_of_payload(truth, t, static=static)]
    prior = [np.full(PHI, np.inf)]

    def add(variance: float, *pairs: tuple[Array, Array]) -> None:
        columns.append(np.stack([(after - before) / (2.0 * STEP) for before, after in pairs], axis=2))
        prior.append(np.full(len(pairs), variance))

    def wrench(*, mount: Array | None = None, gravity: Array | None = None) -> Array:
        other = replace(truth, mount=truth.mount if mount is None else mount, gravity=truth.gravity if gravity is None else gravity)
        return _wrench_at(other, t)

    def turned(name: Literal["mount", "gravity"], axis: Array) -> tuple[Array, Array]:
        before, after = rotation_of(-STEP * axis), rotation_of(STEP * axis)
        if name == "mount":
            return wrench(mount=before @ truth.mount), wrench(mount=after @ truth.mount)
        return wrench(gravity=before @ truth.gravity), wrench(gravity=after @ truth.gravity)

    g, axes = truth.gravity, np.eye(3)
    add(TILT_STD_RAD**2, *(turned("gravity", e) for e in axes[:2]))
    add((GRAVITY_STD_M_S2 / float(np.linalg.norm(GRAVITY))) ** 2, (wrench(gravity=g * (1.0 - STEP)), wrench(gravity=g * (1.0 + STEP))))
    if not static:
        add(DELAY_STD_S**2, (_wrench_at(truth, t + STEP), _wrench_at(truth, t - STEP)))
    if condition.zero_std_rad:
        add(condition.zero_std_rad**2, *((_wrench_at(truth, t, -STEP * e), _wrench_at(truth, t, STEP * e)) for e in np.eye(n)))
    if condition.mount_std_rad:
        add(condition.mount_std_rad**2, *(turned("mount", e) for e in axes))
    if condition.gain_std:
        load = _wrench_at(truth, t)
        add(condition.gain_std**2, *((-STEP * load * e, STEP * load * e) for e in np.eye(6)))
    return np.concatenate(columns, axis=2), np.concatenate(prior)


def _of_payload(truth: Truth, t: Array, *, static: bool) -> Array:
    """(n, 6, 10): the wrench is linear in phi, so ten bodies span it."""
    rng = np.random.default_rng(0)
    bodies = [(np.array([1.0, 0.7]), rng.normal(scale=0.3, size=(2, 3))) for _ in range(PHI)]
    felt = np.stack([_wrench_at(replace(truth, masses=m, places=r), t) for m, r in bodies], axis=2)
    found = felt @ np.linalg.inv(np.column_stack([phi_of(m, r) for m, r in bodies]))
    if static:
        found[:, :, 4:] = 0.0
    return np.asarray(found)


def _wrench_at(truth: Truth, t: Array, zeros: Array | float = 0.0) -> Array:
    q, dq, ddq = truth.path.at(t)
    return wrench_of(truth.arm.move(q + zeros, dq, ddq), truth.mount, truth.masses, truth.places, truth.gravity)


def _whiten(condition: Condition, c: int, x: Array, t: Array) -> Array:
    """Columns (n, p) of one channel in the metric of its noise."""
    std = float(np.hypot(NOISE_STD[c], RESOLUTION[c] / np.sqrt(12.0))) if condition.quantised else float(NOISE_STD[c])
    if condition.noise == "ar1":
        return np.vstack((x[:1], (x[1:] - 0.9 * x[:-1]) / np.sqrt(1.0 - 0.81))) / std
    if condition.noise == "pink":
        power = 1.0 / np.maximum(np.arange(len(x) // 2 + 1), 1.0)
        both = np.concatenate((power, power[1 : (len(x) + 1) // 2]))
        spectrum = np.fft.rfft(x, axis=0) / np.sqrt(power)[:, None]
        return np.asarray(np.fft.irfft(spectrum, n=len(x), axis=0) * np.sqrt(both.mean()) / std)
    if condition.walk_n:
        rate = (condition.walk_n * (1.0 if c < 3 else 0.05)) ** 2
        bands = np.vstack((2.0 * std**2 + rate * np.diff(t), np.full(len(t) - 1, -(std**2))))
        factor = cholesky_banded(bands, lower=True)
        return np.asarray(solve_banded((1, 0), factor, np.diff(x, axis=0)))
    return x / std
