"""What an effect remembers of the rows before a scene's first, so that a run can be simulated in blocks, down to one row at a time.

A batch begins with nothing to remember and forgets what it leaves behind; a run that goes on in blocks hands the same `Memory` to
each of them.
"""

from __future__ import annotations

from collections import defaultdict
from typing import Any

import numpy as np
from numpy.typing import NDArray

Rows = NDArray[Any]


class Past:
    """What one operator remembers: rows of its own choice, None before the run's first row."""

    def __init__(self) -> None:
        self.rows: Rows | None = None

    def before(self, x: Rows, count: int) -> Rows:
        """`x` (N, ...) behind the `count` rows that came before it, or as many as there have been; its own end is remembered."""
        whole = x if self.rows is None else np.concatenate([self.rows, x])
        self.rows = whole[-count:].copy()
        return whole

    def first(self, x: Rows) -> Rows:
        """The run's first row of `x`."""
        if self.rows is None:
            self.rows = x[:1].copy()
        return np.asarray(self.rows[0])


class Memory(defaultdict[str, Past]):
    """The pasts of one effect's operators, by name."""

    def __init__(self) -> None:
        super().__init__(Past)
