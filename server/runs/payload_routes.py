"""The payloads that a cell knows, those that people save for it, and what runs have found of each."""

from __future__ import annotations

from collections.abc import Iterable

from fastapi import APIRouter, Response
from pydantic import BaseModel
from sqlalchemy.orm import Session

from core.cell.cell import Cell
from server.cells.folder import CellsDep
from server.cells.now import read_now
from server.cells.payloads import SavedPayload, check_library_room, check_name_free, check_saved, load_saved
from server.http.dependencies import NowDep, StoreDep
from server.http.errors import Unprocessable
from server.http.parameters import CellPath, SavedPath
from server.people import audit
from server.people.auth import CallerDep
from server.runs.ledger import new_id
from server.runs.payload_library import PayloadPublic, SavedPayloadCreate, SavedPayloadUpdate, answer_saved, list_payloads, take_from_run

router = APIRouter(prefix="/api/cells/{cell}/payloads", tags=["payloads"])


@router.get("", name="list_payloads")
def list_known_payloads(cell: CellPath, cells: CellsDep, store: StoreDep) -> list[PayloadPublic]:
    """All payloads that may be ordered in a cell, by title: those of its `cell.toml` and those of its tool library."""
    loaded = cells.read(cell).cell
    with store.read() as db:
        return list_payloads(db, loaded)


@router.get("/{saved}")
def read_payload(cell: CellPath, saved: SavedPath, cells: CellsDep, store: StoreDep) -> PayloadPublic:
    """A payload of the tool library."""
    loaded = cells.read(cell).cell
    with store.read() as db:
        return answer_saved(db, load_saved(db, cell, saved), loaded)


@router.post("", status_code=201)
def save_payload(
    cell: CellPath, body: SavedPayloadCreate, response: Response, caller: CallerDep, cells: CellsDep, store: StoreDep, now: NowDep
) -> PayloadPublic:
    """Saves a payload in the tool library of a cell."""
    loaded = cells.read(cell).cell
    with store.write() as db:
        check_name_free(db, read_now(cells, db, cell).cell, body.name)
        check_library_room(db, cell)
        row = SavedPayload(id=new_id(now), cell=cell, saved_by=caller.who, saved_at=now)
        _fill(row, _complete(db, loaded, body), SavedPayloadUpdate.model_fields)
        check_saved(row, loaded)
        db.add(row)
        db.flush()
        audit.record(db, caller.who, "payload.save", {"cell": cell, "saved": row.id, "name": row.name, "run": body.run}, now=now)
        answer = answer_saved(db, row, loaded)
    response.headers["Location"] = f"/api/cells/{cell}/payloads/{row.id}"
    return answer


@router.patch("/{saved}")
def change_payload(
    cell: CellPath, saved: SavedPath, body: SavedPayloadUpdate, caller: CallerDep, cells: CellsDep, store: StoreDep, now: NowDep
) -> PayloadPublic:
    """Renames or changes a payload of the tool library; runs that were asked for before keep what they were asked for with."""
    loaded = cells.read(cell).cell
    changed = body.list_changes()
    with store.write() as db:
        row = load_saved(db, cell, saved)
        if body.name is not None:
            check_name_free(db, read_now(cells, db, cell).cell, body.name, but=saved)
        _fill(row, body, changed)
        check_saved(row, loaded)
        row.changed_by, row.changed_at = caller.who, now
        said = {"cell": cell, "saved": saved, "name": row.name, "changed": ", ".join(changed)}
        audit.record(db, caller.who, "payload.change", said, now=now)
        return answer_saved(db, row, loaded)


@router.delete("/{saved}", status_code=204)
def delete_payload(cell: CellPath, saved: SavedPath, caller: CallerDep, cells: CellsDep, store: StoreDep, now: NowDep) -> None:
    """Takes a payload out of the tool library; its runs and their results stay."""
    cells.check_known(cell)
    with store.write() as db:
        row = load_saved(db, cell, saved)
        db.delete(row)
        audit.record(db, caller.who, "payload.delete", {"cell": cell, "saved": saved, "name": row.name}, now=now)


def _complete(db: Session, cell: Cell, body: SavedPayloadCreate) -> SavedPayloadCreate:
    """With what its run says where the body itself says nothing.

    Raises:
        Unprocessable: neither says what contains it.
    """
    box, reference = body.box, body.reference
    if body.run is not None:
        of_run, found = take_from_run(db, cell, body.run)
        box, reference = box or of_run, reference or found
    if box is None:
        raise Unprocessable("library-without-box", name=body.name)
    return body.model_copy(update={"box": box, "reference": reference})


def _fill(row: SavedPayload, body: BaseModel, names: Iterable[str]) -> None:
    """Takes values of a body over, those with parts of their own as JSON."""
    for name in names:
        value = getattr(body, name)
        setattr(row, name, value.model_dump_json() if isinstance(value, BaseModel) else value)
