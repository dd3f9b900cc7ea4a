"""Draws that the causes and the rig have in common."""

from __future__ import annotations

import numpy as np

from bench.stranger.array import Array


def draw_log(rng: np.random.Generator, low: float, high: float) -> float:
    """Log-uniform between two positive bounds."""
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def draw_direction(rng: np.random.Generator, axes: int = 3) -> Array:
    """(axes,), a unit vector, every direction alike."""
    v = rng.normal(size=axes)
    return np.asarray(v / np.linalg.norm(v))


def draw_sign(rng: np.random.Generator) -> float:
    """-1 or 1."""
    return float(rng.choice([-1, 1]))
