"""Least squares whose columns are themselves noisy: what noise alone adds to the information is taken off again."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.array import Array

LARGEST_NOISE_SHARE = 0.9
"""Of the information in one direction; beyond it what is left counts less and less."""


@dataclass(frozen=True)
class Solution:
    """Least squares whose columns are noisy: the gain (n, n) times the right-hand side is the solution.

    Args:
        covariance: (n, n), with priors. told: (n, n), information without them. plain: (n, n), covariance as if no column were noisy.
    """

    covariance: Array
    gain: Array
    told: Array
    plain: Array


@dataclass(frozen=True)
class NoiseOfColumns:
    """Information that is noise of the columns on average.

    Args:
        rows: (k,), unknowns that have some. root: (k, k), of it: `root root^T`.
    """

    rows: NDArray[np.intp]
    root: Array

    @classmethod
    def of(cls, bias: Array) -> NoiseOfColumns:
        """Of the information (n, n)."""
        rows = np.flatnonzero(np.diag(bias))
        values, vectors = np.linalg.eigh(bias[np.ix_(rows, rows)])
        return cls(rows, vectors * np.sqrt(np.maximum(values, 0.0)))


def compensate(normal: Array, noise: NoiseOfColumns, prior: Array) -> Solution:
    """Takes off what noise alone has added to the information.

    Where noise makes up nearly all of it, less and less is taken as known, and in the end the prior alone: the little that chance leaves
    would be a number without meaning.

    Args:
        normal: (n, n); noise: how much of it is noise on average. prior: (n,), information that is known before.
    """
    information = normal + np.diag(prior)
    plain = _inverse(information)
    rows, root = noise.rows, noise.root
    share, directions = np.linalg.eigh(root.T @ plain[np.ix_(rows, rows)] @ root)
    lean, share = root @ directions, np.maximum(share, 1e-12)
    trust = np.clip((1.0 - share) / (1.0 - LARGEST_NOISE_SHARE), 0.0, 1.0)
    told = normal.copy()
    told[np.ix_(rows, rows)] -= (lean * ((1.0 - (1.0 - share) * trust) / share)) @ lean.T
    damping = np.eye(len(normal))
    damping[rows] -= (lean * ((1.0 - trust) / share)) @ lean.T @ plain[rows]
    covariance = _inverse(told + np.diag(prior + np.where(np.arange(len(prior)) < 10, prior, 0.0)))
    return Solution(covariance, covariance @ damping, told, plain)


def _inverse(matrix: Array) -> Array:
    scale = 1.0 / np.sqrt(np.diag(matrix))
    return np.asarray(np.linalg.inv(matrix * np.outer(scale, scale)) * np.outer(scale, scale))
