"""Torques and equations of motion averaged over the same short windows, and which of them friction can be told in.

As in `core.estimation.weak_form`, both sides pass the same cubic B-splines, so that neither lags and neither is smoothed more than the
other. The windows are longer here and stand further apart: friction and filters leave little above some hertz that a rigid arm explains.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from core.array import Array
from core.estimation.joint_torques.torque_regressor import TorqueRegressor
from core.estimation.kinematics import find_jitter, local_derivative
from core.estimation.local_polynomial import derive
from core.estimation.splines import cardinal
from core.estimation.weak_form import second_difference
from core.recording.recording import Recording
from core.robot.model import RobotModel

KNOT_S = 0.05
"""Knot spacing of the windows; each is four knots long."""
APART_S = 0.1
"""Between windows: neighbours share a twentieth of their noise."""
MOST_WINDOWS = 3000
"""Beyond it the windows stand further apart."""
PERIOD_S = 0.004
"""Faster samples are averaged to this first."""
SMOOTH_S = 0.1
"""Window of the local cubics behind velocities."""
SLOWEST_RAD_S = 0.02
"""Below it friction is no function of the velocity."""
TRAVEL_RAD = 0.01
"""Since a joint has turned round or set off: until then it winds up bristles and gears, and its friction is not yet what it will be."""
LONGEST_LATE_S = 0.1
"""By which torques may be late or early; windows keep so far from gaps and ends."""
CHUNK = 2000
"""Samples whose regressors are held at a time."""
FULL = 0.999
"""Of the joint's torque limit: where a torque is cut off it is not what moves the arm."""

Bools = NDArray[np.bool_]


@dataclass(frozen=True)
class TorqueWindows:
    """One recording in K windows of an arm with n joints.

    Args:
        t: (K,), centres, s.
        Y, rate: (K, n, 10 n + 10), windowed regressor, and how it changes per second that the window is later.
        q: (K, n), positions of the joints, rad.
        acceleration: (K, n), of the joints, rad/s2.
        speed: (K, n), velocity of the joints, rad/s.
        usable: (K, n), where the joint has been turning one way.
        samples: torques as recorded, for windows that are shifted.
    """

    t: Array
    Y: Array
    rate: Array
    q: Array
    acceleration: Array
    speed: Array
    usable: Bools
    samples: tuple[Array, Array]
    knot_s: float

    def torques(self, late_s: float) -> Array:
        """(K, n), N m, windowed torques that are this much late, s."""
        t, tau = self.samples
        W = _weights(t, self.t + late_s, self.knot_s)
        return np.asarray(W @ tau)


def cut_into_windows(recording: Recording, robot: RobotModel) -> TorqueWindows | None:
    """The windows of a recording with joints and torques; None where it is too short or sampled too slowly for any."""
    assert recording.q is not None and recording.tau is not None
    t, q, tau = _coarsen(_smooth_stamps(recording.t, recording.q), recording.q, recording.tau)
    period = float(np.median(np.diff(t))) if len(t) > 20 else np.inf
    knot_s = max(KNOT_S, 5.0 * period)
    if t[-1] - t[0] < 20.0 * knot_s or period > 0.05:
        return None
    centres = _centres(t, period, knot_s)
    if len(centres) < 2:
        return None
    regressor = TorqueRegressor(robot, recording.gravity)
    dq, ddq = local_derivative(q, 1, t, window_s=SMOOTH_S), np.asarray(second_difference(t) @ q)
    W = _weights(t, centres, knot_s)
    later = _weights(t, centres, knot_s, derivative=True)
    Y = np.zeros((len(centres), robot.n, 10 * robot.n + 10))
    rate = np.zeros_like(Y)
    for first in range(0, len(t), CHUNK):
        part = slice(first, first + CHUNK)
        rows = regressor.rows(q[part], dq[part], ddq[part]).reshape(len(t[part]), -1)
        Y += (W[:, part] @ rows).reshape(Y.shape)
        rate += (later[:, part] @ rows).reshape(Y.shape)
    usable = _find_usable(q, dq, tau, robot)
    whole = np.asarray(W @ (~usable).astype(float)) < 1e-9
    return TorqueWindows(
        t=centres,
        Y=Y,
        rate=rate,
        q=np.asarray(W @ q),
        acceleration=np.asarray(W @ ddq),
        speed=np.asarray(W @ dq),
        usable=whole,
        samples=(t, tau),
        knot_s=knot_s,
    )


def _smooth_stamps(t: Array, q: Array) -> Array:
    """The instants of samples that a clock of its own has taken regularly and a late reader has stamped; as they are without jitter."""
    jitter_s, _ = find_jitter(t, q)
    period = float(np.median(np.diff(t))) if len(t) > 1 else 0.0
    regular = len(t) > 101 and bool((np.diff(t) < 2.5 * period).all())
    spread = float(np.std(np.diff(t))) if len(t) > 1 else 0.0
    if not regular or (jitter_s == 0.0 and spread < 0.02 * period):
        return t
    return derive(t, 101, 1)


def _coarsen(t: Array, q: Array, tau: Array) -> tuple[Array, Array, Array]:
    """Means of so many neighbours that the period is `PERIOD_S`."""
    every = max(1, int(PERIOD_S / float(np.median(np.diff(t)))) if len(t) > 1 else 1)
    n = len(t) // every * every

    def mean(x: Array) -> Array:
        return np.asarray(x[:n].reshape(-1, every, *x.shape[1:]).mean(axis=1))

    return mean(t), mean(q), mean(tau)


def _centres(t: Array, period: float, knot_s: float) -> Array:
    """Where windows stand that no gap and no end cuts."""
    reach = 2.0 * knot_s + 5.0 * period + LONGEST_LATE_S
    apart = max(APART_S * knot_s / KNOT_S, (t[-1] - t[0]) / MOST_WINDOWS)
    centres = np.arange(t[0] + reach, t[-1] - reach, apart)
    gaps = np.flatnonzero(np.diff(t) > 4.0 * period)
    keep = np.ones(len(centres), dtype=bool)
    for k in gaps:
        keep &= (centres < t[k] - reach) | (centres > t[k + 1] + reach)
    return np.asarray(centres[keep])


def _weights(t: Array, centres: Array, knot_s: float, *, derivative: bool = False) -> csr_array:
    """(K, N), weights of samples at t (N,) in the windows about `centres`; or how they change per second that the centre is later."""
    step = np.gradient(t)
    first, last = np.searchsorted(t, centres - 2.0 * knot_s), np.searchsorted(t, centres + 2.0 * knot_s)
    counts = last - first
    rows = np.repeat(np.arange(len(centres)), counts)
    columns = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts - first, counts)
    x = (t[columns] - centres[rows]) / knot_s
    bump = cardinal(x, 3) * step[columns]
    total = np.bincount(rows, bump, minlength=len(centres))[rows]
    values = (cardinal(x - 0.5, 2) - cardinal(x + 0.5, 2)) / knot_s * step[columns] if derivative else bump
    return csr_array((values / total, (rows, columns)), shape=(len(centres), len(t)))


def _find_usable(q: Array, dq: Array, tau: Array, robot: RobotModel) -> Bools:
    """(N, n): the joint turns faster than `SLOWEST_RAD_S`, and has gone `TRAVEL_RAD` since it turned round or stood; no torque is cut."""
    moving = np.abs(dq) > SLOWEST_RAD_S
    limit = np.array(robot.model.effortLimit)
    cut = (limit > 0.0) & (np.abs(tau) >= FULL * limit)
    usable = moving & (_travel(q, dq, moving) > TRAVEL_RAD)
    return np.asarray(usable & ~cut & np.isfinite(tau))


def _travel(q: Array, dq: Array, moving: Bools) -> Array:
    """(N, n), how far each joint has gone since it last stood or turned round, rad."""
    travel = np.zeros_like(q)
    for j in range(q.shape[1]):
        sign = np.where(moving[:, j], np.sign(dq[:, j]), 0.0)
        starts = np.flatnonzero(np.diff(sign, prepend=sign[0] + 1.0) != 0.0)
        began = starts[np.searchsorted(starts, np.arange(len(q)), side="right") - 1]
        travel[:, j] = np.abs(q[:, j] - q[began, j])
    return travel
