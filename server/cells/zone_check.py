"""What a protected zone would contradict at a place where it is not yet."""

from __future__ import annotations

from core.cell.cell import Cell
from core.errors import BadCell, BadInput
from server.http.errors import Unprocessable
from server.http.flaws import load_flaws
from server.runner.messages import Answered, Failed
from server.runner.work import run_work


def flaws_of_bodies(cell: Cell) -> list[BadInput]:
    """What stands in the way of the robot's base, or of its arm at home, with the payload box of the cell; takes some tenths of a second.

    Raises:
        Unprocessable: the process that looks failed.
    """
    for word in run_work("server.runner.zone_checking", cell):
        match word:
            case Answered(text=text):
                return load_flaws(BadCell, text)
            case Failed(message=message):
                raise Unprocessable(message.code, **message.parameters)
    raise Unprocessable("zone-not-looked-at", cell=cell.name)
