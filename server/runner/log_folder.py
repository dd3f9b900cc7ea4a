"""What lies in the folder of a log that is being imported, what the process that reads it is told, and its limits."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from core.words.catalogue import Language

LOGS, RECORDING, MAPPING, WORK = "logs", "recording", "map.toml", "work"
"""What was sent, the recording made of it, the mapping that it was made with (in the recording), what is needed meanwhile."""
SECONDS, MEMORY = 120.0, 2_000_000_000
"""Of the processor, and bytes of private data."""
MOST_FILE_BYTES = 4_000_000_000
"""Of one file that is written meanwhile."""
MOST_OPEN_FILES = 512
"""A long topic of a bag is one."""


def locate_report(folder: Path, language: Language) -> Path:
    """Where the identification of the recording in an import's folder leaves its page in a language."""
    return folder / f"identified.{language}.html"


class CellRobot(NamedTuple):
    """The robot of the cell in which a log was made."""

    urdf: str
    base_frame: str
    sensor_frame: str


class LogOrder(NamedTuple):
    """What is to be read, by names in `LOGS`.

    Args:
        logs: files, and folders of bags.
        mapping: what somebody has written of its columns; None where nobody has.
        robot: the robot's description; None where none was sent.
        cell: of the cell in which it was made; None where that is none of ours.
        answers: keys of the mapping that somebody has given.
    """

    logs: tuple[str, ...]
    mapping: str | None
    robot: str | None
    cell: CellRobot | None
    answers: dict[str, str]
