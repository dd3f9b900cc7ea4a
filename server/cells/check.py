"""A process that looks at uploaded cells: each in a child of its own, with limits on time, memory and what it may open.

It reads one order a line from standard input (the folder with the upload) and answers with one line of JSON. It has the engine imported
before it reads anything, so that a child is a fork and costs milliseconds; no child's damage reaches the service or the next child.
"""

from __future__ import annotations

import gc
import json
import os
import select
import signal
import sys
from pathlib import Path
from typing import Any

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.effects.library import library
from core.errors import BadCell, BadInput, BadRobot
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.twin.file import read_twin
from server.cells.archive import CELL, UPLOAD, unpack_cell
from server.http.flaws import dump_refusal
from server.http.zip_file import UPLOADED
from server.runner.confinement import confine

SECONDS = 15.0
MEMORY = 512_000_000  # bytes of private data
MOST_FLAWS = 50  # told of one cell

CheckAnswer = dict[str, Any]


def check_upload(folder: Path) -> CheckAnswer:
    """Unpacks and loads the cell, up to the models that planning would use and the effects of its twin."""
    try:
        unpack_cell(folder / UPLOAD, folder / CELL)
        os.chdir(folder / CELL)  # errors name files as the upload does
        cell = load_cell(Path())
        _build(cell)
        read_twin(cell)
    except BadInput as error:
        return _refusal(error)
    except (MemoryError, RecursionError) as error:
        return _refusal(BadCell(UPLOADED, "uploads-check-too-large", reason=type(error).__name__))
    return {"name": cell.name, "title": cell.title}


def _build(cell: Cell) -> None:
    try:
        robot = RobotModel.of_cell(cell)
        CollisionModel(cell, robot, cell.payload_box)
    except (ValueError, RuntimeError, IndexError, ArithmeticError) as error:  # Pinocchio's and Coal's own
        raise BadRobot(cell.robot.urdf, "uploads-model-not-buildable", reason=str(error)[:200]) from error


def check_in_child(folder: Path) -> CheckAnswer:
    """`check`, in a fork that is given up after its time."""
    read_fd, write_fd = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(read_fd)
        _run_child(folder, write_fd)
    os.close(write_fd)
    return _read_outcome(child, read_fd)


def _run_child(folder: Path, write_fd: int) -> None:
    status = 1
    try:
        confine(folder, SECONDS, MEMORY)
        answer = check_upload(folder)
        os.write(write_fd, json.dumps(answer).encode())
        status = 0
    finally:
        os._exit(status)  # never back into the parent's code


def _read_outcome(child: int, read_fd: int) -> CheckAnswer:
    said = b""
    with os.fdopen(read_fd, "rb") as pipe:
        if select.select([pipe], [], [], SECONDS)[0]:
            said = pipe.read()
        else:
            os.kill(child, signal.SIGKILL)
    _, status = os.waitpid(child, 0)
    if said:
        answer: CheckAnswer = json.loads(said)
        return answer
    if os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGKILL, signal.SIGXCPU):
        return _refusal(BadCell(UPLOADED, "uploads-check-too-slow", limit_s=SECONDS))
    return _refusal(BadCell(UPLOADED, "uploads-check-broken-off"))


def _refusal(error: BadInput) -> CheckAnswer:
    """In codes alone: nothing is worded where nothing may be read."""
    answer: CheckAnswer = json.loads(dump_refusal(error, MOST_FLAWS))
    return answer


def main() -> None:
    """Answers until standard input ends, which it does when the service does."""
    library()  # found by looking into the engine's folder, which a child may not
    gc.collect()
    gc.freeze()
    for line in sys.stdin:
        sys.stdout.write(json.dumps(check_in_child(Path(line.rstrip("\n")))) + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main()
