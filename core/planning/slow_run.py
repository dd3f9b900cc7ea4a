"""A run that is slower than its cell allows, for the first time that somebody watches it."""

from __future__ import annotations

from core.cell.cell import Cell
from core.errors import BadInput

SLOWEST_M_S = 0.01
"""Slower than this a transfer takes minutes."""


def find_speed_range(cell: Cell) -> tuple[float, float]:
    """The lowest and the highest speed that may be asked for in a cell, m/s."""
    limit = cell.limits.cartesian_speed_m_s
    return min(SLOWEST_M_S, limit), limit


def limit_speed(cell: Cell, speed_m_s: float | None, where: str) -> Cell:
    """The cell with a lower limit on the Cartesian speed, which planner, controller, second opinion and guard then all keep.

    Args:
        speed_m_s: None for the cell's own.
        where: what it was asked for with.

    Raises:
        BadInput: it is no speed, or higher than the cell's.
    """
    if speed_m_s is None:
        return cell
    slowest, limit = find_speed_range(cell)
    if not slowest <= speed_m_s <= limit:
        raise BadInput(where, "planning-speed-out-of-range", speed_m_s=speed_m_s, slowest_m_s=slowest, limit_m_s=limit)
    return cell.model_copy(update={"limits": cell.limits.model_copy(update={"cartesian_speed_m_s": speed_m_s})})
