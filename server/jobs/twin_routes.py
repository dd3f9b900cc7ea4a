"""The twins of the cells: what has been added to their simulation, taken from diagnoses."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter
from pydantic import Field

from core.gap.addition import add_found
from core.gap.answer import Diagnosis
from core.twin.file import serialise_twin
from server.cells.folder import CellsDep
from server.cells.twin_answer import TwinPublic, answer_twin
from server.http.dependencies import NowDep, StoreDep
from server.http.errors import Conflict, NotFound
from server.http.parameters import CellPath, EffectPath
from server.http.schemas import RequestBody
from server.jobs import jobs
from server.jobs.kinds import DIAGNOSIS, sha256_of
from server.people import audit
from server.people.auth import CallerDep

router = APIRouter(prefix="/api/cells/{cell}/twin", tags=["cells"])


class TwinEffectCreate(RequestBody):
    """An effect that a diagnosis names, or two or three joined by plus signs."""

    diagnosis: str = Field(description="Identifier of the diagnosis that found it.", examples=["019ab1c2e0a17d34a06c11"])
    effect: Annotated[str, Field(pattern=r"^[a-z_]{1,64}(\+[a-z_]{1,64})?$")] = Field(
        description="An effect that the diagnosis names, or two or three joined by plus signs.", examples=["time_delay"]
    )


@router.get("")
def read_twin(cell: CellPath, cells: CellsDep) -> TwinPublic:
    """The effects that simulated runs, identification and diagnosis of the cell count with."""
    return answer_twin(cells.read_twin(cells.read(cell).cell))


@router.post("")
def add_effect(cell: CellPath, body: TwinEffectCreate, store: StoreDep, cells: CellsDep, caller: CallerDep, now: NowDep) -> TwinPublic:
    """Adds an effect to the cell's twin as a diagnosis found it; refused where the twin has changed otherwise since that diagnosis."""
    loaded = cells.load(cell)
    with store.write() as db:  # one at a time: each adds to what the one before has left
        diagnosed = jobs.load_job(db, DIAGNOSIS, body.diagnosis)
        if diagnosed.result is None:
            raise Conflict("jobs-no-effect-yet", job=diagnosed.id, state=diagnosed.state)
        twin = add_found(cells.read_twin(loaded), loaded, Diagnosis.model_validate_json(diagnosed.result), body.effect, now)
        said: audit.Detail = {"cell": cell, "effect": body.effect, "diagnosis": body.diagnosis, "sha256": sha256_of(serialise_twin(twin))}
        audit.record(db, caller.who, "twin.add", said, now=now)
        cells.put_twin(loaded, twin)  # last in the transaction: a store that refuses it leaves the twin as it was
    return answer_twin(twin)


@router.delete("/{effect}")
def remove_effect(cell: CellPath, effect: EffectPath, store: StoreDep, cells: CellsDep, caller: CallerDep, now: NowDep) -> TwinPublic:
    """Takes an effect out of the cell's twin."""
    loaded = cells.load(cell)
    with store.write() as db:
        before = cells.read_twin(loaded)
        if effect not in before.ids:
            raise NotFound("jobs-effect-not-in-twin", effect=effect)
        twin = before.without(effect)
        audit.record(db, caller.who, "twin.remove", {"cell": cell, "effect": effect, "sha256": sha256_of(serialise_twin(twin))}, now=now)
        cells.put_twin(loaded, twin)
    return answer_twin(twin)
