"""Has the payload identified from the recording that was made of a log."""

from __future__ import annotations

import json

from core.cell.cell import Cell
from core.estimation.result import Result
from server.http.errors import Conflict, Unprocessable
from server.http.flaws import raise_refused
from server.imports.imports import LogImport
from server.runner.messages import Answered
from server.runner.work import run_work

MODULE = "server.runner.identifying"


def identify_import(found: LogImport, cell: Cell | None, empty: LogImport | None) -> None:
    """Identifies the payload; `found.identified` is the answer then. The recording must be there, and nothing else under way.

    Args:
        cell: in which it was made; None where that is none of ours.
        empty: a log of the same arm without the payload, whose recording must be there too: the joints' torques alone are compared. None
            where the log stands alone.

    Raises:
        BadRecording, BadRobot, BadTwin: the recording, or the cell's twin, cannot be used.
        Unprocessable: the process ended.
    """
    for word in run_work(MODULE, found.folder, cell, None if empty is None else empty.folder):
        if isinstance(word, Answered):
            raise_refused(json.loads(word.text))
            found.identified = Result.model_validate_json(word.text)
            found.without = () if empty is None else tuple(empty.files)
            return
    raise Unprocessable("jobs-work-lost")


def require_identified(found: LogImport) -> Result:
    """What its payload is.

    Raises:
        Conflict: nobody has asked for it since it was read.
    """
    if found.identified is None:
        raise Conflict("imports-not-identified", log_import=found.id)
    return found.identified
