"""A run as it is answered: from memory where it has its cell, with its progress; else what the database knows."""

from __future__ import annotations

from datetime import timedelta

from server import run_ledger
from server.packml import State
from server.run_schemas import RunAnswer
from server.run_tables import RunRow
from server.service import Service


def answered(here: Service, run: str) -> RunAnswer:
    """A run as it is now.

    Raises:
        NotFound: there is no such run.
    """
    return answer_now(here, here.conductor.row_of(run))


def answer_now(here: Service, row: RunRow) -> RunAnswer:
    """A run that the database has told of, as it is by now."""
    active = here.conductor.of_run(row.id)
    if active is None:
        return run_ledger.answer(row)
    newest = None if active.newest is None else active.newest.batch
    progress, eta_s = (0.0, None) if newest is None else (newest.progress, newest.eta_s)
    unattended_s = here.control.unattended_s(row.cell) if active.state is State.HELD else None
    left_s = None if unattended_s is None else active.hold_limit_s - unattended_s
    return run_ledger.answer(active.row, progress, eta_s, None if left_s is None else here.now() + timedelta(seconds=left_s))
