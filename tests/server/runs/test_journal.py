"""A run's journal keeps whole entries in order, whatever cuts it off."""

from __future__ import annotations

import errno
import os
from datetime import UTC, datetime
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from server.people import audit
from server.runs.event_schemas import EventMessage, PlanShown
from server.runs.journal import FILE, JournalEntry, RunChange, RunJournal, read_journal
from server.runs.tables import RunRow

NOW = datetime(2026, 3, 1, 8, 0, 0, 123456, tzinfo=UTC)


def entry(number: int, **change: object) -> JournalEntry:
    message = EventMessage(sequence=number, at=NOW, event=PlanShown(sha256="a" * 64, robot_s=30.0))
    done = audit.make_deed("account:anna", "run.hold", {"run": "r"}, now=NOW)
    return JournalEntry(number=number, change=RunChange.model_validate(change), messages=[message], deeds=[done], ended=False)


def test_what_is_appended_is_read_as_it_was(tmp_path: Path):
    journal = RunJournal(tmp_path)
    written = [entry(1, state="Idle", plan="{}"), entry(2, reason=None, released_at=NOW), entry(3)]
    for each in written:
        journal.append(each)
    journal.close()
    read = list(read_journal(tmp_path))
    assert read == written
    assert read[1].change.model_fields_set == {"reason", "released_at"}, "a reason that was taken back is a change too"


@given(cut=st.integers(0, 4000))
def test_a_journal_that_is_cut_anywhere_has_all_entries_that_are_whole(cut, tmp_path_factory):
    folder = tmp_path_factory.mktemp("journal")
    journal = RunJournal(folder)
    sizes = []
    for number in range(1, 6):
        journal.append(entry(number, state="Idle"))
        sizes.append((folder / FILE).stat().st_size)
    journal.close()
    size = min(cut, sizes[-1])
    os.truncate(folder / FILE, size)
    assert [each.number for each in read_journal(folder)] == list(range(1, 1 + sum(each <= size for each in sizes)))


def test_a_journal_goes_on_after_one_that_was_closed(tmp_path: Path):
    for number in (1, 2):
        journal = RunJournal(tmp_path)
        journal.append(entry(number))
        journal.close()
    assert [each.number for each in read_journal(tmp_path)] == [1, 2]


def test_an_entry_for_which_there_is_no_room_leaves_no_half_line_behind(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    journal = RunJournal(tmp_path)
    journal.append(entry(1))
    write = os.write

    def half(descriptor: int, line: bytes) -> int:
        if len(line) > 20:
            return write(descriptor, line[:20])
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(os, "write", half)
        patch.setattr("server.runs.journal.os.write", lambda d, line: half(d, line) if len(line) > 40 else half(d, b""))
        with pytest.raises(OSError, match="No space"):
            journal.append(entry(2))
    journal.append(entry(3))
    journal.close()
    assert [each.number for each in read_journal(tmp_path)] == [1, 3]


def test_a_change_is_what_differs_and_makes_one_run_the_other():
    def row(**values: object) -> RunRow:
        return RunRow(**{"id": "r", "state": "Idle", "sequence": 3, "reason": "x", "released": False, "finished_steps": 0, **values})

    before, after = row(), row(state="Held", sequence=5, reason=None, held_since=NOW)
    change = RunChange.between(before, after)
    assert change.model_dump(exclude_unset=True) == {"state": "Held", "sequence": 5, "reason": None, "held_since": NOW}
    change.apply(before)
    assert RunChange.between(before, after).model_fields_set == set()


def test_a_run_without_a_journal_has_no_entries(tmp_path: Path):
    assert list(read_journal(tmp_path / "nowhere")) == []
