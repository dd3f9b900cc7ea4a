"""A run as it is answered: what the store knows, with the progress of one that moves."""

from __future__ import annotations

from server import run_ledger
from server.run_schemas import RunAnswer
from server.service import Service


def answered(here: Service, run: str) -> RunAnswer:
    """A run with its progress."""
    with here.store.read() as db:
        row = run_ledger.load(db, run)
    active = here.conductor.of_run(run)
    newest = None if active is None or active.newest is None else active.newest.batch
    return run_ledger.answer(row) if newest is None else run_ledger.answer(row, newest.progress, newest.eta_s)
