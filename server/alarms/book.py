"""The alarms that are open, and their history: in memory at once, in the database as soon as that takes them.

An alarm is open while what it tells of lasts and, where its kind stays, until somebody has acknowledged it (ISA-18.2).
"""

from __future__ import annotations

from collections.abc import Iterable
from datetime import datetime

from sqlalchemy import inspect, select
from sqlalchemy.orm import Session

from server.alarms.kinds import KINDS, Condition
from server.alarms.tables import AlarmRow
from server.http.errors import Conflict, NotFound
from server.runs.ledger import new_id
from server.runs.reason import dump_message

ENDING = [name for name, kind in KINDS.items() if kind.ends]


class AlarmBook:
    """Of one service. Belongs to the event loop; what is to be written is handed out as copies."""

    def __init__(self) -> None:
        self.changes = 0
        """Counts what has changed, for whoever tells of it."""
        self._open: dict[str, AlarmRow] = {}  # by condition
        self._done: set[str] = set()  # conditions that were ended by acknowledging them
        self._unwritten: dict[str, AlarmRow] = {}

    @property
    def open(self) -> list[AlarmRow]:
        """Newest first."""
        return sorted(self._open.values(), key=lambda row: row.id, reverse=True)

    def load(self, db: Session) -> None:
        """What an earlier service left open, and what need not be told again."""
        for row in db.scalars(select(AlarmRow).where((AlarmRow.cleared_at.is_(None)) | (AlarmRow.acknowledged_at.is_(None)))):
            if _is_open(row):
                self._open[row.condition] = _copy(row)
        ended = select(AlarmRow.condition).where(AlarmRow.kind.in_(ENDING), AlarmRow.acknowledged_at.is_not(None))
        self._done = set(db.scalars(ended))

    def update(self, conditions: Iterable[Condition], now: datetime) -> None:
        """Raises what is new, clears what is over."""
        present = {condition.key: condition for condition in conditions}
        for key, condition in present.items():
            row = self._open.get(key)
            if row is None and key not in self._done:
                self._put(_raise(condition, now))
            elif row is not None and row.cleared_at is not None:
                row.cleared_at = None
                self._put(row)
        for key, row in list(self._open.items()):
            if key not in present and row.cleared_at is None:
                row.cleared_at = now
                self._put(row)

    def find(self, alarm: str) -> AlarmRow:
        """An open alarm.

        Raises:
            NotFound: none of the open ones has this name.
        """
        for row in self._open.values():
            if row.id == alarm:
                return row
        raise NotFound("alarms-unknown", alarm=alarm[:80])

    def check_acknowledgeable(self, alarm: str) -> AlarmRow:
        """An open alarm that nobody has acknowledged.

        Raises:
            NotFound: there is none of this name.
            Conflict: somebody has.
        """
        row = self.find(alarm)
        if row.acknowledged_by is not None:
            raise Conflict("alarms-acknowledged-already", alarm=alarm, who=row.acknowledged_by)
        return row

    def acknowledge(self, alarm: str, who: str, now: datetime) -> AlarmRow:
        """Somebody has seen it; how it stands then.

        Raises:
            NotFound, Conflict: as `check_acknowledgeable`.
        """
        row = self.check_acknowledgeable(alarm)
        row.acknowledged_by, row.acknowledged_at = who, now
        if KINDS[row.kind].ends:
            row.cleared_at = row.cleared_at or now
            self._done.add(row.condition)
        self._put(row)
        return _copy(row)

    def take_unwritten(self) -> list[AlarmRow]:
        """What the database lacks, as copies; whoever cannot write them gives them back."""
        rows, self._unwritten = list(self._unwritten.values()), {}
        return rows

    def give_back(self, rows: Iterable[AlarmRow]) -> None:
        """They could not be written; what has changed meanwhile is newer."""
        self._unwritten = {row.id: row for row in rows} | self._unwritten

    def _put(self, row: AlarmRow) -> None:
        if _is_open(row):
            self._open[row.condition] = row
        else:
            self._open.pop(row.condition, None)
        self._unwritten[row.id] = _copy(row)
        self.changes += 1


def _raise(condition: Condition, now: datetime) -> AlarmRow:
    return AlarmRow(
        id=new_id(now),
        condition=condition.key,
        kind=condition.kind,
        cell=condition.cell,
        run=condition.run,
        message=dump_message(condition.message),
        raised_at=now,
        cleared_at=None,
        acknowledged_by=None,
        acknowledged_at=None,
    )


def _is_open(row: AlarmRow) -> bool:
    return row.cleared_at is None or (KINDS[row.kind].stays and row.acknowledged_at is None)


def _copy(row: AlarmRow) -> AlarmRow:
    """It as an object of its own, which no session knows."""
    return AlarmRow(**{column.key: getattr(row, column.key) for column in inspect(AlarmRow).column_attrs})
