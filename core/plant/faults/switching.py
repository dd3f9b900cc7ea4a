"""On and off at random moments."""

from __future__ import annotations

import numpy as np


class RandomSwitch:
    """Two states with exponential durations (a random telegraph).

    Args:
        mean_s: how long it is off and on, on average, s.
        on: how it begins.
    """

    def __init__(self, mean_s: tuple[float, float], seed: int, *, on: bool) -> None:
        self._rng = np.random.default_rng(seed)
        self._mean_s, self._on = mean_s, on
        self._until = self._rng.exponential(mean_s[on])

    def is_on(self, t: float) -> bool:
        """At a time, s, not before the last one asked for."""
        while t >= self._until:
            self._on = not self._on
            self._until += self._rng.exponential(self._mean_s[self._on])
        return self._on
