"""A run's journal: what happens to it is on disk within milliseconds, in a file of the run's own, before the database has it.

One line is one entry, JSON, in order. An entry that a crash cut short was acknowledged to nobody and counts for nothing. The database
follows (`server.runs.store_follower`); what it does not have when the service ends, the next one takes from here.
"""

from __future__ import annotations

import logging
import os
from collections.abc import Iterator
from contextlib import suppress
from datetime import datetime
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ConfigDict, ValidationError, field_serializer, field_validator

from core.words.message import Message
from server.people.audit import Deed
from server.runs.event_schemas import EventMessage
from server.runs.reason import dump_message
from server.runs.tables import RunRow

log = logging.getLogger("heft.runs")

FILE = "journal.jsonl"


class RunChange(BaseModel):
    """Columns of a run that may change after it was queued; those that are set here did."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    state: str | None = None
    released: bool | None = None
    aborted: bool | None = None
    outcome: str | None = None
    reason: str | None = None
    reason_kind: str | None = None
    lateness: str | None = None
    in_the_way: str | None = None
    plan: str | None = None
    result: str | None = None
    sequence: int | None = None
    steps: int | None = None
    finished_steps: int | None = None
    released_by: str | None = None
    released_at: datetime | None = None
    held_since: datetime | None = None
    ended_at: datetime | None = None

    @field_validator("reason", mode="before")
    @classmethod
    def _take_sentence(cls, reason: object) -> object:
        """Journals of earlier versions have a sentence in the place of a message."""
        return dump_message(Message.of("text", text=reason)) if isinstance(reason, str) and not reason.startswith("{") else reason

    @classmethod
    def between(cls, before: RunRow, after: RunRow) -> RunChange:
        """What differs between two states of one run."""
        changed: dict[str, Any] = {name: getattr(after, name) for name in cls.model_fields if getattr(before, name) != getattr(after, name)}
        return cls(**changed)

    def apply(self, row: RunRow) -> None:
        """Makes the change."""
        for name in self.model_fields_set:
            setattr(row, name, getattr(self, name))


class JournalEntry(BaseModel):
    """One change of a run with all that goes with it.

    Args:
        number: counts from 1 in each journal.
        deeds: for the audit log.
        ended: the run is over with it, and whoever wants to hear of that is told.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    number: int
    change: RunChange
    messages: list[EventMessage]
    deeds: list[Deed]
    ended: bool

    @field_serializer("change")
    def _what_changed(self, change: RunChange) -> dict[str, Any]:
        return change.model_dump(mode="json", exclude_unset=True)


class RunJournal:
    """The journal of one run; one thread writes.

    Args:
        folder: of the run; exists.
    """

    def __init__(self, folder: Path) -> None:
        self._path = folder / FILE
        self._descriptor: int | None = None
        self._whole_bytes = 0

    def append(self, entry: JournalEntry) -> None:
        """Returns when the entry is on disk.

        Raises:
            OSError: the disk is full or gone; nothing of the entry stays in the file.
        """
        if self._descriptor is None:
            self._descriptor = os.open(self._path, os.O_CREAT | os.O_WRONLY | os.O_APPEND, 0o600)
            self._whole_bytes = os.fstat(self._descriptor).st_size
        line = (entry.model_dump_json() + "\n").encode()
        try:
            written = 0
            while written < len(line):
                written += os.write(self._descriptor, line[written:])
            os.fdatasync(self._descriptor)
        except OSError:
            with suppress(OSError):
                os.ftruncate(self._descriptor, self._whole_bytes)
            raise
        self._whole_bytes += len(line)

    def close(self) -> None:
        """The file stays."""
        if self._descriptor is not None:
            os.close(self._descriptor)
            self._descriptor = None

    def remove(self) -> None:
        """The database has it all."""
        self.close()
        self._path.unlink(missing_ok=True)


def read_journal(folder: Path) -> Iterator[JournalEntry]:
    """Entries of a run's journal in order, up to one that was cut short; none where there is no journal."""
    with suppress(FileNotFoundError), (folder / FILE).open("rb") as file:
        for line in file:
            if not line.endswith(b"\n"):
                return
            try:
                entry = JournalEntry.model_validate_json(line)
            except ValidationError:
                log.exception("%s holds a line that is no entry; what is behind it is lost", folder / FILE)
                return
            yield entry
