"""A zip from outside: whatever is wrong with it is a refusal in words, and no entry unpacks to more than it may."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Literal

from core.errors import BadInput
from core.words.message import Message

BROKEN = (zipfile.BadZipFile, NotImplementedError, EOFError, OSError, ValueError, RuntimeError)
"""What `zipfile` raises at a zip that is cut short, forged, encrypted, or packed in a way that it does not know."""
CHUNK = 1 << 16
UPLOADED = Message.of("uploads-upload")
"""Where something is that is wrong with a whole upload."""
What = Literal["cell", "recording", "robot", "log"]


def locate_file(name: str) -> Message:
    """Where something is that is wrong with one file of an upload."""
    return Message.of("uploads-file", name=name[:80])


@contextmanager
def open_zip(archive: Path, kind: type[BadInput], what: What) -> Iterator[zipfile.ZipFile]:
    """The zip, to be looked at and unpacked inside.

    Args:
        kind: of the refusal.
        what: whose folder the zip should have been.

    Raises:
        BadInput: of that kind, where the zip or one of its entries cannot be read.
    """
    try:
        with zipfile.ZipFile(archive) as opened:
            yield opened
    except BROKEN as error:
        raise kind(UPLOADED, "uploads-not-unpackable", reason=str(error)[:120], what=what) from error


def write_entry(zip_file: zipfile.ZipFile, entry: zipfile.ZipInfo, target: Path, *, max_bytes: int, too_much: BadInput) -> int:
    """Unpacks one entry into a new file and returns how many bytes it has.

    Args:
        too_much: raised where there are more than `max_bytes`, whatever the zip's own index says.
    """
    written = 0
    with zip_file.open(entry) as source, target.open("xb") as sink:
        while chunk := source.read(CHUNK):
            written += len(chunk)
            if written > max_bytes:
                raise too_much
            sink.write(chunk)
    return written
