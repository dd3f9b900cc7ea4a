"""What a log does not tell and a person has to."""

from __future__ import annotations

from collections.abc import Sequence

from core.errors import BadRecording
from core.words.message import Message


class OpenQuestion(BadRecording):
    """A key of the mapping that a person has to choose a value for.

    Args:
        where: the log.
        key: such as `wrench.file`.
        choices: values that it may have.
        reason: code of what it means, without parameters.
        likely: the choice that most speaks for; None where nothing speaks for any.
    """

    def __init__(self, where: str, key: str, choices: Sequence[str], reason: str, likely: str | None = None) -> None:
        self.key, self.choices, self.reason, self.likely = key, tuple(choices), Message.of(reason), likely
        super().__init__(where, "import-question", key=key, choices=[f"--set '{key}={choice}'" for choice in choices], reason=self.reason)
