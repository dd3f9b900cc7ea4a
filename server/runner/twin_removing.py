"""An effect is taken out of a cell's twin."""

from __future__ import annotations

from multiprocessing.connection import Connection

from core.cell.cell import Cell
from core.errors import HeftError
from core.twin.file import read_twin, serialise_twin
from server.runner.messages import Answered, Failed
from server.runner.work import give_way


def main(cell: Cell, effect: str, connection: Connection) -> None:
    """Answers with the twin without the effect."""
    give_way()
    try:
        connection.send(Answered(serialise_twin(cell, read_twin(cell).without(effect))))
    except HeftError as error:
        connection.send(Failed(type(error).__name__, error.message))
