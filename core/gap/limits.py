"""From where on a gap, or a payload that it moves, matters."""

from __future__ import annotations

import numpy as np

GAP = 2.0
"""Held-out gap, noise being 1, from which an effect is material."""
SHARES = np.repeat([0.01, 0.01, 0.03], [1, 3, 6])
"""(10,), of the mass, of the norm of the first moment, of the largest moment of inertia."""
