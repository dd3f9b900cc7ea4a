"""The viewers of all cells: each begun when somebody first looks, and fed with what its cell's run does."""

from __future__ import annotations

import asyncio
from dataclasses import dataclass
from typing import Annotated, NamedTuple

from sqlalchemy.exc import SQLAlchemyError

from core.cell.cell import Box, Cell
from core.errors import HeftError
from server.http.dependencies import depend_on
from server.runner.live_schemas import LiveBatch
from server.runner.plan_schemas import RunPlan
from server.runs import ledger as run_ledger
from server.runs.active_run import ActiveRun
from server.runs.conductor import Conductor
from server.runs.schemas import RunOrder
from server.runs.tables import RunRow
from server.viewer.process import InTheWayUpdate, PlanUpdate, RobotUpdate, ViewerProcess, ViewUpdate, ZonesUpdate
from server.viewer.wish import Look, Wish

PERIOD_S = 1.0 / 30.0
STORE_S = 0.5
MOST_WISHES = 64
"""Pages whose wishes are kept for a cell that nobody draws."""


class RunShown(NamedTuple):
    """Of the cell's run what is drawn while it has no plan: the one that is not over, else the last.

    Args:
        in_the_way: obstacle, zone or link that kept it from being planned, or from going on.
        start_rad: where its robot stands before it moves; None where an earlier run has left it somewhere.
    """

    run: str
    in_the_way: str | None
    payload_box: Box
    start_rad: tuple[float, ...] | None


@dataclass
class Drawn:
    """What a viewer has been told."""

    cell: Cell
    run: str | None = None
    plan: RunPlan | None = None
    batch: LiveBatch | None = None
    in_the_way: str | None = None


class Gallery:
    """All viewers.

    Args:
        conductor: whose runs are shown.
    """

    def __init__(self, conductor: Conductor) -> None:
        self._conductor = conductor
        self._ports: dict[str, asyncio.Future[int]] = {}
        self._viewers: dict[str, ViewerProcess] = {}
        self._tasks: set[asyncio.Task[None]] = set()
        self._wishes: dict[str, dict[str, ViewUpdate]] = {}
        """Of pages whose cell nobody draws yet, by cell and view."""

    async def start(self) -> None:
        """Nothing to do before somebody looks."""

    async def close(self) -> None:
        """Ends all viewers."""
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)
        for viewer in self._viewers.values():
            viewer.close()

    async def port(self, cell: str) -> int:
        """Of a cell's viewer, which is begun if need be.

        Raises:
            NotFound, BadCell, BadRobot: there is no such cell to show.
        """
        if cell in self._viewers and not self._viewers[cell].alive:
            self._viewers.pop(cell).close()
            del self._ports[cell]
        if cell not in self._ports:
            loaded = await asyncio.to_thread(self._load_cell, cell)
            if cell not in self._ports:
                self._begin(loaded)
        return await asyncio.shield(self._ports[cell])

    def _begin(self, cell: Cell) -> None:
        viewer = self._viewers[cell.name] = ViewerProcess(cell)
        self._ports[cell.name] = asyncio.ensure_future(viewer.port())
        task = asyncio.create_task(self._feed(cell, viewer))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    def _load_cell(self, name: str) -> Cell:
        with self._conductor.store.read() as db:
            return self._conductor.load_current_cell(db, name)

    def _read_standing(self, name: str) -> tuple[Cell, RunShown | None]:
        """The cell and its run as they are now."""
        with self._conductor.store.read() as db:
            cell, row = self._conductor.load_current_cell(db, name), run_ledger.find_latest_run(db, name)
            return cell, None if row is None else _select_shown(row, cell)

    async def show(self, cell: str, view: str, wish: Wish, look: Look | None) -> None:
        """What one page wants to see; drawn when its cell is.

        Raises:
            NotFound, BadCell, BadRobot: there is no such cell to show.
        """
        update = ViewUpdate(view, wish, look)
        if cell in self._viewers and self._viewers[cell].alive:
            self._viewers[cell].tell(update)
            return
        await asyncio.to_thread(self._load_cell, cell)
        waiting = self._wishes.setdefault(cell, {})
        waiting[view] = update
        while len(waiting) > MOST_WISHES:
            del waiting[next(iter(waiting))]

    async def _feed(self, cell: Cell, viewer: ViewerProcess) -> None:
        """Newest positions 30 times a second, plans, zones and what is in the way when they change."""
        await asyncio.shield(self._ports[cell.name])
        for update in self._wishes.pop(cell.name, {}).values():
            viewer.tell(update)
        drawn = Drawn(cell)
        ticks = 0
        while viewer.alive:
            active = self._conductor.active.get(cell.name)
            if active is not None:
                _tell_active(active, drawn, viewer)
            ticks += 1
            if ticks * PERIOD_S >= STORE_S:
                ticks = 0
                await self._tell_changes(drawn, viewer)
            await asyncio.sleep(PERIOD_S)

    async def _tell_changes(self, drawn: Drawn, viewer: ViewerProcess) -> None:
        """Tells the viewer what has changed in the store.

        Where the robot or an obstacle is another one by now, the viewer ends: the next look begins one anew.
        """
        try:
            cell, shown = await asyncio.to_thread(self._read_standing, drawn.cell.name)
            same = _select_static(cell) == _select_static(drawn.cell)
        except (HeftError, SQLAlchemyError):  # what was drawn stays until the cell can be read again
            return
        if not same:
            viewer.close()
            return
        if cell.zones != drawn.cell.zones:
            viewer.tell(ZonesUpdate(cell))
        drawn.cell = cell
        if shown is not None and shown.run != drawn.run and cell.name not in self._conductor.active:
            viewer.tell(PlanUpdate(None, shown.payload_box, shown.start_rad))
            drawn.run, drawn.plan = shown.run, None
        named = None if shown is None else shown.in_the_way
        if named != drawn.in_the_way:
            viewer.tell(InTheWayUpdate(named))
            drawn.in_the_way = named


def _tell_active(active: ActiveRun, drawn: Drawn, viewer: ViewerProcess) -> None:
    """Tells the viewer of a run's plan, also that there is none yet, and where its robot is."""
    if active.id != drawn.run or active.plan is not drawn.plan:
        paths = [] if active.plan is None else active.plan.paths
        start = tuple(paths[0].q_rad[0]) if paths else _find_start(active.row, drawn.cell)
        viewer.tell(PlanUpdate(active.plan, active.payload_box, start))
        drawn.run, drawn.plan = active.id, active.plan
    if active.newest is not None and active.newest.batch is not drawn.batch:
        drawn.batch = active.newest.batch
        viewer.tell(RobotUpdate(drawn.batch))


def _select_shown(row: RunRow, cell: Cell) -> RunShown:
    order = RunOrder.model_validate_json(row.order)
    payload = cell.payloads.get(order.payload or "")
    box = order.payload_box or (cell.payload_box if payload is None else payload.box)
    return RunShown(row.id, row.in_the_way, box, _find_start(row, cell))


def _find_start(row: RunRow, cell: Cell) -> tuple[float, ...] | None:
    if row.released or run_ledger.motion_of(row) is not None:
        return None
    return RunOrder.model_validate_json(row.order).start_rad or tuple(cell.robot.home_rad)


def _select_static(cell: Cell) -> tuple[object, ...]:
    """What a viewer draws once: all but the zones."""
    return cell.model_copy(update={"zones": ()}), cell.urdf


GalleryDep = Annotated[Gallery, depend_on("gallery")]
