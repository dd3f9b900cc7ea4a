"""Payload, arm, friction, gains and offsets from the windowed torques: generalised least squares with restricted likelihood.

Solved is, for the windowed torques y and what `core.estimation.joint_torques.unknowns` predicts of them,

    min over b of  sum over joints |y_j - f_j(b)|^2 in the metric C_j^-1  +  b^T P^-1 b,

by Gauss-Newton. The noise C_j of each joint and the strengths in P of what has no stated size maximise the restricted likelihood of the
linearised problem, one at a time (Harville 1977, J. Am. Stat. Assoc. 72).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cho_factor, cho_solve
from scipy.optimize import minimize
from scipy.special import ndtri, stdtrit

from core.array import Array
from core.estimation.joint_torques.noise import TorqueNoise, whiten_torques
from core.estimation.joint_torques.unknowns import LATE_STD_S, PHI, SOURCES, TorqueModel
from core.estimation.joint_torques.windows import LONGEST_LATE_S

STEPS = 20
NOISE_STEPS = 4
"""Of these: in which the noise is searched for anew."""
STRENGTH_STEPS = 10
DAMPING = 0.5
"""Of a step, once the noise is known: weights of single windows would go to and fro."""
SETTLED = 0.1
"""Of its standard deviation: what the payload may still move by."""
FLAT = 1e-10
"""Precision of the payload's prior, per square of its units: none."""
LEAST_SEEN = 1e-3
BLOCK_S = 12.5
"""Of a recording, and of one joint: what is taken together where the spread is seen, long because a sensor that is not quite linear or a
hose errs alike whenever the motion comes by."""
FEWEST_BLOCKS = 12
OUTLYING = 4.0
"""Standard deviations of its joint's noise from which a window weighs less (Huber)."""


@dataclass(frozen=True)
class JointRows:
    """Rows of one joint, those of all recordings after each other: times (K,), measured less predicted (K,), derivative (K, size)."""

    t: Array
    off: Array
    J: Array


@dataclass(frozen=True)
class TorqueFit:
    """The solution.

    Args:
        b: all unknowns; `late_s`: by how much the torques of each recording are late.
        covariance: of b.
        repeatability: (10, 10), of the payload by noise and by what changes from recording to recording.
        directions: name of each source -> (10, k), what one standard deviation of each of its causes does to the payload.
        strengths: name of a group -> variance of its prior in units of what it was taken for.
        noise: of each joint; None of one that has no usable windows.
        rows: of each joint, how many windows were used.
        outlying: share of the windows that weigh less because nothing explains them.
        residual: (n,), root mean square of what is left in each joint, N m.
    """

    b: Array
    covariance: Array
    late_s: Array
    late_std_s: Array
    repeatability: Array
    directions: dict[str, Array]
    strengths: dict[str, float]
    noise: tuple[TorqueNoise | None, ...]
    rows: tuple[int, ...]
    outlying: float
    residual: Array
    converged: bool

    @property
    def phi(self) -> Array:
        """(10,), of the payload."""
        return self.b[PHI]


class TorqueSolver:
    """Gauss-Newton on one model."""

    def __init__(self, model: TorqueModel) -> None:
        self.model = model
        self.b = np.zeros(model.size)
        self.late_s = np.zeros(len(model.recorded))
        self.strength = np.ones(model.size)
        self.noise: list[TorqueNoise | None] = [None] * model.n
        self.weight: list[Array] = [np.ones(0)] * model.n

    def solve(self) -> TorqueFit:
        """Iterates until the payload rests."""
        converged = False
        for step in range(STEPS):
            joints = self._linearise()
            if step == 0:
                self._start_noise(joints)
            self._weigh(joints)
            self._improve(joints, noise=step < NOISE_STEPS)
            b, covariance = self._solve_linear(joints)
            moved = b[PHI] - self.b[PHI]
            self.b = b if step < NOISE_STEPS else self.b + DAMPING * (b - self.b)
            self.late_s = np.clip(self.late_s + LATE_STD_S * self.b[self.model.groups["late"].rows], -LONGEST_LATE_S, LONGEST_LATE_S)
            std = np.sqrt(np.maximum(np.diag(covariance)[PHI], 1e-300))
            if step > 2 and (np.abs(moved) < SETTLED * std).all():
                converged = True
                break
        return self._finish(joints, covariance, converged)

    def _linearise(self) -> list[JointRows]:
        """Rows of each joint about the last solution, its own delay being in the torques."""
        b = self.b.copy()
        b[self.model.groups["late"].rows] = 0.0
        predicted = self.model.evaluate(b)
        measured = [each.windows.torques(float(late)) for each, late in zip(self.model.recorded, self.late_s, strict=True)]
        joints = []
        for j in range(self.model.n):
            parts = []
            for each, y, (f, J) in zip(self.model.recorded, measured, predicted, strict=True):
                use = each.windows.usable[:, j]
                off = y[use, j] - f[use, j] + J[use, j] @ b
                parts.append((each.windows.t[use], off, J[use, j]))
            t, off, J = (np.concatenate(column) for column in zip(*parts, strict=True))
            joints.append(JointRows(t, off, J))
        return joints

    def _start_noise(self, joints: list[JointRows]) -> None:
        """A tenth of what each torque spans, shared by both kinds."""
        for j, rows in enumerate(joints):
            if len(rows.t):
                size = 0.02 * max(float(np.ptp(rows.off)), 1e-3)
                self.noise[j] = TorqueNoise(size, size, 1.0)
            self.weight[j] = np.ones(len(rows.t))

    def _weigh(self, joints: list[JointRows]) -> None:
        """Windows that are far off weigh less, from the second pass on."""
        for j, rows in enumerate(joints):
            noise = self.noise[j]
            if noise is None or not self.b.any():
                continue
            off = np.abs(rows.off - rows.J @ self.b) / max(noise.std, 1e-12)
            self.weight[j] = np.minimum(1.0, OUTLYING / np.maximum(off, 1e-12))

    def _whiten_joint(self, joints: list[JointRows], j: int, noise: TorqueNoise) -> tuple[Array, Array, float]:
        """Derivative and measured of one joint as independent rows of unit variance; half the logarithm of the determinant."""
        rows = joints[j]
        columns = np.column_stack((rows.J, rows.off)) * self.weight[j][:, None]
        white, half = whiten_torques(columns, rows.t, noise)
        return white[:, :-1], white[:, -1], half

    @property
    def _precision(self) -> Array:
        prior = 1.0 / self.strength
        prior[PHI] = FLAT
        return prior

    def _system(self, joints: list[JointRows]) -> list[tuple[Array, Array]]:
        """Normal matrix and right side of each joint."""
        parts = []
        for j in range(self.model.n):
            noise = self.noise[j]
            if noise is None:
                parts.append((np.zeros((self.model.size, self.model.size)), np.zeros(self.model.size)))
                continue
            X, y, _ = self._whiten_joint(joints, j, noise)
            parts.append((X.T @ X, X.T @ y))
        return parts

    def _improve(self, joints: list[JointRows], *, noise: bool) -> None:
        """One round of the restricted likelihood: the noise of every joint, then the strengths."""
        parts = self._system(joints)
        A, c = np.sum([part[0] for part in parts], axis=0) + np.diag(self._precision), np.sum([part[1] for part in parts], axis=0)
        for j, before in enumerate(self.noise):
            if before is None or not noise:
                continue
            found = self._improve_noise(joints, j, before, A - parts[j][0], c - parts[j][1])
            X, y, _ = self._whiten_joint(joints, j, found)
            A, c = A + X.T @ X - parts[j][0], c + X.T @ y - parts[j][1]
            self.noise[j], parts[j] = found, (X.T @ X, X.T @ y)
        for _ in range(STRENGTH_STEPS):
            b, covariance = self._solve_parts(parts)
            for group in self.model.groups.values():
                if group.most > 1.0:
                    rows, old = group.rows, float(self.strength[group.rows.start])
                    seen = rows.stop - rows.start - float(np.trace(covariance[rows, rows])) / old
                    if seen > LEAST_SEEN:
                        self.strength[rows] = np.clip(b[rows] @ b[rows] / seen, group.least, group.most)

    def _improve_noise(self, joints: list[JointRows], j: int, noise: TorqueNoise, A: Array, c: Array) -> TorqueNoise:
        """The noise of joint j that maximises the restricted likelihood, the others' information (A, c) being what it is."""
        rows = joints[j]
        mine = np.flatnonzero(np.abs(rows.J).max(axis=0) > 0.0)
        A, c = _eliminate(A, c, mine)
        columns = np.column_stack((rows.J[:, mine], rows.off)) * self.weight[j][:, None]
        floor = 1e-4 * max(float(np.std(rows.off)), 1e-9)

        def unlikelihood(x: Array) -> float:
            tried = TorqueNoise.of_logarithms(x).with_floor(floor)
            white, half = whiten_torques(columns, rows.t, tried)
            X, y = white[:, :-1], white[:, -1]
            factor = cho_factor(A + X.T @ X, lower=True, check_finite=False)
            right = c + X.T @ y
            fits = float(y @ y - right @ cho_solve(factor, right, check_finite=False))
            return half + float(np.log(np.diag(factor[0])).sum()) + 0.5 * fits + tried.penalty

        start = noise.to_logarithms(floor)
        simplex = np.vstack((start, start + 0.5 * np.eye(3)))
        found = minimize(
            unlikelihood, start, method="Nelder-Mead", options={"initial_simplex": simplex, "maxfev": 50, "xatol": 0.05, "fatol": 0.05}
        )
        return TorqueNoise.of_logarithms(found.x).with_floor(floor)

    def _solve_linear(self, joints: list[JointRows]) -> tuple[Array, Array]:
        return self._solve_parts(self._system(joints))

    def _solve_parts(self, parts: list[tuple[Array, Array]]) -> tuple[Array, Array]:
        A = np.sum([part[0] for part in parts], axis=0) + np.diag(self._precision)
        scale = 1.0 / np.sqrt(np.diag(A))
        covariance = cho_solve(cho_factor(A * np.outer(scale, scale), lower=True), np.eye(len(A))) * np.outer(scale, scale)
        right = np.sum([part[1] for part in parts], axis=0)
        late = self.model.groups["late"].rows
        right[late] -= self.late_s / LATE_STD_S * self._precision[late]  # what the torques are shifted by already counts, too
        return covariance @ right, covariance

    def _find_repeatability(self, joints: list[JointRows], covariance: Array, expected: Array) -> Array:
        """(10, 10), of the payload by this recording alone: what the noise makes of it, and what the blocks of the recording disagree by.

        What no model of the noise holds shows as blocks that pull in different directions (Liang & Zeger 1986, Biometrika 73). There the
        covariance is widened to what they show, never narrowed.
        """
        pulls = []
        for j, noise in enumerate(self.noise):
            if noise is None:
                continue
            X, y, _ = self._whiten_joint(joints, j, noise)
            score = X * (y - X @ self.b)[:, None]
            block = np.cumsum(np.diff(joints[j].t, prepend=joints[j].t[0]) < 0.0) * 10**6 + joints[j].t // BLOCK_S
            pulls += [score[block == each].sum(axis=0) for each in np.unique(block)]
        change = np.array(pulls) @ covariance[:, PHI]
        count = len(change)
        student = float(stdtrit(max(count - 10, 1), 0.975) / ndtri(0.975))
        return expected if count <= FEWEST_BLOCKS else _widen(expected, student**2 * count / (count - 10.0) * change.T @ change)

    def _finish(self, joints: list[JointRows], covariance: Array, converged: bool) -> TorqueFit:
        groups = self.model.groups
        directions: dict[str, Array] = {}
        for name, source in SOURCES.items():
            rows = groups[name].rows
            part = covariance[PHI, rows] / np.sqrt(self.strength[rows])
            directions[source] = np.hstack((directions.get(source, np.zeros((10, 0))), part))
        typed = sum((part @ part.T for part in directions.values()), start=np.zeros((10, 10)))
        late = groups["late"].rows
        residual = np.array([_rms(rows.off - rows.J @ self.b) for rows in joints])
        weights = np.concatenate(self.weight)
        return TorqueFit(
            b=self.b,
            covariance=covariance,
            late_s=self.late_s,
            late_std_s=LATE_STD_S * np.sqrt(np.diag(covariance)[late]),
            repeatability=self._find_repeatability(joints, covariance, covariance[PHI, PHI] - typed),
            directions=directions,
            strengths={name: float(self.strength[group.rows.start]) for name, group in groups.items() if group.most > 1.0},
            noise=tuple(self.noise),
            rows=tuple(len(rows.t) for rows in joints),
            outlying=float(np.mean(weights < 1.0)) if len(weights) else 0.0,
            residual=residual,
            converged=converged,
        )


def _widen(covariance: Array, seen: Array) -> Array:
    """A covariance (10, 10), in every direction at least what is seen in it."""
    scale = np.sqrt(np.maximum(np.diag(covariance), 1e-300))
    root = np.linalg.cholesky(covariance / np.outer(scale, scale) + 1e-9 * np.eye(len(scale)))
    inverse = np.linalg.inv(root) / scale
    values, vectors = np.linalg.eigh(inverse @ seen @ inverse.T)
    back = scale[:, None] * root @ vectors
    return np.asarray((back * np.maximum(values, 1.0)) @ back.T)


def _eliminate(A: Array, c: Array, kept: NDArray[np.intp]) -> tuple[Array, Array]:
    """Normal matrix and right side of the kept unknowns, the others being free."""
    others = np.setdiff1d(np.arange(len(A)), kept)
    scale = 1.0 / np.sqrt(np.diag(A)[others])
    factor = cho_factor(A[np.ix_(others, others)] * np.outer(scale, scale), lower=True)
    passed = scale[:, None] * cho_solve(factor, scale[:, None] * A[np.ix_(others, kept)])
    return A[np.ix_(kept, kept)] - A[np.ix_(kept, others)] @ passed, c[kept] - passed.T @ c[others]


def _rms(x: Array) -> float:
    return float(np.sqrt(np.mean(x**2))) if len(x) else float("nan")
