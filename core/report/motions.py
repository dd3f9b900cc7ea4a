"""Motions as recordings and plans name them, in words."""

from __future__ import annotations

from core.words.message import Message
from core.words.wording import Wording

CODES = {
    "hold:": "report-phase-hold",
    "rotate:": "report-phase-rotation",
    "transfer:": "report-phase-transfer",
    "hold ": "report-part-hold",
    "rotation ": "report-part-rotation",
    "transfer ": "report-part-transfer",
    "wave ": "report-part-wave",
    "transfer": "report-part-between",
    "home": "report-part-home",
}
"""By what a name has before its axis."""


def name_motion(name: object, words: Wording) -> str:
    """`rotate:x`, or `rotation x`, in words; a name that no motion of Heft has as it is."""
    if isinstance(name, Message):
        return words.quote(name)
    text = str(name)
    for mark in (":", " "):
        kind, found, axis = text.partition(mark)
        if found and kind + found in CODES:
            return words.say(CODES[kind + found], axis=axis)
    return words.say(CODES[text]) if text in CODES else text
