"""What a report says of itself, so that it can be kept: when, which run, who answers for it, made by what.

Who accepts a result does so after its report was made. The record stands between two marks in the page, so that it can be put in anew.
"""

from __future__ import annotations

from dataclasses import dataclass
from datetime import UTC, datetime
from html import escape

from core.recording.order_reference import NO_ORDER, OrderReference
from core.words.wording import Wording

BEGIN, END = "<!-- record -->", "<!-- end of the record -->"
HEADER_END = "</header>"


@dataclass(frozen=True, kw_only=True)
class Record:
    """Of one report.

    Args:
        at: when the robot had done its part; None where nobody says.
        cell: name or title of the cell.
        version: of the code that made the result, see `core.version`.
        plan_sha256: of the plan that was made, hexadecimal; None where there was none.
        order: that it was made for.
        run: identifier of the run; None of what no service has carried.
        operator: who let the robot move.
        accepted_by, accepted_at: who took the result for good, and when; None before that.
    """

    at: datetime | None
    cell: str | None
    version: str
    plan_sha256: str | None = None
    order: OrderReference = NO_ORDER
    run: str | None = None
    operator: str | None = None
    accepted_by: str | None = None
    accepted_at: datetime | None = None


def render_record(record: Record, words: Wording) -> str:
    """The record between its marks, as HTML."""
    rows = "\n".join(f"<div><dt>{escape(name)}</dt><dd>{escape(value)}</dd></div>" for name, value in list_facts(record, words))
    return f'{BEGIN}\n<dl class="facts record">\n{rows}\n</dl>\n{END}'


def put_record(page: str, record: Record, words: Wording) -> str:
    """A report with this record in the place of the one that it had; one from before there were records gets it below its title."""
    before, begin, rest = page.partition(BEGIN)
    _, end, after = rest.partition(END)
    if begin and end:
        return f"{before}{render_record(record, words)}{after}"
    return page.replace(HEADER_END, f"{render_record(record, words)}\n{HEADER_END}", 1)


def list_facts(record: Record, words: Wording) -> list[tuple[str, str]]:
    """Names and values, in the order in which people look for them; what nobody knows is left out."""
    accepted = words.say("record-not-accepted")
    if record.accepted_by is not None:
        when = "" if record.accepted_at is None else f", {format_time(record.accepted_at)}"
        accepted = f"{name_person(record.accepted_by)}{when}"
    found = {
        "record-date": None if record.at is None else format_time(record.at),
        "record-run": record.run,
        "record-order": record.order.order_id,
        "record-work-order": record.order.work_order,
        "record-serial-number": record.order.serial_number,
        "record-operator": None if record.operator is None else name_person(record.operator),
        "record-accepted": None if record.run is None else accepted,
        "record-cell": record.cell,
        "record-software": f"Heft {record.version}",
        "record-plan": record.plan_sha256,
    }
    return [(words.say(code), value) for code, value in found.items() if value]


def format_time(moment: datetime) -> str:
    """Such as 2026-03-01 08:00:24 UTC: the same in every language, and in every zone."""
    return f"{moment.astimezone(UTC):%Y-%m-%d %H:%M:%S} UTC"


def name_person(who: str) -> str:
    """As people call them: "account:anna" is anna."""
    return who.removeprefix("account:")
