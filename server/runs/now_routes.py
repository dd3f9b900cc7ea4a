"""What every robot does at this moment, and how to stop it: for whoever is in front of it, signed in or not.

Nothing here waits for the database. To stop a robot nobody has to be somebody; who did it is recorded as far as it is known.
"""

from __future__ import annotations

from datetime import datetime
from typing import Literal

from fastapi import APIRouter
from pydantic import Field

from server.http.dependencies import ClientAddressDep, NowDep
from server.http.errors import Conflict
from server.http.parameters import CellPath
from server.http.schemas import Answer
from server.people import audit
from server.runs.conductor import Conductor, ConductorDep
from server.runs.packml import MOVING, Command, State
from server.runs.reason import explain_stop_of_nobody

router = APIRouter(prefix="/api/now", tags=["now"])

COMES_TO_REST = frozenset({State.HELD, State.SUSPENDED})
"""The robot is not commanded in these states, although its run may go on."""


class CellNow(Answer):
    """A cell as it is now."""

    cell: str = Field(description="Name of the cell.", examples=["lwr4_bench"])
    run: str | None = Field(description="The run that has the cell; null where none does.", examples=["019ab1c2d3e44f1c2a9be7"])
    state: State | None = Field(description="State of the machine (PackML); null without a run.")
    moving: bool = Field(description="Whether the robot may move at this moment.")
    since: datetime | None = Field(description="When the run went into its state.", examples=["2026-03-01T08:00:00.120Z"])
    reason_kind: str | None = Field(
        description="Kind of why it stands, see docs/runs.md; null where it does not.", examples=["network-late"]
    )
    safety_rated: Literal[False] = Field(default=False, description="Always false: it is not a safety function.")


@router.get("")
async def read_now(conductor: ConductorDep) -> list[CellNow]:
    """Every cell with a robot that a run has; told from memory."""
    return [cell_now(conductor, name) for name in sorted(conductor.active)]


@router.post("/{cell}/stop")
async def stop_now(cell: CellPath, conductor: ConductorDep, address: ClientAddressDep, now: NowDep) -> CellNow:
    """Stops the cell's robot. Anybody may, and it is recorded from where. It is no emergency stop."""
    active = conductor.active.get(cell)
    if active is None:
        raise Conflict("runs-nothing-to-stop", cell=cell)
    done = audit.make_deed(f"nobody@{address}", "run.stop", {"run": active.id, "address": address}, now=now)
    await conductor.command(active.id, Command.STOP, explain_stop_of_nobody(address), done)
    return cell_now(conductor, cell)


def cell_now(conductor: Conductor, name: str) -> CellNow:
    """What the cell's robot does."""
    active = conductor.active.get(name)
    if active is None:
        return CellNow(cell=name, run=None, state=None, moving=False, since=None, reason_kind=None)
    moving = active.state in MOVING - COMES_TO_REST
    return CellNow(cell=name, run=active.id, state=active.state, moving=moving, since=active.changed_at, reason_kind=active.row.reason_kind)
