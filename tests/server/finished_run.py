"""A run that is over, written into the store as its ledger writes it: nobody waits for a robot."""

from __future__ import annotations

from datetime import datetime

from core.estimation.result import Result
from server.runs import ledger as run_ledger
from server.runs.packml import Command
from server.runs.schemas import RunCreate
from server.store.store import Store


def finished_run(store: Store, now: datetime, result: Result | None, *, cell: str, payload: str, empty: bool = False) -> str:
    """One that is Complete with this result; Stopped where there is none."""
    path = [Command.STOP, None] if result is None else [None, Command.START, None, None, None]
    with store.write() as db:
        row = run_ledger.add_run(db, RunCreate(cell=cell, payload=payload, empty=empty), "account:anna", now)
        run_ledger.keep_steps(db, row, path, now)
        row.result = None if result is None else result.model_dump_json()
        return row.id
