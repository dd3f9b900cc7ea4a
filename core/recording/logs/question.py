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
    """

    def __init__(self, where: str, key: str, choices: Sequence[str], reason: str) -> None:
        self.key, self.choices, self.reason = key, tuple(choices), Message.of(reason)
        super().__init__(where, "import-question", key=key, choices=[f"--set '{key}={choice}'" for choice in choices], reason=self.reason)
