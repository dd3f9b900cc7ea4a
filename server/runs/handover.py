"""Control of a cell that is asked for while somebody else has it, and how that ends.

A request has a fence of its own from the beginning, and the screen that asks answers the server's stamps with it, as whoever is in control
does. Control passes with one of these answers: so it is never between two screens, never with two, and a robot that moves is supervised
throughout.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum

from server.runs.link import Link

PASS_S = 30.0
"""How long whoever is in control may take to answer a request; then control passes."""


@dataclass
class Holder:
    """Of the control of one cell, or who asks for it.

    Args:
        fence: counts the holders.
        lease_s: of the cell.
        alive_s: when they last were.
        device: the name of their screen; may be empty.
        since_s: when control became theirs.
        number: of the last renewal; `command`: of the last command.
    """

    who: str
    fence: int
    lease_s: float
    alive_s: float
    device: str = ""
    since_s: float = 0.0
    number: int = -1
    command: int = -1
    confirmed: bool = False
    link: Link = field(default_factory=Link)


class RequestOutcome(StrEnum):
    """How a request for control ended. Control has passed in the first four."""

    accepted = "accepted"
    unanswered = "unanswered"
    vacant = "vacant"
    own = "own"
    declined = "declined"
    withdrawn = "withdrawn"
    silent = "silent"
    overtaken = "overtaken"


@dataclass
class ControlRequest:
    """One that nobody has answered yet, or that is about to pass.

    Args:
        asker: whose fence is newer than the holder's.
        passes_s: when control passes by itself.
        due: why control passes with the asker's next answer, where it does before that.
    """

    asker: Holder
    asked_s: float
    passes_s: float
    due: RequestOutcome | None = None


@dataclass(frozen=True)
class EndedRequest:
    """How the last request of a cell ended.

    Args:
        fence: of the request; that of the holder where control has passed.
        who, device: who asked.
        holder: who was in control until then, or declined; null where nobody was.
        at_s: when.
    """

    fence: int
    who: str
    device: str
    holder: str | None
    outcome: RequestOutcome
    at_s: float
