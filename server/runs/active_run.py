"""A run that has its cell: what its control process tells becomes states in memory and in its journal, and messages for who watches.

The state in memory is the run; the journal keeps it within milliseconds, the database follows. Nothing here waits for the database but
the release, before anything moves.
"""

from __future__ import annotations

import asyncio
import logging
import os
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from datetime import datetime
from pathlib import Path

from core.cell.cell import Cell
from core.errors import Cause, Commanded, HoldExpired, Lateness
from core.events import Event, PhaseStarted, Progress, RobotStopped, StepFinished
from core.sessions.leased import Renewal
from core.words.message import Message
from server.http.errors import StoreUnavailable
from server.people.audit import Deed
from server.runner.messages import (
    Beat,
    Done,
    End,
    Failed,
    FromChild,
    Happened,
    Hold,
    MotionEnded,
    Paced,
    PageLate,
    Ready,
    Release,
    Resume,
    Sampled,
    ZoneChanged,
)
from server.runner.plan_schemas import RunPlan
from server.runner.process import ControlProcess
from server.runs import ledger as run_ledger
from server.runs.broadcast import Broadcast
from server.runs.event_schemas import EventMessage, PlanShown
from server.runs.journal import JournalEntry, RunChange, RunJournal
from server.runs.ledger import Step
from server.runs.metrics import RunMetrics
from server.runs.order import order_of
from server.runs.packml import FINAL, Command, State
from server.runs.reason import NO_ROOM, NOT_KEPT, Reason, find_reason_kind, set_reason
from server.runs.reason import explain_failure as failure
from server.runs.steps import after, from_states, update_in_the_way
from server.runs.store_follower import StoreFollower
from server.runs.tables import RunRow
from server.store.store import Store

log = logging.getLogger("heft.runs")

GRACE_S = 15.0
"""What a control process may take to end when it is told to: braking, and writing the recording."""
STORE_PATIENCE_S = 30.0
"""How long the database may lag behind a robot that moves; then the robot is put on hold."""
STORE_LOOK_S = 0.25
RELEASE_PATIENCE_S = 3.0
"""How long a release waits for the database, before and after it is written."""
SHUTDOWN_PATIENCE_S = 5.0
"""How long the end of the service waits for a database that is away; the next one goes on from the journal."""


class ActiveRun:
    """One run from its planning to its end.

    Args:
        row: of the run, in Resetting.
        events: its events so far, with their sequence numbers.
        cell: with its zones where they are now.
        folder: of the run; made here.
        broadcast: to who watches it.
        metrics: that count what happens to it.
    """

    def __init__(
        self,
        store: Store,
        row: RunRow,
        events: list[tuple[int, str]],
        cell: Cell,
        folder: Path,
        broadcast: Broadcast,
        now: Callable[[], datetime],
        metrics: RunMetrics,
    ) -> None:
        self.id, self.cell, self.folder = row.id, cell.name, folder
        self.row, self.events, self.broadcast = row, events, broadcast
        self.newest: Sampled | None = None
        self.plan: RunPlan | None = None
        self.changed_at: datetime = now()
        """When it went into its state."""
        self._now, self._metrics = now, metrics
        folder.mkdir(parents=True, exist_ok=True)
        order = order_of(row, cell, folder)
        self.payload_box, self.hold_limit_s = order.payload_box, cell.control.hold_limit_s
        self._steps = asyncio.Lock()
        self._journal, self._journal_writer = RunJournal(folder), ThreadPoolExecutor(1, "run-journal")
        self._number = row.journaled
        self._unwritten: list[JournalEntry] = []
        self._commands = 0
        """That are being given at this moment."""
        self._ended_for: Reason | None = None
        self._follower = StoreFollower(store, row.id)
        self._process = ControlProcess(order)

    @property
    def state(self) -> State:
        """Where it is now."""
        return State(self.row.state)

    async def carry(self) -> None:
        """Until the run is over and its control process has ended."""
        looking = asyncio.create_task(self._watch_store())
        try:
            async for message in self._process.messages():
                await self._hear(message)
        finally:
            looking.cancel()

    async def keep(self, is_closing: Callable[[], bool]) -> None:
        """Until the database has everything; a service that ends does not wait long for that."""
        while self._commands:
            await asyncio.sleep(0.01)
        given_s = 0.0
        while not await self._follower.caught_up(1.0):
            given_s += is_closing()
            if given_s >= SHUTDOWN_PATIENCE_S:
                log.warning("the database lacks what happened to run %s; it is taken from its journal at the next start", self.id)
                break
        else:
            await asyncio.get_running_loop().run_in_executor(self._journal_writer, self._journal.remove)
        await self._follower.close()
        self._journal.close()
        self._journal_writer.shutdown(wait=False)

    def renew(self, renewal: Renewal) -> None:
        """Hands a sign of life of whoever is in control on."""
        self._process.tell(renewal)

    def beat(self, stamp_s: float) -> None:
        """Hands a sign of life of the service on. From any thread."""
        self._process.tell(Beat(stamp_s, os.getpid()))

    def note_late_page(self, late_s: float) -> None:
        """Hands on that the page of whoever is in control does not respond."""
        self._process.tell(PageLate(late_s))

    def _end(self, reason: Reason) -> None:
        """Tells the robot to stop for good; nothing is written."""
        self._ended_for = self._ended_for or reason
        self._process.tell(End(reason.message))

    def tell_zone_change(self, message: ZoneChanged) -> None:
        """Hands on how a zone is now."""
        self._process.tell(message)

    async def release(self, plan_sha256: str, who: str, deed: Deed) -> None:
        """Lets the plan begin, once the database has that it may.

        Raises:
            IllegalCommandError: there is no plan that waits.
            StoreUnavailable: the database cannot be written; nothing has moved.
        """
        if not await self._follower.caught_up(RELEASE_PATIENCE_S):
            raise StoreUnavailable("store-release-waits")

        def change(row: RunRow) -> None:
            row.released, row.released_by, row.released_at = True, who, self._now()

        await self._step(lambda _: [Command.START], change=change, deeds=[deed])
        if self._unwritten or not await self._follower.caught_up(RELEASE_PATIENCE_S):
            self._end(Reason(NOT_KEPT, Message.of("runs-release-not-kept")))
            raise StoreUnavailable("store-release-not-taken")
        self._process.tell(Release(plan_sha256))

    async def command(self, command: Command, reason: Reason, deed: Deed) -> None:
        """Holds, resumes, stops or aborts; the robot hears of it before anything is written.

        Raises:
            IllegalCommandError: not in this state.
            StoreUnavailable: the robot was to go on, and the database cannot be written.
        """
        self._commands += 1
        try:
            await self._command(command, reason, deed)
        finally:
            self._commands -= 1

    async def _command(self, command: Command, reason: Reason, deed: Deed) -> None:
        if command is Command.UNHOLD and self.state is State.HELD and not await self._follower.caught_up(RELEASE_PATIENCE_S):
            raise StoreUnavailable("store-resume-waits")
        if command in (Command.STOP, Command.ABORT):
            self._end(reason)
            asyncio.get_running_loop().call_later(GRACE_S, self._process.kill)
        elif command is Command.HOLD and self.state is State.EXECUTE:
            self._process.tell(Hold())

        def change(row: RunRow) -> None:
            set_reason(row, None if command is Command.UNHOLD else reason)
            row.lateness = None

        await self._step(lambda _: [command], change=change, deeds=[deed])
        if command is Command.UNHOLD:
            self._process.tell(Resume())

    async def _watch_store(self) -> None:
        """A robot that moves is put on hold while the database lags too far behind; goes on until it is cancelled."""
        while True:
            await asyncio.sleep(STORE_LOOK_S)
            behind = self._follower.behind_s
            if behind > STORE_PATIENCE_S and self.state is State.EXECUTE:
                lateness = Lateness(cause=Cause.STORE, late_s=behind, limit_s=STORE_PATIENCE_S)
                self._process.tell(Hold(lateness))

    async def _hear(self, message: FromChild) -> None:
        match message:
            case Sampled():
                self.newest = message
                self.broadcast.samples(message.batch)
            case Happened(event=Progress()):
                pass  # stands in the samples
            case Happened(event=event):
                await self._handle_event(event)
            case Ready(plan=plan):
                self.plan = plan
                shown = PlanShown(sha256=plan.sha256, robot_s=plan.summary.robot_s)
                await self._step(from_states(State.RESETTING), [shown], lambda row: setattr(row, "plan", plan.model_dump_json()))
            case Paced():
                self._metrics.observe_pace(message)
            case MotionEnded():
                await self._step(from_states(State.EXECUTE))
            case Done(result=result):
                text = result.model_dump_json()
                path = from_states(State.COMPLETING, State.STOPPING, State.ABORTING)
                await self._step(path, change=lambda row: setattr(row, "result", text))
            case Failed():
                await self._fail(message)

    async def _handle_event(self, event: Event) -> None:
        def change(row: RunRow) -> None:
            row.in_the_way = update_in_the_way(event, row.in_the_way)
            match event:
                case PhaseStarted(steps=steps):
                    row.steps = steps
                case StepFinished(step=step):
                    row.finished_steps = step
                case RobotStopped(held=True, lateness=Lateness() as lateness):
                    set_reason(row, Reason(find_reason_kind(event.error, lateness), event.message))
                    row.lateness = lateness.model_dump_json()

        await self._step(lambda state: after(event, state), [event], change)

    async def _fail(self, failed: Failed) -> None:
        """The end of a run that did not come through: where it was told to end, as told; before any motion Stopped; else Aborted."""

        def change(row: RunRow) -> None:
            ordered = failed.error == Commanded.__name__ and self._ended_for is not None
            if not (ordered and row.reason is not None and row.state in (State.STOPPING, State.ABORTING)):
                set_reason(row, self._ended_for if ordered else failure(failed))
                row.lateness = None if failed.lateness is None else failed.lateness.model_dump_json()
            if row.state != State.STOPPING and failed.error != HoldExpired.__name__:
                row.aborted, row.in_the_way = True, failed.in_the_way

        await self._step(run_ledger.find_end_path, change=change)

    async def _step(
        self,
        path: Callable[[State], Iterable[Step]],
        events: Sequence[Event] = (),
        change: Callable[[RunRow], object] = lambda _: None,
        deeds: Sequence[Deed] = (),
    ) -> None:
        """The change, the events, the states on the path: into the journal, then to the watchers and after them to the database."""
        async with self._steps:
            row = run_ledger.copy_row(self.row)
            change(row)
            messages = run_ledger.tell(row, events, self._now()) + run_ledger.advance(row, path(State(row.state)), self._now())
            changed = RunChange.between(self.row, row)
            if not (messages or deeds or changed.model_fields_set):
                return
            self._number += 1
            ended = self.row.ended_at is None and row.ended_at is not None
            await self._note(JournalEntry(number=self._number, change=changed, messages=messages, deeds=list(deeds), ended=ended))
            if row.state != self.row.state:
                self.changed_at = self._now()
            self.row = row
            self._metrics.count_events(messages, row)
            self._tell(messages)

    async def _note(self, entry: JournalEntry) -> None:
        """Into the journal. Where that cannot be written the robot stops; its state is in memory until there is room."""
        self._unwritten.append(entry)
        try:
            await asyncio.get_running_loop().run_in_executor(self._journal_writer, self._write_journal)
        except OSError as error:
            log.error("the journal of run %s cannot be written: %s", self.id, error.strerror)
            if self.state not in FINAL:
                self._end(Reason(NO_ROOM, Message.of("runs-journal-not-writable", reason=error.strerror or "")))
        self._follower.add(entry)

    def _write_journal(self) -> None:
        """What it lacks, in order."""
        while self._unwritten:
            self._journal.append(self._unwritten[0])
            self._unwritten.pop(0)

    def _tell(self, messages: Iterable[EventMessage]) -> None:
        for message in messages:
            text = message.model_dump_json()
            self.events.append((message.sequence, text))
            self.broadcast.event(message.sequence, text)
