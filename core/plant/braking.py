"""How the drives brake when they are told to stop."""

from __future__ import annotations

import math

import numpy as np

from core.array import Array


def braking_positions(q: Array, dq: Array, acceleration: Array, *, period: float) -> Array:
    """Commands that take a moving arm to standstill, all joints at the same time.

    The joint velocity keeps its direction while it shrinks, so the arm stays on its path to first order and no point of
    it gets faster: if each joint braked as hard as it can, one that stops early would no longer cancel the motion of
    another.

    Args:
        q, dq: (n,), commanded position and velocity now.
        acceleration: (n,), limits, rad/s2.
        period: s.

    Returns:
        (K, n), one row per coming period, `K = ceil(max |dq / acceleration| / period)`; the last two rows are equal up
        to rounding. Each joint travels `|dq| (K - 1) period / 2`.
    """
    K = math.ceil(float(np.max(np.abs(dq) / acceleration)) / period)
    share = 1.0 - np.arange(1, K + 1) / max(K, 1)
    return np.asarray(q + np.outer(period * np.cumsum(share), dq))
