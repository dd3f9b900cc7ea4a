"""Time-optimal speed along a fixed path within joint velocity, joint acceleration and Cartesian speed limits, from rest to rest.

Reachability analysis as in TOPP-RA (Pham and Pham 2018, "A new approach to time-optimal path parameterization based on reachability
analysis"): with x = sdot^2 and u = sddot all limits are linear, `|q' u + q'' x| <= a` and `0 <= x <= X`, and along one interval
`x_next = x + 2 ds u`. A backward pass finds the largest x from which the end can still be reached, a forward pass takes the largest u that
stays below it. The largest feasible x is found by bisection, since the feasible x form an interval that starts at 0.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from core.array import Array

_BISECTIONS = 60


@njit(cache=True)
def _accelerations(tangent: Array, curvature: Array, limit: Array, x: float) -> tuple[float, float]:
    """Smallest and largest u that keep `|q' u + q'' x| <= a`; the interval is empty (first > second) where none does."""
    low, high = -1e12, 1e12
    for j in range(len(limit)):
        t, c = tangent[j], curvature[j] * x
        if abs(t) < 1e-9:
            if abs(c) > limit[j]:
                return 1.0, -1.0
            continue
        first, second = (-limit[j] - c) / t, (limit[j] - c) / t
        if first > second:
            first, second = second, first
        low, high = max(low, first), min(high, second)
    return low, high


@njit(cache=True)
def _can_reach(tangent: Array, curvature: Array, limit: Array, x: float, ds: float, x_next: float) -> bool:
    """Whether an allowed u leads from x into [0, x_next] over ds."""
    low, high = _accelerations(tangent, curvature, limit, x)
    return bool(low <= high and x + 2.0 * ds * low <= x_next and x + 2.0 * ds * high >= 0.0)


@njit(cache=True)
def _profile(s: Array, tangent: Array, curvature: Array, limit: Array, ceiling: Array) -> Array:
    last = len(s) - 1
    K = np.zeros(last + 1)
    for i in range(last - 1, -1, -1):
        ds = s[i + 1] - s[i]
        high = ceiling[i]
        if not _can_reach(tangent[i], curvature[i], limit, high, ds, K[i + 1]):
            low = 0.0
            for _ in range(_BISECTIONS):
                middle = 0.5 * (low + high)
                if _can_reach(tangent[i], curvature[i], limit, middle, ds, K[i + 1]):
                    low = middle
                else:
                    high = middle
            high = low
        K[i] = high
    x = np.zeros(last + 1)
    for i in range(last):
        u = _accelerations(tangent[i], curvature[i], limit, x[i])[1]
        x[i + 1] = max(0.0, min(K[i + 1], x[i] + 2.0 * (s[i + 1] - s[i]) * u))
    return x


def fastest_profile(s: Array, tangent: Array, curvature: Array, acceleration: Array, ceiling: Array) -> Array:
    """Squared speeds x = sdot^2 (N,) at the grid points s, as large as the limits allow, 0 at both ends.

    Args:
        s: (N,), path parameter, strictly increasing.
        tangent, curvature: (N, n), first and second derivative of the joint positions with respect to s.
        acceleration: (n,), limits, rad/s2.
        ceiling: (N,), largest allowed x at each point (from velocity and Cartesian speed).
    """
    return np.asarray(_profile(s, tangent, curvature, acceleration, ceiling))
