"""Friction fitted to the torques of a recording's joints, or else to their tracking error, one joint at a time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import pinocchio as pin
from scipy.signal import savgol_filter

from core.array import Array, interpolate
from core.recording.recording import Recording
from core.robot.model import RobotModel

SMOOTHING = 0.1
"""s, window of the Savitzky-Golay filter that every signal goes through alike."""
SPACING = 0.02
"""s, between the rows that are fitted."""
BLOCK = 1.0
"""s, within which residuals may hang together."""
MOVING = 0.02
"""rad/s, above which a joint slides."""
RIDGE = 1e-3
"""Pull of the rigid body's parameters towards the URDF's, as a share of the rows."""
BELOW = 3.0
"""Standard deviations by which friction may seem to give energy."""


@dataclass(frozen=True)
class FrictionSignals:
    """Smoothed, thinned signals (M, n), the rest of the model's columns Y (M, n, ...), and `raw` (N, n) as recorded.

    `signal` is what is left to explain: torque less the URDF's, or tracking error; `spread` (n,) that of the whole.
    """

    period: float
    spread: Array
    raw: Array
    q: Array
    dq: Array
    ddq: Array
    signal: Array
    sign: Array
    Y: Array

    @classmethod
    def of(cls, recording: Recording) -> FrictionSignals | None:
        """None where joints, their kinematics, or both torques and commands are missing, or where there is too little."""
        q, robot = recording.q, recording.robot
        raw = recording.tau
        if raw is None and q is not None and recording.q_cmd is not None:
            raw = recording.q_cmd - q
        if q is None or robot is None or raw is None or len(q) < 50:
            return None
        t = np.linspace(recording.t[0], recording.t[-1], len(q))
        period = float(t[1] - t[0])
        q, signal = interpolate(t, recording.t, q), interpolate(t, recording.t, raw)
        window = min(max(5, 2 * round(0.5 * SMOOTHING / period) + 1), len(q) // 2 * 2 - 1)
        rows = slice(0, None, max(1, round(SPACING / period)))
        dq_full = savgol_filter(q, window, 3, deriv=1, delta=period, axis=0)
        smooth, dq, ddq, sign, signal = (
            x[rows]
            for x in (
                savgol_filter(q, window, 3, axis=0),
                dq_full,
                savgol_filter(q, window, 3, deriv=2, delta=period, axis=0),
                savgol_filter(np.tanh(dq_full / (0.5 * MOVING)), window, 3, axis=0),
                savgol_filter(signal, window, 3, axis=0),
            )
        )
        robot_model = RobotModel(robot)
        model = robot_model.model
        spread = np.asarray(signal.std(axis=0))
        model.gravity.linear = np.asarray(recording.gravity)
        Y = _regressors(model, smooth, dq, ddq)
        if recording.tau is not None:
            signal = signal - Y @ np.concatenate([body.toDynamicParameters() for body in list(model.inertias)[1:]])
        if recording.wrench is not None:
            J = robot_model.sensor_jacobians(smooth).transpose(0, 2, 1)
            W = savgol_filter(interpolate(t, recording.t, recording.wrench), window, 3, axis=0)[rows]
            Y = np.concatenate([Y, J @ W[:, :, None], J], axis=2)
        return cls(period * (rows.step or 1), spread, raw, smooth, dq, ddq, signal, sign, Y)


class FrictionFit(NamedTuple):
    """Coulomb and viscous coefficient of one joint, their covariance, and their columns (M, 2); the signal's offset beside them."""

    friction: Array
    covariance: Array
    columns: Array
    offset: float
    offset_std: float


def _regressors(model: pin.Model, q: Array, dq: Array, ddq: Array) -> Array:
    """(M, n, 10 n)."""
    data = model.createData()
    return np.stack([pin.computeJointTorqueRegressor(model, data, *row).copy() for row in zip(q, dq, ddq, strict=True)])


def fit_joint(run: FrictionSignals, j: int) -> FrictionFit | None:
    """Least squares over the rows in which joint j moves; None where they are too few or the joint goes one way only."""
    rows = np.abs(run.dq[:, j]) > MOVING
    both = min(np.count_nonzero(run.dq[rows, j] > 0), np.count_nonzero(run.dq[rows, j] < 0))
    if np.count_nonzero(rows) < 60 or both < 20:
        return None
    y = run.signal[rows, j]
    friction = np.column_stack([run.sign[rows, j], run.dq[rows, j]])
    X = np.column_stack([friction, run.ddq[rows, j], np.ones(len(y)), run.Y[rows, j]])
    size = np.sqrt(np.mean(X**2, axis=0))
    X = X[:, size > 1e-9] / size[size > 1e-9]
    ridge = np.full(X.shape[1], RIDGE**2 * len(y))
    ridge[:2] = 1e-12
    bread = np.linalg.inv(X.T @ X + np.diag(ridge))
    beta = bread @ (X.T @ y)
    covariance = _estimate_covariance(X, y - X @ beta, bread, np.asarray(np.flatnonzero(rows) * run.period // BLOCK, dtype=np.float64))
    scale = 1.0 / size[:2]
    k = int(np.count_nonzero(size[:3] > 1e-9))  # its column is 1 everywhere
    of_offset = float(beta[k]), float(np.sqrt(covariance[k, k]))
    return FrictionFit(beta[:2] * scale, covariance[:2, :2] * np.outer(scale, scale), friction, *of_offset)


def _estimate_covariance(X: Array, e: Array, bread: Array, block: Array) -> Array:
    """Covariance of a least-squares estimate whose residuals hang together within blocks (sandwich), at least that of independent ones."""
    _, index = np.unique(block, return_inverse=True)
    scores = np.zeros((index.max() + 1, X.shape[1]))
    np.add.at(scores, index, X * e[:, None])
    freedom = len(e) / max(len(e) - X.shape[1], 1)
    groups = len(scores) / max(len(scores) - 1, 1)
    return np.asarray(freedom * (groups * bread @ (scores.T @ scores) @ bread + bread * np.mean(e**2)))


def bound_friction(friction: Array, covariance: Array) -> tuple[Array, Array]:
    """Coefficients (k,) that give no energy, with standard uncertainties (k,): what is below zero within its uncertainty is zero, and the
    others are what they most probably are then; NaN where one is further below zero, for then it is no friction that was fitted."""
    std = np.sqrt(np.diag(covariance))
    if (friction < -BELOW * std).any():
        return np.full_like(friction, np.nan), np.full_like(friction, np.nan)
    value, free = friction.copy(), friction > 0.0
    if free.any() and not free.all():
        of_fixed = covariance[np.ix_(~free, ~free)]
        gain = covariance[np.ix_(free, ~free)] @ np.linalg.inv(of_fixed)
        value[free] -= gain @ friction[~free]
        std[free] = np.sqrt(np.maximum(np.diag(covariance[np.ix_(free, free)] - gain @ covariance[np.ix_(~free, free)]), 0.0))
    return np.maximum(value, 0.0), std


def sigma_of(friction: Array, covariance: Array) -> float:
    """How far coefficients (k,) stand from zero, as standard deviations above chance (Fisher's approximation)."""
    k = len(friction)
    wald = float(friction @ np.linalg.solve(covariance + 1e-15 * np.trace(covariance) * np.eye(k), friction))
    return float(np.sqrt(2.0 * wald) - np.sqrt(2.0 * k - 1.0))


def noise_of(raw: Array, holds: tuple[slice, ...]) -> Array:
    """(n,), of one motionless sample, from the differences of neighbours; of all samples where nothing is at rest."""
    steps = [np.diff(raw[hold], axis=0) for hold in holds if len(raw[hold]) > 2] or [np.diff(raw, axis=0)]
    return np.asarray(1.4826 / np.sqrt(2.0) * np.median(np.abs(np.concatenate(steps)), axis=0))


def tracking_error(recording: Recording) -> Array | None:
    """(n,), r.m.s. of commanded less measured position while a joint moves, rad, 0 for one that does not; None without commands."""
    q, commanded = recording.q, recording.q_cmd
    if q is None or commanded is None:
        return None
    moving = np.abs(np.gradient(q, recording.t, axis=0)) > MOVING
    squares = np.where(moving, (commanded - q) ** 2, 0.0).sum(axis=0)
    return np.asarray(np.sqrt(squares / np.maximum(moving.sum(axis=0), 1)))
