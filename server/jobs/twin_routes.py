"""The twins of the cells: what has been added to their simulation, taken from diagnoses."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Response
from pydantic import Field
from sqlalchemy import select
from sqlalchemy.orm import Session
from starlette.status import HTTP_202_ACCEPTED

from core.cell.cell import Cell
from core.gap.answer import Diagnosis
from server.cells.folder import CellsDep
from server.cells.twin_answer import TwinAnswer, twin_of
from server.http.dependencies import NamePath, NowDep, StoreDep, set_accepted_headers
from server.http.errors import Conflict, NotFound, Unprocessable
from server.http.schemas import RequestBody
from server.jobs import jobs
from server.jobs.answer import JobAnswer
from server.jobs.jobs import UNDER_WAY, AdditionsDep, Worker
from server.jobs.kinds import ADDITION, DIAGNOSIS, AdditionOrder, DiagnosisOrder, sha256_of
from server.people import audit
from server.people.auth import CallerDep
from server.runner.messages import Answered, Failed
from server.runner.work import run_work
from server.runs.tables import JobRow

router = APIRouter(prefix="/api/cells/{cell}/twin", tags=["cells"])

TYPICAL_S = 30


class AdditionBody(RequestBody):
    """An effect that a diagnosis names, or two joined by a plus sign."""

    diagnosis: str
    effect: Annotated[str, Field(pattern=r"^[a-z_]{1,64}(\+[a-z_]{1,64})?$")]


class AdditionAnswer(JobAnswer):
    """An addition; `twin` is the cell's twin with the effect, null until it is done."""

    addition: str
    cell: str
    effect: str
    diagnosis: str
    twin: TwinAnswer | None


@router.get("")
def read_twin(cell: NamePath, cells: CellsDep) -> TwinAnswer:
    """The effects that simulated runs, identification and diagnosis of the cell count with."""
    return twin_of(cells.read(cell).cell)


@router.post("", status_code=HTTP_202_ACCEPTED)
def add_effect(
    cell: NamePath,
    body: AdditionBody,
    response: Response,
    store: StoreDep,
    cells: CellsDep,
    additions: AdditionsDep,
    caller: CallerDep,
    now: NowDep,
) -> AdditionAnswer:
    """Fits an effect anew to the recording of a diagnosis that names it, and adds it to the cell's twin."""
    cells.load(cell)
    with store.write() as db:
        diagnosed = jobs.load_job(db, DIAGNOSIS, body.diagnosis)
        _check_named(diagnosed, body.effect)
        recording = DiagnosisOrder.model_validate_json(diagnosed.order).recording
        order = AdditionOrder(cell=cell, effect=body.effect, diagnosis=body.diagnosis, recording=recording)
        row = jobs.add_job(db, ADDITION, order, cell, caller.who, now)
        audit.record(db, caller.who, "twin.queue", {"addition": row.id, "cell": cell, "effect": body.effect}, now=now)
        found = _answer(additions, row)
    additions.wake()
    set_accepted_headers(response, f"/api/cells/{cell}/twin/additions/{found.addition}", TYPICAL_S)
    return found


@router.get("/additions/{addition}")
def read_addition(cell: NamePath, addition: str, additions: AdditionsDep, store: StoreDep) -> AdditionAnswer:
    """How far an addition is, and why it was refused."""
    with store.read() as db:
        row = _load(db, cell, addition)
    return _answer(additions, row)


@router.delete("/additions/{addition}")
def cancel_addition(
    cell: NamePath, addition: str, store: StoreDep, additions: AdditionsDep, caller: CallerDep, now: NowDep
) -> AdditionAnswer:
    """Ends an addition that waits or runs; the twin stays as it is."""
    with store.write() as db:
        _load(db, cell, addition)
        row = jobs.cancel(db, ADDITION, addition, caller.who, now)
        audit.record(db, caller.who, "twin.cancel", {"addition": addition, "cell": cell}, now=now)
        found = _answer(additions, row)
    additions.drop(addition)
    return found


@router.delete("/{effect}")
def remove_effect(cell: NamePath, effect: NamePath, store: StoreDep, cells: CellsDep, caller: CallerDep, now: NowDep) -> TwinAnswer:
    """Takes an effect out of the cell's twin."""
    loaded = cells.load(cell)
    if effect not in [entry.effect for entry in twin_of(loaded).effects]:
        raise NotFound("jobs-effect-not-in-twin", effect=effect)
    with store.write() as db:
        _check_nothing_under_way(db, cell)
        left = _remove_from_twin(loaded, effect)
        audit.record(db, caller.who, "twin.remove", {"cell": cell, "effect": effect, "sha256": sha256_of(left)}, now=now)
        cells.put_twin(cell, left)  # last, as in `server.jobs.kinds`
    return TwinAnswer.model_validate_json(left)


def _load(db: Session, cell: str, addition: str) -> JobRow:
    row = jobs.load_job(db, ADDITION, addition)
    if row.about != cell:
        raise NotFound("jobs-unknown", kind=ADDITION, job=addition[:80])
    return row


def _remove_from_twin(cell: Cell, effect: str) -> str:
    """The twin that is left, as JSON, from a process that knows the effects."""
    for word in run_work("server.runner.twin_removing", cell, effect):
        match word:
            case Answered(text=text):
                return text
            case Failed(message=message):
                raise Unprocessable(message.code, **message.parameters)
    raise Unprocessable("jobs-twin-unchanged", cell=cell.name)


def _check_named(diagnosed: JobRow, effect: str) -> None:
    """The diagnosis is done, names the effect, and has found that a twin can take it."""
    if diagnosed.result is None:
        raise Conflict("jobs-no-effect-yet", job=diagnosed.id, state=diagnosed.state)
    found = Diagnosis.model_validate_json(diagnosed.result)
    named = {each.id: each for each in found.effects} | {"+".join(pair.ids): pair for pair in found.pairs}
    if not named:
        raise Unprocessable("jobs-no-effect-named", effect=effect)
    if effect not in named:
        raise Unprocessable("jobs-effect-not-named", effect=effect, effects=list(named))
    why_not = named[effect].why_not
    if not named[effect].addable and why_not is None:
        raise Unprocessable("jobs-effect-not-judged")
    if not named[effect].addable and why_not is not None:
        raise Unprocessable("jobs-effect-not-addable", why_not=why_not)


def _check_nothing_under_way(db: Session, cell: str) -> None:
    """An addition writes the twin that it began with."""
    query = select(JobRow.id).where(JobRow.kind == ADDITION, JobRow.about == cell, JobRow.state.in_(UNDER_WAY)).limit(1)
    addition = db.scalar(query)
    if addition is not None:
        raise Conflict("jobs-twin-busy", cell=cell, addition=addition)


def _answer(additions: Worker, row: JobRow) -> AdditionAnswer:
    order = AdditionOrder.model_validate_json(row.order)
    return AdditionAnswer.of(
        row,
        additions,
        addition=row.id,
        cell=order.cell,
        effect=order.effect,
        diagnosis=order.diagnosis,
        twin=None if row.result is None else TwinAnswer.model_validate_json(row.result),
    )
