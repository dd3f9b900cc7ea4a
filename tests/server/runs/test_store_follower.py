"""The database follows a run's journal: in order, once, whatever happens to it meanwhile."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator

import pytest
from sqlalchemy import func, select
from sqlalchemy.exc import OperationalError

from server.people import audit
from server.people.audit import AuditEntry
from server.runs import ledger as run_ledger
from server.runs.crashed_runs import forget_journals, take_from_journals
from server.runs.event_schemas import PlanShown
from server.runs.journal import JournalEntry, RunChange, RunJournal
from server.runs.schemas import RunCreate
from server.runs.store_follower import StoreFollower, keep_entry
from server.runs.tables import RunRow
from server.settings import Settings
from server.store.store import Store
from tests.server.kept import Kept, kept
from tests.server.made_people import BOTH_STORES, Clock

pytestmark = BOTH_STORES
ORDER = RunCreate(cell="lwr4_bench", payload="steel_block")


@pytest.fixture
def service(settings: Settings, clock: Clock) -> Iterator[Kept]:
    with kept(settings, clock) as found:
        yield found


def queued(service: Kept) -> RunRow:
    with service.store.write() as db:
        return run_ledger.add_run(db, ORDER, "account:anna", service.now())


def entries(service: Kept, row: RunRow, count: int) -> list[JournalEntry]:
    """Each tells of one event and of one deed."""
    found, row = [], run_ledger.copy_row(row)
    for number in range(1, count + 1):
        before = run_ledger.copy_row(row)
        messages = run_ledger.tell(row, [PlanShown(sha256=f"{number:064d}", robot_s=1.0)], service.now())
        done = audit.make_deed("account:anna", "run.hold", {"run": row.id, "number": number}, now=service.now())
        change = RunChange.between(before, row)
        found.append(JournalEntry(number=number, change=change, messages=messages, deeds=[done], ended=False))
    return found


def check_all_there(service: Kept, run: str, count: int) -> None:
    with service.store.read() as db:
        assert [sequence for sequence, _ in run_ledger.list_events(db, run, 0)] == list(range(1, count + 2))
        assert db.get(RunRow, run).sequence == count + 1
        assert db.scalar(select(func.count()).select_from(AuditEntry).where(AuditEntry.action == "run.hold")) == count
        assert audit.verify_chain(audit.entries(db))[2] is None


def test_an_entry_is_written_once_however_often_it_is_taken(service):
    row = queued(service)
    for each in [*entries(service, row, 3), *entries(service, row, 3)]:
        with service.store.write() as db:
            keep_entry(db, row.id, each)
    check_all_there(service, row.id, 3)


def test_a_store_that_fails_again_and_again_gets_everything_in_order_in_the_end(service, monkeypatch: pytest.MonkeyPatch):
    row = queued(service)
    monkeypatch.setattr("server.runs.store_follower.RETRY_S", 0.01)
    failures = iter([True, True, False, True, False, False, True])
    write = Store.write

    def failing(self: Store):
        if next(failures, False):
            raise OperationalError("locked", None, Exception("locked"))
        return write(self)

    async def follow() -> None:
        follower = StoreFollower(service.store, row.id)
        with monkeypatch.context() as patch:
            patch.setattr(Store, "write", failing)
            for each in entries(service, row, 12):
                follower.add(each)
                await asyncio.sleep(0.002)
            assert follower.behind_s > 0.0
            assert await follower.caught_up(10.0)
        assert follower.behind_s == 0.0
        await follower.close()

    asyncio.run(follow())
    check_all_there(service, row.id, 12)


def test_a_store_that_is_away_is_noticed_also_when_nothing_is_to_be_written(service, monkeypatch: pytest.MonkeyPatch):
    row = queued(service)
    monkeypatch.setattr("server.runs.store_follower.PROBE_S", 0.01)

    def away(_: Store) -> None:
        raise OperationalError("away", None, Exception("away"))

    async def follow() -> float:
        follower = StoreFollower(service.store, row.id)
        assert await follower.caught_up(5.0)
        monkeypatch.setattr(Store, "check_writable", away)
        await asyncio.sleep(0.3)
        behind = follower.behind_s
        assert not await follower.caught_up(0.05)
        await follower.close()
        return behind

    assert asyncio.run(follow()) > 0.1


@pytest.mark.parametrize("known", range(4))
def test_the_next_service_takes_from_the_journals_what_the_database_lacks(service, settings: Settings, known):
    row = queued(service)
    folder = settings.data / "recordings" / row.id
    folder.mkdir(parents=True)
    journal = RunJournal(folder)
    for each in entries(service, row, 3):
        journal.append(each)
    journal.close()
    with service.store.write() as db:
        for each in entries(service, row, 3)[:known]:
            keep_entry(db, row.id, each)
    with service.store.write() as db:
        take_from_journals(db, folder.parent)
    check_all_there(service, row.id, 3)
    forget_journals(folder.parent)
    assert list(folder.iterdir()) == []
