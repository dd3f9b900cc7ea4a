"""Runs that no process carries: they are changed in the store alone."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime

from server.people import audit
from server.people.audit import Deed
from server.runs import ledger as run_ledger
from server.runs.metrics import RunMetrics
from server.runs.packml import Command
from server.runs.reason import Reason, set_reason
from server.runs.tables import RunRow
from server.store.store import Store


class IdleRuns:
    """Those of a store; every method waits for the database.

    Args:
        metrics: that count what happens to them.
    """

    def __init__(self, store: Store, now: Callable[[], datetime], metrics: RunMetrics) -> None:
        self._store, self._now, self._metrics = store, now, metrics

    def first(self) -> list[RunRow]:
        """Of each cell the one that comes next, of the runs that are not over; an aborted one is not over before it is cleared."""
        with self._store.read() as db:
            return run_ledger.list_first_runs(db)

    def command(self, run: str, command: Command, reason: Reason, deed: Deed) -> None:
        """A command and what follows from it; that it was given goes into the audit log in the same transaction.

        Raises:
            NotFound: there is no such run.
            IllegalCommandError: not in its state.
        """
        with self._store.write() as db:
            row = run_ledger.load_run(db, run)
            if row.reason is None:
                set_reason(row, reason)
            told = run_ledger.keep_steps(db, row, [command, None], self._now())
            audit.record_deed(db, deed)
        self._metrics.count_events(told, row)

    def end(self, run: str, reason: Reason) -> None:
        """Closes a run that did not come through: as it was told to end; Stopped before any motion; else Aborted."""
        with self._store.write() as db:
            run_ledger.end(db, run_ledger.load_run(db, run), reason, self._now())
