"""Algorithms 1-5: mass and first moment from motionless samples, moments of inertia from rotations about one axis.

Each exists as a recursion, for use on line, and in a batch; both give the same numbers. The raw wrench goes in, and the offsets of Eq. (5),
which are known only after opposed poses, are taken out of the *result*: the regression is linear, so it is done for the response and for
unit offsets side by side.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.segments import ALONG_AXIS
from core.estimation.uncertainty import gain, inertia_uncertainty, one_sigma, propagate_covariance
from core.payload.inertia import Motion
from core.payload.rotations import skew

DIFFUSE = 100.0
"""Variance of the parameters before the first sample, SI."""
INERTIA_OF_AXIS = (4, 7, 9)
"""Places of Ixx, Iyy, Izz in Phi."""


@dataclass(frozen=True)
class Thresholds:
    """The paper's epsilon, from the noise of the kinematics.

    Args:
        still: epsilon_s, for angular (rad/s) and linear (m/s) velocity.
        fast: epsilon_1, rad/s2, from which an axis counts as accelerating.
        slow: epsilon_2, rad/s2, below which it counts as not accelerating.
        in_place: m/s, up to which the sensor origin counts as staying where it is: Eq. (4) holds for pure rotations only.
    """

    still: tuple[float, float]
    fast: float
    slow: float
    in_place: float = 0.02

    @classmethod
    def of_noise(cls, omega_std: float, velocity_std: float, alpha_std: float) -> Thresholds:
        """Six standard deviations keep a robot that is still; an acceleration counts when its noise is below 2 %."""
        return cls((6.0 * omega_std, 6.0 * velocity_std), 50.0 * alpha_std, 10.0 * alpha_std)

    def find_rotation_axis(self, g: Array, v: Array, alpha: Array) -> int | None:
        """Line 5 of Algorithms 3-5 for one sample, (3,) each: the one axis that accelerates; None if none, or more than one, does.

        What Eq. (4) presupposes is asked for too: that axis lies along gravity, and the sensor origin stays in place.
        """
        size = np.abs(alpha)
        axis = int(np.argmax(size))
        if size[axis] <= self.fast or size[axis - 1] >= self.slow or size[axis - 2] >= self.slow:
            return None
        along = abs(g[axis]) > ALONG_AXIS * float(np.sqrt(g @ g))
        return axis if along and v @ v < self.in_place**2 else None

    def find_rotation_rows(self, motion: Motion, speed: Array, axis: int) -> NDArray[np.bool_]:
        """The same for all rows and one axis; `speed` (N,) of the sensor origin."""
        size = np.abs(motion.alpha)
        others = [i for i in range(3) if i != axis]
        along = np.abs(motion.g[:, axis]) > ALONG_AXIS * np.linalg.norm(motion.g, axis=1)
        fast = (size[:, axis] > self.fast) & (size[:, others] < self.slow).all(axis=1)
        return np.asarray(fast & along & (speed < self.in_place))


class RecursiveLeastSquares:
    """`regress` of the paper, sample by sample, with the covariance of Eq. (8).

    Args:
        size: number of parameters.
        columns: number of responses solved for side by side.
        variance: (r,), of the response's rows.
    """

    def __init__(self, size: int, columns: int, variance: Array) -> None:
        self.psi = np.zeros((size, columns))
        self.covariance = DIFFUSE * np.eye(size)
        self.variance = variance
        self.count = 0

    def update(self, regr: Array, resp: Array) -> None:
        """Takes one sample: regr (r, size) and resp (r, columns)."""
        K = gain(self.covariance, regr, self.variance)
        self.covariance = propagate_covariance(self.covariance, regr, K)
        self.psi += K @ (resp - regr @ self.psi)
        self.count += 1


def regress(regr: Array, resp: Array, variance: Array) -> tuple[Array, Array]:
    """The batch: stacked regr (N, r, n) and resp (N, r, c) -> parameters (n, c) and their covariance (n, n)."""
    weighted = regr / variance[:, None]
    information = np.einsum("kri,krj->ij", weighted, regr)
    right = np.einsum("kri,krc->ic", weighted, resp)
    covariance = np.linalg.inv(information + np.eye(regr.shape[2]) / DIFFUSE)
    return covariance @ right, np.asarray(covariance)


@dataclass(frozen=True)
class Decoupled:
    """What Algorithms 1-5 have found, for the raw response and for unit offsets.

    Args:
        mass, first_moment: parameters (n, 4) and covariance, columns `[raw, three unit offsets]`; None before the first motionless sample.
        inertia: for each axis the pair `[raw, unit offset]` (2,), or None.
        alpha_reference: (3,), rms of the angular acceleration used for each axis, rad/s2.
    """

    mass: tuple[Array, Array] | None
    first_moment: tuple[Array, Array] | None
    inertia: tuple[Array | None, Array | None, Array | None]
    alpha_reference: Array

    def parameters(self, offset: Array, *, torque_std: Array, alpha_std: float) -> tuple[Array, Array]:
        """Phi and its standard deviation (10,), NaN where not identified.

        Args:
            offset: (6,), Eq. (5); NaN where unknown.
            torque_std: (3,), of one sample. `alpha_std`: rad/s2.
        """
        phi, std = np.full(10, np.nan), np.full(10, np.nan)
        for rows, found, o in ((slice(0, 1), self.mass, offset[:3]), (slice(1, 4), self.first_moment, offset[3:])):
            if found is not None:
                psi, covariance = found
                phi[rows] = psi[:, 0] - psi[:, 1:] @ o
                std[rows] = np.where(np.isnan(phi[rows]), np.nan, one_sigma(covariance))
        for axis, pair in enumerate(self.inertia):
            if pair is not None:
                k = INERTIA_OF_AXIS[axis]
                phi[k] = pair[0] - pair[1] * offset[3 + axis]
                std[k] = inertia_uncertainty(
                    phi[k], torque_std=torque_std[axis], alpha_std=alpha_std, alpha_reference=self.alpha_reference[axis]
                )
        return phi, std


class RecursiveRegression:
    """Algorithms 1-5 on line.

    Args:
        variance: (6,), of the wrench's samples, Lambda of Eq. (8).
    """

    def __init__(self, thresholds: Thresholds, variance: Array) -> None:
        self.thresholds = thresholds
        self._mass = RecursiveLeastSquares(1, 4, variance[:3])
        self._moment = RecursiveLeastSquares(3, 4, variance[3:])
        self._inertia = [RecursiveLeastSquares(1, 2, variance[3 + i : 4 + i]) for i in range(3)]
        self._square = np.zeros(3)
        self._resp = np.zeros((2, 3, 4))
        self._resp[:, :, 1:] = np.eye(3)

    def update(self, g: Array, omega: Array, v: Array, alpha: Array, wrench: Array) -> bool:
        """One sample in the sensor frame, (3,) each, and the raw wrench (6,); returns whether the robot is motionless."""
        omega_limit, v_limit = self.thresholds.still
        still = bool(omega @ omega < omega_limit**2 and v @ v < v_limit**2)
        if still:
            self._resp[0, :, 0], self._resp[1, :, 0] = wrench[:3], wrench[3:]
            cross = np.array([[0.0, -g[2], g[1]], [g[2], 0.0, -g[0]], [-g[1], g[0], 0.0]])
            self._mass.update(-g[:, None], self._resp[0])
            self._moment.update(cross, self._resp[1])
        axis = self.thresholds.find_rotation_axis(g, v, alpha)
        if axis is not None:
            self._inertia[axis].update(np.array([[alpha[axis]]]), np.array([[wrench[3 + axis], 1.0]]))
            self._square[axis] += alpha[axis] ** 2
        return still

    @property
    def found(self) -> Decoupled:
        """What is known so far."""
        counts = np.array([max(r.count, 1) for r in self._inertia])
        mass, moment = ((r.psi, r.covariance) if r.count else None for r in (self._mass, self._moment))
        return Decoupled(
            mass,
            moment,
            (self._pair(0), self._pair(1), self._pair(2)),
            np.sqrt(self._square / counts),
        )

    def _pair(self, axis: int) -> Array | None:
        return self._inertia[axis].psi[0] if self._inertia[axis].count else None


def regression(
    motion: Motion,
    speed: Array,
    wrench: Array,
    still: NDArray[np.bool_],
    *,
    thresholds: Thresholds,
    variance: Array,
) -> Decoupled:
    """Algorithms 1-5 in a batch: raw wrench (N, 6), speed (N,) of the sensor origin; `still` (N,) is line 5 of Algorithms 1 and 2."""
    mass = moment = None
    if still.any():
        g, w = motion.g[still], wrench[still]
        unit = np.broadcast_to(np.eye(3), (len(g), 3, 3))
        mass = regress(-g[..., None], np.concatenate((w[:, :3, None], unit), axis=2), variance[:3])
        moment = regress(skew(g), np.concatenate((w[:, 3:, None], unit), axis=2), variance[3:])
    pairs: list[Array | None] = [None, None, None]
    reference = np.zeros(3)
    for axis in range(3):
        rows = thresholds.find_rotation_rows(motion, speed, axis)
        if rows.any():
            alpha, tau = motion.alpha[rows, axis], wrench[rows, 3 + axis]
            resp = np.stack((tau, np.ones_like(tau)), axis=1)[:, None, :]
            pairs[axis] = regress(alpha[:, None, None], resp, variance[3 + axis : 4 + axis])[0][0]
            reference[axis] = np.sqrt(np.mean(alpha**2))
    return Decoupled(mass, moment, (pairs[0], pairs[1], pairs[2]), reference)
