"""The pairs of which the second opinion asks nothing, as messages."""

from __future__ import annotations

from collections.abc import Sequence

from core.second_opinion.pairs import AccountedPair
from core.words.message import Message


def describe_left_out(pairs: Sequence[AccountedPair]) -> list[Message]:
    """One for each reason, with all pairs that have it."""
    reasons = {pair.why.code: pair.why for pair in pairs}
    return [
        Message.of(
            "opinion-left-out",
            pairs=[Message.of("opinion-pair", first=pair.first, second=pair.second) for pair in pairs if pair.why == why],
            reason=why,
        )
        for why in reasons.values()
    ]
