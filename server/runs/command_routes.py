"""What moves a run: its plan is shown, released by an operator at the cell, and commanded."""

from __future__ import annotations

import asyncio
from enum import StrEnum

from fastapi import APIRouter
from pydantic import Field

from core.sessions.leased import Renewal
from server.http.dependencies import NowDep
from server.http.errors import Conflict
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
from server.runs.schemas import RunAnswer

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


class Sent(RequestBody):
    """What makes a command of whoever is in control count once and now.

    Args:
        fence: of their control; `number` counts their commands up; `stamp_s` is the newest stamp that the server sent them.
    """

    fence: int
    number: int = Field(ge=0)
    stamp_s: float


class CommandBody(RequestBody):
    """A command; `sent` may be left out of stop and abort."""

    command: RunCommand
    sent: Sent | None = None


class ReleaseBody(RequestBody):
    """What is released: exactly the plan that was shown."""

    plan_sha256: str
    offer: str
    sent: Sent


class PlanAnswer(Answer):
    """A plan that waits for its release.

    Args:
        offer: comes back with the release; good for `expires_s` seconds.
    """

    run: str
    plan: RunPlan
    offer: str
    expires_s: float


@router.get("/plan")
def read_plan(run: str, conductor: ConductorDep, offers: OffersDep) -> PlanAnswer:
    """What is going to happen: to be looked at before it is released."""
    row = conductor.row_of(run)
    if row.plan is None:
        raise Conflict("runs-no-plan", allowed=run_ledger.list_offered_commands(State(row.state)), run=run, state=row.state)
    plan = RunPlan.model_validate_json(row.plan)
    return PlanAnswer(run=run, plan=plan, offer=offers.make(run, plan.sha256), expires_s=offers.length_s)


@router.post("/release")
async def release_run(
    run: str, body: ReleaseBody, conductor: ConductorDep, control: ControlDep, releases: ReleasesDep, now: NowDep, caller: CallerDep
) -> RunAnswer:
    """An operator at the cell lets the shown plan begin; void (409) when anything has changed or the offer is older than 60 s."""
    await releases.release(run, caller.who, body.plan_sha256, body.offer, renewal(body.sent))
    return await asyncio.to_thread(answer_run, conductor, control, now, run)


@router.post("/commands")
async def command_run(
    run: str, body: CommandBody, conductor: ConductorDep, control: ControlDep, caller: CallerDep, now: NowDep
) -> RunAnswer:
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


def renewal(sent: Sent) -> Renewal:
    """What the control of a cell checks."""
    return Renewal(sent.fence, sent.number, sent.stamp_s)
