"""The operator console as it was built: files that the browser loads, and a page in their place where nobody has built them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from fastapi.responses import FileResponse, HTMLResponse, Response

from server.http.dependencies import depend_on
from server.http.errors import NotFound

PLACES = (Path(__file__).parents[1] / "console", Path(__file__).parents[2] / "web" / "dist")
"""In an installed package; in a checkout."""
INDEX, ASSETS = "index.html", "assets"

POLICY = "; ".join(
    (
        "default-src 'self'",
        "img-src 'self' data: blob:",
        "object-src 'none'",
        "base-uri 'none'",
        "form-action 'none'",
        "frame-ancestors 'none'",
    )
)
"""Scripts, styles, sockets, workers and frames (the viewer) of our own only."""
HEADERS = {"Content-Security-Policy": POLICY, "X-Frame-Options": "DENY"}
ANEW = {"Cache-Control": "no-cache"}
FOR_GOOD = {"Cache-Control": "public, max-age=31536000, immutable"}
"""For files whose names change with what is in them."""

UNBUILT = """<!doctype html>
<html lang="en"><meta charset="utf-8"><title>Heft</title>
<p>The console has not been built: <code>make run</code> builds it, which needs Node 20 or later. The API works without it, see
<a href="/openapi.json">/openapi.json</a>.</p></html>
"""


class Console:
    """The built files.

    Args:
        places: folders that may hold them; the first that does counts, looked for at each request of the page.
    """

    def __init__(self, places: tuple[Path, ...] = PLACES) -> None:
        self._places = places

    @property
    def folder(self) -> Path | None:
        """Where they are; None where nobody has built them."""
        return next((place for place in self._places if (place / INDEX).is_file()), None)

    def page(self) -> Response:
        """The page, or one that says how to build it."""
        folder = self.folder
        if folder is None:
            return HTMLResponse(UNBUILT, status_code=503, headers=HEADERS | ANEW)
        return FileResponse(folder / INDEX, media_type="text/html", headers=HEADERS | ANEW)

    def asset(self, path: str) -> Response:
        """A script, a style or a picture of the page.

        Raises:
            NotFound: there is none of that name.
        """
        folder = self.folder
        if folder is not None:
            assets = (folder / ASSETS).resolve()
            file = (assets / path).resolve()
            if file.is_relative_to(assets) and file.is_file():
                return FileResponse(file, headers=HEADERS | FOR_GOOD)
        raise NotFound("request-console-file-unknown", path=path[:80])


ConsoleDep = Annotated[Console, depend_on("console")]
