"""Who is in control of a cell: one person at a time, whose screen answers the server's stamps.

The server sends a stamp of its own clock; the screen sends it back with the fence of its holder and a number that counts up. What comes
back is as old as its stamp, whatever the network did to it meanwhile: a message that lay in a buffer renews nothing.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Annotated

from sqlalchemy.orm import Session

from core.sessions.leased import FUTURE_S, Renewal
from server.http.dependencies import depend_on
from server.http.errors import Conflict
from server.runs.link import Link
from server.runs.tables import ControlFence

STAMP_PERIOD_S = 0.05
"""Of the stamps that are sent to the screen."""
SETTLE_S = 3.0
"""From taking control to the first answered stamp."""
COMMAND_AGE_S = 2.0
"""Of the stamp that a command carries: what a person saw when they pressed."""


@dataclass
class Holder:
    """Of the control of one cell.

    Args:
        fence: counts the holders.
        lease_s: of the cell.
        alive_s: when they last were.
        number: of the last renewal; `command`: of the last command.
    """

    who: str
    fence: int
    lease_s: float
    alive_s: float
    number: int = -1
    command: int = -1
    confirmed: bool = False
    link: Link = field(default_factory=Link)


class ControlRegistry:
    """Of all cells. Only the event loop's thread may use it.

    Args:
        clock: monotonic, s; the same that control processes read.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self.clock = clock
        self._holders: dict[str, Holder] = {}

    def holder(self, cell: str) -> Holder | None:
        """Who is in control; None if nobody is."""
        holder = self._holders.get(cell)
        if holder is None:
            return None
        patience = holder.lease_s if holder.confirmed else SETTLE_S
        return holder if self.clock() - holder.alive_s <= patience else None

    def unattended_s(self, cell: str) -> float | None:
        """For how long nobody has been in control; None where somebody is, or nobody ever was."""
        last = self._holders.get(cell)
        return None if last is None or self.holder(cell) is not None else self.clock() - last.alive_s - last.lease_s

    def check_free(self, cell: str, who: str) -> None:
        """Whether somebody may take control.

        Raises:
            Conflict: somebody else is in control.
        """
        present = self.holder(cell)
        if present is not None and present.who != who:
            raise Conflict("runs-control-taken", cell=cell, holder=present.who)

    def take(self, cell: str, who: str, fence: int, lease_s: float) -> Holder:
        """Gives control of a cell that nobody else holds, with a fence of `next_fence`; who holds it already has it on a new screen then.

        Raises:
            Conflict: somebody else is in control.
        """
        self.check_free(cell, who)
        self._holders[cell] = Holder(who, fence, lease_s, self.clock())
        return self._holders[cell]

    def let_go(self, cell: str, who: str, fence: int) -> None:
        """Whoever had this fence has no more control, and does not get it back with it."""
        if self.held_with(cell, who, fence) is not None:
            del self._holders[cell]

    def held_with(self, cell: str, who: str, fence: int) -> Holder | None:
        """The last holder where that is whoever has this fence; their connection may be lost meanwhile."""
        holder = self._holders.get(cell)
        return holder if holder is not None and (holder.who, holder.fence) == (who, fence) else None

    def renew(self, cell: str, who: str, renewal: Renewal) -> bool:
        """Takes an answered stamp; one that is old, repeated, reordered, from the future or not the holder's counts for nothing."""
        holder, now = self.held_with(cell, who, renewal.fence), self.clock()
        if holder is None or renewal.number <= holder.number:
            return False
        if not max(now - holder.lease_s, holder.alive_s if holder.confirmed else 0.0) < renewal.stamp_s <= now + FUTURE_S:
            return False
        holder.number, holder.alive_s, holder.confirmed = renewal.number, renewal.stamp_s, True
        return True

    def command(self, cell: str, who: str, renewal: Renewal) -> None:
        """Takes the fence, number and stamp of a command.

        Raises:
            Conflict: whoever sends it is not in control, or it is old, repeated, reordered or from the future.
        """
        holder, now = self.holder(cell), self.clock()
        if holder is None or not holder.confirmed:
            raise Conflict("runs-control-free", cell=cell)
        if (holder.who, holder.fence) != (who, renewal.fence):
            raise Conflict("runs-control-elsewhere", cell=cell, holder=holder.who, fence=holder.fence, who=who, sent_fence=renewal.fence)
        if renewal.number <= holder.command:
            raise Conflict("runs-command-repeated", number=renewal.number, last_number=holder.command)
        if not now - COMMAND_AGE_S <= renewal.stamp_s <= now + FUTURE_S:
            raise Conflict("runs-command-late", age_s=now - renewal.stamp_s, limit_s=COMMAND_AGE_S)
        holder.command = renewal.number


def next_fence(db: Session, cell: str) -> int:
    """A fence that nobody has had; it never counts back, also not when the service starts anew."""
    row = db.get(ControlFence, cell)
    if row is None:
        row = ControlFence(cell=cell, fence=0)
        db.add(row)
    row.fence += 1
    return row.fence


ControlDep = Annotated[ControlRegistry, depend_on("control")]
