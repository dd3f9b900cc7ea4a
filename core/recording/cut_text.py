"""What a file says, short and printable enough to be named in a message."""

from __future__ import annotations


def cut_text(value: object, most: int = 80) -> str:
    """Its beginning, with spaces for what cannot be printed."""
    return "".join(letter if letter.isprintable() else " " for letter in str(value)[:most])
