"""What a service that ended in the middle of it left behind: runs that are closed now, and samples that become a recording."""

from __future__ import annotations

import logging
from collections.abc import Callable
from datetime import datetime
from pathlib import Path
from typing import NamedTuple

from sqlalchemy import select
from sqlalchemy.orm import Session

from core.cell.cell import Cell
from core.errors import HeftError
from core.recording.order_reference import OrderReference
from core.words.message import Message
from server.runner.messages import Failed, Recovered
from server.runner.run_folder import RECORDING, SAMPLES
from server.runner.work import run_work
from server.runs.journal import FILE, read_journal
from server.runs.ledger import keep_steps
from server.runs.packml import FINAL, Command, State
from server.runs.reason import SERVICE_ENDED, Reason, set_reason
from server.runs.store_follower import keep_entry
from server.runs.tables import RunRow

log = logging.getLogger("heft.runs")


class RecoveryInput(NamedTuple):
    """The cell of a run, the folder of the recording that it continued, and what the plant calls its order."""

    cell: Cell
    continues: Path | None
    reference: OrderReference


def take_from_journals(db: Session, folder: Path) -> None:
    """What the journals of runs have and the database lacks."""
    for journal in sorted(folder.glob(f"*/{FILE}")):
        if db.get(RunRow, journal.parent.name) is not None:
            for entry in read_journal(journal.parent):
                keep_entry(db, journal.parent.name, entry)


def forget_journals(folder: Path) -> None:
    """The database has all that is in them."""
    for journal in folder.glob(f"*/{FILE}"):
        journal.unlink()


def find_unrecovered(folder: Path) -> list[str]:
    """Runs whose samples are there, but no recording: their control process died, or had no room to write it."""
    found = (each for each in folder.glob(f"*/{SAMPLES}") if each.stat().st_size > 0)
    return sorted(each.parent.name for each in found if not (each.parent / RECORDING).exists())


def close_crashed(db: Session, now: datetime) -> None:
    """Aborts the runs that an earlier service left under way; those that only waited go on waiting."""
    for row in db.scalars(select(RunRow).where(RunRow.state.not_in((*FINAL, State.ABORTED, State.RESETTING)))):
        set_reason(row, Reason(SERVICE_ENDED, Message.of("runs-service-ended", state=row.state)))
        if row.state == State.CLEARING:
            keep_steps(db, row, [None], now)
        else:
            keep_steps(db, row, [None] if row.state == State.ABORTING else [Command.ABORT, None], now)


def recover_run(folder: Path, load_input: Callable[[], RecoveryInput]) -> None:
    """The samples of a run whose control process died with its server, as a recording; where that cannot be, the log says why.

    Args:
        folder: of the run, named like it.
        load_input: tells what is known of the run, as far as its cell can still be read.
    """
    try:
        words = list(run_work("server.runner.recovery", folder, *load_input()))
    except HeftError as error:
        words = [Failed(type(error).__name__, error.message)]
    for word in words:
        if isinstance(word, Recovered):
            log.info("recovered %d samples of run %s", word.samples, folder.name)
        else:
            log.error("the samples of run %s could not be recovered: %s", folder.name, word.message if isinstance(word, Failed) else word)
