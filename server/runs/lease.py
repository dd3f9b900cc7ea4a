"""Who is in control of a cell: one person at a time, whose screen answers the server's stamps.

The server sends a stamp of its own clock; the screen sends it back with the fence of its holder and a number that counts up. What comes
back is as old as its stamp, whatever the network did to it meanwhile: a message that lay in a buffer renews nothing. Control that somebody
has passes to another who asks for it (see `server.runs.handover`).
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Annotated

from sqlalchemy.orm import Session

from core.sessions.leased import FUTURE_S, Renewal
from server.http.dependencies import depend_on
from server.http.errors import Conflict
from server.runs.handover import PASS_S, ControlRequest, EndedRequest, Holder, RequestOutcome
from server.runs.tables import ControlFence

STAMP_PERIOD_S = 0.05
"""Of the stamps that are sent to the screen."""
SETTLE_S = 5.0
"""From taking control to the first answered stamp."""
COMMAND_AGE_S = 2.0
"""Of the stamp that a command carries: what a person saw when they pressed."""


class ControlRegistry:
    """Of all cells. Only the event loop's thread may use it.

    Args:
        clock: monotonic, s; the same that control processes read.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self.clock = clock
        self._holders: dict[str, Holder] = {}
        self._requests: dict[str, ControlRequest] = {}
        self._ended: dict[str, EndedRequest] = {}
        self._newest: dict[str, int] = {}  # fence that anybody was given

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

    def take(self, cell: str, who: str, fence: int, lease_s: float, device: str = "") -> Holder:
        """Gives control of a cell that nobody else holds, with a fence of `next_fence`; who holds it already has it on a new screen then.

        A request that waits is void.

        Raises:
            Conflict: somebody else is in control, or was faster.
        """
        self.check_free(cell, who)
        self._count_up(cell, fence)
        self._end_request(cell, RequestOutcome.overtaken)
        self._holders[cell] = Holder(who, fence, lease_s, self.clock(), device, self.clock())
        return self._holders[cell]

    def let_go(self, cell: str, who: str, fence: int) -> None:
        """Whoever had this fence has no more control, and does not get it back with it; nor do they ask for it any more."""
        if self.held_with(cell, who, fence) is not None:
            del self._holders[cell]
        if self.asked_with(cell, who, fence) is not None:
            self._end_request(cell, RequestOutcome.withdrawn)

    def held_with(self, cell: str, who: str, fence: int) -> Holder | None:
        """The last holder where that is whoever has this fence; their connection may be lost meanwhile."""
        holder = self._holders.get(cell)
        return holder if holder is not None and (holder.who, holder.fence) == (who, fence) else None

    def request(self, cell: str) -> ControlRequest | None:
        """Who asks for control of a cell; a screen that has gone silent asks no more."""
        request = self._requests.get(cell)
        if request is not None and self.clock() - request.asker.alive_s > SETTLE_S:
            self._end_request(cell, RequestOutcome.silent)
        return self._requests.get(cell)

    def last_request(self, cell: str) -> EndedRequest | None:
        """How the last request that is over has ended; None where there was none."""
        self.request(cell)
        return self._ended.get(cell)

    def asked_with(self, cell: str, who: str, fence: int) -> Holder | None:
        """Who asks for control, where that is whoever has this fence."""
        request = self.request(cell)
        return request.asker if request is not None and (request.asker.who, request.asker.fence) == (who, fence) else None

    def check_may_ask(self, cell: str, who: str) -> None:
        """Whether somebody may ask for control: one asks at a time.

        Raises:
            Conflict: somebody else asks already.
        """
        request = self.request(cell)
        if request is not None and request.asker.who != who:
            raise Conflict("runs-control-asked", cell=cell, who=request.asker.who)

    def ask(self, cell: str, who: str, fence: int, lease_s: float, device: str = "") -> ControlRequest:
        """Asks for control, with a fence of `next_fence`, which has to come back with answered stamps from now on.

        Control passes with one of these answers: the next one where nobody is in control or whoever asks has control on another screen;
        else the one after it was accepted or nobody has answered for `PASS_S`. Until then nothing changes for whoever is in control.

        Raises:
            Conflict: somebody else asks already, or was faster.
        """
        self.check_may_ask(cell, who)
        self._count_up(cell, fence)
        self._end_request(cell, RequestOutcome.withdrawn)
        now, present = self.clock(), self.holder(cell)
        due = RequestOutcome.own if present is not None and present.who == who else None
        request = ControlRequest(Holder(who, fence, lease_s, now, device), now, now + PASS_S, due)
        self._requests[cell] = request
        return request

    def check_asked(self, cell: str, who: str, fence: int, asked: int) -> ControlRequest:
        """The request with the fence `asked`, for whoever is in control with `fence` to decide about.

        Raises:
            Conflict: they are not in control, or nobody asks with that fence any more.
        """
        self._check_holder(cell, who, fence)
        request = self.request(cell)
        if request is None or request.asker.fence != asked:
            raise Conflict("runs-control-not-asked", cell=cell)
        return request

    def answer(self, cell: str, who: str, fence: int, asked: int, *, accept: bool) -> None:
        """Whoever is in control with `fence` accepts or declines the request with the fence `asked`.

        One that is accepted passes with the asker's next answered stamp: should that not come, control stays where it is.

        Raises:
            Conflict: as `check_asked`.
        """
        request = self.check_asked(cell, who, fence, asked)
        if accept:
            request.due = RequestOutcome.accepted
        else:
            self._end_request(cell, RequestOutcome.declined)

    def renew(self, cell: str, who: str, renewal: Renewal) -> bool:
        """Takes an answered stamp; whether it renews control. One that is old, repeated, reordered, from the future or neither the holder's
        nor the asker's counts for nothing; one of the asker's renews control once that has passed, which it does with it."""
        holder = self.held_with(cell, who, renewal.fence)
        if holder is not None:
            return self._take_answer(holder, renewal)
        asker = self.asked_with(cell, who, renewal.fence)
        return asker is not None and self._take_answer(asker, renewal) and self._pass_when_due(cell)

    def _take_answer(self, holder: Holder, renewal: Renewal) -> bool:
        now = self.clock()
        if renewal.number <= holder.number:
            return False
        if not max(now - holder.lease_s, holder.alive_s if holder.confirmed else 0.0) < renewal.stamp_s <= now + FUTURE_S:
            return False
        holder.number, holder.alive_s, holder.confirmed = renewal.number, renewal.stamp_s, True
        return True

    def _pass_when_due(self, cell: str) -> bool:
        """Passes control to whoever asks, just after they have answered a stamp; whether it has passed."""
        request = self._requests[cell]
        if request.due is None and self.holder(cell) is None:
            request.due = RequestOutcome.vacant
        if request.due is None and self.clock() >= request.passes_s:
            request.due = RequestOutcome.unanswered
        if request.due is None:
            return False
        self._end_request(cell, request.due)
        request.asker.since_s = self.clock()
        self._holders[cell] = request.asker
        return True

    def _end_request(self, cell: str, outcome: RequestOutcome) -> None:
        request, holder = self._requests.pop(cell, None), self.holder(cell)
        if request is not None:
            asker, until = request.asker, None if holder is None else holder.who
            self._ended[cell] = EndedRequest(asker.fence, asker.who, asker.device, until, outcome, self.clock())

    def _count_up(self, cell: str, fence: int) -> None:
        """A fence never counts back, also where two were given at the same time and the older one comes second.

        Raises:
            Conflict: somebody was faster.
        """
        if fence <= self._newest.get(cell, fence - 1):
            raise Conflict("runs-control-overtaken", cell=cell)
        self._newest[cell] = fence

    def _check_holder(self, cell: str, who: str, fence: int) -> Holder:
        """Whoever has this fence is in control.

        Raises:
            Conflict: nobody is, or somebody else.
        """
        holder = self.holder(cell)
        if holder is None or not holder.confirmed:
            raise Conflict("runs-control-free", cell=cell)
        if (holder.who, holder.fence) != (who, fence):
            raise Conflict("runs-control-elsewhere", cell=cell, holder=holder.who, fence=holder.fence, who=who, sent_fence=fence)
        return holder

    def command(self, cell: str, who: str, renewal: Renewal) -> None:
        """Takes the fence, number and stamp of a command.

        Raises:
            Conflict: whoever sends it is not in control, or it is old, repeated, reordered or from the future.
        """
        holder, now = self._check_holder(cell, who, renewal.fence), self.clock()
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
