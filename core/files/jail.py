"""Files that must not lead outside their folder, nor be larger than what they can honestly be."""

from __future__ import annotations

from pathlib import Path

from core.errors import BadInput


def find_inside(folder: Path, name: str, refusal: type[BadInput], *, max_bytes: int, where: str | None = None) -> Path:
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
            raise refusal(where, f"{name!r}, which leads outside the folder", "a file inside it")
        if not path.is_file():
            raise refusal(
                where,
                "no such file" if not path.exists() else "something that is no file",
                f"the file {name!r} in {folder}",
            )
        size = path.stat().st_size
    except (OSError, ValueError, RuntimeError) as error:  # a loop of links, a name with NUL, no permission
        raise refusal(where, f"a path that cannot be followed ({error})", "a file inside the folder") from error
    if size > max_bytes:
        raise refusal(where, f"{size} bytes", f"at most {max_bytes}")
    return path


def read_inside(folder: Path, name: str, refusal: type[BadInput], *, max_bytes: int, where: str | None = None) -> str:
    """Text of `find_inside`, in UTF-8.

    Raises:
        BadInput: of the given kind.
    """
    path = find_inside(folder, name, refusal, max_bytes=max_bytes, where=where)
    where = where or str(folder / name)
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise refusal(where, f"the byte 0x{error.object[error.start]:02x} at position {error.start}", "text in UTF-8") from error
    except OSError as error:
        raise refusal(where, f"a file that cannot be read ({error.strerror})", "a readable file") from error
