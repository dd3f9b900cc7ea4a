"""A message that says anything."""

from __future__ import annotations

from core.words.message import Message


def sentence(text: str) -> Message:
    """A message with these words."""
    return Message.of("text", text=text)
