"""Readings of a sensor that is asked less often than they are recorded: which of them are fresh."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from core.array import Array
from core.effects.sample_dropout import find_held_share

LEAST = 0.15
"""Share of held rows from which a recording is looked at through its fresh readings alone."""


class Fresh(NamedTuple):
    """Where the fresh readings lie.

    Args:
        rows: (M,), the fresh ones.
        between: (N, N), from samples to the straight lines between those at fresh rows; what goes through it is known at no other row.
        every: how many rows from one fresh reading to the next, in the mean.
    """

    rows: NDArray[np.intp]
    between: csr_array
    every: float


def find_fresh(wrench: Array) -> Fresh | None:
    """The fresh rows of readings (N, 6), of which the others repeat the row before in all channels; None where hardly any does."""
    if find_held_share(wrench)[0] < LEAST:
        return None
    n = len(wrench)
    fresh = np.flatnonzero(np.concatenate(([True], (np.diff(wrench, axis=0) != 0).any(axis=1))))
    rows = np.arange(n)
    after = np.clip(np.searchsorted(fresh, rows, side="right"), 1, len(fresh) - 1)
    first, last = fresh[after - 1], fresh[after]
    share = np.clip((rows - first) / (last - first), 0.0, 1.0)
    weights, columns = np.concatenate((1.0 - share, share)), np.concatenate((first, last))
    return Fresh(fresh, csr_array((weights, (np.tile(rows, 2), columns)), shape=(n, n)), n / len(fresh))
