"""Work in the background, one at a time of each kind: it waits in the store, so a service that starts anew goes on with it."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime
from enum import StrEnum
from typing import Annotated

from pydantic import BaseModel
from sqlalchemy import select
from sqlalchemy.exc import SQLAlchemyError
from sqlalchemy.orm import Session

from core.errors import HeftError
from server.http.dependencies import depend_on
from server.http.errors import Conflict, NotFound
from server.runner.messages import Advanced, Answered, Failed
from server.runner.work import Work
from server.runs.ledger import new_id
from server.runs.reason import Reason, dump_message, explain_cancellation, explain_error, explain_failure, set_reason
from server.runs.tables import JobRow
from server.store.store import Store

log = logging.getLogger("heft.jobs")

RETRY_S = 2.0


class JobStatus(StrEnum):
    """How far a job is."""

    waiting = "waiting"
    running = "running"
    done = "done"
    failed = "failed"
    cancelled = "cancelled"


UNDER_WAY = (JobStatus.waiting, JobStatus.running)


def _record_nothing(_db: Session, _row: JobRow) -> None:
    """Nothing else is written down."""


@dataclass(frozen=True)
class JobKind:
    """One kind of job.

    Args:
        name: in the store and in words.
        module: whose `main(*arguments, connection)` does it, in a process of its own.
        arguments: of that, for one job; may raise a `HeftError`, with which the job fails.
        also: what else is written down in the transaction that changes the job, when it tells something and when it ends.
    """

    name: str
    module: str
    arguments: Callable[[JobRow], tuple[object, ...]]
    also: Callable[[Session, JobRow], object] = _record_nothing


def add_job(db: Session, kind: str, order: BaseModel, about: str | None, who: str, now: datetime) -> JobRow:
    """A job that waits for its turn."""
    row = JobRow(id=new_id(now), kind=kind, about=about, order=order.model_dump_json(), state=JobStatus.waiting)
    row.requested_by, row.requested_at = who, now
    db.add(row)
    db.flush()
    return row


def load_job(db: Session, kind: str, job: str) -> JobRow:
    """One job.

    Raises:
        NotFound: there is none of that kind.
    """
    row = db.get(JobRow, job)
    if row is None or row.kind != kind:
        raise NotFound("jobs-unknown", kind=kind, job=job[:80])
    return row


def cancel(db: Session, kind: str, job: str, who: str, now: datetime) -> JobRow:
    """A job that nobody wants any more; `Worker.drop` ends its process.

    Raises:
        NotFound: there is none of that kind.
        Conflict: it is over.
    """
    row = load_job(db, kind, job)
    if row.state not in UNDER_WAY:
        raise Conflict("jobs-over", kind=kind, job=job, state=row.state)
    row.state, row.ended_at = JobStatus.cancelled, now
    set_reason(row, explain_cancellation(who))
    return row


def list_jobs(db: Session, kind: str, limit: int) -> list[JobRow]:
    """Newest first."""
    return list(db.scalars(select(JobRow).where(JobRow.kind == kind).order_by(JobRow.id.desc()).limit(limit)))


def find_newest_done(db: Session, kind: str, about: str) -> JobRow | None:
    """The newest job of a kind that is done and about something, such as a run; None where there is none."""
    done = select(JobRow).where(JobRow.kind == kind, JobRow.about == about, JobRow.state == JobStatus.done)
    return db.scalars(done.order_by(JobRow.id.desc()).limit(1)).first()


class Worker:
    """Works through the waiting jobs of one kind."""

    def __init__(self, store: Store, now: Callable[[], datetime], kind: JobKind) -> None:
        self._store, self._now, self._kind = store, now, kind
        self.progress: dict[str, float] = {}
        """Of the one that runs, 0 to 1."""
        self._running: tuple[str, Work] | None = None
        self._wake = asyncio.Event()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._task: asyncio.Task[None] | None = None
        self._closing = False

    async def start(self) -> None:
        """Goes on until `close`."""
        self._loop = asyncio.get_running_loop()
        self._task = asyncio.create_task(self._run_forever())

    async def close(self) -> None:
        """What is not done is begun again by the next service."""
        self._closing = True
        self._wake.set()
        self._kill()
        if self._task is not None:
            await self._task

    def wake(self) -> None:
        """There is one that waits. From any thread."""
        if self._loop is not None:
            self._loop.call_soon_threadsafe(self._wake.set)

    def drop(self, job: str) -> None:
        """Ends the process of a job that is no longer wanted. From any thread."""
        if self._running is not None and self._running[0] == job:
            self._kill()

    def _kill(self) -> None:
        if self._running is not None:
            self._running[1].kill()

    async def _run_forever(self) -> None:
        while not self._closing:
            self._wake.clear()
            try:
                while not self._closing and (found := await asyncio.to_thread(self._next)) is not None:
                    await asyncio.to_thread(self._work, found)
            except SQLAlchemyError:
                log.exception("jobs could not be read or written")
                asyncio.get_running_loop().call_later(RETRY_S, self._wake.set)
            await self._wake.wait()

    def _next(self) -> JobRow | None:
        query = select(JobRow).where(JobRow.kind == self._kind.name, JobRow.state.in_(UNDER_WAY)).order_by(JobRow.id).limit(1)
        with self._store.write() as db:
            row = db.scalar(query)
            if row is not None:
                row.state = JobStatus.running
            return row

    def _work(self, row: JobRow) -> None:
        """In a thread; the work itself is in a process, which ends when this is left."""
        try:
            work = Work(self._kind.module, *self._kind.arguments(row))
            self._running = row.id, work
            for word in work.words():
                if self._closing or not self._is_running(row.id):
                    return
                match word:
                    case Advanced(done=done, told=None):
                        self.progress[row.id] = done
                    case Advanced(told=told):
                        self._change(row.id, told=told)
                    case Answered(text=text):
                        self._end(row.id, JobStatus.done, result=text)
                    case Failed():
                        self._fail(row.id, explain_failure(word))
        except HeftError as error:
            self._fail(row.id, explain_error(error))
        finally:
            self._running = None
            self.progress.pop(row.id, None)

    def _is_running(self, job: str) -> bool:
        """Whether nobody has cancelled it."""
        with self._store.read() as db:
            return load_job(db, self._kind.name, job).state == JobStatus.running

    def _fail(self, job: str, reason: Reason) -> None:
        self._end(job, JobStatus.failed, reason=dump_message(reason.message), reason_kind=reason.kind)

    def _end(self, job: str, state: JobStatus, **changes: str) -> None:
        self._change(job, state=state, ended_at=self._now(), **changes)

    def _change(self, job: str, **changes: object) -> None:
        with self._store.write() as db:
            row = load_job(db, self._kind.name, job)
            if row.state not in UNDER_WAY:  # cancelled while it answered
                return
            for name, value in changes.items():
                setattr(row, name, value)
            self._kind.also(db, row)


DiagnosesDep = Annotated[Worker, depend_on("diagnoses")]
TrialsDep = Annotated[Worker, depend_on("trials")]
