"""A cell as it is now: what its files say, and its protected zones where the people are."""

from __future__ import annotations

from sqlalchemy.orm import Session

from core.cell.folder import CellRead
from server.cells.folder import CellFolder
from server.cells.zones import positions, with_zones_as_they_are


def read_now(cells: CellFolder, db: Session, name: str) -> CellRead:
    """A cell with its zones where they are, whatever they contradict there.

    Raises:
        NotFound: there is none of that name.
        BadCell: its cell.toml cannot be read as a cell.
    """
    found = cells.read(name)
    return found._replace(cell=with_zones_as_they_are(found.cell, positions(db, name)))
