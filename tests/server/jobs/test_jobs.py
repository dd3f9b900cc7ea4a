"""Jobs are done one after the other, each as a whole or not at all, also by a service that starts anew."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from pydantic import BaseModel
from sqlalchemy.orm import Session

from server.http.errors import Conflict, NotFound
from server.jobs import jobs
from server.jobs.jobs import JobKind, JobStatus, Worker
from server.runs.reason import read_reason
from server.runs.tables import JobRow
from server.service import utc_now
from server.store.store import Store


class Order(BaseModel):
    what: str


@pytest.fixture
def store(tmp_path: Path) -> Store:
    store = Store(f"sqlite:///{tmp_path / 'heft.sqlite'}")
    store.migrate()
    return store


def kind(also: Callable[[Session, JobRow], object] = lambda _db, _row: None) -> JobKind:
    return JobKind("work", "tests.server.light_work", lambda row: (Order.model_validate_json(row.order).what,), also)


def queued(store: Store, what: str) -> str:
    with store.write() as db:
        return jobs.add_job(db, "work", Order(what=what), None, "account:anna", utc_now()).id


def row_of(store: Store, job: str) -> JobRow:
    with store.read() as db:
        return jobs.load_job(db, "work", job)


async def worked(worker: Worker, until: Callable[[], bool]) -> None:
    await worker.start()
    for _ in range(1000):
        if until():
            break
        await asyncio.sleep(0.02)
    await worker.close()
    assert until()


def over(store: Store, job: str) -> Callable[[], bool]:
    return lambda: row_of(store, job).ended_at is not None


@pytest.mark.parametrize(
    ("what", "state", "result", "reason"),
    [
        ("answer", JobStatus.done, '"done"', None),
        ("fail", JobStatus.failed, None, "a sentence"),
        ("die", JobStatus.failed, None, "ended unexpectedly"),
    ],
)
def test_a_job_ends_with_its_answer_or_its_reason(
    store: Store, what: str, state: JobStatus, result: str | None, reason: str | None
) -> None:
    job = queued(store, what)
    asyncio.run(worked(Worker(store, utc_now, kind()), over(store, job)))
    row = row_of(store, job)
    assert (row.state, row.result) == (state, result)
    assert reason is None or reason in str(read_reason(row))
    assert json.loads(row.told or "") == ["sealed"]


def test_what_is_told_and_how_it_ends_is_written_in_the_same_transactions(store: Store) -> None:
    seen: list[tuple[str, str | None, str | None]] = []
    job = queued(store, "answer")
    asyncio.run(worked(Worker(store, utc_now, kind(lambda _, row: seen.append((row.state, row.told, row.result)))), over(store, job)))
    assert seen == [("running", '["sealed"]', None), ("done", '["sealed"]', '"done"')]


def test_a_cancelled_job_stays_cancelled_and_the_next_one_runs(store: Store) -> None:
    job, following = queued(store, "wait"), queued(store, "answer")
    worker = Worker(store, utc_now, kind())

    def cancelled_then_done() -> bool:
        if row_of(store, job).told is not None and row_of(store, job).state == JobStatus.running:
            with store.write() as db:
                jobs.cancel(db, "work", job, "account:anna", utc_now())
            worker.drop(job)
        return row_of(store, following).state == JobStatus.done

    asyncio.run(worked(worker, cancelled_then_done))
    assert (row_of(store, job).state, str(read_reason(row_of(store, job)))) == (JobStatus.cancelled, "cancelled by anna.")
    assert worker.progress == {}


def test_what_is_cancelled_while_it_answers_stays_cancelled_and_changes_nothing(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    job = queued(store, "answer")
    seen: list[str] = []

    def wanted_a_moment_ago(worker: Worker, job: str) -> bool:
        if row_of(store, job).told is not None:
            with store.write() as db:
                jobs.cancel(db, "work", job, "account:anna", utc_now())
        return True

    monkeypatch.setattr(Worker, "_is_running", wanted_a_moment_ago)
    asyncio.run(worked(Worker(store, utc_now, kind(lambda _, row: seen.append(row.state))), over(store, job)))
    assert (row_of(store, job).state, row_of(store, job).result, seen) == (JobStatus.cancelled, None, ["running"])


def test_what_is_over_cannot_be_cancelled(store: Store) -> None:
    job = queued(store, "answer")
    for state in (JobStatus.done, JobStatus.failed, JobStatus.cancelled):
        with store.write() as db:
            jobs.load_job(db, "work", job).state = state
        with store.write() as db, pytest.raises(Conflict, match=f"it is {state}; only what waits or runs"):
            jobs.cancel(db, "work", job, "account:anna", utc_now())


def test_a_job_that_a_service_left_is_begun_again_by_the_next(store: Store) -> None:
    job = queued(store, "answer")
    with store.write() as db:
        jobs.load_job(db, "work", job).state = JobStatus.running
    asyncio.run(worked(Worker(store, utc_now, kind()), over(store, job)))
    assert row_of(store, job).state == JobStatus.done


def test_a_job_of_another_kind_is_not_there(store: Store) -> None:
    job = queued(store, "answer")
    with store.read() as db, pytest.raises(NotFound):
        jobs.load_job(db, "diagnosis", job)


def test_a_service_that_ends_does_not_wait_for_what_is_not_done(store: Store) -> None:
    job = queued(store, "wait")
    asyncio.run(worked(Worker(store, utc_now, kind()), lambda: row_of(store, job).told is not None))
    assert row_of(store, job).state == JobStatus.running
