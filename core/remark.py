"""What somebody should know before they use a number, for people of any language."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Remark:
    """One of them.

    Args:
        id: what it is about; a language has words for it.
        sentence: in English.
        values: what the sentence names, SI.
    """

    id: str
    sentence: str
    values: dict[str, float | str] = field(default_factory=dict)
