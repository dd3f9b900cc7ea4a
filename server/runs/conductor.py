"""Which run has which cell: one after the other in each, and what is asked of a run goes to whoever has it."""

from __future__ import annotations

import asyncio
import logging
import threading
import time
from collections.abc import Callable, Coroutine
from contextlib import suppress
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import Annotated

from sqlalchemy.exc import SQLAlchemyError
from sqlalchemy.orm import Session

from core.cell.cell import Cell
from core.errors import HeftError, refuse
from core.payload.shapes import StandingShape
from core.sessions.leased import Renewal
from core.words.message import Message
from server.cells.folder import CellFolder
from server.cells.now import read_now
from server.http.dependencies import depend_on
from server.http.errors import Conflict
from server.people import audit
from server.people.audit import Deed
from server.runner.context import warm_up
from server.runner.messages import ZoneChanged
from server.runner.run_folder import is_unlocked
from server.runs import ledger as run_ledger
from server.runs.active_run import ActiveRun
from server.runs.broadcast import Broadcast
from server.runs.crashed_runs import RecoveryInput, close_crashed, find_unrecovered, forget_journals, recover_run, take_from_journals
from server.runs.idle import IdleRuns
from server.runs.metrics import RunMetrics
from server.runs.order import reference_of
from server.runs.packml import Command, IllegalCommandError, State
from server.runs.reason import SHUT_DOWN, Reason, explain_error
from server.runs.tables import RunRow
from server.store.store import Store
from server.telemetry.request_context import run_id

log = logging.getLogger("heft.runs")

RETRY_S = 1.0
KEPT_S = 3.0
BEAT_S = 0.05
"""Of the signs of life that the robots' control processes get."""
SHUT_DOWN_NOW = Reason(SHUT_DOWN, Message.of("runs-shut-down"))


class Conductor:
    """All runs of the service.

    Args:
        folder: of the runs' recordings.
        metrics: that count what happens to them.
    """

    def __init__(self, store: Store, cells: CellFolder, folder: Path, now: Callable[[], datetime], metrics: RunMetrics) -> None:
        self.store, self.cells, self.folder, self.now, self._metrics = store, cells, folder, now, metrics
        self.active: dict[str, ActiveRun] = {}
        """By cell."""
        self.queue_changes = 0
        """Counts what may have changed in the queues of the cells."""
        self._idle = IdleRuns(store, now, metrics)
        self._broadcasts: dict[str, Broadcast] = {}
        self._tasks: set[asyncio.Task[None]] = set()
        self._wake = asyncio.Event()
        self._taking = asyncio.Lock()  # a run that is changed in the store alone is not given its cell meanwhile
        self._loop: asyncio.AbstractEventLoop | None = None
        self._closing = False
        self._closed = threading.Event()

    async def start(self) -> None:
        """Takes from the journals what the database lacks, closes what a crash left open, then carries the runs that wait."""
        self._loop = asyncio.get_running_loop()
        warm_up()
        threading.Thread(target=self._beat, name="beat", daemon=True).start()
        await asyncio.to_thread(self._catch_up)
        for run in await asyncio.to_thread(find_unrecovered, self.folder):
            self._spawn(asyncio.to_thread(recover_run, self.folder / run, partial(self._load_recovery_input, run)))
        self._spawn(self._queue())

    def _catch_up(self) -> None:
        """What an earlier service left behind, in the database."""
        with self.store.write() as db:
            take_from_journals(db, self.folder)
            close_crashed(db, self.now())
        forget_journals(self.folder)

    def _beat(self) -> None:
        """A sign of life for every robot, from a thread of its own: an event loop that is busy is no reason to brake, a lease that is not
        renewed is."""
        while not self._closed.wait(BEAT_S):
            for active in list(self.active.values()):
                active.beat(time.monotonic())

    async def close(self) -> None:
        """Stops every robot and waits until it stands."""
        self._closing = True
        self._wake.set()
        for active in list(self.active.values()):
            with suppress(IllegalCommandError):
                await active.command(
                    Command.ABORT, SHUT_DOWN_NOW, audit.make_deed("service", "run.abort", {"run": active.id}, now=self.now())
                )
        await asyncio.gather(*self._tasks, return_exceptions=True)
        self._closed.set()

    def wake(self) -> None:
        """There may be a run to begin. From any thread."""
        self.queue_changes += 1
        if self._loop is not None:
            self._loop.call_soon_threadsafe(self._wake.set)

    def tell_zone_change(self, cell: str, zone: str, shape: StandingShape | None) -> None:
        """Tells the cell's run. From any thread."""

        def tell() -> None:
            if cell in self.active:
                self.active[cell].tell_zone_change(ZoneChanged(zone, shape))

        if self._loop is not None:
            self._loop.call_soon_threadsafe(tell)

    def renew(self, cell: str, renewal: Renewal) -> None:
        """A sign of life of who is in control of a cell."""
        if cell in self.active:
            self.active[cell].renew(renewal)

    def note_late_page(self, cell: str, late_s: float) -> None:
        """The page of who is in control of a cell does not respond."""
        if cell in self.active:
            self.active[cell].note_late_page(late_s)

    def broadcast(self, run: str) -> Broadcast:
        """To who watches a run that is not over."""
        return self._broadcasts.setdefault(run, Broadcast())

    def _finish(self, run: str) -> None:
        self.queue_changes += 1
        self._broadcasts.pop(run, Broadcast()).end()
        self._wake.set()

    def of_run(self, run: str) -> ActiveRun | None:
        """The run, if it has its cell."""
        return next((active for active in self.active.values() if active.id == run), None)

    def load_current_cell(self, db: Session, name: str) -> Cell:
        """A cell with its zones where they are, whatever they contradict there.

        Raises:
            NotFound: there is none of that name.
            BadCell, BadRobot: it cannot be read, or its robot cannot be used.
        """
        found = read_now(self.cells, db, name)
        if found.robot_flaws:
            refuse(self.cells.flaws(found))
        return found.cell

    def load_plannable_cell(self, db: Session, name: str) -> Cell:
        """The same where something can be planned in it.

        Raises:
            NotFound: there is none of that name.
            BadCell, BadRobot: nothing can, and why.
        """
        found = read_now(self.cells, db, name)
        refuse(self.cells.flaws(found))
        return found.cell

    def read_current_cell(self, name: str) -> Cell:
        """The same for whoever has no session of the database at hand."""
        with self.store.read() as db:
            return self.load_current_cell(db, name)

    def _load_recovery_input(self, run: str) -> RecoveryInput:
        with self.store.read() as db:
            row = run_ledger.load_run(db, run)
            motion = run_ledger.motion_of(row)
            continues = None if motion is None else motion.recording
            return RecoveryInput(self.load_current_cell(db, row.cell), continues, reference_of(row))

    def row_of(self, run: str) -> RunRow:
        """A run as it is now: from memory where it has its cell, else from the database.

        Raises:
            NotFound: there is no such run.
        """
        active = self.of_run(run)
        if active is not None:
            return active.row
        with self.store.read() as db:
            return run_ledger.load_run(db, run)

    def wait_until_kept(self, run: str) -> bool:
        """Waits a moment until a run that is over is in the database alone; whether it is. Not from the event loop."""
        until = time.monotonic() + KEPT_S
        while self.of_run(run) is not None and time.monotonic() < until:
            time.sleep(0.02)
        return self.of_run(run) is None

    async def command(self, run: str, command: Command, reason: Reason, deed: Deed) -> None:
        """Passes a command on; a run that has no process is changed in the store alone.

        Raises:
            NotFound: there is no such run.
            Conflict: not in its state, or its robot has not been let go of yet.
        """
        active = self.of_run(run)
        if command is Command.CLEAR and ((active is not None and active.state is State.ABORTED) or not is_unlocked(self.folder / run)):
            raise Conflict("runs-recording-open", allowed=["clear"], run=run)
        try:
            if active is None:
                active = await self._command_idle(run, command, reason, deed)
            if active is not None:
                await active.command(command, reason, deed)
        except IllegalCommandError:
            raise run_ledger.refusal(await asyncio.to_thread(self.row_of, run), run_ledger.OFFERED.get(command, command)) from None

    async def _command_idle(self, run: str, command: Command, reason: Reason, deed: Deed) -> ActiveRun | None:
        """Changes a run in the store, unless it has just got its cell: then it is returned."""
        async with self._taking:
            active = self.of_run(run)
            if active is None:
                await asyncio.to_thread(self._idle.command, run, command, reason, deed)
                self._finish(run)
            return active

    async def _queue(self) -> None:
        while not self._closing:
            self._wake.clear()
            try:
                await self._begin_waiting()
            except SQLAlchemyError:
                log.exception("the runs that wait could not be read")
                asyncio.get_running_loop().call_later(RETRY_S, self._wake.set)
            await self._wake.wait()

    async def _begin_waiting(self) -> None:
        async with self._taking:
            for row in await asyncio.to_thread(self._idle.first):
                if row.state == State.RESETTING and row.cell not in self.active and not self._closing:
                    await self._begin(row)

    async def _begin(self, row: RunRow) -> None:
        try:
            cell, events = await asyncio.to_thread(self._load_cell_and_events, row)
            if self._closing:  # nobody would abort it any more; it waits for the next start
                return
            active = ActiveRun(self.store, row, events, cell, self.folder / row.id, self.broadcast(row.id), self.now, self._metrics)
        except (HeftError, OSError) as error:
            await asyncio.to_thread(self._idle.end, row.id, explain_error(error))
            self._finish(row.id)
            return
        self.active[row.cell] = active
        self.queue_changes += 1
        self._spawn(self._carry(active))

    def _load_cell_and_events(self, row: RunRow) -> tuple[Cell, list[tuple[int, str]]]:
        """The run's cell, and what has happened to it."""
        with self.store.read() as db:
            return self.load_plannable_cell(db, row.cell), run_ledger.list_events(db, row.id, 0)

    async def _carry(self, active: ActiveRun) -> None:
        run_id.set(active.id)
        try:
            await active.carry()
            await active.keep(lambda: self._closing)
        finally:
            del self.active[active.cell]
            self._finish(active.id)

    def _spawn(self, work: Coroutine[None, None, None]) -> None:
        task = asyncio.create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)


ConductorDep = Annotated[Conductor, depend_on("conductor")]
