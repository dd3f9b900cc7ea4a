"""Cells that are being made of robots' descriptions: each a folder beside the cells, gone when it is left, imported or old."""

from __future__ import annotations

import json
import re
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import timedelta
from pathlib import Path
from typing import Annotated, Any
from zipfile import ZIP_STORED, ZipFile

from core.new_cell.order import CellOrder
from core.words.catalogue import Language
from server.cells.archive import UPLOAD, unpack_robot
from server.cells.folder import NEW, CellFolder
from server.http.dependencies import depend_on
from server.http.draft_folders import DraftFolder, DraftFolders
from server.http.errors import Conflict, NotFound, Unprocessable
from server.http.flaws import raise_refused
from server.runner.messages import Answered
from server.runner.work import run_work

LASTS = timedelta(hours=2)
"""How long a draft is kept that nobody asks for."""
MOST = 10
"""Drafts at a time."""
ROBOT, MADE, PICTURE = "robot", "made", "home.png"
"""In the folder of a draft: what was sent, the cell made of it, the picture of its home."""
DESCRIPTIONS = (".urdf", ".xacro", ".xml")
ARGUMENT = re.compile(r"<xacro:arg\s[^>]*>")
ATTRIBUTE = re.compile(r"\b(name|default)\s*=\s*[\"']([^\"']*)[\"']")
IS_ROBOT = re.compile(r"<robot[\s>]")
PACKAGE_NAME = re.compile(r"<name>\s*([A-Za-z0-9_.-]{1,128})\s*</name>")
OURS = re.compile(rf"{MADE}/[^/\s\"]+/")
"""Before the names of files: where they lie is no news to anybody."""
MOST_LETTERS = 200_000
"""Of a file that are looked through for what it is."""


@dataclass
class Draft(DraftFolder):
    """A cell that is being made."""

    description: str | None = None
    """The URDF to make it of, a path from the folder; None before one was read."""
    packages: tuple[str, ...] = ()
    """Folders in which its packages may be found, paths from the folder."""


class Drafts(DraftFolders[Draft]):
    """All drafts of the service."""

    def __init__(self, cells: CellFolder) -> None:
        super().__init__(Draft, LASTS, MOST)
        self._cells = cells

    def _choose_folder(self) -> Path:
        return self._cells.folder.resolve() / f"{NEW}{secrets.token_hex(8)}"

    def _refuse_more(self) -> Conflict:
        return Conflict("drafts-too-many", most_drafts=MOST)

    def _refuse_unknown(self, name: str) -> NotFound:
        return NotFound("drafts-unknown", draft=name)


def receive_robot(draft: Draft, name: str | None) -> None:
    """Unpacks what was sent, which is a zip of ROS packages, or one file of that name.

    Raises:
        BadRobot: no zip, or an entry that no honest package has.
    """
    folder = draft.folder / ROBOT
    if name is None:
        unpack_robot(draft.folder / UPLOAD, folder)
        _name_package(folder)
    else:
        folder.mkdir()
        (draft.folder / UPLOAD).rename(folder / name)


def _name_package(folder: Path) -> None:
    """A zip of what is in a package, without its folder: it gets one of the package's name, by which the description names its meshes."""
    manifest = folder / "package.xml"
    if not manifest.is_file():
        return
    named = PACKAGE_NAME.search(_read_beginning(manifest))
    if named is not None and not (folder / named.group(1)).exists():
        moved = folder.with_name(f"{folder.name}.moved")
        folder.rename(moved)
        folder.mkdir()
        moved.rename(folder / named.group(1))


def list_descriptions(draft: Draft) -> dict[str, list[tuple[str, str]]]:
    """Files that may describe a whole robot, the likeliest first, each with the names and defaults of its arguments."""
    root = draft.folder / ROBOT
    files = [file for file in root.rglob("*") if file.suffix in DESCRIPTIONS and file.is_file()]
    texts = {file: _read_beginning(file) for file in files}
    found = [file for file in files if IS_ROBOT.search(texts[file])]
    found.sort(key=lambda file: _rank(file, texts[file]))
    return {file.relative_to(draft.folder).as_posix(): list(_list_arguments(texts[file])) for file in found}


def _rank(file: Path, text: str) -> tuple[bool, bool, int, str]:
    """A URDF before a xacro file, one that says something of a robot before one of macros alone, a short path before a long one."""
    return (file.suffix != ".urdf", "<link" not in text and "<xacro:include" not in text, len(file.parts), str(file))


def _list_arguments(text: str) -> Iterator[tuple[str, str]]:
    for argument in ARGUMENT.findall(text):
        given = dict(ATTRIBUTE.findall(argument))
        if "name" in given:
            yield given["name"], given.get("default", "")


def _read_beginning(file: Path) -> str:
    with file.open(encoding="utf-8", errors="replace") as opened:
        return opened.read(MOST_LETTERS)


def _find_packages(draft: Draft) -> tuple[str, ...]:
    """Folders in which packages may be found: the top, what contains one, and what may be one."""
    root = draft.folder / ROBOT
    above = {manifest.parent.parent for manifest in root.rglob("package.xml")}
    folders = [
        root,
        *sorted(each for each in above if each.is_relative_to(root)),
        *sorted(each for each in root.iterdir() if each.is_dir()),
    ]
    return tuple(folder.relative_to(draft.folder).as_posix() for folder in dict.fromkeys(folders))


def read_robot(draft: Draft, file: str, arguments: dict[str, str]) -> Any:
    """The outline of the robot that a file describes, as JSON; from now on the cell is made of it.

    Raises:
        BadInput: it cannot be read, and why.
        Conflict: the draft is being worked on.
        Unprocessable: the file is not one of the draft, or the process ended.
    """
    if file not in list_descriptions(draft):
        raise Unprocessable("drafts-file-unknown", file=file[:120])
    given = Path(file)
    expanded = given if given.suffix == ".urdf" else given.with_name(f"{given.stem.removesuffix('.urdf')}.expanded.urdf")
    with _working(draft):
        draft.packages = _find_packages(draft)
        answer = _work(draft, "server.runner.robot_reading", file, draft.packages, arguments, expanded.as_posix())
        draft.description = expanded.as_posix()
    return answer


def make_draft(draft: Draft, order: CellOrder, language: Language) -> Any:
    """The cell as it would be imported, as JSON.

    Raises:
        BadInput: none can be made, and why.
        Conflict: the draft is being worked on.
        Unprocessable: the process ended.
    """
    with _working(draft):
        return _work(draft, "server.runner.cell_making", order, language)


@contextmanager
def _working(draft: Draft) -> Iterator[None]:
    if not draft.busy.acquire(blocking=False):
        raise Conflict("drafts-busy", draft=draft.id)
    try:
        yield
    finally:
        draft.busy.release()


def _work(draft: Draft, module: str, *arguments: Any) -> Any:
    text = next((word.text for word in run_work(module, draft.folder, *arguments) if isinstance(word, Answered)), None)
    if text is None:
        raise Unprocessable("drafts-work-ended", draft=draft.id)
    answer = json.loads(OURS.sub("", text.replace(f"{draft.folder}/", "")))
    raise_refused(answer)
    return answer


def pack_cell(draft: Draft, name: str, archive: Path) -> None:
    """The made cell as the zip that an upload would be.

    Raises:
        Conflict: none of that name was made.
    """
    made = draft.folder / MADE / name
    if not made.is_dir():
        raise Conflict("drafts-not-made", draft=draft.id, name=name)
    with ZipFile(archive, "w", ZIP_STORED) as opened:
        for file in sorted(made.rglob("*")):
            if file.is_file() and file.name != PICTURE:
                opened.write(file, file.relative_to(made).as_posix())


DraftsDep = Annotated[Drafts, depend_on("drafts")]
