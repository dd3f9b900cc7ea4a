"""What a log consists of: named columns with a clock, one table for each file of columns and each topic of a bag."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Protocol

from core.array import Array
from core.errors import BadInput, BadRecording
from core.files.jail import find_inside
from core.recording.bags.bag import BAGS, is_bag, read_bag
from core.recording.bags.spooled_table import SpooledTable
from core.recording.bags.transforms import compose_transforms, find_root
from core.recording.logs.column_file import read_column_file
from core.recording.samples import MAX_BYTES, Samples
from core.words.message import Message

COLUMNS = (".csv", ".csv.gz", ".txt", ".parquet")
KINDS = (*COLUMNS, *BAGS)
ALL = slice(None)
POSE_OF = "tf "


class LogTable(Protocol):
    """Columns of equal length.

    Args:
        where: what messages call it.
        columns: their names.
        frame: in which the values are, where the log says so.
    """

    @property
    def where(self) -> str | Message: ...
    @property
    def columns(self) -> Sequence[str]: ...
    @property
    def frame(self) -> str | None: ...

    def __len__(self) -> int: ...

    def numbers(self, *names: str, rows: slice = ALL) -> Array:
        """The columns side by side, (N, len(names)), finite.

        Raises:
            BadRecording: a column is missing, holds text, or a value is missing, NaN or infinite.
        """
        ...


class FileTable:
    """A file of columns."""

    def __init__(self, samples: Samples) -> None:
        self.samples, self.where, self.columns = samples, samples.where, samples.table.column_names
        self.frame: str | None = None

    def __len__(self) -> int:
        return len(self.samples)

    def numbers(self, *names: str, rows: slice = ALL) -> Array:
        """The columns side by side."""
        return self.samples.numbers(*names)[rows]


class Log:
    """All tables of a log.

    Args:
        where: what messages call it.
        tables: by name: of the file, or of the topic.
        urdf: a robot's description that the log itself brings.
    """

    def __init__(self, where: str, tables: dict[str, LogTable], urdf: str | None = None) -> None:
        self.where, self.tables, self.urdf = where, tables, urdf

    def table(self, name: str | None, key: str) -> LogTable:
        """The table of a name; without a name that of a log that has but one.

        Raises:
            BadRecording: there is none of that name, or several and no name.
        """
        where = Message.of("import-key", file=self.where, key=f"{key}.file")
        if name is None:
            if len(self.tables) != 1:
                raise BadRecording(where, "import-which-file", files=list(self.tables)[:20])
            return next(iter(self.tables.values()))
        if name not in self.tables and name.startswith(POSE_OF) and (composed := self.compose(name.rpartition(">")[2])) is not None:
            return composed
        if name not in self.tables:
            raise BadRecording(where, "import-no-table", name=name, files=list(self.tables)[:20])
        return self.tables[name]

    def compose(self, frame: str) -> SpooledTable | None:
        """The pose of a frame in the root of the tree of transforms, as a table `tf <root>><frame>`; None where no bag tells it."""
        transforms = {name: table for name, table in self.tables.items() if isinstance(table, SpooledTable)}
        root = find_root(transforms, frame)
        return None if root is None else compose_transforms(transforms, frame, f"{self.where}: {POSE_OF}{root}>{frame}")


def is_log(name: str) -> bool:
    """Whether a file of that name may be a log."""
    return name.lower().endswith(KINDS)


def holds_logs(folder: Path) -> bool:
    """Whether a folder is a bag, or has logs in it."""
    return is_bag(folder) or any(_list_logs(folder))


def _list_logs(folder: Path) -> list[Path]:
    return sorted(each for each in folder.iterdir() if is_log(each.name) or (each.is_dir() and is_bag(each)))


def open_log(paths: Sequence[Path]) -> Log:
    """The tables of files and bags; of a folder that is no bag itself, those of the files in it.

    Raises:
        BadInput: a path that is not there, or of a kind that is not known; a folder without logs.
        BadRecording: a file that cannot be read, with the reason.
    """
    tables: dict[str, LogTable] = {}
    urdf = None
    for path in _list_files(paths):
        if is_bag(path):
            bag = read_bag(path)
            found: dict[str, LogTable] = dict(bag.tables)
            urdf = bag.urdf or urdf
        else:
            file = find_inside(path.parent, path.name, BadRecording, max_bytes=MAX_BYTES)
            found = {path.name: FileTable(read_column_file(file, str(path)))}
        twice = tables.keys() & found.keys()
        if twice:
            raise BadInput(str(path), "import-name-twice", name=sorted(twice)[0])
        tables |= found
    return Log(str(paths[0]), tables, urdf)


def _list_files(paths: Iterable[Path]) -> Iterable[Path]:
    for path in paths:
        if not path.exists():
            raise BadInput(str(path), "import-no-log")
        if path.is_dir() and not is_bag(path):
            inside = _list_logs(path)
            if not inside:
                raise BadInput(str(path), "import-no-files", kinds=KINDS)
            yield from inside
        elif path.is_dir() or is_log(path.name):
            yield path
        else:
            raise BadInput(str(path), "import-no-files", kinds=KINDS)
