"""The payloads that a cell knows, as they are answered: of cell.toml and of the tool library, each with what runs have found of it."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import datetime
from typing import Annotated

import numpy as np
from pydantic import Field, StringConstraints
from sqlalchemy import func, select
from sqlalchemy.orm import Session

from core.cell.cell import Cell, Payload
from core.estimation.result import Result
from core.estimation.result_part import Numbers
from core.payload.inertia import is_consistent
from core.payload.shapes import Box, Positive
from core.words.message import Message
from server.cells.payloads import PayloadReference, SavedPayload, find_flaw, list_saved, read_box, read_reference
from server.http.errors import Conflict
from server.http.schemas import Answer, Name, RequestBody
from server.runs import ledger as run_ledger
from server.runs.schemas import RunOrder
from server.runs.tables import RunRow

PayloadTitle = Annotated[str, StringConstraints(pattern=r"^[^\x00-\x1f\x7f]*\S[^\x00-\x1f\x7f]*$", max_length=200)]
Note = Annotated[str, Field(max_length=1000)]

ALWAYS = ("name", "title", "box")
"""What every saved payload has."""

TITLE, NOTE = "What people call it: one line of text.", "What somebody should know who mounts or carries it."
LEAST, MOST = (
    "It should weigh at least this, kg; null where nobody has said.",
    "It should weigh at most this, kg; null where nobody has said.",
)


class SavedPayloadCreate(RequestBody):
    """A payload for the tool library of a cell."""

    name: Name = Field(description="Name that orders give it; nothing else in the cell may have it.", examples=["gripper_shaft"])
    title: PayloadTitle = Field(description=TITLE, examples=["Gripper with shaft"])
    box: Box | None = Field(default=None, description="What certainly contains it, sensor frame; that of `run` where null.")
    note: Note | None = Field(default=None, description=NOTE, examples=["Jaws closed"])
    mass_least_kg: Positive | None = Field(default=None, description=LEAST, examples=[2.6])
    mass_most_kg: Positive | None = Field(default=None, description=MOST, examples=[3.0])
    reference: PayloadReference | None = Field(default=None, description="What is known of it; null where nobody knows, or `run` says.")
    run: str | None = Field(
        default=None,
        description="A run of this cell with a result: its box, and what it found where all ten parameters are determined, are taken where "
        "`box` and `reference` say nothing.",
        examples=["019ab1c2d3e44f1c2a9be7"],
    )


class SavedPayloadUpdate(RequestBody):
    """What changes of a saved payload: what is absent stays; null takes it away, but for name, title and box, which stay then too."""

    name: Name | None = Field(default=None, description="Name that orders give it; runs keep the one of then.", examples=["gripper_shaft"])
    title: PayloadTitle | None = Field(default=None, description=TITLE, examples=["Gripper with shaft"])
    box: Box | None = Field(default=None, description="What certainly contains it, sensor frame.")
    note: Note | None = Field(default=None, description=NOTE, examples=["Jaws closed"])
    mass_least_kg: Positive | None = Field(default=None, description=LEAST, examples=[2.6])
    mass_most_kg: Positive | None = Field(default=None, description=MOST, examples=[3.0])
    reference: PayloadReference | None = Field(default=None, description="What is known of it; null where nobody knows.")

    def list_changes(self) -> list[str]:
        """Names of the fields that change, sorted."""
        return sorted(name for name in self.model_fields_set if name not in ALWAYS or getattr(self, name) is not None)


class AcceptedPublic(Answer):
    """What the last accepted run found of a payload, without the tools that the cell knows; null is what it did not determine."""

    run: str = Field(description="Identifier of the run.", examples=["019ab1c2d3e44f1c2a9be7"])
    ended_at: datetime | None = Field(description="When it ended.", examples=["2026-03-01T08:00:24Z"])
    accepted_by: str = Field(description="Who took the result for good.", examples=["account:anna"])
    accepted_at: datetime = Field(description="When it was taken for good.", examples=["2026-03-01T08:03:00Z"])
    mass_kg: float | None = Field(description="Mass, kg.", examples=[2.783])
    mass_std_kg: float | None = Field(description="Its standard uncertainty, kg.", examples=[0.002])
    com_m: Numbers = Field(description="Centre of mass, m, sensor frame.", examples=[[0.0, -0.0168, 0.0365]])
    com_std_m: Numbers = Field(description="Its standard uncertainties, m.", examples=[[0.0001, 0.0001, 0.0001]])


class PayloadPublic(Answer):
    """A payload that a cell knows; what has no `id` stands in its `cell.toml` and is changed there."""

    cell: str = Field(description="Name of the cell.", examples=["lwr4_bench"])
    name: str = Field(description="Name that orders give it.", examples=["gripper_shaft"])
    id: str | None = Field(
        description="Identifier in the tool library, which stays when it is renamed; null where it is one of `cell.toml`.",
        examples=["019ab1c2d3e44f1c2a9be7"],
    )
    title: str = Field(description="What people call it.", examples=["Gripper with shaft"])
    note: str | None = Field(description=NOTE, examples=["Jaws closed"])
    box: Box = Field(description="What certainly contains it, sensor frame.")
    mass_least_kg: float | None = Field(description=LEAST, examples=[2.6])
    mass_most_kg: float | None = Field(description=MOST, examples=[3.0])
    reference: PayloadReference | None = Field(description="What is known of it; null where nobody knows.")
    saved_by: str | None = Field(description="Who saved it; null where it is one of `cell.toml`.", examples=["account:anna"])
    saved_at: datetime | None = Field(
        description="When it was saved; null where it is one of `cell.toml`.", examples=["2026-03-01T08:00:00Z"]
    )
    changed_by: str | None = Field(description="Who changed it last; null where nobody has.", examples=["account:ben"])
    changed_at: datetime | None = Field(description="When it was changed last; null where nobody has.", examples=["2026-03-02T08:00:00Z"])
    runs: int = Field(description="How many runs carried it.", examples=[12])
    last_accepted: AcceptedPublic | None = Field(description="What the last accepted run found; null where there is none.")
    flaw: Message | None = Field(description="Why it cannot be used in the cell as that is now; null where it can.")


Key = tuple[str | None, str | None]
"""Identifier of a saved payload, else the name of one of cell.toml."""


def list_payloads(db: Session, cell: Cell) -> list[PayloadPublic]:
    """All that a cell knows, by title."""
    counts, accepted = _count_runs(db, cell.name), _find_accepted(db, cell.name)
    found = [_of_file(cell, name, payload, counts, accepted) for name, payload in cell.payloads.items()]
    found += [_of_library(row, cell, counts, accepted) for row in list_saved(db, cell.name)]
    return sorted(found, key=lambda each: each.title.lower())


def answer_saved(db: Session, row: SavedPayload, cell: Cell) -> PayloadPublic:
    """One of the library."""
    return _of_library(row, cell, _count_runs(db, cell.name), _find_accepted(db, cell.name))


def take_from_run(db: Session, cell: Cell, run: str) -> tuple[Box | None, PayloadReference | None]:
    """Of a run the payload's box and what was found of it; None where the cell no longer knows that, or not all is determined.

    Raises:
        NotFound: there is no such run.
        Conflict: it has no result, or is one of another cell.
    """
    row = run_ledger.load_run(db, run)
    if row.cell != cell.name:
        raise Conflict("library-run-of-other-cell", run=run, cell=cell.name)
    result, of_file = run_ledger.load_result(row), cell.payloads.get(row.payload or "")
    box = RunOrder.model_validate_json(row.order).payload_box or (None if of_file is None else of_file.box)
    return box, _reference_of(result, run)


def _reference_of(result: Result, run: str) -> PayloadReference | None:
    """What was found of the payload alone, where a rigid body can be so."""
    found = result.workpiece or result.estimate
    phi = [] if found is None else [value for value in found.phi if value is not None]
    if len(phi) < len(found.phi if found else ()) or not phi or not is_consistent(np.array(phi)):
        return None
    mass, x, y, z, xx, xy, xz, yy, yz, zz = phi
    return PayloadReference(mass_kg=mass, first_moment_kg_m=(x, y, z), inertia_kg_m2=(xx, xy, xz, yy, yz, zz), source=f"Heft, run {run}")


def _count_runs(db: Session, cell: str) -> dict[Key, int]:
    query = select(RunRow.saved_payload, RunRow.payload, func.count()).where(RunRow.cell == cell)
    counts: dict[Key, int] = {}
    for saved, name, count in db.execute(query.group_by(RunRow.saved_payload, RunRow.payload)):
        counts[_key(saved, name)] = counts.get(_key(saved, name), 0) + count
    return counts


def _find_accepted(db: Session, cell: str) -> dict[Key, AcceptedPublic]:
    """Of each payload the last run whose result was accepted."""
    newest = select(func.max(RunRow.id)).where(RunRow.cell == cell, RunRow.accepted_by.is_not(None))
    rows = db.scalars(select(RunRow).where(RunRow.id.in_(newest.group_by(RunRow.saved_payload, RunRow.payload))).order_by(RunRow.id))
    return {_key(row.saved_payload, row.payload): found for row in rows for found in _read_accepted(row)}


def _key(saved: str | None, name: str | None) -> Key:
    return (saved, None) if saved is not None else (None, name)


def _read_accepted(row: RunRow) -> Iterator[AcceptedPublic]:
    if row.accepted_by is None or row.accepted_at is None or row.result is None:
        return
    result = Result.model_validate_json(row.result)
    found = result.workpiece or result.estimate
    yield AcceptedPublic(
        run=row.id,
        ended_at=row.ended_at,
        accepted_by=row.accepted_by,
        accepted_at=row.accepted_at,
        mass_kg=None if found is None else found.phi[0],
        mass_std_kg=None if found is None else found.std[0],
        com_m=[None] * 3 if found is None else found.com_m,
        com_std_m=[None] * 3 if found is None else found.com_std_m,
    )


def _of_file(cell: Cell, name: str, payload: Payload, counts: dict[Key, int], accepted: dict[Key, AcceptedPublic]) -> PayloadPublic:
    reference = PayloadReference.model_validate(payload.model_dump(include=set(PayloadReference.model_fields)))
    return PayloadPublic(
        cell=cell.name, name=name, id=None, title=payload.title, note=None, box=payload.box, mass_least_kg=None, mass_most_kg=None,
        reference=reference, saved_by=None, saved_at=None, changed_by=None, changed_at=None,
        runs=counts.get((None, name), 0), last_accepted=accepted.get((None, name)), flaw=None,
    )  # fmt: skip


def _of_library(row: SavedPayload, cell: Cell, counts: dict[Key, int], accepted: dict[Key, AcceptedPublic]) -> PayloadPublic:
    return PayloadPublic(
        cell=row.cell, name=row.name, id=row.id, title=row.title, note=row.note, box=read_box(row),
        mass_least_kg=row.mass_least_kg, mass_most_kg=row.mass_most_kg, reference=read_reference(row),
        saved_by=row.saved_by, saved_at=row.saved_at, changed_by=row.changed_by, changed_at=row.changed_at,
        runs=counts.get((row.id, None), 0), last_accepted=accepted.get((row.id, None)), flaw=find_flaw(row, cell),
    )  # fmt: skip
