"""Messages in stored answers, some of which are from before there were messages."""

from __future__ import annotations

from typing import Annotated, TypeAlias

from pydantic import BeforeValidator

from core.words.message import Message


def restore_message(said: object) -> object:
    """A message as it is; of a sentence that an earlier version stored, the message that says it."""
    return Message.of("text", text=said) if isinstance(said, str) else said


Said: TypeAlias = Annotated[Message, BeforeValidator(restore_message)]
"""What is said in a stored answer."""
