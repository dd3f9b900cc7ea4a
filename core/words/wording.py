"""What a page says in one language: messages of the catalogue, what other parts of the engine say, and numbers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from core.words.catalogue import Language, decimal_mark
from core.words.message import Message, Parameter


@dataclass(frozen=True)
class Wording:
    """The words of one page or sheet."""

    language: Language = "en"

    def say(self, code: str, /, **parameters: Parameter) -> str:
        """A message of the catalogue."""
        return Message.of(code, **parameters).say(self.language)

    def quote(self, said: Message | str) -> str:
        """What another part of the engine says: a message in this language, a name as it is."""
        return said.say(self.language) if isinstance(said, Message) else said

    def mark(self, number: str) -> str:
        """A number that is written already, with the language's decimal mark."""
        return number.replace(".", decimal_mark(self.language))

    def list_numbers(self, numbers: Iterable[str]) -> str:
        """Numbers that are written already in a row; nothing between them looks like a decimal mark."""
        return (", " if decimal_mark(self.language) == "." else "; ").join(map(self.mark, numbers))


ENGLISH = Wording()
