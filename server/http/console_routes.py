"""The operator console: its page and what belongs to it. Anybody may load it; what it shows, it asks for as whoever has signed in."""

from __future__ import annotations

from fastapi import APIRouter, Response

from server.http.console import ConsoleDep

router = APIRouter(tags=["console"], include_in_schema=False)


@router.get("/")
def console_page(console: ConsoleDep) -> Response:
    """The page."""
    return console.page()


@router.get("/assets/{path:path}")
def console_asset(path: str, console: ConsoleDep) -> Response:
    """A file of the page, named after its content."""
    return console.asset(path)
