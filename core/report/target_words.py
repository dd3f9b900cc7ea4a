"""How far a run met its target, as words of the report."""

from __future__ import annotations

from dataclasses import dataclass

from core.report.rows import sentence
from core.requirement.target_answer import TargetPart
from core.words.wording import Wording


@dataclass(frozen=True)
class TargetBlock:
    """What the page says of it.

    Args:
        sign: before the sentence.
        alarm: whether it was not reached.
        details: each quantity against what was wanted.
    """

    sign: str
    verdict: str
    alarm: bool
    details: list[str]


def target_block(target: TargetPart | None, words: Wording) -> TargetBlock | None:
    """None where there was no target."""
    if target is None:
        return None
    reached = target.standing == "reached"
    return TargetBlock(
        sign="✓" if reached else "▲",
        verdict=sentence(target.message, words),
        alarm=not reached,
        details=[sentence(each.message, words) for each in target.quantities],
    )
