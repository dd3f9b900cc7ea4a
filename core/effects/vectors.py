"""Vectors along a run, compiled: turned between sensor and base, the specific force at a place, the moment of a force."""

from __future__ import annotations

import numpy as np
from numba import njit

from core.array import Array
from core.payload.inertia import Motion


@njit(cache=True)
def turn(rotation: Array, v: Array) -> Array:
    """(N, 3), `R v` for R (N, 3, 3) and v (N, 3): from sensor to base axes."""
    out = np.empty_like(v)
    for k in range(len(v)):
        R = rotation[k]
        x, y, z = v[k, 0], v[k, 1], v[k, 2]
        for i in range(3):
            out[k, i] = R[i, 0] * x + R[i, 1] * y + R[i, 2] * z
    return out


@njit(cache=True)
def turn_back(rotation: Array, v: Array) -> Array:
    """(N, 3), `R^T v`: from base to sensor axes."""
    out = np.empty_like(v)
    for k in range(len(v)):
        R = rotation[k]
        x, y, z = v[k, 0], v[k, 1], v[k, 2]
        for i in range(3):
            out[k, i] = R[0, i] * x + R[1, i] * y + R[2, i] * z
    return out


def find_specific_force(motion: Motion, place: Array) -> Array:
    """(N, 3), `a - g` at a place (3,) of the body, sensor axes, m/s2."""
    return np.asarray(_find_specific_force(motion.g, motion.a, motion.omega, motion.alpha, np.ascontiguousarray(place)))


@njit(cache=True)
def _find_specific_force(g: Array, a: Array, omega: Array, alpha: Array, r: Array) -> Array:
    out = np.empty_like(a)
    rx, ry, rz = r[0], r[1], r[2]
    for k in range(len(a)):
        px, py, pz = omega[k, 0], omega[k, 1], omega[k, 2]
        ax, ay, az = alpha[k, 0], alpha[k, 1], alpha[k, 2]
        vx, vy, vz = py * rz - pz * ry, pz * rx - px * rz, px * ry - py * rx
        out[k, 0] = a[k, 0] - g[k, 0] + ay * rz - az * ry + py * vz - pz * vy
        out[k, 1] = a[k, 1] - g[k, 1] + az * rx - ax * rz + pz * vx - px * vz
        out[k, 2] = a[k, 2] - g[k, 2] + ax * ry - ay * rx + px * vy - py * vx
    return out


@njit(cache=True)
def add_force(w: Array, f: Array, place: Array, torque: Array) -> Array:
    """(N, 6), w plus a force f (N, 3) at a place (3,) and a torque (N, 3) beside it."""
    out = np.empty_like(w)
    x, y, z = place[0], place[1], place[2]
    for k in range(len(w)):
        fx, fy, fz = f[k, 0], f[k, 1], f[k, 2]
        out[k, 0], out[k, 1], out[k, 2] = w[k, 0] + fx, w[k, 1] + fy, w[k, 2] + fz
        out[k, 3] = w[k, 3] + y * fz - z * fy + torque[k, 0]
        out[k, 4] = w[k, 4] + z * fx - x * fz + torque[k, 1]
        out[k, 5] = w[k, 5] + x * fy - y * fx + torque[k, 2]
    return out


@njit(cache=True)
def add_course(w: Array, course: Array, sizes: Array) -> Array:
    """(N, 6), w plus one course (N,) in all channels, in each of its size (6,)."""
    out = np.empty_like(w)
    for k in range(len(w)):
        x = course[k]
        for c in range(6):
            out[k, c] = w[k, c] + x * sizes[c]
    return out


@njit(cache=True)
def load_of_moment(omega: Array, alpha: Array, b: Array, s: Array, ds: Array, dds: Array) -> tuple[Array, Array]:
    """Force and torque about its place, (N, 3) each, of a first moment s (N, 3), kg m, with its rates, in the field b (N, 3):
    `s'' + 2 omega x s' + alpha x s + omega x (omega x s)` and `s x b`."""
    f, tau = np.empty_like(s), np.empty_like(s)
    for k in range(len(s)):
        px, py, pz = omega[k, 0], omega[k, 1], omega[k, 2]
        ax, ay, az = alpha[k, 0], alpha[k, 1], alpha[k, 2]
        x, y, z = s[k, 0], s[k, 1], s[k, 2]
        vx, vy, vz = 2.0 * ds[k, 0] + py * z - pz * y, 2.0 * ds[k, 1] + pz * x - px * z, 2.0 * ds[k, 2] + px * y - py * x
        f[k, 0] = dds[k, 0] + py * vz - pz * vy + ay * z - az * y
        f[k, 1] = dds[k, 1] + pz * vx - px * vz + az * x - ax * z
        f[k, 2] = dds[k, 2] + px * vy - py * vx + ax * y - ay * x
        tau[k, 0] = y * b[k, 2] - z * b[k, 1]
        tau[k, 1] = z * b[k, 0] - x * b[k, 2]
        tau[k, 2] = x * b[k, 1] - y * b[k, 0]
    return f, tau
