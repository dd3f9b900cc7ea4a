"""The audit log shows every change to it; neither database lets an entry be changed by the way."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sqlalchemy import text
from sqlalchemy.exc import DatabaseError

from core.errors import BadInput
from server.people import audit
from server.people.audit import AuditEntry
from server.serve import verify_audit
from server.store.store import Store
from tests.server.made_people import BOTH_STORES


@pytest.fixture
def store(database_url: str | None, tmp_path: Path) -> Iterator[Store]:
    store = Store(database_url or f"sqlite:///{tmp_path / 'heft.sqlite'}")
    store.migrate()
    yield store
    store.close()


def write(store: Store, count: int) -> None:
    for k in range(count):
        with store.write() as db:
            audit.record(db, "account:anna", "run.release", {"run": k, "note": "größer"})


def chain(store: Store) -> list[AuditEntry]:
    with store.read() as db:
        return list(audit.entries(db))


@BOTH_STORES
def test_what_is_recorded_verifies(store: Store) -> None:
    write(store, 7)
    count, last, flaw = audit.verify_chain(chain(store))
    assert (count, flaw) == (7, None)
    assert last == chain(store)[-1].hash


@BOTH_STORES
@pytest.mark.parametrize("statement", ["UPDATE audit SET who = 'account:eve' WHERE number = 2", "DELETE FROM audit WHERE number = 3"])
def test_the_database_refuses_changes(statement: str, store: Store) -> None:
    write(store, 3)
    with pytest.raises(DatabaseError, match="append-only"), store.write() as db:
        db.execute(text(statement))
    assert audit.verify_chain(chain(store))[0] == 3


@BOTH_STORES
def test_entries_written_at_once_make_one_chain(store: Store) -> None:
    threads = [threading.Thread(target=write, args=(store, 5)) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert audit.verify_chain(chain(store))[::2] == (20, None)


def test_an_entry_is_kept_and_logged_only_with_what_it_records(store: Store, caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level("INFO", "heft.audit")
    with pytest.raises(ZeroDivisionError), store.write() as db:
        audit.record(db, "account:anna", "run.release")
        raise ZeroDivisionError
    assert chain(store) == []
    assert caplog.records == []
    write(store, 2)
    assert [record.__dict__["audit_hash"] for record in caplog.records] == [entry.hash for entry in chain(store)]


def made(count: int) -> list[AuditEntry]:
    """Entries outside of any database."""
    entries, previous = [], audit.START
    for k in range(1, count + 1):
        entry = AuditEntry(number=k, at=f"t{k}", who="account:anna", action="run.release", detail=f'{{"run":{k}}}', request="r")
        entry.previous_hash = previous
        entry.hash = previous = audit.entry_hash(entry)
        entries.append(entry)
    return entries


@given(st.integers(0, 8), st.sampled_from(["at", "who", "action", "detail", "request", "previous_hash", "hash"]))
def test_any_change_to_any_entry_is_found_where_it_is(index: int, name: str) -> None:
    entries = made(9)
    setattr(entries[index], name, "changed")
    count, _, flaw = audit.verify_chain(entries)
    assert count == index
    assert flaw is not None


@pytest.mark.parametrize("change", [lambda e: e.pop(3), lambda e: e.insert(2, e[4]), lambda e: e.reverse(), lambda e: e.pop(0)])
def test_what_is_missing_added_or_in_another_order_is_found(change: Callable[[list[AuditEntry]], object]) -> None:
    entries = made(6)
    change(entries)
    assert audit.verify_chain(entries)[2] is not None


def test_a_later_entry_made_to_fit_is_found(store: Store) -> None:
    entries = made(5)
    entries[1].who = "account:eve"
    entries[1].hash = audit.entry_hash(entries[1])
    assert audit.verify_chain(entries)[0] == 2


def test_an_end_that_was_cut_off_is_found_by_a_hash_seen_earlier(store: Store, tmp_path: Path) -> None:
    write(store, 4)
    second, last = chain(store)[1].hash, chain(store)[-1].hash
    assert "4 entries" in str(verify_audit(tmp_path, last))
    with store.write() as db:
        db.execute(text("DROP TRIGGER audit_no_delete"))
        db.execute(text("DELETE FROM audit WHERE number > 2"))
    assert "2 entries" in str(verify_audit(tmp_path, second))
    with pytest.raises(BadInput, match="cut off"):
        verify_audit(tmp_path, last)


def test_there_is_nothing_to_verify_where_no_service_was(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match=r"no heft\.sqlite"):
        verify_audit(tmp_path)
