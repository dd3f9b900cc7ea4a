"""Which run has which cell: one after the other in each, and what is asked of a run goes to whoever has it."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Coroutine
from contextlib import suppress
from datetime import datetime
from functools import partial
from pathlib import Path

from sqlalchemy.exc import SQLAlchemyError
from sqlalchemy.orm import Session

from core.cell import Cell
from core.errors import HeftError, refuse
from core.sessions.leased import Renewal
from core.shapes import Pose
from server import run_ledger
from server.active_run import ActiveRun
from server.broadcast import Broadcast
from server.cell_folder import CellFolder
from server.cell_now import read_now
from server.crashed_runs import Left, close_crashed, recover
from server.errors import Conflict
from server.idle_runs import IdleRuns
from server.packml import Command, IllegalCommandError, State
from server.reason import NOT_KEPT, SHUT_DOWN, Reason, of_error
from server.request_context import run_id
from server.run_metrics import RunMetrics
from server.run_tables import RunRow
from server.runner.context import warm_up
from server.runner.messages import ZoneMoved
from server.runner.run_folder import free
from server.store import Store

log = logging.getLogger("heft.runs")

RETRY_S = 1.0
SHUT_DOWN_NOW = Reason(SHUT_DOWN, "the service was shut down; the robot was stopped.")
STATE_NOT_KEPT = Reason(NOT_KEPT, "the run's state could not be written; the robot was stopped.")


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
        self._idle = IdleRuns(store, now, metrics)
        self._broadcasts: dict[str, Broadcast] = {}
        self._tasks: set[asyncio.Task[None]] = set()
        self._wake = asyncio.Event()
        self._taking = asyncio.Lock()  # a run that is changed in the store alone is not given its cell meanwhile
        self._loop: asyncio.AbstractEventLoop | None = None
        self._closing = False

    async def start(self) -> None:
        """Closes what a crash left open, then carries the runs that wait."""
        self._loop = asyncio.get_running_loop()
        warm_up()
        with self.store.write() as db:
            crashed = close_crashed(db, self.now())
        for run in crashed:
            self._spawn(asyncio.to_thread(recover, self.folder / run, partial(self._left_of, run)))
        self._spawn(self._queue())

    async def close(self) -> None:
        """Stops every robot and waits until it stands."""
        self._closing = True
        self._wake.set()
        for active in list(self.active.values()):
            with suppress(IllegalCommandError):
                await active.command(Command.ABORT, SHUT_DOWN_NOW, lambda _: None)
        await asyncio.gather(*self._tasks, return_exceptions=True)

    def wake(self) -> None:
        """There may be a run to begin. From any thread."""
        if self._loop is not None:
            self._loop.call_soon_threadsafe(self._wake.set)

    def zone_moved(self, cell: str, zone: str, pose: Pose) -> None:
        """Tells the cell's run. From any thread."""

        def tell() -> None:
            if cell in self.active:
                self.active[cell].zone_moved(ZoneMoved(zone, pose))

        if self._loop is not None:
            self._loop.call_soon_threadsafe(tell)

    def renew(self, cell: str, renewal: Renewal) -> None:
        """A sign of life of who is in control of a cell."""
        if cell in self.active:
            self.active[cell].renew(renewal)

    def broadcast(self, run: str) -> Broadcast:
        """To who watches a run that is not over."""
        return self._broadcasts.setdefault(run, Broadcast())

    def _over(self, run: str) -> None:
        self._broadcasts.pop(run, Broadcast()).end()
        self._wake.set()

    def of_run(self, run: str) -> ActiveRun | None:
        """The run, if it has its cell."""
        return next((active for active in self.active.values() if active.id == run), None)

    def cell_now(self, db: Session, name: str) -> Cell:
        """A cell with its zones where they are, whatever they contradict there.

        Raises:
            NotFound: there is none of that name.
            BadCell, BadRobot: it cannot be read, or its robot cannot be used.
        """
        found = read_now(self.cells, db, name)
        if found.robot_flaws:
            refuse(self.cells.flaws(found))
        return found.cell

    def plannable(self, db: Session, name: str) -> Cell:
        """The same where something can be planned in it.

        Raises:
            NotFound: there is none of that name.
            BadCell, BadRobot: nothing can, and why.
        """
        found = read_now(self.cells, db, name)
        refuse(self.cells.flaws(found))
        return found.cell

    def _left_of(self, run: str) -> Left:
        with self.store.read() as db:
            row = run_ledger.load(db, run)
            motion = run_ledger.motion_of(row)
            return Left(self.cell_now(db, row.cell), None if motion is None else motion.recording)

    async def command(self, run: str, command: Command, reason: Reason, also: Callable[[Session], object]) -> None:
        """Passes a command on; a run that has no process is changed in the store alone.

        Raises:
            NotFound: there is no such run.
            Conflict: not in its state, or its robot has not been let go of yet.
        """
        active = self.of_run(run)
        if command is Command.CLEAR and ((active is not None and active.state is State.ABORTED) or not free(self.folder / run)):
            raise Conflict(f"run {run}: its control process still closes the recording; ask again in some seconds", ["clear"])
        try:
            if active is None:
                active = await self._changed(run, command, reason, also)
            if active is not None:
                await active.command(command, reason, also)
        except IllegalCommandError:
            with self.store.read() as db:
                raise run_ledger.refusal(run_ledger.load(db, run), run_ledger.OFFERED.get(command, command)) from None

    async def _changed(self, run: str, command: Command, reason: Reason, also: Callable[[Session], object]) -> ActiveRun | None:
        """Changes a run in the store, unless it has just got its cell: then it is returned."""
        async with self._taking:
            active = self.of_run(run)
            if active is None:
                await asyncio.to_thread(self._idle.command, run, command, reason, also)
                self._over(run)
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
            with self.store.read() as db:
                cell = self.plannable(db, row.cell)
            active = ActiveRun(self.store, row, cell, self.folder / row.id, self.broadcast(row.id), self.now, self._metrics)
        except (HeftError, OSError) as error:
            await asyncio.to_thread(self._idle.end, row.id, of_error(error))
            self._over(row.id)
            return
        self.active[row.cell] = active
        self._spawn(self._carry(active))

    async def _carry(self, active: ActiveRun) -> None:
        run_id.set(active.id)
        try:
            await active.carry()
        except SQLAlchemyError:
            log.exception("the state of run %s could not be written", active.id)
            await self._bury(active.id)
        finally:
            del self.active[active.cell]
            self._over(active.id)

    async def _bury(self, run: str) -> None:
        """Tries to write the end of a run until the store can be written again."""
        while not self._closing:
            try:
                await asyncio.to_thread(self._idle.end, run, STATE_NOT_KEPT)
            except SQLAlchemyError:
                await asyncio.sleep(RETRY_S)
            else:
                return

    def _spawn(self, work: Coroutine[None, None, None]) -> None:
        task = asyncio.create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
