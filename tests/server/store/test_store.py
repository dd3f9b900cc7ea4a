"""The store keeps all of a write or nothing of it, on either database, and its tables are those that the code describes."""

from __future__ import annotations

import json
import threading
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

import pytest
from alembic.autogenerate import compare_metadata
from alembic.migration import MigrationContext
from sqlalchemy import create_engine, select, text

from server.jobs import jobs
from server.jobs import kinds as job_kinds
from server.people.accounts import Account, add_account
from server.people.roles import Role
from server.runs import ledger as run_ledger
from server.runs.reason import read_reason
from server.runs.tables import RunRow
from server.service import utc_now
from server.store.migration import upgrade
from server.store.store import MIGRATIONS, Store, is_up_to_date
from server.tables import Table
from tests.server.made_people import BOTH_STORES
from tests.server.postgresql import Cluster
from tests.server.sentence import sentence


@pytest.fixture
def store(database_url: str | None, tmp_path: Path) -> Iterator[Store]:
    store = Store(database_url or f"sqlite:///{tmp_path / 'heft.sqlite'}")
    store.migrate()
    yield store
    store.close()


def names(store: Store) -> set[str]:
    with store.read() as db:
        return set(db.scalars(text("SELECT name FROM accounts")))


def add(store: Store, name: str) -> None:
    with store.write() as db:
        add_account(db, name, "x", frozenset({Role.viewer}), utc_now())


@BOTH_STORES
def test_the_migrations_make_the_tables_that_the_code_describes(store: Store) -> None:
    with store.read() as db:
        context = MigrationContext.configure(db.connection(), opts={"compare_type": True})
        assert compare_metadata(context, Table.metadata) == []


@BOTH_STORES
def test_migrating_twice_changes_nothing(store: Store) -> None:
    add(store, "anna")
    store.migrate()
    assert names(store) == {"anna"}


def test_two_services_that_start_at_once_migrate_once(postgresql: Cluster) -> None:
    url = postgresql.empty()
    stores = [Store(url) for _ in range(3)]
    threads = [threading.Thread(target=store.migrate) for store in stores]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    add(stores[0], "anna")
    assert names(stores[2]) == {"anna"}
    for store in stores:
        store.close()


@BOTH_STORES
def test_a_write_that_fails_leaves_nothing(store: Store) -> None:
    with pytest.raises(ZeroDivisionError), store.write() as db:
        add_account(db, "anna", "x", frozenset({Role.viewer}), utc_now())
        db.flush()
        raise ZeroDivisionError
    assert names(store) == set()


@BOTH_STORES
def test_many_may_write_at_once_and_all_is_kept(store: Store) -> None:
    threads = [threading.Thread(target=add, args=(store, f"a{k}")) for k in range(12)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert names(store) == {f"a{k}" for k in range(12)}


@BOTH_STORES
def test_a_connection_that_is_in_use_when_the_store_closes_is_closed_when_it_is_given_back(store: Store) -> None:
    with store.read() as db:
        driver = db.connection().connection.driver_connection
        assert driver is not None
        store.close()
        assert db.scalar(text("SELECT 1")) == 1
    with pytest.raises(Exception, match="closed"):
        driver.cursor().execute("SELECT 1")


@BOTH_STORES
def test_times_come_back_with_their_offset(store: Store) -> None:
    now = utc_now()
    with store.write() as db:
        add_account(db, "anna", "x", frozenset({Role.viewer}), now)
    with store.read() as db:
        account = db.get(Account, "anna")
        assert account is not None
        assert account.created_at == now
        assert account.created_at.utcoffset() is not None


def test_sqlite_waits_for_the_disk(store: Store) -> None:
    with store.read() as db:
        asked = ("journal_mode", "synchronous", "foreign_keys", "busy_timeout")
        assert [db.scalar(text(f"PRAGMA {name}")) for name in asked] == ["wal", 2, 1, 5000]


def test_diagnoses_of_an_older_version_are_jobs_now_and_the_newest_version_is_known_without_alembic(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path / 'older.sqlite'}"
    engine = create_engine(url)
    with engine.begin() as connection:
        upgrade(connection, MIGRATIONS, "0002")
        assert not is_up_to_date(connection)
        values = "'1', '/data/r', 'run-1', 'done', '{}', NULL, 'account:anna', '2026-03-01 00:00:00.000000', NULL"
        connection.execute(text(f"INSERT INTO diagnoses VALUES ({values})"))
    store = Store(url)
    store.migrate()
    with store.read() as db:
        row = jobs.load_job(db, job_kinds.DIAGNOSIS, "1")
        assert (row.about, row.state, row.requested_at) == ("run-1", "done", datetime(2026, 3, 1, tzinfo=UTC))
        assert job_kinds.DiagnosisOrder.model_validate_json(row.order).recording == Path("/data/r")
    store.close()
    with engine.begin() as connection:
        assert is_up_to_date(connection)
    engine.dispose()


OLDER_RUN = """INSERT INTO runs (id, cell, run_order, state, released, aborted, reason, sequence, requested_by, requested_at)
VALUES ('1', 'line', '{}', 'Aborted', false, true, :reason, 4, 'account:anna', '2026-03-01 00:00:00')"""
OLDER_EVENTS: list[dict[str, object]] = [
    {"kind": "state_changed", "state": "Idle", "reason": None},
    {"kind": "state_changed", "state": "Aborted", "reason": 'no "way"'},
    {"kind": "robot_stopped", "error": "TooClose", "message": 'no "way"'},
    {"kind": "phase_started", "phase": "hold", "toward": "x+"},
]


def test_sentences_of_an_older_version_are_messages_now(tmp_path: Path) -> None:
    migrate_sentences(f"sqlite:///{tmp_path / 'older.sqlite'}")


def test_sentences_of_an_older_version_are_messages_now_in_postgresql(postgresql: Cluster) -> None:
    migrate_sentences(postgresql.empty())


def migrate_sentences(url: str) -> None:
    engine = create_engine(url)
    with engine.begin() as connection:
        upgrade(connection, MIGRATIONS, "0008")
        connection.execute(text(OLDER_RUN), {"reason": "the service was shut down; the robot was stopped."})
        for sequence, event in enumerate(OLDER_EVENTS):
            body = json.dumps({"kind": "event", "sequence": sequence, "event": event}, separators=(",", ":"))
            connection.execute(text("INSERT INTO run_events VALUES ('1', :sequence, :body)"), {"sequence": sequence, "body": body})
    store = Store(url)
    store.migrate()
    with store.read() as db:
        row = run_ledger.load_run(db, "1")
        assert read_reason(row) == sentence("the service was shut down; the robot was stopped.")
        told = [json.loads(body)["event"] for _, body in run_ledger.list_events(db, "1", -1)]
    said = {"code": "text", "parameters": {"text": 'no "way"'}, "text": 'no "way"'}
    assert told == [OLDER_EVENTS[0], OLDER_EVENTS[1] | {"reason": said}, OLDER_EVENTS[2] | {"message": said}, OLDER_EVENTS[3]]
    store.close()
    engine.dispose()


def test_runs_of_an_older_version_know_their_payload_by_name(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path / 'older.sqlite'}"
    engine = create_engine(url)
    with engine.begin() as connection:
        upgrade(connection, MIGRATIONS, "0003")
        for run, order, result in (("1", '{"payload": "gripper"}', None), ("2", '{"payload": null}', '{"payload": "steel_block"}')):
            row = {"id": run, "run_order": order, "result": result, "at": "2026-03-01 00:00:00.000000"}
            columns = "id, cell, run_order, state, released, aborted, result, sequence, requested_by, requested_at"
            values = ":id, 'line', :run_order, 'Complete', 0, 0, :result, 0, 'account:anna', :at"
            connection.execute(text(f"INSERT INTO runs ({columns}) VALUES ({values})"), row)
    store = Store(url)
    store.migrate()
    with store.read() as db:
        assert [(row.id, row.payload, row.accepted_by) for row in db.scalars(select(RunRow).order_by(RunRow.id))] == [
            ("1", "gripper", None), ("2", "steel_block", None),
        ]  # fmt: skip
    store.close()
    engine.dispose()


OLDER_RUNS = {
    "completed": ("Complete", 1, 0, None, True),
    "stopped": ("Stopped", 1, 0, "stop-asked", True),
    "cancelled": ("Stopped", 0, 0, "cancelled", True),
    "refused": ("Stopped", 0, 1, "no-path", True),
    "aborted": ("Aborted", 1, 1, "too-close", True),
    "aborted and cleared": ("Stopped", 1, 1, "too-close", True),
    "expired on hold": ("Stopped", 1, 0, "hold-expired", True),
    "None": ("Idle", 0, 0, None, False),
}
"""State, released, aborted, kind of the reason and whether it has ended, by the outcome that follows."""


def test_runs_of_an_older_version_get_their_outcomes(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path / 'older.sqlite'}"
    engine = create_engine(url)
    insert = text(
        "INSERT INTO runs (id, cell, run_order, state, released, aborted, reason_kind, sequence, requested_by, requested_at, ended_at) "
        "VALUES (:id, 'c', '{\"cell\": \"c\"}', :state, :released, :aborted, :kind, 0, 'key:mes', :at, :ended)"
    )
    with engine.begin() as connection:
        upgrade(connection, MIGRATIONS, "0009")
        for name, (state, released, aborted, kind, ended) in OLDER_RUNS.items():
            at = "2026-03-01 00:00:00.000000"
            values = {"id": name, "state": state, "released": released, "aborted": aborted, "kind": kind, "at": at}
            connection.execute(insert, values | {"ended": at if ended else None})
    store = Store(url)
    store.migrate()
    with store.read() as db:
        rows = {row.id: row for row in db.scalars(select(RunRow))}
        outcomes = {name: row.outcome for name, row in rows.items()}
        answered = {name: run_ledger.build_answer(row).outcome for name, row in rows.items()}
    store.close()
    assert outcomes == answered
    special = {"None": None, "aborted and cleared": "aborted", "expired on hold": "stopped"}
    assert outcomes == {name: special.get(name, name) for name in OLDER_RUNS}
    assert {row.order_id for row in rows.values()} == {None}
