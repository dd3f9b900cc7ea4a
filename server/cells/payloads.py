"""The tool library: payloads that people have saved for a cell, beside those of its cell.toml.

Each cell has its own: box and values are in the frame of its sensor, and its names are those of one cell, as for zones and obstacles.
"""

from __future__ import annotations

from collections.abc import Iterator
from datetime import datetime
from typing import Annotated

import numpy as np
from pydantic import Field
from sqlalchemy import String, Text, UniqueConstraint, func, select
from sqlalchemy.orm import Mapped, Session, mapped_column

from core.cell.cell import Cell, Payload
from core.cell.contradictions import box_contradictions, load_contradictions, mass_contradictions, payload_contradictions
from core.errors import BadCell, BadPayload, refuse
from core.payload.inertia import InertialParameters
from core.payload.shapes import Box, Positive, Six, Vector3
from core.words.message import Message
from server.http.errors import Conflict, NotFound
from server.http.flaws import restore_flaw
from server.http.schemas import RequestBody
from server.store.store import Table

MOST = 500
"""Payloads that a cell's library holds: more nobody finds anything in."""


class PayloadReference(RequestBody):
    """What is known of a payload: results are compared with it, and the simulated robot carries it."""

    mass_kg: Positive = Field(description="Mass, kg.", examples=[2.783])
    first_moment_kg_m: Vector3 = Field(description="Mass times centre of mass, kg m, sensor frame.", examples=[[0.0, -0.0468, 0.1015]])
    inertia_kg_m2: Six = Field(
        description="Ixx Ixy Ixz Iyy Iyz Izz about the sensor's origin, kg m2.", examples=[[0.0069, 0.0, 0.0, 0.0066, 0.0017, 0.0033]]
    )
    source: Annotated[str, Field(min_length=1, max_length=200)] = Field(description="Where the numbers are from.", examples=["CAD"])


class SavedPayload(Table):
    """A payload that somebody saved. `box` and `reference` are JSON (`core.payload.shapes.Box`, `PayloadReference`)."""

    __tablename__ = "saved_payloads"
    __table_args__ = (UniqueConstraint("cell", "name"),)

    id: Mapped[str] = mapped_column(String(32), primary_key=True)
    """Stays when it is renamed; sorts by the time of its making."""
    cell: Mapped[str] = mapped_column(String(64), index=True)
    name: Mapped[str] = mapped_column(String(64))
    title: Mapped[str] = mapped_column(String(200))
    note: Mapped[str | None] = mapped_column(Text)
    box: Mapped[str] = mapped_column(Text)
    mass_least_kg: Mapped[float | None]
    mass_most_kg: Mapped[float | None]
    reference: Mapped[str | None] = mapped_column(Text)
    """None where only box and perhaps the mass are known."""
    saved_by: Mapped[str] = mapped_column(String(80))
    saved_at: Mapped[datetime]
    changed_by: Mapped[str | None] = mapped_column(String(80))
    changed_at: Mapped[datetime | None]


def list_saved(db: Session, cell: str) -> list[SavedPayload]:
    """A cell's library, by title."""
    return list(db.scalars(select(SavedPayload).where(SavedPayload.cell == cell).order_by(func.lower(SavedPayload.title), SavedPayload.id)))


def load_saved(db: Session, cell: str, saved: str) -> SavedPayload:
    """One of a cell's library, by its identifier.

    Raises:
        NotFound: there is none.
    """
    row = db.get(SavedPayload, saved)
    if row is None or row.cell != cell:
        raise NotFound("library-unknown", cell=cell, saved=saved[:80])
    return row


def find_saved(db: Session, cell: str, name: str) -> SavedPayload | None:
    """One of a cell's library, by its name."""
    return db.scalar(select(SavedPayload).where(SavedPayload.cell == cell, SavedPayload.name == name))


def check_name_free(db: Session, cell: Cell, name: str, *, but: str | None = None) -> None:
    """Nothing in the cell has that name yet, letter case aside: no obstacle, zone, tool or payload of cell.toml, and no saved payload.

    Args:
        cell: with its zones as they are now.
        but: identifier of the saved payload that may have it, since it is the one that is changed.

    Raises:
        Conflict: something has.
    """
    for by, taken, owner in _list_names(db, cell):
        if taken.lower() == name.lower() and (owner is None or owner != but):
            raise Conflict("library-name-taken", cell=cell.name, name=name, by=by)


def _list_names(db: Session, cell: Cell) -> Iterator[tuple[str, str, str | None]]:
    """What has a name, the name, and the identifier of the saved payload that it is of."""
    yield from (("obstacle", each.name, None) for each in cell.obstacles)
    yield from (("zone", each.name, None) for each in cell.zones)
    yield from (("tool", name, None) for name in cell.tools)
    yield from (("payload", name, None) for name in cell.payloads)
    yield from (("saved", each.name, each.id) for each in list_saved(db, cell.name))


def check_library_room(db: Session, cell: str) -> None:
    """One more has room in the library.

    Raises:
        Conflict: it is full.
    """
    if len(list_saved(db, cell)) >= MOST:
        raise Conflict("library-full", cell=cell, most_saved=MOST)


def read_box(row: SavedPayload) -> Box:
    """What certainly contains it, sensor frame."""
    return Box.model_validate_json(row.box)


def read_reference(row: SavedPayload) -> PayloadReference | None:
    """What is known of it."""
    return None if row.reference is None else PayloadReference.model_validate_json(row.reference)


def read_known_payload(row: SavedPayload) -> Payload | None:
    """It as cell.toml would have it; None where its mass distribution is not known."""
    reference = read_reference(row)
    return None if reference is None else Payload(title=row.title, box=read_box(row), **reference.model_dump())


def find_expected_mass(row: SavedPayload) -> float | None:
    """About how heavy it is, kg; None where nobody has said."""
    reference = read_reference(row)
    if reference is not None:
        return reference.mass_kg
    known = [each for each in (row.mass_least_kg, row.mass_most_kg) if each is not None]
    return sum(known) / len(known) if known else None


def check_saved(row: SavedPayload, cell: Cell) -> None:
    """It can be carried in the cell as that is now.

    Raises:
        BadPayload: its box or what is known of it does not go with the cell, or with itself.
    """
    refuse([restore_flaw(BadPayload, flaw.message) for flaw in _list_flaws(row, cell)])


def find_flaw(row: SavedPayload, cell: Cell) -> Message | None:
    """Why it cannot be used in the cell as that is now; None where it can."""
    if row.name in cell.payloads:
        return Message.of("library-name-taken", cell=cell.name, name=row.name, by="payload")
    return next((flaw.message for flaw in _list_flaws(row, cell)), None)


def _list_flaws(row: SavedPayload, cell: Cell) -> Iterator[BadCell]:
    least, most = row.mass_least_kg, row.mass_most_kg
    if least is not None and most is not None and least > most:
        yield BadCell("mass_least_kg", "library-mass-range", least_kg=least, most_kg=most)
    yield from box_contradictions(read_box(row), "box")
    known = read_known_payload(row)
    if known is not None:
        yield from payload_contradictions(row.name, known, cell, lambda key: key if key == "box" else f"reference.{key}")
    elif (heaviest := most or least) is not None:
        yield from mass_contradictions(heaviest, cell, "mass_least_kg" if most is None else "mass_most_kg")
        yield from load_contradictions([row.name], InertialParameters(np.array([heaviest, *[0.0] * 9])), cell)
