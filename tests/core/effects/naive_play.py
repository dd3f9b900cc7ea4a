"""Play, sample by sample."""

from __future__ import annotations

import numpy as np

Array = np.ndarray


def naive_play(x: Array, r: float) -> Array:
    """A piston of half-width r that is pushed along."""
    piston, out = x[0], []
    for value in x:
        if value - piston > r:
            piston = value - r
        elif piston - value > r:
            piston = value + r
        out.append(piston)
    return np.array(out)
