"""An uploaded cell is a zip from outside: unpacked entry by entry, each looked at first, so that nothing lands outside its folder."""

from __future__ import annotations

import re
import stat
import zipfile
from collections import Counter
from pathlib import Path, PurePosixPath

from core.cell.cell import CELL_FILE
from core.errors import BadCell
from server.http.zip_file import UPLOADED, locate_file, open_zip, write_entry

MAX_FILES = 200
MAX_BYTES = 60_000_000  # of all files together, unpacked
MAX_DEPTH = 4
KINDS = (".toml", ".urdf", ".stl", ".obj", ".dae", ".json", ".md", ".txt")
"""What a cell is made of."""

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


def _check_amount(files: list[zipfile.ZipInfo]) -> None:
    if len(files) > MAX_FILES:
        raise BadCell(UPLOADED, "uploads-too-many-files", files=len(files), most_files=MAX_FILES)
    total = sum(entry.file_size for entry in files)
    if total > MAX_BYTES:
        raise BadCell(UPLOADED, "uploads-too-many-bytes", unpacked_bytes=total, most_bytes=MAX_BYTES)


def _parse_name(entry: zipfile.ZipInfo) -> PurePosixPath:
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
    if len(name.parts) > MAX_DEPTH or not all(_PART.fullmatch(part) for part in name.parts):
        raise BadCell(where, "uploads-name-unusual", levels=MAX_DEPTH)
    if name.suffix not in KINDS:
        raise BadCell(where, "uploads-kind-unknown", kind=name.suffix, kinds=KINDS)
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
