"""A file of a log as it is sent: what it is by its name, written as it comes, whole or not at all."""

from __future__ import annotations

import hashlib
import shutil
from collections.abc import AsyncIterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import anyio

from core.errors import BadInput
from server.http.errors import NoRoom
from server.http.zip_file import locate_file
from server.imports.log_archive import LOG_KINDS, unpack_log
from server.runs.releases import SPARE_BYTES

ZIP, MAPPING, ROBOT = ".zip", ".toml", ".urdf"
KINDS = (*LOG_KINDS, ZIP, MAPPING, ROBOT)
MOST_LETTERS = 120
PART = ".part"
FileKind = Literal["log", "mapping", "robot"]


@dataclass(frozen=True)
class SentFile:
    """A file that was sent: what it is, its size, and the SHA-256 of its content. A zip is a folder of its name."""

    kind: FileKind
    size_bytes: int
    sha256: str


def check_file_name(name: str) -> FileKind:
    """What a file of that name is.

    Raises:
        BadInput: none that a log has, or a name that leads somewhere.
    """
    if len(name) > MOST_LETTERS or name.startswith(".") or any(ord(letter) < 32 or letter in "/\\" for letter in name):
        raise BadInput(locate_file(name), "imports-name-unusual", most_letters=MOST_LETTERS)
    ending = next((each for each in KINDS if name.lower().endswith(each)), None)
    if ending is None:
        raise BadInput(locate_file(name), "imports-kind-unknown", kinds=KINDS)
    return "mapping" if ending == MAPPING else "robot" if ending == ROBOT else "log"


async def receive_file(name: str, chunks: AsyncIterator[bytes], folder: Path) -> SentFile:
    """Writes a file into the folder of logs; a zip is unpacked.

    Raises:
        BadInput: its name, or what is in it, is none of a log.
        NoRoom: it cannot be written.
    """
    kind = check_file_name(name)
    part = folder / PART
    try:
        size, sha256 = await _write(chunks, part)
        if size == 0:
            raise BadInput(locate_file(name), "imports-file-empty")
        if name.lower().endswith(ZIP):
            await anyio.to_thread.run_sync(unpack_log, part, folder / name)
        else:
            part.replace(folder / name)
        return SentFile(kind, size, sha256)
    except OSError as error:
        raise NoRoom("imports-not-writable", reason=str(error.strerror)) from error
    finally:
        part.unlink(missing_ok=True)


async def _write(chunks: AsyncIterator[bytes], file: Path) -> tuple[int, str]:
    """Size and SHA-256 of what came."""
    size, digest = 0, hashlib.sha256()
    async with await anyio.open_file(file, "wb") as opened:
        async for chunk in chunks:
            size += len(chunk)
            digest.update(chunk)
            await opened.write(chunk)
    return size, digest.hexdigest()


def remove_file(name: str, folder: Path) -> None:
    """Nothing of it stays."""
    place = folder / name
    with suppress(FileNotFoundError):
        shutil.rmtree(place) if place.is_dir() else place.unlink()


def check_room(folder: Path, needed_bytes: int) -> None:
    """Raises NoRoom where the disk has too little for what may come."""
    free, needed = shutil.disk_usage(folder).free, SPARE_BYTES + needed_bytes
    if free < needed:
        raise NoRoom("imports-disk-too-full", free_mb=free / 1e6, needed_mb=needed / 1e6)
