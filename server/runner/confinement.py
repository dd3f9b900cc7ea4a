"""Limits on a process that works on files of foreign origin: on time, memory, and what it may open."""

from __future__ import annotations

import os
import resource
import sys
from math import ceil
from pathlib import Path
from typing import Any

from core.errors import BadInput
from core.files.confinement import stay_here
from server.http.zip_file import UPLOADED

FORBIDDEN = ("socket.", "subprocess.", "os.exec", "os.fork", "os.posix_spawn", "os.system", "ctypes.", "os.symlink", "os.link")


def confine(folder: Path, seconds: float, memory: int, open_files: int = 64) -> None:
    """From here on: little time, little memory, no file outside the folder, no network, no other program.

    Args:
        seconds: of the processor, beside what it has used already.
        memory: bytes of private data.
        open_files: at a time.
    """
    used = resource.getrusage(resource.RUSAGE_SELF)
    resource.setrlimit(resource.RLIMIT_DATA, (memory, memory))
    resource.setrlimit(resource.RLIMIT_CPU, (ceil(used.ru_utime + used.ru_stime + seconds) + 1,) * 2)
    resource.setrlimit(resource.RLIMIT_NOFILE, (open_files, open_files))
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
