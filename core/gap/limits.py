"""From where on a gap, or a payload that it moves, matters."""

from __future__ import annotations

import numpy as np

from core.array import Array

GAP = 2.0
"""Held-out gap, noise being 1, from which an effect is material."""
SHARES = np.repeat([0.01, 0.01, 0.03], [1, 3, 6])
"""(10,), of the mass, of the norm of the first moment, of the largest moment of inertia."""
BEYOND_STD = 2.0
"""Standard deviations beyond which a payload parameter has moved."""


def sizes(phi: Array) -> Array:
    """(10,), what the shares of payload parameters (10,) refer to."""
    return np.concatenate(([abs(phi[0])], np.full(3, np.linalg.norm(phi[1:4])), np.full(6, np.abs(phi[[4, 7, 9]]).max())))
