"""The ten parameters without the knowledge that they are the same everywhere: the simplest model that can contradict a set-up.

    force:   f   = - m_w g + m_a a + B mc_f + o,           B = R^T R''
    torque:  tau = g x mc_w - a x mc_a + (inertia) + o,    g = R^T (gravity + lean)

The mass shows in weight and inertia, the first moment in torque and, as soon as something turns, in force. A right set-up has m_a = m_w and
mc_f = mc_a = mc_w. Slips of geometry spoil the fit itself; a clock that is wrong by a factor, positions in millimetres, another unit of
force or torque, a torque about another point break the equations between its parts.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.estimation.setup.stances import FORCE, TORQUE, Stances
from core.estimation.weak_form import regressor_of, tilt_axes

SLACK = 0.02
"""Share of the load's change that the model is allowed to miss without blame: gain, cross-talk, drift, lag."""
TILT_RAD = 0.12
"""Standard deviation of the prior on the tilt of the base."""
BLIND = 1e-8
"""Share of the information below which a direction is not seen: its variance is then next to infinite."""

MASS_WEIGHT, MASS_INERTIA = 0, 1
MOMENT_WEIGHT, MOMENT_INERTIA, MOMENT_FORCE = slice(2, 5), slice(5, 8), slice(8, 11)
INERTIA = slice(11, 17)
COUNT = 17


@dataclass(frozen=True)
class PayloadFit:
    """What the model makes of the stances.

    Args:
        z: (17,), `[m_w, m_a, mc_w, mc_a, mc_f, inertia]`, kg, kg m and kg m2, by the recording's clock.
        covariance: (17, 17), with the slack; what the stances do not show is next to infinite.
        misfit: root mean square of the residuals in units of noise and slack; 1 and less is as good as it gets.
        unexplained: share of the change of force, and of torque, that is left, root mean square.
        freedom: of the residuals.
        blur: share of what linear acceleration, and turning, seem to be that is the noise of the poses.
    """

    z: Array
    covariance: Array
    misfit: float
    unexplained: tuple[float, float]
    freedom: int
    blur: tuple[float, float]

    @property
    def mass(self) -> float:
        """kg, by its weight; negative where the wrench has the other sign."""
        return float(self.z[MASS_WEIGHT])

    @property
    def mass_std(self) -> float:
        """kg."""
        return float(np.sqrt(self.covariance[MASS_WEIGHT, MASS_WEIGHT]))

    @property
    def first_moment(self) -> Array:
        """(3,), kg m, by its weight."""
        return self.z[MOMENT_WEIGHT]

    @property
    def lever_m(self) -> float:
        """Distance of the centre of mass from the sensor's origin."""
        return float(np.linalg.norm(self.first_moment)) / abs(self.mass) if self.mass else np.inf

    @property
    def upright(self) -> bool:
        """Whether the mass is positive beyond doubt."""
        return self.mass > 3.0 * self.mass_std

    @property
    def upside_down(self) -> bool:
        """Whether it is negative beyond doubt."""
        return self.mass < -3.0 * self.mass_std


def fit_payload(stances: Stances) -> PayloadFit:
    """Fits the model by linear least squares, the force first: it says how the base leans."""
    weight, inertia, turning = _regressors(stances, stances.gravity)
    g0, axes = float(np.linalg.norm(stances.gravity)), tilt_axes(stances.gravity)
    spread = _find_spread(stances.wrench[:, FORCE])
    leaning = -g0 * (stances.base @ axes)
    columns = [weight[:, :3, :1], inertia[:, :3, :1], turning[:, :3, 1:4]]
    x, left, S = _solve([*columns, leaning], stances, FORCE, [np.inf] * 5 + [TILT_RAD * spread / g0] * 2)
    mass = float(x[0] if S[0, 0] <= S[1, 1] else x[1])  # of a sensor that stays level only accelerations show it
    lean = g0 * axes @ x[5:7] / mass if abs(mass) * g0 > 0.3 * spread > 0.0 else np.zeros(3)
    weight = _regressors(stances, stances.gravity + _shorten(lean, 0.3 * g0))[0]
    columns = [weight[:, 3:, 1:4], inertia[:, 3:, 1:4], turning[:, 3:, 4:]]
    u, torque_left, T = _solve(columns, stances, TORQUE, [np.inf] * 12)
    z, covariance = np.zeros(COUNT), np.zeros((COUNT, COUNT))
    at_force, at_torque = np.array([0, 1, 8, 9, 10]), np.array([2, 3, 4, 5, 6, 7, 11, 12, 13, 14, 15, 16])
    z[at_force], z[at_torque] = x[:5], u[:12]
    covariance[np.ix_(at_force, at_force)], covariance[np.ix_(at_torque, at_torque)] = S[:5, :5], T[:12, :12]
    freedom = 6 * stances.distinct - (25 if stances.moves else 12)
    square = float((left**2).sum() + (torque_left**2).sum()) / (6 * len(stances))
    widened = max(square, 1.0) * len(stances) / stances.distinct
    misfit = float(np.sqrt(square * 6 * stances.distinct / max(freedom, 1)))
    shares = tuple(
        float(np.sqrt(np.mean((residual * _sigma(stances, part)) ** 2)) / max(_find_spread(stances.wrench[:, part]), 1e-300))
        for residual, part in ((left, FORCE), (torque_left, TORQUE))
    )
    return PayloadFit(z, covariance * widened, misfit, (shares[0], shares[1]), freedom, _blur(stances))


def _regressors(stances: Stances, gravity: Array) -> tuple[Array, Array, Array]:
    """V (P, 6, 10) of weight, of linear acceleration, and of turning."""
    P = len(stances)
    zero, none = np.zeros((P, 3)), np.zeros((P, 3, 3))
    a, B = _accelerations(stances) if stances.moves else (zero, none)
    return regressor_of(-(stances.base @ gravity), none), regressor_of(a, none), regressor_of(zero, B)


def _accelerations(stances: Stances) -> tuple[Array, Array]:
    """Of the sensor's origin (P, 3), and `R^T R''` (P, 3, 3), sensor axes."""
    B = stances.base @ stances.differentiate_twice(stances.rotation)
    if stances.position is None:
        return np.zeros((len(B), 3)), B
    return np.einsum("kij,kj->ki", stances.base, stances.differentiate_twice(stances.position)), B


def _blur(stances: Stances) -> tuple[float, float]:
    """Noise of a second difference against what was seen of it: by as much a regression makes its coefficient too small."""
    if not stances.moves:
        return 0.0, 0.0
    of_second_difference = np.sqrt(6.0) / float(np.median(stances.half_s)) ** 2
    shares = [
        float((of_second_difference * std) ** 2 / max(float(np.mean(seen**2)), 1e-300))
        for std, seen in zip(stances.jitter, _accelerations(stances), strict=True)
    ]
    return min(shares[0], 1.0), min(shares[1], 1.0)


def _find_spread(x: Array) -> float:
    """Root mean square of how far the values (P, 3) are from their mean."""
    return float(np.sqrt(np.mean((x - x.mean(axis=0)) ** 2)))


def _sigma(stances: Stances, channels: slice) -> Array:
    """(P, 1), of one channel: noise of the mean, and the slack."""
    slack = SLACK * _find_spread(stances.wrench[:, channels])
    return np.asarray(np.sqrt(np.mean(stances.noise[:, channels] ** 2, axis=1, keepdims=True) + slack**2 + 1e-24))


def _shorten(v: Array, longest: float) -> Array:
    size = float(np.linalg.norm(v))
    return v if size <= longest else np.asarray(v * (longest / size))


def _solve(columns: list[Array], stances: Stances, channels: slice, prior: list[float]) -> tuple[Array, Array, Array]:
    """Unknowns of the columns (P, 3, k) and an offset (3,); residuals (P, 3) over sigma; covariance of unknowns."""
    P, sigma = len(stances), _sigma(stances, channels)
    A = np.concatenate([*columns, np.broadcast_to(np.eye(3), (P, 3, 3))], axis=2) / sigma[..., None]
    b = stances.wrench[:, channels] / sigma
    k = A.shape[2]
    rows = A.reshape(-1, k)
    normal = rows.T @ rows + np.diag(np.concatenate((np.array(prior) ** -2.0, np.zeros(3))))
    scale = 1.0 / np.sqrt(np.maximum(np.diag(normal), 1e-30))
    inverse = np.linalg.inv(normal * np.outer(scale, scale) + BLIND * np.eye(k)) * np.outer(scale, scale)
    x = inverse @ (rows.T @ b.ravel())
    return x, b - A @ x, inverse
