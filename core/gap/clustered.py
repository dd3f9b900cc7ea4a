"""Standard uncertainties of a fit whose model is not exact: its misfit repeats itself within a second, or a motion, and is not noise."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.array import Array

CLUSTER_S = 1.0
"""What a model gets wrong goes on for about so long at least; further apart it may count as independent."""


def enlarge_covariance(covariance: Array, columns: Array, residual: Array, t: Array, motion: NDArray[np.int64]) -> Array:
    """The covariance with each standard uncertainty raised to its cluster-robust one where that is larger; correlations stay.

    The robust covariance is `N^-1 (sum_g s_g s_g^T) N^-1 G / (G - 1)` with `s_g = Z_g^T r_g` over G clusters (Liang and Zeger 1986): of one
    second each, and motion by motion; the larger of both counts. Where the model is exact they come to `N^-1`.

    Args:
        covariance: (n, n), `N^-1`.
        columns: (6 K, n), Z, whitened; channel by channel.
        residual: (6 K,), r, likewise.
        t: (K,), s, increasing. motion: (K,), number of the motion that each row belongs to, not decreasing.
    """
    seconds = np.floor((t - t[0]) / CLUSTER_S).astype(np.int64)
    windows = (columns * residual[:, None]).reshape(-1, len(t), columns.shape[1]).sum(axis=0)
    robust = [_find_spread(windows @ covariance, of) for of in (seconds, motion)]
    raised = np.sqrt(np.maximum(1.0, np.maximum(*robust) / np.diag(covariance)))
    return np.asarray(covariance * np.outer(raised, raised))


def _find_spread(moved: Array, cluster: NDArray[np.int64]) -> Array:
    """(n,), variance by what each cluster (K,) moves the parameters (K, n) together; nothing where there is one alone."""
    starts = np.flatnonzero(np.diff(cluster, prepend=cluster[0] - 1))
    count = len(starts)
    return np.asarray(np.square(np.add.reduceat(moved, starts, axis=0)).sum(axis=0) * count / max(count - 1, 1) * (count > 1))
