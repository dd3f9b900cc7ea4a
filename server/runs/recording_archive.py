"""An uploaded recording is a zip from outside: of its entries only the files that a recording has are unpacked, each up to its size."""

from __future__ import annotations

import shutil
import zipfile
from pathlib import Path, PurePosixPath

from core.errors import BadRecording
from core.recording.manifest import FILE as MANIFEST
from server.http.zip_file import UPLOADED, locate_file, open_zip, write_entry

MAX_BYTES = 400_000_000  # of all files together, unpacked
MAX_FILES = 20


def unpack_recording(archive: Path, folder: Path) -> None:
    """Unpacks a zip of a recording folder; what is in the files is `core.recording.folder.read_recording`'s to judge.

    Args:
        folder: made here, whole or not at all.

    Raises:
        BadRecording: no zip, no recording in it, or one that unpacks to too much.
    """
    part = folder.with_name(folder.name + ".part")
    part.mkdir()
    try:
        with open_zip(archive, BadRecording, "recording") as opened:
            _write_all(opened, _select_entries(opened), part)
        part.replace(folder)
    finally:
        shutil.rmtree(part, ignore_errors=True)


def _select_entries(zip_file: zipfile.ZipFile) -> dict[str, zipfile.ZipInfo]:
    """The recording's files by their bare names: where they lie in the zip does not matter, so no name leads anywhere."""
    from core.recording.samples import FILES as SAMPLES  # noqa: PLC0415 - the service starts sooner without Arrow

    entries = [entry for entry in zip_file.infolist() if not entry.is_dir()]
    if len(entries) > MAX_FILES:
        raise BadRecording(UPLOADED, "uploads-too-many-files", files=len(entries), most_files=MAX_FILES)
    wanted: dict[str, zipfile.ZipInfo] = {}
    for entry in entries:
        name = PurePosixPath(entry.filename.replace("\\", "/")).name
        if name == MANIFEST or name in SAMPLES or name.endswith(".urdf"):
            if name in wanted:
                raise BadRecording(locate_file(name), "uploads-two-recordings")
            wanted[name] = entry
    if MANIFEST not in wanted:
        raise BadRecording(UPLOADED, "uploads-no-manifest", file=MANIFEST)
    return wanted


def _write_all(zip_file: zipfile.ZipFile, entries: dict[str, zipfile.ZipInfo], folder: Path) -> None:
    left = MAX_BYTES
    too_much = BadRecording(UPLOADED, "uploads-recording-too-large", most_bytes=MAX_BYTES)
    for name, entry in entries.items():
        left -= write_entry(zip_file, entry, folder / name, max_bytes=left, too_much=too_much)
