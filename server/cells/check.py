"""A process that looks at uploaded cells: each in a child of its own, with limits on time, memory and what it may open.

It reads one order a line from standard input (the folder with the upload) and answers with one line of JSON. It has the engine imported
before it reads anything, so that a child is a fork and costs milliseconds; no child's damage reaches the service or the next child.
"""

from __future__ import annotations

import gc
import json
import os
import resource
import select
import signal
import sys
from pathlib import Path
from typing import Any

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.effects.library import library
from core.errors import BadCell, BadInput, BadRobot
from core.files.confinement import stay_here
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.twin.file import read_twin
from server.cells.archive import CELL, UPLOAD, unpack_cell
from server.http.flaws import dump_flaws
from server.http.zip_file import UPLOADED

SECONDS = 15.0
MEMORY = 512_000_000  # bytes of private data
MOST_FLAWS = 50  # told of one cell
FORBIDDEN = ("socket.", "subprocess.", "os.exec", "os.fork", "os.posix_spawn", "os.system", "ctypes.", "os.symlink", "os.link")

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


def confine(folder: Path) -> None:
    """From here on: little time, little memory, no file outside the folder, no network, no other program."""
    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (round(SECONDS) + 1,) * 2)
    resource.setrlimit(resource.RLIMIT_NOFILE, (64, 64))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    stay_here()
    inside = folder.resolve()

    def watch(event: str, arguments: tuple[Any, ...]) -> None:
        if event == "open" and isinstance(arguments[0], str | bytes | os.PathLike):
            path = Path(os.fsdecode(arguments[0])).resolve()
            if not path.is_relative_to(inside) and not _belongs_to_program(path, arguments):
                raise BadInput(str(path), "uploads-outside-file")
        elif event.startswith(FORBIDDEN):
            raise BadInput(UPLOADED, "uploads-program", event=event)

    sys.addaudithook(watch)


def _belongs_to_program(path: Path, arguments: tuple[Any, ...]) -> bool:
    """What Python itself may still have to read: modules, compiled code."""
    flags = arguments[2] if len(arguments) > 2 and isinstance(arguments[2], int) else 0
    writes = flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT)
    return not writes and any(path.is_relative_to(place) for place in PROGRAM)


PROGRAM = tuple({Path(place).resolve() for place in (sys.prefix, sys.base_prefix, Path(__file__).parents[2] / "core")})


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
        confine(folder)
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
    return {"refused": type(error).__name__, "flaws": dump_flaws(error, MOST_FLAWS)}


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
