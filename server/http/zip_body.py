"""A request whose body is a zip: cells and recordings are taken in so."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import anyio
from fastapi import Request

from server.http.errors import Unprocessable
from server.http.zip_file import What

ZIP: dict[str, Any] = {
    "requestBody": {"required": True, "content": {"application/zip": {"schema": {"type": "string", "format": "binary"}}}}
}
"""How OpenAPI describes it."""


FILE = "application/octet-stream"
FILE_OR_ZIP: dict[str, Any] = {
    "requestBody": {"required": True, "content": dict.fromkeys(("application/zip", FILE), ZIP["requestBody"]["content"]["application/zip"])}
}
"""The same where one file may come in place of a zip."""


def check_is_upload(request: Request, what: What) -> bool:
    """Whether the request brings a single file, not a zip of `what`.

    Raises:
        Unprocessable: it says that it brings something else.
    """
    if request.headers.get("content-type", "").partition(";")[0] == FILE:
        return True
    check_is_zip(request, what)
    return False


def check_is_zip(request: Request, what: What) -> None:
    """The request says that it brings a zip of the folder of `what`.

    Raises:
        Unprocessable: it says something else.
    """
    kind = request.headers.get("content-type", "")
    if kind.partition(";")[0] != "application/zip":
        raise Unprocessable("uploads-no-zip", found=kind[:60], what=what)


async def write_body(request: Request, archive: Path) -> None:
    """The request's body as a file, written as it comes."""
    async with await anyio.open_file(archive, "wb") as file:
        async for chunk in request.stream():
            await file.write(chunk)
