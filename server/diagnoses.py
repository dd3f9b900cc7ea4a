"""Diagnoses as jobs, one at a time: they wait in the store, so a service that starts anew goes on with them."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from datetime import datetime
from enum import StrEnum
from pathlib import Path

from sqlalchemy import select
from sqlalchemy.exc import SQLAlchemyError
from sqlalchemy.orm import Session

from core.gap.answer import Diagnosis
from server.errors import NotFound
from server.run_ledger import new_id
from server.run_tables import DiagnosisRow
from server.runner.diagnosing import Fitted, diagnosed
from server.store import Store

log = logging.getLogger("heft.diagnoses")

RETRY_S = 2.0


class State(StrEnum):
    """How far a diagnosis is."""

    waiting = "waiting"
    running = "running"
    done = "done"
    failed = "failed"


def queue(db: Session, recording: Path, run: str | None, who: str, now: datetime) -> DiagnosisRow:
    """A diagnosis that waits for its turn."""
    row = DiagnosisRow(id=new_id(now), recording=str(recording), run=run, state=State.waiting, requested_by=who, requested_at=now)
    db.add(row)
    db.flush()
    return row


def load(db: Session, diagnosis: str) -> DiagnosisRow:
    """One diagnosis.

    Raises:
        NotFound: there is none.
    """
    row = db.get(DiagnosisRow, diagnosis)
    if row is None:
        raise NotFound("diagnosis", diagnosis)
    return row


class Diagnoser:
    """Works through the diagnoses that wait."""

    def __init__(self, store: Store, now: Callable[[], datetime]) -> None:
        self._store, self._now = store, now
        self.progress: dict[str, float] = {}
        """Of the one that runs, 0 to 1."""
        self._wake = asyncio.Event()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._task: asyncio.Task[None] | None = None
        self._closing = False

    async def start(self) -> None:
        """Goes on until `close`."""
        self._loop = asyncio.get_running_loop()
        self._task = asyncio.create_task(self._forever())

    async def close(self) -> None:
        """What is not done is begun again by the next service."""
        self._closing = True
        self._wake.set()
        if self._task is not None:
            await self._task

    def wake(self) -> None:
        """There is one that waits. From any thread."""
        if self._loop is not None:
            self._loop.call_soon_threadsafe(self._wake.set)

    async def _forever(self) -> None:
        while not self._closing:
            self._wake.clear()
            try:
                while not self._closing and (found := await asyncio.to_thread(self._next)) is not None:
                    await asyncio.to_thread(self._work, *found)
            except SQLAlchemyError:
                log.exception("diagnoses could not be read or written")
                asyncio.get_running_loop().call_later(RETRY_S, self._wake.set)
            await self._wake.wait()

    def _next(self) -> tuple[str, Path] | None:
        query = select(DiagnosisRow).where(DiagnosisRow.state.in_((State.waiting, State.running))).order_by(DiagnosisRow.id).limit(1)
        with self._store.write() as db:
            row = db.scalar(query)
            if row is None:
                return None
            row.state = State.running
            return row.id, Path(row.recording)

    def _work(self, diagnosis: str, folder: Path) -> None:
        """In a thread; the work itself is in a process."""
        try:
            for answer in diagnosed(folder):
                if self._closing:
                    return
                if isinstance(answer, Fitted):
                    self.progress[diagnosis] = answer.done / (answer.of + 1)
                elif isinstance(answer, Diagnosis):
                    self._close(diagnosis, State.done, result=answer.model_dump_json())
                else:
                    self._close(diagnosis, State.failed, reason=answer.message)
        finally:
            self.progress.pop(diagnosis, None)

    def _close(self, diagnosis: str, state: State, *, result: str | None = None, reason: str | None = None) -> None:
        with self._store.write() as db:
            row = load(db, diagnosis)
            row.state, row.result, row.reason, row.ended_at = state, result, reason, self._now()
