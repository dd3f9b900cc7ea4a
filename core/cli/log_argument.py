"""A log of another program where a recording is asked for: what is known of it, and the recording that is made of it for the time being."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, NamedTuple

import typer

from core.cell.cell import Cell
from core.cli.terminal import find_wording, messages
from core.errors import BadInput
from core.recording.manifest import FILE as MANIFEST

MapOption = Annotated[
    Path | None,
    typer.Option("--map", metavar="FILE", help="What a log's columns mean (docs/import.md). [default: what their names and values say]"),
]
UrdfOption = Annotated[
    Path | None, typer.Option(metavar="FILE", help="The robot's description: the attitude of a log comes from its joints then.")
]
SetOption = Annotated[
    list[str] | None, typer.Option("--set", metavar="KEY=VALUE", help="One key of a log's mapping, such as wrench.sign=-1.")
]


class LogKnowledge(NamedTuple):
    """What a person knows of a log.

    Args:
        mapping: file that says what its columns mean.
        urdf: file of the robot's description.
        changes: keys of the mapping, as `KEY=VALUE`.
        cell: in which it was made: its robot is the log's, where no other description is given.
    """

    mapping: Path | None = None
    urdf: Path | None = None
    changes: tuple[str, ...] = ()
    cell: Cell | None = None

    @property
    def given(self) -> str | None:
        """The first option of them that was given; None where none was."""
        options = (("--map", self.mapping), ("--urdf", self.urdf), ("--set", self.changes))
        return next((name for name, value in options if value), None)


def are_log(paths: Sequence[Path]) -> bool:
    """Whether these are the files of one log; recordings are folders with a `recording.json`.

    Raises:
        BadInput: some are, and some are recordings.
    """
    logs = [_is_log(path) for path in paths]
    if any(logs) and not all(logs):
        raise BadInput(str(paths[logs.index(True)]), "cli-log-beside-recording")
    return all(logs)


def _is_log(path: Path) -> bool:
    """A file that is no JSON, or a folder that holds logs and no recording."""
    if not path.is_dir():
        return path.is_file() and path.suffix.lower() != ".json"
    if (path / MANIFEST).exists():
        return False
    from core.recording.logs.tables import holds_logs  # noqa: PLC0415 - only a folder that is no recording waits for what reads bags

    return holds_logs(path)


def check_no_log(path: Path, known: LogKnowledge) -> None:
    """Nothing where no option of logs was given for a recording.

    Raises:
        BadInput: one was.
    """
    if known.given is not None:
        raise BadInput(known.given, "cli-option-of-logs", recording=str(path))


@contextmanager
def take_recording(path: Path, known: LogKnowledge) -> Iterator[Path]:
    """The folder of a recording.

    Raises:
        BadInput: an option of logs was given.
    """
    check_no_log(path, known)
    yield path


@contextmanager
def take_log(paths: Sequence[Path], known: LogKnowledge) -> Iterator[Path]:
    """The folder of a recording that is made of a log and is gone afterwards; what the log was taken for is told beside the answer.

    Raises:
        BadInput, BadRecording: as for `heft import`.
    """
    from core.cli.import_log import make_recording  # noqa: PLC0415 - only a log waits for what reads logs

    with TemporaryDirectory(prefix="heft-") as folder:
        out = Path(folder) / "recording"
        make_recording(paths, out, known, messages)
        messages.print(find_wording().say("cli-log-taken", logs=" ".join(map(str, paths))), highlight=False, soft_wrap=True)
        yield out
