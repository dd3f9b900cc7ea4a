"""Entries of twins for tests, as if a recording had been diagnosed."""

from __future__ import annotations

from datetime import UTC, datetime

import numpy as np

from core.cell.cell import Cell
from core.effects.library import find_effect
from core.twin.model import make_home_scene
from core.twin.twin import Entry, Fitted


def entry(cell: Cell, effect: str, *, std: float = 1e-4, **values: float) -> Entry:
    """An effect of the cell; parameters that are not given have their absent values. All have the same uncertainty, independently."""
    parameters = find_effect(effect).parameters(make_home_scene(cell))
    fitted = {p.name: Fitted(value=values.pop(p.name, p.absent), std=std, unit=p.unit) for p in parameters}
    assert not values, f"{effect} has no {list(values)}"
    return Entry(
        effect=effect,
        parameters=fitted,
        covariance=tuple(tuple(row) for row in (std**2 * np.eye(len(fitted))).tolist()),
        recording="run-1",
        sha256="0123456789abcdef" * 4,
        added=datetime(2026, 1, 2, 3, 4, tzinfo=UTC),
        gap_before=5.0,
        gap_after=1.0,
    )
