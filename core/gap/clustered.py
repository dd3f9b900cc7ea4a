"""Standard uncertainties of a fit whose model is not exact: its misfit repeats itself within a second, and is not noise."""

from __future__ import annotations

import numpy as np

from core.array import Array

CLUSTER_S = 1.0
"""What a model gets wrong goes on for about so long; further apart it counts as independent."""


def enlarge_covariance(covariance: Array, columns: Array, residual: Array, t: Array) -> Array:
    """The covariance with each standard uncertainty raised to its cluster-robust one where that is larger; correlations stay.

    The robust covariance is `N^-1 (sum_g s_g s_g^T) N^-1 G / (G - 1)` with `s_g = Z_g^T r_g` over G clusters of one second (Liang and
    Zeger 1986). Where the model is exact it comes to `N^-1`.

    Args:
        covariance: (n, n), `N^-1`.
        columns: (6 K, n), Z, whitened; channel by channel.
        residual: (6 K,), r, likewise.
        t: (K,), s, increasing.
    """
    starts = np.flatnonzero(np.diff(np.floor((t - t[0]) / CLUSTER_S), prepend=-1.0))
    count = len(starts)
    if count < 2:
        return covariance
    windows = (columns * residual[:, None]).reshape(-1, len(t), columns.shape[1]).sum(axis=0)
    scores = np.add.reduceat(windows, starts, axis=0)
    robust = np.square(scores @ covariance).sum(axis=0) * count / (count - 1)
    raised = np.sqrt(np.maximum(1.0, robust / np.diag(covariance)))
    return covariance * np.outer(raised, raised)
