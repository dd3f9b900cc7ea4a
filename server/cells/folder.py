"""The cells of this service: a folder each in one folder; read anew when a file changed, replaced as a whole or not at all."""

from __future__ import annotations

import hashlib
import shutil
from pathlib import Path
from threading import Lock
from typing import Annotated, Any

from core.cell.cell import CELL_FILE, Cell
from core.cell.folder import CellRead, list_cell_folders, read_cell_folder
from core.errors import BadCell, BadInput, BadTwin, refuse, together
from core.twin.file import parse_twin, put_twin
from core.twin.twin import Twin
from core.words.message import Message
from server.http.dependencies import depend_on
from server.http.errors import Conflict, NotFound
from server.http.flaws import restore_flaw

OLD, NEW = ".old-", ".new-"
"""What stands before the name of a folder while it is being replaced; no cell's name begins so."""

Stamp = tuple[tuple[str, int, int], ...]


class CellFolder:
    """The folder that holds the cells.

    Args:
        folder: made, with copies of the cells at hand, where it does not exist.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._read: dict[str, tuple[Stamp, CellRead]] = {}
        self._replacing = Lock()

    def prepare(self) -> None:
        """Makes the folder where there is none; ends a replacement that a crash cut off."""
        if not self.folder.exists():
            self.folder.mkdir(parents=True)
            for cell in list_cell_folders():
                shutil.copytree(cell, self.folder / cell.name)
        for old in self.folder.glob(f"{OLD}*"):
            place = self.folder / old.name.removeprefix(OLD)
            if place.exists():
                shutil.rmtree(old)
            else:
                old.replace(place)
        for new in self.folder.glob(f"{NEW}*"):
            shutil.rmtree(new)

    def names(self) -> list[str]:
        """Of all cells, readable or not."""
        return sorted(file.parent.name for file in self.folder.glob(f"[!.]*/{CELL_FILE}"))

    def check_known(self, name: str) -> None:
        """There is such a cell, whether or not it can be read.

        Raises:
            NotFound: there is none of that name.
        """
        if name not in self.names():
            raise NotFound("request-cell-unknown", cell=name[:80])

    def load(self, name: str) -> Cell:
        """A cell, checked.

        Raises:
            NotFound: there is none of that name.
            BadCell, BadRobot: it cannot be used.
        """
        found = self.read(name)
        refuse(self.flaws(found))
        return found.cell

    def read(self, name: str) -> CellRead:
        """A cell as its files have it; `flaws` says what speaks against using it.

        Raises:
            NotFound: there is none of that name.
            BadCell: its cell.toml cannot be read as a cell.
        """
        self.check_known(name)
        stamp = _stamp(self.folder / name)
        known = self._read.get(name)
        if known is None or known[0] != stamp:
            self._read[name] = known = (stamp, self._read_anew(name))
        return known[1]

    def _read_anew(self, name: str) -> CellRead:
        try:
            cell, robot_flaws = read_cell_folder(self.folder / name)
        except BadInput as error:
            raise together([self.shorten_paths(each) for each in (error, *error.others)]) from error
        if cell.name == name:
            return CellRead(cell, robot_flaws)
        misnamed = BadCell(f"{name}/{CELL_FILE}: name", "uploads-cell-misnamed", name=cell.name, folder=name)
        return CellRead(cell.model_copy(update={"name": name}), (misnamed, *robot_flaws))

    def flaws(self, found: CellRead) -> list[BadInput]:
        """What speaks against using a cell, with its zones where `found` has them."""
        return [self.shorten_paths(each) for each in found.flaws]

    def shorten_paths(self, flaw: BadInput) -> BadInput:
        """A flaw whose files are named from the folder of the cells on: no screen needs to say where that is."""
        told = restore_flaw(type(flaw), _replace_text(flaw.message, f"{self.folder}/", ""))
        told.in_the_way = flaw.in_the_way
        return told

    def digest(self, name: str) -> str:
        """SHA-256 over the names and contents of a cell's files, hex."""
        self.check_known(name)
        whole = hashlib.sha256()
        folder = self.folder / name
        for file in _files(folder):
            content = hashlib.sha256(file.read_bytes()).hexdigest()
            whole.update(f"{file.relative_to(folder).as_posix()}\0{content}\n".encode())
        return whole.hexdigest()

    def read_twin(self, cell: Cell) -> Twin:
        """The cell's twin as data: whether its effects exist is found by those who know them.

        Raises:
            BadTwin: its file is malformed.
        """
        try:
            return parse_twin(cell)
        except BadTwin as error:
            raise self.shorten_paths(error) from error

    def put_twin(self, cell: Cell, twin: Twin) -> None:
        """Puts a twin into a cell's folder, whose effects a diagnosis has checked; one without effects is no file.

        Raises:
            BadTwin: it cannot be written; the older one stays.
        """
        try:
            put_twin(cell, twin)
        except BadTwin as error:
            raise self.shorten_paths(error) from error

    def install(self, unpacked: Path, name: str, *, replace: bool) -> None:
        """Puts a checked folder into its place: all of it or nothing.

        Args:
            unpacked: on the same file system; it is moved.

        Raises:
            Conflict: there is such a cell and it is not to be replaced.
        """
        place, old = self.folder / name, self.folder / f"{OLD}{name}"
        with self._replacing:
            if place.exists() and not replace:
                raise Conflict("uploads-cell-exists", cell=name)
            if place.exists():
                place.replace(old)
            unpacked.replace(place)
            if old.exists():
                shutil.rmtree(old)


def _replace_text(said: Any, old: str, new: str) -> Any:
    """A message with other text in all that it names."""
    match said:
        case Message():
            return Message(code=said.code, parameters={name: _replace_text(value, old, new) for name, value in said.parameters.items()})
        case str():
            return said.replace(old, new)
        case [*values]:
            return [_replace_text(each, old, new) for each in values]
    return said


def _stamp(folder: Path) -> Stamp:
    """Names, sizes and times of a cell's files."""
    return tuple((str(each), (stat := each.stat()).st_size, stat.st_mtime_ns) for each in _files(folder))


def _files(folder: Path) -> list[Path]:
    """All of a cell, but for what is just being written."""
    return sorted(each for each in folder.rglob("*") if each.suffix != ".part" and each.is_file())


CellsDep = Annotated[CellFolder, depend_on("cells")]
