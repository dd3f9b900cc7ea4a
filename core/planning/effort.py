"""How much is searched before a plan is refused: in candidates and iterations, not in seconds, so that every machine finds the same.

More effort begins with what less effort does: it never changes a plan that less of it finds.
"""

from __future__ import annotations

PATH_ITERATIONS = (800, 1200, 2000, 4000)
"""Of one search for a path after the other, in all twice the last: most paths take a tenth of the first, and where there is no path to a
start configuration another one is cheaper than a longer search."""

GRID_ROUNDS = 3
"""Rounds of the search for a start configuration, each with twice the candidates of the one before."""


def path_iterations(effort: int) -> tuple[int, ...]:
    """Iterations of one search after the other, in all at least `effort` times those of 1."""
    return (*PATH_ITERATIONS, *(PATH_ITERATIONS[-1] * 2**k for k in range(1, _doublings(effort) + 1)))


def grid_rounds(effort: int) -> int:
    """Rounds that try at least `effort` times the candidates of 1."""
    return GRID_ROUNDS + _doublings(effort)


def _doublings(effort: int) -> int:
    """How often twice as much is at least `effort` times as much."""
    return (effort - 1).bit_length()
