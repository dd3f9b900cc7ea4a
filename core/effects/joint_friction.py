"""Friction in the joints: it shows in the joint torques, or else in the tracking error, and never in the wrist's wrench."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray
from scipy.signal import savgol_filter

from core.effects.effect import Finding, Parameter, Symptom, View
from core.recording import Recording
from core.robot import RobotModel

Array = NDArray[np.float64]

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


class JointFriction(Symptom):
    """`tau_j = Y_j(q, dq, ddq) pi + A ddq_j + o + Fc sign(dq_j) + Fv dq_j`, per joint, over the samples in which the joint moves.

    Y is the rigid body's regressor (Atkeson, An, Hollerbach 1986), pi is free up to a weak pull towards the URDF, A the rotor's inertia,
    o the torque sensor's offset. What the wrist sensor feels goes in as `J^T W` with a free factor and offsets, so that a cable
    that rubs on the payload is not taken for friction of the joints.

    Without torques the tracking error `q_cmd - q` stands in their place, which a joint controller makes
    proportional to the torque; only its Coulomb part can be told from a lag then.

    Material when in some joint the friction part (r.m.s. over its moving samples) is above three times the noise of one motionless
    sample and above 2 % of the signal's spread, one of its coefficients stands five standard deviations above zero, and none three
    below it: friction takes energy away.
    """

    id = "joint_friction"
    title = "friction in the joints"
    stage = "actuation"

    def parameters(self, recording: Recording) -> tuple[Parameter, ...]:
        """See `Symptom.parameters`."""
        joints = range(0 if recording.q is None else recording.q.shape[1])
        if recording.tau is None:
            return tuple(Parameter(f"joint_{j + 1}_coulomb_rad", "rad", 0.0, -0.1, 0.1, 0.001) for j in joints)
        kinds = (("coulomb_nm", "N m", 5.0), ("viscous_nms_per_rad", "N m s/rad", 5.0))
        return tuple(Parameter(f"joint_{j + 1}_{name}", unit, 0.0, -1e3, 1e3, scale) for j in joints for name, unit, scale in kinds)

    def observe(self, recording: Recording, view: View) -> Finding | None:
        """See `Symptom.observe`."""
        run = _Run.of(recording)
        if run is None:
            return None
        fits = [_fit(run, j) for j in range(run.q.shape[1])]
        if all(fit is None for fit in fits):
            return None
        noise = _noise(run.raw, view.holds)
        count = 1 if recording.tau is None else 2
        unknown = np.full(count, np.nan)
        theta = np.concatenate([unknown if fit is None else fit.friction[:count] for fit in fits])
        std = np.concatenate([unknown if fit is None else np.sqrt(np.diag(fit.covariance))[:count] for fit in fits])
        sigmas = np.array([0.0 if fit is None else _sigma(fit, count) for fit in fits])
        sizes = np.array([0.0 if fit is None else _size(fit, count) for fit in fits])
        z = np.nan_to_num((theta / std).reshape(-1, count))
        material = (sizes > 3.0 * noise) & (sizes > 0.02 * run.spread) & (z.max(axis=1) > 5.0) & (z.min(axis=1) > -3.0)
        worst = int(np.argmax(np.where(material, sizes / np.maximum(noise, 1e-12), 0.0) if material.any() else sigmas))
        return Finding(theta, std, float(sigmas.max()), bool(material.any()), _sentence(recording, worst, theta, std, count))

    def advice(self, finding: Finding) -> str:
        """See `Symptom.advice`."""
        return (
            "Enter the joints' friction in the cell's twin or compensate it in the controller; "
            "warm the joints up by a few minutes of motion before measuring."
        )


@dataclass(frozen=True)
class _Run:
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
    def of(cls, recording: Recording) -> _Run | None:
        """None where joints, their kinematics, or both torques and commands are missing, or where there is too little."""
        q, robot = recording.q, recording.robot
        raw = recording.tau
        if raw is None and q is not None and recording.q_cmd is not None:
            raw = recording.q_cmd - q
        if q is None or robot is None or raw is None or len(q) < 50:
            return None
        t = np.linspace(recording.t[0], recording.t[-1], len(q))
        period = float(t[1] - t[0])
        q, signal = _at(t, recording.t, q), _at(t, recording.t, raw)
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
            J = np.stack([robot_model.sensor_jacobian(row) for row in smooth]).transpose(0, 2, 1)
            W = savgol_filter(_at(t, recording.t, recording.wrench), window, 3, axis=0)[rows]
            Y = np.concatenate([Y, J @ W[:, :, None], J], axis=2)
        return cls(period * (rows.step or 1), spread, raw, smooth, dq, ddq, signal, sign, Y)


class _Fit(NamedTuple):
    """Coulomb and viscous coefficient of one joint, their covariance, and their columns (M, 2)."""

    friction: Array
    covariance: Array
    columns: Array


def _at(t: Array, recorded: Array, x: Array) -> Array:
    return np.column_stack([np.interp(t, recorded, column) for column in x.T])


def _regressors(model: pin.Model, q: Array, dq: Array, ddq: Array) -> Array:
    """(M, n, 10 n)."""
    data = model.createData()
    return np.stack([pin.computeJointTorqueRegressor(model, data, *row).copy() for row in zip(q, dq, ddq, strict=True)])


def _fit(run: _Run, j: int) -> _Fit | None:
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
    covariance = _clustered(X, y - X @ beta, bread, np.asarray(np.flatnonzero(rows) * run.period // BLOCK, dtype=np.float64))
    scale = 1.0 / size[:2]
    return _Fit(beta[:2] * scale, covariance[:2, :2] * np.outer(scale, scale), friction)


def _clustered(X: Array, e: Array, bread: Array, block: Array) -> Array:
    """Covariance of a least-squares estimate whose residuals hang together within blocks (sandwich), at least that of independent ones."""
    _, index = np.unique(block, return_inverse=True)
    scores = np.zeros((index.max() + 1, X.shape[1]))
    np.add.at(scores, index, X * e[:, None])
    freedom = len(e) / max(len(e) - X.shape[1], 1)
    groups = len(scores) / max(len(scores) - 1, 1)
    return np.asarray(freedom * (groups * bread @ (scores.T @ scores) @ bread + bread * np.mean(e**2)))


def _noise(raw: Array, holds: tuple[slice, ...]) -> Array:
    """(n,), of one motionless sample, from the differences of neighbours; of all samples where nothing is at rest."""
    steps = [np.diff(raw[hold], axis=0) for hold in holds if len(raw[hold]) > 2] or [np.diff(raw, axis=0)]
    return np.asarray(1.4826 / np.sqrt(2.0) * np.median(np.abs(np.concatenate(steps)), axis=0))


def _sigma(fit: _Fit, count: int) -> float:
    """How far the coefficients stand from zero, as standard deviations above chance (Fisher's approximation)."""
    part = fit.covariance[:count, :count]
    wald = float(fit.friction[:count] @ np.linalg.solve(part + 1e-15 * np.trace(part) * np.eye(count), fit.friction[:count]))
    return float(np.sqrt(2.0 * wald) - np.sqrt(2.0 * count - 1.0))


def _size(fit: _Fit, count: int) -> float:
    """r.m.s. of the friction part."""
    return float(np.sqrt(np.mean((fit.columns[:, :count] @ fit.friction[:count]) ** 2)))


def _sentence(recording: Recording, joint: int, theta: Array, std: Array, count: int) -> str:
    k = count * joint
    if recording.tau is None:
        return (
            f"Joint {joint + 1} lags its command by {1e3 * theta[k]:.2f} +- {1e3 * std[k]:.2f} mrad in the direction of motion: "
            "Coulomb friction in the tracking error."
        )
    return (
        f"Joint {joint + 1} rubs with {theta[k]:.2f} +- {std[k]:.2f} N m (Coulomb) and "
        f"{theta[k + 1]:.2f} +- {std[k + 1]:.2f} N m s/rad (viscous)."
    )
