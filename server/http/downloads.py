"""What is kept as files, on its way out: a recording as a zip, a report as a page that may do nothing but be looked at."""

from __future__ import annotations

import re
import tempfile
import unicodedata
import zipfile
from collections.abc import Iterator, Sequence
from datetime import datetime
from pathlib import Path
from typing import Any

from fastapi.responses import FileResponse, Response, StreamingResponse

from core.words.message import Message
from server.http.errors import Conflict

CHUNK = 1 << 18
MOST_LETTERS = 60
"""Of each part of a name."""
ZIPPED: dict[int | str, dict[str, Any]] = {200: {"content": {"application/zip": {"schema": {"type": "string", "format": "binary"}}}}}
TEXT: dict[int | str, dict[str, Any]] = {200: {"content": {"application/octet-stream": {"schema": {"type": "string"}}}}}
PDF: dict[int | str, dict[str, Any]] = {200: {"content": {"application/pdf": {"schema": {"type": "string", "format": "binary"}}}}}
PAGE: dict[int | str, dict[str, Any]] = {200: {"content": {"text/html": {"schema": {"type": "string"}}}}}
HARMLESS = {"Content-Security-Policy": "sandbox; default-src 'none'; style-src 'unsafe-inline'; img-src data:"}
"""Names in a report come from cells and recordings that somebody sent in."""


def name_file(*parts: str | None, when: datetime) -> str:
    """A file's name without its ending: what it is, of what, with which tool, on which day (UTC); plain letters that every system takes."""
    plain = (unicodedata.normalize("NFKD", part).encode("ascii", "ignore").decode() for part in parts if part)
    words = (re.sub(r"[^A-Za-z0-9_.]+", "_", part).strip("_.") for part in plain)
    return "-".join([*(word[:MOST_LETTERS] for word in words if word), f"{when:%Y-%m-%d}"])


def send_zip(folder: Path, name: str, missing: Message) -> StreamingResponse:
    """A folder of plain files as `name`.zip, which unpacks into a folder of that name.

    Raises:
        Conflict: there is no such folder; `missing` says why and what to do.
    """
    if not folder.is_dir():
        raise Conflict(missing.code, **missing.parameters)
    headers = {"Content-Disposition": f'attachment; filename="{name}.zip"'}
    return StreamingResponse(_chunks(folder, name), media_type="application/zip", headers=headers)


def page(files: Sequence[Path], name: str, missing: Message) -> FileResponse:
    """A report as `name`.html: the first of these files that is there.

    Raises:
        Conflict: none of them is; `missing` says why and what to do.
    """
    file = next((each for each in files if each.is_file()), None)
    if file is None:
        raise Conflict(missing.code, **missing.parameters)
    return FileResponse(file, media_type="text/html", filename=f"{name}.html", headers=HARMLESS)


def text(content: str, name: str) -> Response:
    """Some lines as a file that is saved, whatever they look like."""
    headers = {"Content-Disposition": f'attachment; filename="{name}"'}
    return Response(content, media_type="application/octet-stream", headers=headers)


def _chunks(folder: Path, name: str) -> Iterator[bytes]:
    """The zip is made beside the folder, in a file without a name that is gone when it is closed; samples hardly shrink further."""
    with tempfile.TemporaryFile(dir=folder.parent) as archive:
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_STORED) as opened:
            for file in sorted(folder.iterdir()):
                opened.write(file, f"{name}/{file.name}")
        archive.seek(0)
        while chunk := archive.read(CHUNK):
            yield chunk
