"""One viewer for one cell, in a process of its own: what it draws costs neither the service nor the robot any time."""

from __future__ import annotations

import asyncio
import os
import signal
import time
from dataclasses import dataclass
from multiprocessing.connection import Connection

import numpy as np

from core.cell.cell import Box, Cell
from server.runner.context import CONTEXT
from server.runner.live_schemas import LiveBatch
from server.runner.pipe import Speaker
from server.runner.plan_schemas import RunPlan
from server.runner.priority import Priority, take
from server.viewer.wish import Look, Wish


@dataclass(frozen=True)
class RobotUpdate:
    """The robot is here now, and feels this."""

    batch: LiveBatch


@dataclass(frozen=True)
class ZonesUpdate:
    """The zones of this cell are what they are now."""

    cell: Cell


@dataclass(frozen=True)
class PlanUpdate:
    """What is to be looked at before a run: its plan, or None while there is none, its payload box, and where its robot stands.

    Args:
        start_rad: None where the robot stays where it is drawn.
    """

    plan: RunPlan | None
    payload_box: Box
    start_rad: tuple[float, ...] | None


@dataclass(frozen=True)
class InTheWayUpdate:
    """What is in the way of the cell's run: an obstacle, a zone or a link; None where nothing is."""

    name: str | None


@dataclass(frozen=True)
class ViewUpdate:
    """What one page wants to see in a way of its own; `look` turns its camera once."""

    view: str
    wish: Wish
    look: Look | None


Shown = RobotUpdate | ZonesUpdate | PlanUpdate | InTheWayUpdate | ViewUpdate
REFRESH_S = 0.5
"""How often it is asked what stands before a robot that moves."""


class ViewerProcess:
    """Belongs to the running event loop."""

    def __init__(self, cell: Cell) -> None:
        self._connection, theirs = CONTEXT.Pipe()
        self._process = CONTEXT.Process(target=_show, args=(cell, theirs), name=f"heft-viewer-{cell.name}", daemon=True)
        self._process.start()
        theirs.close()
        self._speaker: Speaker[Shown] = Speaker(self._connection, RobotUpdate)

    async def port(self) -> int:
        """Where it listens, on 127.0.0.1."""
        return int(await asyncio.to_thread(self._connection.recv))

    def tell(self, message: Shown) -> None:
        """Returns at once; of positions only the newest is drawn."""
        self._speaker.tell(message)

    @property
    def alive(self) -> bool:
        """Whether it runs."""
        return self._process.is_alive()

    def close(self) -> None:
        """Ends it."""
        self._process.kill()
        self._process.join()
        self._connection.close()


def _show(cell: Cell, connection: Connection) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    take(Priority.VIEWER)
    from server.viewer.in_the_way import Mark  # noqa: PLC0415 - no other process needs viser
    from server.viewer.scene import ViewerScene, open_server  # noqa: PLC0415 - the same
    from server.viewer.views import Views  # noqa: PLC0415 - the same

    server = open_server()
    scene = ViewerScene(server, cell)
    mark, views = Mark(server, scene), Views(server, scene)
    connection.send(server.get_port())
    refreshed_s = time.monotonic()
    while True:
        try:
            shown: Shown = connection.recv()
        except (EOFError, OSError):
            os._exit(0)  # viser takes seconds to stop, and nobody looks any more
        match shown:
            case RobotUpdate(batch=batch):
                scene.move(np.array(batch.q_rad), batch.nearest)
                views.forget_plans()
                if time.monotonic() - refreshed_s < REFRESH_S:
                    continue
            case ZonesUpdate():
                scene.show_zones(shown.cell)
                mark.update_zones()
            case InTheWayUpdate(name=name):
                mark.show(name)
            case PlanUpdate():
                scene.show_payload_box(shown.payload_box)
                scene.show_plan(shown.plan)
                if shown.start_rad is not None:
                    scene.move(np.array(shown.start_rad), None)
            case ViewUpdate():
                views.update(shown.view, shown.wish, shown.look)
                continue
        views.refresh()
        refreshed_s = time.monotonic()
