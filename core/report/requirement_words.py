"""Whether an answer is good enough for its cell, as words of the report."""

from __future__ import annotations

from dataclasses import dataclass

from core.report.rows import sentence
from core.requirement.answer import RequirementPart
from core.words.wording import Wording


@dataclass(frozen=True)
class RequirementBlock:
    """What the page says of it.

    Args:
        sign: before the verdict.
        alarm: whether it is not good enough.
        details: what stands behind the verdict.
    """

    sign: str
    verdict: str
    alarm: bool
    details: list[str]


def requirement_block(requirement: RequirementPart | None, words: Wording) -> RequirementBlock | None:
    """None where nothing is known of the cell."""
    if requirement is None:
        return None
    return RequirementBlock(
        sign=verdict_sign(requirement),
        verdict=sentence(requirement.message, words),
        alarm=requirement.adequacy is not None and not requirement.adequacy.good_enough,
        details=[sentence(each, words) for each in requirement.details],
    )


def verdict_sign(requirement: RequirementPart) -> str:
    """Good enough, not good enough, not judged."""
    if requirement.adequacy is None:
        return "?"
    return "✓" if requirement.adequacy.good_enough else "▲"
