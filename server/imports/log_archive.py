"""A zip of a log, the folder of a bag or several files: of its entries only those that a log has are unpacked, each up to its size."""

from __future__ import annotations

import shutil
import zipfile
from pathlib import Path, PurePosixPath

from core.errors import BadInput
from core.recording.manifest import FILE as MANIFEST
from server.http.zip_file import UPLOADED, locate_file, open_zip, write_entry

LOG_KINDS = (".csv", ".csv.gz", ".txt", ".parquet", ".mcap", ".bag", ".db3")
"""As `core.recording.logs.tables` has them, without the engine's imports; a test holds them together."""
BAG_METADATA = "metadata.yaml"
MAX_BYTES = 1_000_000_000  # of all files together, unpacked
MAX_FILES = 100


def unpack_log(archive: Path, folder: Path) -> None:
    """Unpacks a zip; what is in the files is for the process to judge that reads them.

    Args:
        folder: made here, whole or not at all.

    Raises:
        BadInput: no zip, no log in it, or one that unpacks to too much.
    """
    folder.mkdir()
    try:
        with open_zip(archive, BadInput, "log") as opened:
            left = MAX_BYTES
            too_much = BadInput(UPLOADED, "imports-unpacks-too-large", most_bytes=MAX_BYTES)
            for name, entry in _select_entries(opened).items():
                left -= write_entry(opened, entry, folder / name, max_bytes=left, too_much=too_much)
    except BaseException:
        shutil.rmtree(folder, ignore_errors=True)
        raise


def _select_entries(opened: zipfile.ZipFile) -> dict[str, zipfile.ZipInfo]:
    """The files of a log by their bare names: where they lie in the zip does not matter, so no name leads anywhere."""
    entries = [entry for entry in opened.infolist() if not entry.is_dir()]
    if len(entries) > MAX_FILES:
        raise BadInput(UPLOADED, "uploads-too-many-files", files=len(entries), most_files=MAX_FILES)
    wanted: dict[str, zipfile.ZipInfo] = {}
    for entry in entries:
        name = PurePosixPath(entry.filename.replace("\\", "/")).name
        if name == MANIFEST:
            raise BadInput(locate_file(name), "imports-own-recording")
        if name == BAG_METADATA or name.lower().endswith(LOG_KINDS):
            if name in wanted:
                raise BadInput(locate_file(name), "uploads-two-recordings")
            wanted[name] = entry
    if not any(name != BAG_METADATA for name in wanted):
        raise BadInput(UPLOADED, "imports-no-log-inside", kinds=LOG_KINDS)
    return wanted
