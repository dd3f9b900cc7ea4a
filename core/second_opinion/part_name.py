"""What a message calls the parts of a motion."""

from __future__ import annotations

from core.words.message import Message


def name_part(part: str) -> Message:
    """A part of a motion, such as `transfer x+` or `home`, as a message names it; by its own name where it has another one."""
    match part.split():
        case ["transfer", axis]:
            return Message.of("planning-part-transfer", axis=axis)
        case ["rotation", axis]:
            return Message.of("planning-part-rotation", axis=axis)
        case ["wave", axis]:
            return Message.of("planning-part-wave", axis=axis)
        case ["home"]:
            return Message.of("planning-part-home")
        case ["start"]:
            return Message.of("planning-part-start")
    return Message.of("text", text=part)
