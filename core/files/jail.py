"""Files that must not lead outside their folder, nor be larger than what they can honestly be."""

from __future__ import annotations

from pathlib import Path

from core.errors import BadInput
from core.words.message import Message

MOST_LETTERS = 300
"""Of the system's own words."""


def find_inside(folder: Path, name: str, refusal: type[BadInput], *, max_bytes: int, where: str | Message | None = None) -> Path:
    """The regular file `name` inside `folder`, symbolic links followed.

    Args:
        refusal: the error to raise.
        max_bytes: size that no honest file of this kind exceeds.
        where: what the sentence names; the file itself where absent.

    Raises:
        BadInput: of the given kind: the path leads outside the folder, is no regular file, or the file is too large.
    """
    where = where or str(folder / name)
    try:
        path = (folder / name).resolve()
        if not path.is_relative_to(folder.resolve()):
            raise refusal(where, "files-leads-outside", name=name)
        if not path.is_file():
            if path.exists():
                raise refusal(where, "files-no-regular-file", name=name, folder=str(folder))
            raise refusal(where, "files-missing", name=name, folder=str(folder))
        size = path.stat().st_size
    except (OSError, ValueError, RuntimeError) as error:  # a loop of links, a name with NUL, no permission
        raise refusal(where, "files-path-not-followed", reason=str(error)[:MOST_LETTERS]) from error
    if size > max_bytes:
        raise refusal(where, "files-too-large", bytes=size, most=max_bytes)
    return path


def read_inside(folder: Path, name: str, refusal: type[BadInput], *, max_bytes: int, where: str | Message | None = None) -> str:
    """Text of `find_inside`, in UTF-8.

    Raises:
        BadInput: of the given kind.
    """
    path = find_inside(folder, name, refusal, max_bytes=max_bytes, where=where)
    where = where or str(folder / name)
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        byte = f"0x{error.object[error.start]:02x}"
        raise refusal(where, "files-not-utf8", byte=byte, position=error.start) from error
    except OSError as error:
        raise refusal(where, "files-unreadable", reason=str(error.strerror)) from error
