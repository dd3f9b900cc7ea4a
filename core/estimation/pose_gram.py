"""What the noise of the poses makes in the windows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import csr_array

from core.array import Array
from core.estimation.annihilating_filter import AnnihilatingFilter
from core.estimation.banded import BAND, bands_of, trace


@dataclass(frozen=True)
class PoseGram:
    """Covariance of the windowed accelerations by the noise of the poses.

    Args:
        noise: (6, 6), of one sample, the same everywhere.
        steady: (b, K), lower bands for unit noise.
        jittered: (6, 6, b, K), what goes with the speed; None where the samples have their instants.
    """

    noise: Array
    steady: Array
    jittered: Array | None

    @classmethod
    def of(cls, noise: Array, second: csr_array, jittered: Sequence[csr_array], count: int = BAND) -> PoseGram:
        """From the windows' second differences (K, N) of the poses and, where their instants are off, the six accelerations (K, N) of that.

        Args:
            count: of lower bands.
        """
        steady = bands_of(csr_array(second @ second.T), count)
        if not jittered:
            return cls(noise, steady, None)
        added = np.zeros((6, 6, *steady.shape))
        for a, b in np.ndindex(6, 6):
            if b <= a:
                product = csr_array(jittered[a] @ jittered[b].T)
                added[a, b] = added[b, a] = bands_of(csr_array(0.5 * (product + product.T)), count)
        return cls(noise, steady, added)

    def behind(self, filtering: AnnihilatingFilter) -> PoseGram:
        """Of what passes a filter over the windows."""
        if self.jittered is None:
            return replace(self, steady=filtering.covariance(self.steady))
        jittered = np.zeros((6, 6, self.jittered.shape[2] + filtering.reach, self.jittered.shape[3]))
        for a, b in np.ndindex(6, 6):
            if b <= a:
                jittered[a, b] = jittered[b, a] = filtering.covariance(self.jittered[a, b])
        return replace(self, steady=filtering.covariance(self.steady), jittered=jittered)

    def find_variance_through(self, m: Array) -> Array:
        """(b, K) of a channel in which the accelerations show as m (6,)."""
        seen = (m @ self.noise @ m) * self.steady
        return seen if self.jittered is None else seen + np.einsum("i,ijbk,j->bk", m, self.jittered, m, optimize=True)

    def trace_with(self, inverse: Array) -> Array:
        """(6, 6), trace of the products with the inverse (b, K) of a channel's covariance."""
        steady = self.noise * trace(inverse, self.steady)
        return steady if self.jittered is None else steady + trace(inverse, self.jittered)
