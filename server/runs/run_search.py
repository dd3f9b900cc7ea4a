"""Runs that contain words, over the whole history: what a plant knows a run by, who had to do with it, how it is and when it was."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import UTC, date, datetime, time, timedelta

from sqlalchemy import ColumnElement, and_, func, or_

from server.runs.tables import RunRow

TEXTS = (RunRow.id, RunRow.payload, RunRow.order_id, RunRow.work_order, RunRow.serial_number, RunRow.state, RunRow.outcome)
PEOPLE = (RunRow.requested_by, RunRow.released_by, RunRow.accepted_by)
TIMES = (RunRow.requested_at, RunRow.ended_at)


def contain_words(search: str) -> Iterator[ColumnElement[bool]]:
    """What holds for a run that contains each of the words somewhere, letter case aside; a day is written 2026-03-01, in UTC."""
    for word in search.lower().split():
        texts = [*TEXTS, *(func.replace(who, "account:", "") for who in PEOPLE)]
        yield or_(*(func.lower(text).contains(word, autoescape=True) for text in texts), *_on_day(word))


def _on_day(word: str) -> Iterator[ColumnElement[bool]]:
    try:
        begin = datetime.combine(date.fromisoformat(word), time(), UTC)
        end = begin + timedelta(days=1)
    except (ValueError, OverflowError):  # not a day, or the last one that there is
        return
    for moment in TIMES:
        yield and_(moment >= begin, moment < end)
