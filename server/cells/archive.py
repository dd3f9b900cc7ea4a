"""An uploaded cell is a zip from outside: unpacked entry by entry, each looked at first, so that nothing lands outside its folder."""

from __future__ import annotations

import re
import stat
import zipfile
from collections import Counter
from pathlib import Path, PurePosixPath

from core.cell.cell import CELL_FILE
from core.errors import BadCell, BadRobot
from server.http.flaws import restore_flaw
from server.http.zip_file import UPLOADED, locate_file, open_zip, write_entry

MAX_FILES = 200
MAX_BYTES = 60_000_000  # of all files together, unpacked
MAX_DEPTH = 4
KINDS = (".toml", ".urdf", ".stl", ".obj", ".dae", ".json", ".md", ".txt")
"""What a cell is made of."""

MAX_ROBOT_FILES = 2000
MAX_ROBOT_BYTES = 200_000_000
MAX_ROBOT_DEPTH = 12
ROBOT_KINDS = (".urdf", ".xacro", ".xml", ".stl", ".obj", ".dae", ".yaml", ".yml")
"""What a robot's description is made of; whatever else is in its packages is left out."""

UPLOAD, CELL = "upload.zip", "cell"
"""In the folder of one upload: the archive, and what it is unpacked to."""

_PART = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,63}", re.ASCII)


def unpack_cell(archive: Path, folder: Path) -> None:
    """Unpacks a zip of a cell: its files at the top, or all in one folder, which is left out.

    Args:
        folder: made here.

    Raises:
        BadCell: no zip, or an entry that no honest cell has.
    """
    with open_zip(archive, BadCell, "cell") as opened:
        files = [entry for entry in opened.infolist() if not entry.is_dir()]
        _check_amount(files)
        names = [_parse_name(entry) for entry in files]
        _check_unique(names)
        shared = _find_shared_folder(names)
        folder.mkdir()
        for entry, name in zip(files, names, strict=True):
            _write(opened, entry, folder / name.relative_to(shared))


def unpack_robot(archive: Path, folder: Path) -> None:
    """Unpacks what of a zip of ROS packages describes a robot.

    Args:
        folder: made here.

    Raises:
        BadRobot: no zip, or an entry that no honest package has.
    """
    try:
        with open_zip(archive, BadCell, "robot") as opened:
            wanted = [entry for entry in opened.infolist() if _is_of_robot(entry)]
            _check_amount(wanted, MAX_ROBOT_FILES, MAX_ROBOT_BYTES)
            names = [_parse_name(entry, ROBOT_KINDS, MAX_ROBOT_DEPTH) for entry in wanted]
            _check_unique(names)
            folder.mkdir()
            for entry, name in zip(wanted, names, strict=True):
                _write(opened, entry, folder / name)
    except BadCell as error:
        raise restore_flaw(BadRobot, error.message) from error


def _is_of_robot(entry: zipfile.ZipInfo) -> bool:
    name = PurePosixPath(entry.filename)
    hidden = any(part.startswith((".", "__")) for part in name.parts if part != "..")
    return not entry.is_dir() and not hidden and name.suffix.lower() in ROBOT_KINDS


def _check_amount(files: list[zipfile.ZipInfo], most_files: int = MAX_FILES, most_bytes: int = MAX_BYTES) -> None:
    if len(files) > most_files:
        raise BadCell(UPLOADED, "uploads-too-many-files", files=len(files), most_files=most_files)
    total = sum(entry.file_size for entry in files)
    if total > most_bytes:
        raise BadCell(UPLOADED, "uploads-too-many-bytes", unpacked_bytes=total, most_bytes=most_bytes)


def _parse_name(entry: zipfile.ZipInfo, kinds: tuple[str, ...] = KINDS, most_levels: int = MAX_DEPTH) -> PurePosixPath:
    where, name = locate_file(entry.filename), PurePosixPath(entry.filename)
    kind = stat.S_IFMT(entry.external_attr >> 16)
    if kind == stat.S_IFLNK:
        raise BadCell(where, "uploads-symbolic-link")
    if kind not in (0, stat.S_IFREG):
        raise BadCell(where, "uploads-special-file")
    if entry.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise BadCell(where, "uploads-compression-unknown", compression=entry.compress_type)
    if entry.flag_bits & 1:
        raise BadCell(where, "uploads-encrypted-file")
    if set("\\\0") & set(entry.orig_filename) or name.is_absolute() or ".." in name.parts:
        raise BadCell(where, "uploads-name-outside")
    if len(name.parts) > most_levels or not all(_PART.fullmatch(part) for part in name.parts):
        raise BadCell(where, "uploads-name-unusual", levels=most_levels)
    if name.suffix.lower() not in kinds:
        raise BadCell(where, "uploads-kind-unknown", kind=name.suffix, kinds=kinds)
    return name


def _check_unique(names: list[PurePosixPath]) -> None:
    counts = Counter(str(name).lower() for name in names)  # some file systems know no case
    for name, count in counts.items():
        if count > 1:
            raise BadCell(locate_file(name), "uploads-same-names", files=count)


def _find_shared_folder(names: list[PurePosixPath]) -> PurePosixPath:
    for place in (PurePosixPath(), *{PurePosixPath(name.parts[0]) for name in names if len(name.parts) > 1}):
        if place / CELL_FILE in names and all(name.is_relative_to(place) for name in names):
            return place
    raise BadCell(UPLOADED, "uploads-no-cell-file", file=CELL_FILE)


def _write(zip_file: zipfile.ZipFile, entry: zipfile.ZipInfo, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    lie = BadCell(locate_file(entry.filename), "uploads-longer-than-listed", listed_bytes=entry.file_size)
    write_entry(zip_file, entry, target, max_bytes=entry.file_size, too_much=lie)
