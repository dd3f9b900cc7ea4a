"""A part that hangs from a point of a moving body and swings in all directions. Compiled."""

from __future__ import annotations

import numpy as np
from numba import njit

from core.array import Array
from core.effects.memory import Past

GRAVITY = 9.81
"""m/s2, under which the frequency of a pendulum is stated."""
REACH = 0.5
"""Longest step of the integration, in units of the time in which the swing or its friction changes anything."""


def hang(
    b: Array, omega: Array, period: float, frequency_hz: float, damping: float, start: Array, past: Past | None = None
) -> tuple[Array, Array]:
    """Solves `n'' = -b / l - 2 zeta w (n' - omega x n)` across n, |n| = 1, w^2 = g / l, in axes that do not turn.

    Runge-Kutta steps of fourth order.

    Args:
        b: (N, 3), specific force `a - g` at the point from which it hangs, m/s2; straight between rows.
        omega: (N, 3), angular velocity of the body that it rubs against, rad/s.
        period: of the rows, s.
        frequency_hz: of small swings at rest on Earth.
        damping: zeta, of these.
        start: (2, 3), where it hangs in the first row, as a direction of any length, and the rate of its unit vector, 1/s.
        past: of a run that comes in blocks.

    Returns:
        From the point to the part, m, and the second derivative of that, m/s2; (N, 3) each.
    """
    past = past or Past()
    w = 2.0 * np.pi * frequency_hz
    length = GRAVITY / w**2
    rows = np.concatenate([b / -length, omega], axis=1)
    n = start[0] / max(float(np.linalg.norm(start[0])), 1e-9)
    rate = start[1] - (start[1] @ n) * n
    if past.rows is not None:  # the last row, and how it hung then
        rows, n, rate = np.concatenate([past.rows[:1], rows]), past.rows[1, :3], past.rows[1, 3:]
    steps = int(np.ceil(period * w * (1.0 + 2.0 * damping) / REACH))
    hung = _integrate(rows, 2.0 * damping * w, period, steps, n, rate)
    past.rows = np.stack([rows[-1], hung[-1, :6]])
    return length * hung[-len(b) :, :3], length * hung[-len(b) :, 6:]


@njit(cache=True)
def accelerate(row: Array, nx: float, ny: float, nz: float, vx: float, vy: float, vz: float, friction: float) -> tuple[float, float, float]:
    """n'' for one row: the pull (1/s2) and the angular velocity of the body."""
    x = row[0] - friction * (vx - row[4] * nz + row[5] * ny)
    y = row[1] - friction * (vy - row[5] * nx + row[3] * nz)
    z = row[2] - friction * (vz - row[3] * ny + row[4] * nx)
    along = x * nx + y * ny + z * nz + vx * vx + vy * vy + vz * vz
    return x - along * nx, y - along * ny, z - along * nz


@njit(cache=True)
def _integrate(rows: Array, friction: float, period: float, steps: int, n: Array, v: Array) -> Array:
    """(N, 9): n, n', n''."""
    out = np.empty((len(rows), 9))
    nx, ny, nz, vx, vy, vz = n[0], n[1], n[2], v[0], v[1], v[2]
    h = period / steps
    now, slope, half = rows[0].copy(), np.zeros(6), np.zeros(6)
    for i in range(len(rows)):
        if i > 0:
            for c in range(6):
                slope[c] = (rows[i, c] - rows[i - 1, c]) / steps
                now[c] = rows[i - 1, c]
        for _ in range(steps if i > 0 else 0):
            ax, ay, az = accelerate(now, nx, ny, nz, vx, vy, vz, friction)
            for c in range(6):
                half[c] = now[c] + 0.5 * slope[c]
                now[c] += slope[c]
            px, py, pz = nx + 0.5 * h * vx, ny + 0.5 * h * vy, nz + 0.5 * h * vz
            bx, by, bz = accelerate(half, px, py, pz, vx + 0.5 * h * ax, vy + 0.5 * h * ay, vz + 0.5 * h * az, friction)
            s = 0.25 * h * h
            px, py, pz = px + s * ax, py + s * ay, pz + s * az
            cx, cy, cz = accelerate(half, px, py, pz, vx + 0.5 * h * bx, vy + 0.5 * h * by, vz + 0.5 * h * bz, friction)
            s = 0.5 * h * h
            px, py, pz = nx + h * vx + s * bx, ny + h * vy + s * by, nz + h * vz + s * bz
            dx, dy, dz = accelerate(now, px, py, pz, vx + h * cx, vy + h * cy, vz + h * cz, friction)
            s = h * h / 6.0
            nx, ny, nz = nx + h * vx + s * (ax + bx + cx), ny + h * vy + s * (ay + by + cy), nz + h * vz + s * (az + bz + cz)
            vx += h / 6.0 * (ax + 2.0 * (bx + cx) + dx)
            vy += h / 6.0 * (ay + 2.0 * (by + cy) + dy)
            vz += h / 6.0 * (az + 2.0 * (bz + cz) + dz)
            one = 1.0 / np.sqrt(nx * nx + ny * ny + nz * nz)
            nx, ny, nz = one * nx, one * ny, one * nz
            along = vx * nx + vy * ny + vz * nz
            vx, vy, vz = vx - along * nx, vy - along * ny, vz - along * nz
        out[i, 0], out[i, 1], out[i, 2], out[i, 3], out[i, 4], out[i, 5] = nx, ny, nz, vx, vy, vz
        out[i, 6], out[i, 7], out[i, 8] = accelerate(rows[i], nx, ny, nz, vx, vy, vz, friction)
    return out
