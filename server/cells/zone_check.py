"""What a protected zone would contradict at a place where it is not yet."""

from __future__ import annotations

import json

from core.cell.cell import Cell
from core.errors import BadCell
from server.http.errors import Unprocessable
from server.runner.messages import Answered, Failed
from server.runner.work import run_work


def flaws_of_bodies(cell: Cell) -> list[BadCell]:
    """What stands in the way of the robot's base, or of its arm at home, with the payload box of the cell; takes some tenths of a second.

    Raises:
        Unprocessable: the process that looks failed.
    """
    for word in run_work("server.runner.zone_checking", cell):
        match word:
            case Answered(text=text):
                return [BadCell(*flaw) for flaw in json.loads(text)]
            case Failed(message=message):
                raise Unprocessable(message)
    raise Unprocessable(f"zones of {cell.name}: nothing was looked at; send it again")
