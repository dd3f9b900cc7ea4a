"""A run that has its cell: what its control process tells becomes states in the store and messages for who watches."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Iterable
from datetime import datetime
from pathlib import Path

from sqlalchemy.exc import SQLAlchemyError
from sqlalchemy.orm import Session

from core.cell import Cell
from core.errors import Commanded
from core.events import Event, Progress
from core.sessions.leased import Renewal
from server import run_ledger
from server.broadcast import Broadcast
from server.event_schemas import EventMessage, PlanShown
from server.packml import MOVING, Command, State
from server.plan_schemas import RunPlan
from server.reason import Reason, because
from server.reason import failed as failure
from server.run_ledger import Step
from server.run_metrics import RunMetrics
from server.run_order import order_of
from server.run_steps import after, from_states, in_the_way
from server.run_tables import RunRow
from server.runner.messages import (
    Done,
    End,
    Failed,
    FromChild,
    Happened,
    Hold,
    MotionEnded,
    Paced,
    Ready,
    Release,
    Resume,
    Sampled,
    ZoneMoved,
)
from server.runner.process import ControlProcess
from server.store import Store
from server.store_watch import StoreWatch

log = logging.getLogger("heft.runs")

GRACE_S = 15.0
"""What a control process may take to end when it is told to: braking, and writing the recording."""


class ActiveRun:
    """One run from its planning to its end.

    Args:
        row: of the run, in Resetting.
        cell: with its zones where they are now.
        folder: of the run; made here.
        broadcast: to who watches it.
        metrics: that count what happens to it.
    """

    def __init__(
        self, store: Store, row: RunRow, cell: Cell, folder: Path, broadcast: Broadcast, now: Callable[[], datetime], metrics: RunMetrics
    ) -> None:
        self.id, self.cell, self.folder = row.id, cell.name, folder
        self.state, self.broadcast = State(row.state), broadcast
        self.newest: Sampled | None = None
        self.plan: RunPlan | None = None
        self._store, self._now, self._metrics = store, now, metrics
        self._steps = asyncio.Lock()
        self._watch = StoreWatch(store, lambda: self.state in MOVING, self._end)
        folder.mkdir(parents=True, exist_ok=True)
        order = order_of(row, cell, folder)
        self.payload_box = order.payload_box
        self._process = ControlProcess(order)

    async def carry(self) -> None:
        """Until the run is over."""
        looking = asyncio.create_task(self._watch.look())
        try:
            async for message in self._process.messages():
                await self._hear(message)
        except SQLAlchemyError as error:
            self._end(f"the run's state could not be written ({type(error).__name__}); the robot was stopped.")
            async for _ in self._process.messages():
                pass
            raise
        finally:
            looking.cancel()
            self._watch.close()

    def renew(self, renewal: Renewal) -> None:
        """Hands a sign of life on."""
        self._process.tell(renewal)

    def _end(self, reason: str) -> None:
        """Tells the robot to stop for good; nothing is written."""
        self._process.tell(End(reason))

    def zone_moved(self, moved: ZoneMoved) -> None:
        """Hands a zone's new place on."""
        self._process.tell(moved)

    async def release(self, plan_sha256: str, who: str, also: Callable[[Session], object]) -> None:
        """Lets the plan begin; `also` is written in the same transaction.

        Raises:
            IllegalCommandError: there is no plan that waits.
        """

        def change(row: RunRow) -> None:
            row.released, row.released_by, row.released_at = True, who, self._now()

        await self._step(lambda _: [Command.START], change=change, also=also)
        self._process.tell(Release(plan_sha256))

    async def command(self, command: Command, reason: Reason, also: Callable[[Session], object]) -> None:
        """Holds, resumes, stops or aborts; the robot hears of an end before the store does.

        Raises:
            IllegalCommandError: not in this state.
        """
        if command in (Command.STOP, Command.ABORT):
            self._end(reason.sentence)
            asyncio.get_running_loop().call_later(GRACE_S, self._process.kill)
        elif command is Command.HOLD and self.state is State.EXECUTE:
            self._process.tell(Hold())

        def change(row: RunRow) -> None:
            because(row, None if command is Command.UNHOLD else reason)

        await self._step(lambda _: [command], change=change, also=also)
        if command is Command.UNHOLD:
            self._process.tell(Resume())

    async def _hear(self, message: FromChild) -> None:
        match message:
            case Sampled():
                self.newest = message
                self.broadcast.samples(message.batch.model_dump_json())
            case Happened(event=Progress()):
                pass  # stands in the samples
            case Happened(event=event):
                await self._happened(event)
            case Ready(plan=plan):
                self.plan = plan
                shown = PlanShown(sha256=plan.sha256, robot_s=plan.summary.robot_s)
                await self._step(from_states(State.RESETTING), [shown], lambda row: setattr(row, "plan", plan.model_dump_json()))
            case Paced():
                self._metrics.paced(message)
            case MotionEnded():
                await self._step(from_states(State.EXECUTE))
            case Done(result=result):
                text = result.model_dump_json()
                path = from_states(State.COMPLETING, State.STOPPING, State.ABORTING)
                await self._step(path, change=lambda row: setattr(row, "result", text))
            case Failed():
                await self._fail(message)

    async def _happened(self, event: Event) -> None:
        def change(row: RunRow) -> None:
            row.in_the_way = in_the_way(event, row.in_the_way)

        await self._step(lambda state: after(event, state), [event], change)

    async def _fail(self, failed: Failed) -> None:
        """The end of a run that did not come through: where it was told to end, as told; before any motion Stopped; else Aborted."""

        def change(row: RunRow) -> None:
            asked = row.state == State.STOPPING or (row.state == State.ABORTING and failed.error == Commanded.__name__)
            if row.reason is None or not asked:
                because(row, failure(failed))
            if row.state != State.STOPPING:
                row.aborted, row.in_the_way = True, failed.in_the_way

        await self._step(run_ledger.ending, change=change)

    async def _step(
        self,
        path: Callable[[State], Iterable[Step]],
        events: Iterable[Event] = (),
        change: Callable[[RunRow], object] = lambda _: None,
        also: Callable[[Session], object] = lambda _: None,
    ) -> None:
        """One transaction: the change, the states on the path, the events, whatever else; then the watchers are told."""

        def write() -> tuple[RunRow, list[EventMessage]]:
            with self._store.write() as db:
                row = run_ledger.load(db, self.id)
                change(row)
                told = run_ledger.tell(db, row, list(events), self._now()) + run_ledger.steps(db, row, path(State(row.state)), self._now())
                also(db)
                return row, told

        async with self._steps:
            row, messages = await self._watch.written(write)
            self.state = State(row.state)
            self._metrics.told(messages, row)
            for message in messages:
                self.broadcast.event(message.sequence, message.model_dump_json())
