"""A text file that appears only when it is whole."""

from __future__ import annotations

import uuid
from pathlib import Path


def write_whole(file: Path, text: str) -> None:
    """Writes text in UTF-8; who reads meanwhile finds the older file, or none.

    Raises:
        OSError: the folder cannot be written; an older file stays as it is.
    """
    part = file.with_name(f".{file.name}.{uuid.uuid4().hex[:8]}.part")
    try:
        part.write_text(text, encoding="utf-8")
        part.replace(file)
    finally:
        part.unlink(missing_ok=True)
