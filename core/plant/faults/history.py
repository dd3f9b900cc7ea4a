"""The last samples of a signal, to be read at any time between them."""

from __future__ import annotations

from collections import deque

from core.array import Array


class History:
    """Keeps a signal for `longest_s` and reads it between samples by straight lines; before its start it was constant.

    Args:
        longest_s: as far as `ago` may reach back, s.
        period: s.
    """

    def __init__(self, longest_s: float, period: float) -> None:
        self._period = period
        self._last: deque[Array] = deque(maxlen=int(longest_s / period) + 3)

    def push(self, value: Array) -> None:
        """Takes the newest sample."""
        if not self._last:
            self._last.extend([value] * (self._last.maxlen or 1))
        self._last.appendleft(value)

    def ago(self, seconds: float) -> Array:
        """The signal that long before the newest sample; not before the oldest."""
        place = min(max(seconds / self._period, 0.0), len(self._last) - 1.001)
        whole = int(place)
        share = place - whole
        return (1 - share) * self._last[whole] + share * self._last[whole + 1]
