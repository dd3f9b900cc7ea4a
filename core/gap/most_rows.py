"""The payload that most rows agree on, whatever the others say: least trimmed squares (Rousseeuw 1984)."""

from __future__ import annotations

from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.estimation.quadratic import solve_scaled
from core.gap.windows import Windows

FREE = 1.0 / 3.0
"""Share of the rows that the payload has to fit, at least."""
PARTS, DRAWN = 12, 3
"""The search begins at every choice of so many of so many equal parts of the recording,"""
KEPT, ROUNDS = 8, 30
"""and goes on from the best ones, by so many concentration steps at most (Rousseeuw and Van Driessen 2006)."""


def fit_most(windows: Windows, target: Array) -> Array:
    """(n,), payload, offsets and imperfections that fit the best of the target's rows (6, K) best."""
    X = windows.X
    normal, right = np.einsum("ckn,ckm->knm", X, X), np.einsum("ckn,ck->kn", X, target)
    prior = np.diag(windows.prior_std**-2.0)
    most = round(FREE * len(windows))

    def fit(rows: NDArray[np.intp]) -> Array:
        return solve_scaled(normal[rows].sum(axis=0) + prior, right[rows].sum(axis=0))

    def squares(beta: Array) -> Array:
        return np.asarray(((target - X @ beta) ** 2).sum(axis=0))

    def cost(beta: Array) -> float:
        return float(np.sort(squares(beta))[:most].sum())

    def concentrate(beta: Array) -> Array:
        for _ in range(ROUNDS):
            closer = fit(np.argsort(squares(beta))[:most])
            if cost(closer) >= (1.0 - 1e-9) * cost(beta):
                break
            beta = closer
        return beta

    parts = np.array_split(np.arange(len(windows)), PARTS)
    begun = sorted((fit(np.concatenate(drawn)) for drawn in combinations(parts, DRAWN)), key=cost)
    return min(map(concentrate, begun[:KEPT]), key=cost)
