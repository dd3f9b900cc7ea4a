"""A body of point masses: everything about it is a sum, in whatever frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.payload.uncertain_parameters import UncertainParameters


@dataclass(frozen=True)
class Cloud:
    """Masses (N,), kg, at points (N, 3), m."""

    masses: Array
    points: Array

    @property
    def com(self) -> Array:
        return self.masses @ self.points / self.masses.sum()

    def inertia(self, about: Array) -> Array:
        """(3, 3), straight from its definition: sum of m (r^2 1 - r r^T)."""
        total = np.zeros((3, 3))
        for mass, point in zip(self.masses, self.points - about, strict=True):
            total += mass * (point @ point * np.eye(3) - np.outer(point, point))
        return total

    def parameters(self, covariance: Array) -> UncertainParameters:
        """In the paper's order."""
        inertia = self.inertia(np.zeros(3))
        six = [inertia[i, j] for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))]
        return UncertainParameters(np.array([self.masses.sum(), *(self.masses @ self.points), *six]), covariance)

    def moved(self, rotation: Array, translation: Array) -> Cloud:
        return Cloud(self.masses, self.points @ rotation.T + translation)


def cloud(seed: int) -> Cloud:
    """A tool of some kilograms beside its flange."""
    rng = np.random.default_rng(seed)
    return Cloud(rng.uniform(0.1, 0.8, 8), rng.normal([0.02, -0.03, 0.09], [0.05, 0.03, 0.06], (8, 3)))


def covariance(seed: int) -> Array:
    """(10, 10), of a usual identification: grams, tenths of millimetres, some 1e-5 kg m2."""
    rng = np.random.default_rng(seed)
    std = np.array([2e-3, *[2e-4] * 3, *[3e-5] * 6])
    mixed = np.eye(10) + 0.2 * rng.normal(size=(10, 10))
    return np.asarray(std[:, None] * (mixed @ mixed.T) * std)
