"""What moves a run: its plan is shown, released by an operator at the cell, and commanded."""

from __future__ import annotations

import asyncio
from enum import StrEnum

from fastapi import APIRouter
from pydantic import Field

from core.sessions.leased import Renewal
from server.http.dependencies import NowDep
from server.http.errors import Conflict
from server.http.parameters import RunPath
from server.http.schemas import Answer, RequestBody
from server.people import audit
from server.people.auth import CallerDep
from server.runner.plan_schemas import RunPlan
from server.runs import ledger as run_ledger
from server.runs.answer import answer_run
from server.runs.conductor import ConductorDep
from server.runs.lease import ControlDep
from server.runs.packml import State
from server.runs.reason import explain_command
from server.runs.releases import OffersDep, ReleasesDep
from server.runs.schemas import RunPublic

router = APIRouter(prefix="/api/runs/{run}", tags=["runs"])


class RunCommand(StrEnum):
    """What may be asked of a run."""

    hold = "hold"
    resume = "resume"
    stop = "stop"
    abort = "abort"
    clear = "clear"


COMMANDS = {name: command for command, name in run_ledger.OFFERED.items()}
WITHOUT_CONTROL = frozenset({RunCommand.stop, RunCommand.abort})
"""Who sees that the robot has to stop need not be in control of it."""


class FencingToken(RequestBody):
    """What makes a command of whoever is in control count once and now."""

    fence: int = Field(description="Of the control that was taken, as `POST /api/control` answered it.", examples=[17])
    number: int = Field(ge=0, description="Counts the commands of this control up; one that came already counts for nothing.", examples=[4])
    stamp_s: float = Field(
        description="The newest stamp that the service has sent over `/api/control/{cell}/lease`, s by its clock.", examples=[81234.56]
    )


class CommandCreate(RequestBody):
    """A command; `sent` may be left out of stop and abort."""

    command: RunCommand = Field(description="What is to happen.")
    sent: FencingToken | None = Field(
        default=None, description="Shows that it comes from whoever is in control, once and now; may be left out of stop and abort."
    )


class ReleaseCreate(RequestBody):
    """What is released: exactly the plan that was shown."""

    plan_sha256: str = Field(
        description="`plan.sha256` of the plan that was shown.",
        examples=["9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"],
    )
    offer: str = Field(description="The `offer` that came with the plan.", examples=["81234.560.5f0c"])
    sent: FencingToken = Field(description="Shows that it comes from whoever is in control, once and now.")


class PlanPublic(Answer):
    """A plan that waits for its release."""

    run: str = Field(description="Identifier of the run.", examples=["019ab1c2d3e44f1c2a9be7"])
    plan: RunPlan = Field(description="What is going to happen.")
    offer: str = Field(description="Comes back with the release.", examples=["81234.560.5f0c"])
    expires_s: float = Field(description="How long the offer is good, s.", examples=[60.0])


@router.get("/plan")
def read_plan(run: RunPath, conductor: ConductorDep, offers: OffersDep) -> PlanPublic:
    """What is going to happen: to be looked at before it is released."""
    row = conductor.row_of(run)
    if row.plan is None:
        raise Conflict("runs-no-plan", allowed=run_ledger.list_offered_commands(State(row.state)), run=run, state=row.state)
    plan = RunPlan.model_validate_json(row.plan)
    return PlanPublic(run=run, plan=plan, offer=offers.make(run, plan.sha256), expires_s=offers.length_s)


@router.post("/release")
async def release_run(
    run: RunPath, body: ReleaseCreate, conductor: ConductorDep, control: ControlDep, releases: ReleasesDep, now: NowDep, caller: CallerDep
) -> RunPublic:
    """An operator at the cell lets the shown plan begin; void (409) when anything has changed or the offer is older than 60 s."""
    await releases.release(run, caller.who, body.plan_sha256, body.offer, renewal(body.sent))
    return await asyncio.to_thread(answer_run, conductor, control, now, run)


@router.post("/commands")
async def command_run(
    run: RunPath, body: CommandCreate, conductor: ConductorDep, control: ControlDep, caller: CallerDep, now: NowDep
) -> RunPublic:
    """Holds, resumes, stops, aborts or clears. All but stop and abort need control of the cell."""
    cell = (await asyncio.to_thread(conductor.row_of, run)).cell
    if body.command not in WITHOUT_CONTROL:
        if body.sent is None:
            raise Conflict("runs-command-without-control", command=body.command.value, cell=cell)
        control.command(cell, caller.who, renewal(body.sent))
    await conductor.command(
        run,
        COMMANDS[body.command],
        explain_command(body.command, caller.who),
        audit.make_deed(caller.who, f"run.{body.command}", {"run": run}, now=now),
    )
    return await asyncio.to_thread(answer_run, conductor, control, now, run)


def renewal(sent: FencingToken) -> Renewal:
    """What the control of a cell checks."""
    return Renewal(sent.fence, sent.number, sent.stamp_s)
