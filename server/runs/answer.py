"""A run as it is answered: from memory where it has its cell, with its progress; else what the database knows."""

from __future__ import annotations

from datetime import datetime, timedelta

from server.runs import ledger as run_ledger
from server.runs.conductor import Conductor
from server.runs.lease import ControlRegistry
from server.runs.packml import State
from server.runs.schemas import RunPublic
from server.runs.tables import RunRow


def answer_run(conductor: Conductor, control: ControlRegistry, now: datetime, run: str) -> RunPublic:
    """A run as it is now.

    Raises:
        NotFound: there is no such run.
    """
    return answer_now(conductor, control, now, conductor.row_of(run))


def answer_now(conductor: Conductor, control: ControlRegistry, now: datetime, row: RunRow) -> RunPublic:
    """A run that the database has told of, as it is by now."""
    active = conductor.of_run(row.id)
    if active is None:
        return run_ledger.build_answer(row)
    newest = None if active.newest is None else active.newest.batch
    progress, eta_s = (0.0, None) if newest is None else (newest.progress, newest.eta_s)
    unattended_s = control.unattended_s(row.cell) if active.state is State.HELD else None
    left_s = None if unattended_s is None else active.hold_limit_s - unattended_s
    return run_ledger.build_answer(active.row, progress, eta_s, None if left_s is None else now + timedelta(seconds=left_s))
