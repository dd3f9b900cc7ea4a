"""A file that appears only when it is whole."""

from __future__ import annotations

import uuid
from pathlib import Path


def write_whole(file: Path, content: str | bytes) -> None:
    """Writes text in UTF-8, or bytes as they are; who reads meanwhile finds the older file, or none.

    Raises:
        OSError: the folder cannot be written; an older file stays as it is.
    """
    part = file.with_name(f".{file.name}.{uuid.uuid4().hex[:8]}.part")
    try:
        part.write_bytes(content.encode() if isinstance(content, str) else content)
        part.replace(file)
    finally:
        part.unlink(missing_ok=True)
