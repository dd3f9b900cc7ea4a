"""Recorded joint velocities come late: a controller filters them out of the positions."""

from __future__ import annotations

import numpy as np
from scipy.signal import savgol_filter

from core.array import Array, interpolate
from core.effects.effect import Finding, Parameter, Symptom, View
from core.recording.recording import Recording
from core.words.message import Message

SMOOTHING_S, SPACING_S = 0.1, 0.02
"""Window of the local polynomials that both sides go through, and between the rows that are fitted."""
FEWEST = 100
"""Samples."""
MOVING_RAD_S = 0.02
ROUNDS = 4
"""Each begins with the lag of the one before."""
BLOCK_S = 1.0
"""Within which what is left may hang together."""
STRANGE = 0.1
"""Share of the velocity's square left over from which it is no late velocity of this position but something else."""
TOLERATED_S = 0.005
LARGEST_S = 0.5


class VelocityLag(Symptom):
    """`dq(t) = (1 + g) d/dt q (t - lag)`, one lag for all joints: the group delay of whatever filter made it.

    Material where the lag is more than 5 ms: friction and accelerations that are taken from such velocities belong to another moment.
    """

    id = "velocity_lag"
    title = Message.of("effect-velocity-lag-title")
    stage = "kinematics"
    side = "joints"

    def parameters(self, recording: Recording) -> tuple[Parameter, ...]:
        """The lag, s."""
        return (Parameter("lag_s", "s", 0.0, 0.0, LARGEST_S, 0.01),)

    def observe(self, recording: Recording, view: View) -> Finding | None:
        """Compares velocities with positions; None without either, where nothing moves, or where velocities are of another kind."""
        if recording.q is None or recording.dq is None or len(recording) < FEWEST:
            return None
        found = find_lag(recording.t, recording.q, recording.dq)
        if found is None or found[0] <= 0.0:
            return None
        lag, std = found
        times = lag / TOLERATED_S
        seen = Message.of("symptom-velocity-lag", lag_s=lag, lag_std_s=std)
        return Finding(np.array([lag]), np.array([std]), lag / std, times > 1.0, times, seen)

    def advice(self, finding: Finding) -> Message:
        """Advises recording unfiltered velocities, or leaving them out, with the lag in ms."""
        return Message.of("advice-velocity-lag", lag_s=finding.theta[0])


def find_lag(t: Array, q: Array, dq: Array) -> tuple[float, float] | None:
    """The lag of velocities dq (N, n) behind those of positions q (N, n), s, with its standard uncertainty; None where there is none to
    tell."""
    even = np.linspace(t[0], t[-1], len(t))
    period = float(even[1] - even[0])
    window = min(max(5, 2 * round(0.5 * SMOOTHING_S / period) + 1), len(t) // 2 * 2 - 1)
    positions, recorded = (interpolate(even, t, x) for x in (q, dq))
    rate = savgol_filter(positions, window, 3, deriv=1, delta=period, axis=0)
    acceleration = savgol_filter(positions, window, 3, deriv=2, delta=period, axis=0)
    recorded = savgol_filter(recorded, window, 3, axis=0)
    edge = max(window, round(LARGEST_S / period))
    rows = np.arange(edge, len(t), max(1, round(SPACING_S / period)))
    lag, std = 0.0, np.inf
    for _ in range(ROUNDS):
        v, a = (interpolate(even[rows] - lag, even, x) for x in (rate, acceleration))
        moving = np.abs(v) > MOVING_RAD_S
        X, y = np.column_stack((a[moving], v[moving])), (v - recorded[rows])[moving]
        if len(y) < FEWEST or not a[moving].any():
            return None
        bread = np.linalg.inv(X.T @ X)
        beta = bread @ (X.T @ y)
        left = y - X @ beta
        if np.square(left).sum() > STRANGE * np.square(v[moving]).sum() or abs(beta[1]) > STRANGE:
            return None
        block = np.broadcast_to((even[rows] // BLOCK_S).astype(int)[:, None], v.shape)[moving]
        scores = np.column_stack([np.bincount(block, weights=x * left) for x in X.T])
        covariance = bread @ (scores.T @ scores) @ bread
        lag, std = float(np.clip(lag + beta[0], 0.0, LARGEST_S)), float(np.sqrt(covariance[0, 0]))
    return lag, max(std, 1e-6)
