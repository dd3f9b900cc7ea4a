"""The pairs of which the second opinion asks nothing, in words."""

from __future__ import annotations

from collections.abc import Sequence

from core.second_opinion.pairs import AccountedPair


def describe_left_out(pairs: Sequence[AccountedPair]) -> list[str]:
    """A line for each reason, with all pairs that have it."""
    return [
        f"{', '.join(f'{pair.first} - {pair.second}' for pair in pairs if pair.why == why)}: {why}"
        for why in dict.fromkeys(pair.why for pair in pairs)
    ]
