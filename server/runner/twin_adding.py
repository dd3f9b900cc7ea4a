"""An effect for a cell's twin, fitted anew to the recording in which a diagnosis found it."""

from __future__ import annotations

from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path

from core.cell.cell import Cell
from core.errors import HeftError
from core.gap.twin_addition import with_effect
from core.twin.file import read_twin, serialise_twin
from server.runner.diagnosing import fit_with_progress
from server.runner.messages import Answered, Failed
from server.runner.work import give_way


def main(cell: Cell, recording: Path, effect: str, connection: Connection) -> None:
    """Answers with the twin to which the effect is added, or two joined by a plus sign; done twice it is the same twin."""
    give_way()
    with suppress(BrokenPipeError):  # nobody waits any more
        try:
            twin = with_effect(read_twin(cell), cell, recording, effect, fit_all=fit_with_progress(connection))
            connection.send(Answered(serialise_twin(cell, twin)))
        except HeftError as error:
            connection.send(Failed(type(error).__name__, error.message))
