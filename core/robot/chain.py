"""Forward kinematics and Jacobian of a chain of hinges, compiled. Pinocchio is the oracle in the tests; this is for inner loops.

Compiled code is cached beside the sources or in `NUMBA_CACHE_DIR`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit

from core.array import Array


class Chain(NamedTuple):
    """A chain of n hinges.

    Args:
        placements: (n + 1, 4, 4), each joint's frame in the previous one (the first in the world); the last is the sensor's in
            the last joint.
        axes: (n, 3), unit axis of each joint in its own frame.
    """

    placements: Array
    axes: Array


@njit(cache=True)
def joint_frames(placements: Array, axes: Array, q: Array, R: Array, p: Array) -> None:
    """Fills R (n+1, 3, 3) and p (n+1, 3) with the joints' frames after their rotation, and the sensor's, in the world."""
    n = len(q)
    Rc = np.eye(3)
    pc = np.zeros(3)
    A = np.empty((3, 3))
    for j in range(n + 1):
        for r in range(3):
            s = pc[r]
            for c in range(3):
                s += Rc[r, c] * placements[j, c, 3]
            p[j, r] = s
        for r in range(3):
            for c in range(3):
                A[r, c] = Rc[r, 0] * placements[j, 0, c] + Rc[r, 1] * placements[j, 1, c] + Rc[r, 2] * placements[j, 2, c]
        if j < n:
            x, y, z = axes[j, 0], axes[j, 1], axes[j, 2]
            s, c = np.sin(q[j]), np.cos(q[j])
            v = 1.0 - c
            for r in range(3):
                a0, a1, a2 = A[r, 0], A[r, 1], A[r, 2]
                Rc[r, 0] = a0 * (x * x * v + c) + a1 * (x * y * v + z * s) + a2 * (x * z * v - y * s)
                Rc[r, 1] = a0 * (x * y * v - z * s) + a1 * (y * y * v + c) + a2 * (y * z * v + x * s)
                Rc[r, 2] = a0 * (x * z * v + y * s) + a1 * (y * z * v - x * s) + a2 * (z * z * v + c)
        else:
            Rc[:] = A
        for r in range(3):
            pc[r] = p[j, r]
            for c in range(3):
                R[j, r, c] = Rc[r, c]


@njit(cache=True)
def _forward(placements: Array, axes: Array, q: Array) -> Array:
    n = len(q)
    R = np.empty((n + 1, 3, 3))
    p = np.empty((n + 1, 3))
    joint_frames(placements, axes, q, R, p)
    T = np.zeros((4, 4))
    T[:3, :3] = R[n]
    T[:3, 3] = p[n]
    T[3, 3] = 1.0
    return T


@njit(cache=True)
def _forward_many(placements: Array, axes: Array, q: Array) -> Array:
    T = np.empty((len(q), 4, 4))
    for k in range(len(q)):
        T[k] = _forward(placements, axes, q[k])
    return T


@njit(cache=True)
def fill_jacobian(R: Array, p: Array, axes: Array, J: Array) -> None:
    """Fills J (6, n): velocity of the sensor in its own axes, linear over angular, from the joints' frames."""
    n = len(axes)
    for j in range(n):
        w0 = R[j, 0, 0] * axes[j, 0] + R[j, 0, 1] * axes[j, 1] + R[j, 0, 2] * axes[j, 2]
        w1 = R[j, 1, 0] * axes[j, 0] + R[j, 1, 1] * axes[j, 1] + R[j, 1, 2] * axes[j, 2]
        w2 = R[j, 2, 0] * axes[j, 0] + R[j, 2, 1] * axes[j, 1] + R[j, 2, 2] * axes[j, 2]
        d0, d1, d2 = p[n, 0] - p[j, 0], p[n, 1] - p[j, 1], p[n, 2] - p[j, 2]
        v0, v1, v2 = w1 * d2 - w2 * d1, w2 * d0 - w0 * d2, w0 * d1 - w1 * d0
        for c in range(3):
            J[c, j] = R[n, 0, c] * v0 + R[n, 1, c] * v1 + R[n, 2, c] * v2
            J[3 + c, j] = R[n, 0, c] * w0 + R[n, 1, c] * w1 + R[n, 2, c] * w2


@njit(cache=True)
def _jacobian(placements: Array, axes: Array, q: Array) -> Array:
    n = len(q)
    R = np.empty((n + 1, 3, 3))
    p = np.empty((n + 1, 3))
    joint_frames(placements, axes, q, R, p)
    J = np.empty((6, n))
    fill_jacobian(R, p, axes, J)
    return J


@njit(cache=True)
def _jacobian_many(placements: Array, axes: Array, q: Array) -> Array:
    J = np.empty((len(q), 6, len(axes)))
    for k in range(len(q)):
        J[k] = _jacobian(placements, axes, q[k])
    return J


@njit(cache=True)
def _first_moment_many(placements: Array, axes: Array, masses: Array, firsts: Array, q: Array) -> Array:
    n = len(axes)
    total = np.zeros((len(q), 3))
    R = np.empty((n + 1, 3, 3))
    p = np.empty((n + 1, 3))
    for k in range(len(q)):
        joint_frames(placements, axes, q[k], R, p)
        for j in range(n):
            for r in range(3):
                total[k, r] += masses[j] * p[j, r] + R[j, r, 0] * firsts[j, 0] + R[j, r, 1] * firsts[j, 1] + R[j, r, 2] * firsts[j, 2]
    return total


def forward(chain: Chain, q: Array) -> Array:
    """(4, 4) sensor frame in the world at q (n,)."""
    return np.asarray(_forward(chain.placements, chain.axes, q))


def forward_many(chain: Chain, q: Array) -> Array:
    """(N, 4, 4) sensor frames in the world at q (N, n)."""
    return np.asarray(_forward_many(chain.placements, chain.axes, q))


def jacobian(chain: Chain, q: Array) -> Array:
    """(6, n) Jacobian of the sensor origin in sensor axes, linear over angular, at q (n,)."""
    return np.asarray(_jacobian(chain.placements, chain.axes, q))


def jacobian_many(chain: Chain, q: Array) -> Array:
    """(N, 6, n) Jacobians as of `jacobian` at q (N, n)."""
    return np.asarray(_jacobian_many(chain.placements, chain.axes, q))


def first_moment_many(chain: Chain, masses: Array, firsts: Array, q: Array) -> Array:
    """(N, 3), kg m, first moment in the world at q (N, n) of bodies (n,), kg, whose own ones are (n, 3), kg m, in their joints' frames."""
    return np.asarray(_first_moment_many(chain.placements, chain.axes, masses, firsts, q))
