"""How joints on springs deflect: `M e'' + D e' + K e = -tau`, all joints coupled by the inertia of the links. Compiled.

e is what the link is ahead of its motor, tau what the rigid arm along the motors' motion asks of the joints. Solved for
`z = C^-1/2 e`, C = 1/K: rigid joints (C = 0) need no case of their own, and each mode of `C^1/2 M C^1/2` is one over the square of its
angular frequency. Springs may lose: beside each acts Dahl's friction, `r K b s` with `ds = (1 - sign(de) s) de / b`, by which they are
1 + r times as stiff after a turn back, until they have given way by about b. Or they harden: `K (x + r (x - w tanh(x / w)))`, by which
they are 1 + r times as stiff where they have given way by more than about w.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from core.array import Array
from core.effects.memory import Past

GAMMA = 0.55
BETA = 0.25 * (0.5 + GAMMA) ** 2
"""Newmark's parameters: stable for joints of any stiffness, and what is too fast for the rows dies out. At 200 Hz a mode of 8 Hz is
0.5 % too slow and seems damped by another 0.6 % of the critical damping."""


class Spring(NamedTuple):
    """What the springs of all joints are beside their stiffness.

    Args:
        turned, bend: by how much stiffer after a turn back, as a share, and until how far, rad.
        loaded, wind_up: by how much stiffer under much load, as a share, and from how far on, rad.
    """

    turned: float = 0.0
    bend: float = 1.0
    loaded: float = 0.0
    wind_up: float = 1.0


LINEAR = Spring()
NEWTON_STEPS = 30
"""From where a spring would rest that does not harden to where one does: its force is convex on the way, so no step goes too far."""


def deflection(
    inertia: Array,
    load: Array,
    compliance: Array,
    damping: float,
    period: float,
    past: Past | None = None,
    share: float = 1.0,
    spring: Spring = LINEAR,
) -> tuple[Array, Array]:
    """Deflection (N, n), rad, and its second derivative, rad/s2, of joints that follow their load when the run begins.

    Newmark, A method of computation for structural dynamics, 1959; Dahl, A solid friction model, 1968, relaxed when the run begins.

    Args:
        inertia: (N, n, n), of the links in joint coordinates, kg m2.
        load: (N, n), N m.
        compliance: (n,), rad/(N m).
        damping: of each joint alone on its spring, a share of the critical one.
        period: of the rows, s.
        past: of a run that comes in blocks.
        share: of the inertia that swings.
        spring: of every joint, beside its stiffness.
    """
    past = past or Past()
    soft = np.flatnonzero(compliance > 0.0)
    root = np.sqrt(compliance[soft])
    pull = -load[0, soft] * root
    start = (
        np.stack([_rest(pull, root, spring), np.full_like(root, np.nan), np.zeros_like(root), pull, np.zeros_like(root)])
        if past.rows is None
        else past.rows
    )
    error, second, past.rows = _swing(inertia, share, soft, root, load, start, damping, period, past.rows is None, spring)
    return error, second


def _rest(pull: Array, root: Array, spring: Spring) -> Array:
    """(k,), z at which springs rest under a pull (k,) on it, relaxed."""
    z = pull
    for _ in range(NEWTON_STEPS if spring.loaded else 0):
        hard = np.tanh(root * z / spring.wind_up)
        z = z - (z + spring.loaded * (z - spring.wind_up / root * hard) - pull) / (1.0 + spring.loaded * hard**2)
    return z


@njit(cache=True)
def _swing(
    inertia: Array,
    share: float,
    soft: NDArray[np.intp],
    root: Array,
    load: Array,
    start: Array,
    damping: float,
    h: float,
    at_rest: bool,
    spring: Spring,
) -> tuple[Array, Array, Array]:
    """e, e'' (N, n) and the end (5, k): z, z', z'', the pull on it and Dahl's s; `start` likewise, its z' NaN until the second row of the
    run."""
    N, k = len(load), len(soft)
    error, second = np.zeros(load.shape), np.zeros(load.shape)
    end = start.copy()
    z, v, a, before, s = end[0], end[1], end[2], end[3], end[4]
    turned, bend, loaded, wind_up = spring
    A, one_over, d, x, y, hard = np.empty((k, k)), np.empty(k), np.empty(k), np.empty(k), np.empty(k), np.zeros(k)
    pull = np.empty(k)
    for t in range(N):
        for i in range(k):
            pull[i] = -load[t, soft[i]] * root[i]
        if t > 0 or not at_rest:
            for i in range(k):
                if np.isnan(v[i]):
                    v[i] = (pull[i] - before[i]) / h
                for j in range(i + 1):
                    A[i, j] = root[i] * root[j] * (share * inertia[t, soft[i], soft[j]])
                d[i] = 2.0 * damping * np.sqrt(max(A[i, i], 0.0))
                if loaded > 0.0:  # most springs do not harden, and this is slow
                    hard[i] = np.tanh(root[i] * z[i] / wind_up)
                tangent = turned * (1.0 - np.sign(v[i]) * s[i]) + loaded * hard[i] * hard[i]  # on the way that it goes
                A[i, i] += GAMMA * h * d[i] + BETA * h * h * (1.0 + tangent)
            _factorise(A, one_over, 0.01 * h * h)
            for i in range(k):
                way = h * v[i] + (0.5 - BETA) * h * h * a[i]
                held = turned * (bend / root[i] * s[i] + (1.0 - np.sign(v[i]) * s[i]) * way)
                held += loaded * (z[i] - wind_up / root[i] * hard[i] + hard[i] * hard[i] * way)
                y[i] = z[i]
                z[i] += way
                v[i] += (1.0 - GAMMA) * h * a[i]
                x[i] = pull[i] - d[i] * v[i] - z[i] - held
            _solve(A, one_over, x)
            for i in range(k):
                a[i] = x[i]
                v[i] += GAMMA * h * a[i]
                z[i] += BETA * h * h * a[i]
                if turned > 0.0:  # most springs lose nothing, and this is slow
                    went = root[i] * (z[i] - y[i])
                    s[i] = np.sign(went) + (s[i] - np.sign(went)) * np.exp(-abs(went) / bend)
        for i in range(k):
            error[t, soft[i]], second[t, soft[i]], before[i] = root[i] * z[i], root[i] * a[i], pull[i]
    return error, second, end


@njit(cache=True)
def _factorise(A: Array, one_over: Array, least: float) -> None:
    """Cholesky's factor below the diagonal of A, in place, and one over its diagonal; a trial payload that is no body is held off."""
    for i in range(len(A)):
        for j in range(i):
            x = A[i, j]
            for m in range(j):
                x -= A[i, m] * A[j, m]
            A[i, j] = x * one_over[j]
        x = A[i, i]
        for m in range(i):
            x -= A[i, m] * A[i, m]
        one_over[i] = 1.0 / np.sqrt(max(x, least))


@njit(cache=True)
def _solve(A: Array, one_over: Array, x: Array) -> None:
    k = len(x)
    for i in range(k):
        for m in range(i):
            x[i] -= A[i, m] * x[m]
        x[i] *= one_over[i]
    for i in range(k - 1, -1, -1):
        for m in range(i + 1, k):
            x[i] -= A[m, i] * x[m]
        x[i] *= one_over[i]
