"""Has a log read by a process with limits, and takes in what it says."""

from __future__ import annotations

import json
import shutil

from server.cells.folder import CellFolder
from server.http.errors import Conflict, Unprocessable
from server.http.flaws import raise_refused
from server.imports.imports import LogImport
from server.runner.log_folder import MEMORY, SECONDS, WORK, CellRobot, LogOrder
from server.runner.log_schemas import LogReading
from server.runner.messages import Advanced, Answered
from server.runner.work import run_work

MODULE = "server.runner.log_reading"


def read_import(found: LogImport, cells: CellFolder, cell: str | None, answers: dict[str, str]) -> None:
    """Reads the log anew; `found.reading` says how far it is understood then.

    Args:
        cell: in which it was made; None where that is none of ours.
        answers: keys of the mapping that somebody has given.

    Raises:
        BadInput: it cannot be used, and why.
        Conflict: no log was sent, or it is being worked on.
        Unprocessable: the process ended.
    """
    order = _make_order(found, None if cell is None else _read_robot(cells, cell), answers)
    with found.working():
        found.forget_reading()
        found.answers, found.cell = answers, cell
        (found.folder / WORK).mkdir()
        try:
            found.reading = _read(found, order)
        except BaseException:
            found.forget_reading()
            raise
        finally:
            found.progress = None
            shutil.rmtree(found.folder / WORK, ignore_errors=True)


def _make_order(found: LogImport, cell: CellRobot | None, answers: dict[str, str]) -> LogOrder:
    names = {kind: [name for name, sent in found.files.items() if sent.kind == kind] for kind in ("log", "mapping", "robot")}
    if not names["log"]:
        raise Conflict("imports-no-log-yet", log_import=found.id)
    for kind in ("mapping", "robot"):
        if len(names[kind]) > 1:
            raise Conflict("imports-several", log_import=found.id, names=names[kind])
    mapping, robot = (next(iter(names[kind]), None) for kind in ("mapping", "robot"))
    return LogOrder(tuple(names["log"]), mapping, robot, cell, answers)


def _read_robot(cells: CellFolder, name: str) -> CellRobot:
    cell = cells.load(name)
    return CellRobot(cell.urdf, cell.robot.base_frame, cell.robot.sensor_frame)


def _read(found: LogImport, order: LogOrder) -> LogReading:
    found.progress = 0.0
    for word in run_work(MODULE, found.folder, order):
        if isinstance(word, Advanced):
            found.progress = word.done
        elif isinstance(word, Answered):
            raise_refused(json.loads(word.text))
            return LogReading.model_validate_json(word.text)
    raise Unprocessable("imports-reading-ended", log_import=found.id, limit_s=SECONDS, limit_gb=MEMORY / 1e9)


def check_understood(found: LogImport) -> None:
    """Raises Conflict where no recording was made of the log."""
    if found.reading is None:
        raise Conflict("imports-not-read", log_import=found.id)
    if found.reading.question is not None:
        raise Conflict("imports-question-open", log_import=found.id, key=found.reading.question.key)
    if found.reading.contradiction is not None:
        raise Conflict("imports-contradicted", log_import=found.id, contradiction=found.reading.contradiction)
