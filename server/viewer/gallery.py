"""The viewers of all cells: each begun when somebody first looks, and fed with what its cell's run does."""

from __future__ import annotations

import asyncio
from typing import Annotated

from sqlalchemy.exc import SQLAlchemyError

from core.cell.cell import Cell
from core.errors import HeftError
from core.payload.shapes import Pose
from server.http.dependencies import depend_on
from server.runs import ledger as run_ledger
from server.runs.conductor import Conductor
from server.viewer.process import InTheWayUpdate, PlanUpdate, RobotUpdate, ViewerProcess, ZonesUpdate

PERIOD_S = 1.0 / 30.0
STORE_S = 0.5


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

    def _read_standing(self, name: str) -> tuple[Cell, str | None]:
        """The cell as it is now, and what its run has in its way."""
        with self._conductor.store.read() as db:
            return self._conductor.load_current_cell(db, name), run_ledger.find_in_the_way(db, name)

    async def _feed(self, cell: Cell, viewer: ViewerProcess) -> None:
        """Newest positions 30 times a second, plans, zones and what is in the way when they change."""
        await asyncio.shield(self._ports[cell.name])
        plan = batch = in_the_way = None
        ticks = 0
        while viewer.alive:
            active = self._conductor.active.get(cell.name)
            if active is not None and active.plan is not None and active.plan is not plan:
                plan = active.plan
                viewer.tell(PlanUpdate(plan, active.payload_box))
            if active is not None and active.newest is not None and active.newest.batch is not batch:
                batch = active.newest.batch
                viewer.tell(RobotUpdate(batch))
            ticks += 1
            if ticks * PERIOD_S >= STORE_S:
                ticks = 0
                cell, in_the_way = await self._tell_changes(cell, in_the_way, viewer)
            await asyncio.sleep(PERIOD_S)

    async def _tell_changes(self, cell: Cell, in_the_way: str | None, viewer: ViewerProcess) -> tuple[Cell, str | None]:
        """Tells the viewer what has changed; returns how it stands.

        Where the robot or an obstacle is another one by now, the viewer ends: the next look begins one anew.
        """
        try:
            now, named = await asyncio.to_thread(self._read_standing, cell.name)
            same = _select_static(now) == _select_static(cell)
        except (HeftError, SQLAlchemyError):  # what was drawn stays until the cell can be read again
            return cell, in_the_way
        if not same:
            viewer.close()
            return now, named
        if now.zones != cell.zones:
            viewer.tell(ZonesUpdate(now))
        if named != in_the_way:
            viewer.tell(InTheWayUpdate(named))
        return now, named


def _select_static(cell: Cell) -> tuple[object, ...]:
    """What a viewer draws once: all but where the zones are."""
    return (
        cell.model_copy(update={"zones": ()}),
        cell.urdf,
        [(zone.name, zone.shape.model_copy(update={"pose": Pose()})) for zone in cell.zones],
    )


GalleryDep = Annotated[Gallery, depend_on("gallery")]
