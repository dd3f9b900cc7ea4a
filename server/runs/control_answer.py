"""Who is in control of a cell, as it is told."""

from __future__ import annotations

from datetime import datetime, timedelta

from pydantic import Field

from core.cell.cell import Control as CellControl
from core.errors import HeftError
from server.cells.folder import CellFolder
from server.http.schemas import Answer
from server.runs.handover import RequestOutcome
from server.runs.lease import STAMP_PERIOD_S, ControlRegistry


class LinkPublic(Answer):
    """The connection of whoever is in control, in the last 60 s."""

    round_trip_p50_s: float = Field(description="Half of the stamps came back within this time, s.", examples=[0.012])
    round_trip_p99_s: float = Field(description="99 % of the stamps came back within this time, s.", examples=[0.14])
    lost_share: float = Field(description="Share of the stamps that were not answered within the lease, 0 to 1.", examples=[0.002])
    longest_gap_s: float = Field(
        description="The longest time that control rested on one answer, s; the lease is what it may be.", examples=[0.31]
    )
    answers: int = Field(description="How many stamps were answered.", examples=[1180])
    window_s: float = Field(description="Over how long this was measured, s.", examples=[60.0])
    advised: bool = Field(
        description="Whether the link is good enough for a release; over one that is not, a run is likely to be put on hold."
    )


class ControlRequestPublic(Answer):
    """Somebody asks for control that somebody else has."""

    fence: int = Field(description="Of whoever asks; names the request, and is that of the holder once control has passed.", examples=[42])
    who: str = Field(description="Who asks.", examples=["account:ben"])
    device: str = Field(description="On which screen; empty where it has no name.", examples=["Tablet 2"])
    asked_at: datetime = Field(description="When it was asked for; ISO 8601 with offset.", examples=["2026-11-23T08:15:00Z"])
    passes_at: datetime = Field(description="When control passes where nobody answers; ISO 8601.", examples=["2026-11-23T08:15:30Z"])
    accepted: bool = Field(description="Whether control passes with the next sign of life of whoever asks.", examples=[False])


class EndedRequestPublic(Answer):
    """How the last request for control ended."""

    fence: int = Field(description="Names the request.", examples=[42])
    who: str = Field(description="Who asked.", examples=["account:ben"])
    device: str = Field(description="On which screen; empty where it has no name.", examples=["Tablet 2"])
    holder: str | None = Field(description="Who was in control until then; null where nobody was.", examples=["account:anna"])
    outcome: RequestOutcome = Field(
        description="Control has passed: accepted, unanswered (by time), vacant (nobody was in control any more), own (to another screen "
        "of the same person). It has not: declined, withdrawn, silent (the screen that asked), overtaken (somebody took control).",
        examples=["accepted"],
    )
    ended_at: datetime = Field(description="When; ISO 8601 with offset.", examples=["2026-11-23T08:15:12Z"])


class ControlPublic(Answer):
    """Who is in control."""

    cell: str = Field(description="Name of the cell.", examples=["lwr4_bench"])
    holder: str | None = Field(description="Who is in control; null where nobody is.", examples=["account:anna"])
    fence: int | None = Field(
        description="To be sent with every answered stamp and every command; null where nobody is in control.", examples=[17]
    )
    device: str | None = Field(description="Name of the holder's screen; null where nobody is in control.", examples=["Tablet 1"])
    since: datetime | None = Field(description="Since when; null where nobody is in control.", examples=["2026-11-23T08:00:00Z"])
    lease_s: float = Field(description="How long one answered stamp lasts, s.", examples=[1.0])
    hold_limit_s: float = Field(description="How long a run on hold waits for somebody to be in control again, s.", examples=[120.0])
    stamp_period_s: float = Field(default=STAMP_PERIOD_S, description="Time between two stamps, s.", examples=[0.05])
    link: LinkPublic | None = Field(
        description="The connection of whoever is in control; null until there are enough answers to say anything."
    )
    request: ControlRequestPublic | None = Field(description="Who asks for control now; null where nobody does.")
    last_request: EndedRequestPublic | None = Field(description="How the last request ended; null where nobody has asked yet.")


def control_settings(cells: CellFolder, name: str) -> CellControl:
    """How a cell's robot depends on whoever is in control; the usual where its file cannot be read: a robot in it may have to be cleared.

    Raises:
        NotFound: there is no such cell.
    """
    cells.check_known(name)
    try:
        return cells.read(name).cell.control
    except HeftError:
        return CellControl()


def answer_control(control: ControlRegistry, cell: str, settings: CellControl, now: datetime) -> ControlPublic:
    """Who is in control of a cell as it is told, over which link, and who asks for it."""
    holder, request, ended = control.holder(cell), control.request(cell), control.last_request(cell)
    found = None if holder is None else holder.link.figures(holder.lease_s, control.clock())

    def at(moment_s: float) -> datetime:
        return now + timedelta(seconds=moment_s - control.clock())

    return ControlPublic(
        cell=cell,
        holder=None if holder is None else holder.who,
        fence=None if holder is None else holder.fence,
        device=None if holder is None else holder.device,
        since=None if holder is None else at(holder.since_s),
        lease_s=settings.lease_s,
        hold_limit_s=settings.hold_limit_s,
        link=None if found is None else LinkPublic(**found._asdict()),
        request=None
        if request is None
        else ControlRequestPublic(
            fence=request.asker.fence,
            who=request.asker.who,
            device=request.asker.device,
            asked_at=at(request.asked_s),
            passes_at=at(request.passes_s),
            accepted=request.due is not None,
        ),
        last_request=None
        if ended is None
        else EndedRequestPublic(
            fence=ended.fence,
            who=ended.who,
            device=ended.device,
            holder=ended.holder,
            outcome=ended.outcome,
            ended_at=at(ended.at_s),
        ),
    )
