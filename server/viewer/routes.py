"""The way to a cell's viewer: on the same origin, for those who are signed in, and nowhere else."""

from __future__ import annotations

import asyncio
from contextlib import suppress
from hashlib import sha256

from fastapi import APIRouter, Request, Response, WebSocket
from fastapi.responses import RedirectResponse
from starlette.websockets import WebSocketDisconnect
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed
from websockets.typing import Subprotocol

from core.errors import HeftError
from server.http.parameters import ViewPath
from server.viewer.gallery import GalleryDep

router = APIRouter(prefix="/viewer", tags=["viewer"], include_in_schema=False)

POLICY_VIOLATION, GOING_AWAY = 1008, 1001
NOT_MODIFIED = 304
SHOWN_ONLY = b"""<style>
.mantine-Notifications-root, .mantine-Paper-root, [data-portal], [data-dock-root] > :not(:first-child) { display: none !important; }
[data-dock-root] { background: #e6e8e9; }
:root[data-mantine-color-scheme="dark"] [data-dock-root] { background: #202427; }
</style></head>"""
"""Of viser's page the scene alone is seen, on the console's ground: its panel, its settings and what it says of the browser are not for
who stands at a robot."""
OWN_PROCESS = {"document-isolation-policy": "isolate-and-require-corp"}
"""The browser draws in a process of its own. On the same thread a picture that takes two seconds, as it may without a graphics card on a
busy machine, kept whoever is in control from stopping the robot for as long."""


@router.get("/{cell}")
async def to_viewer(cell: str) -> RedirectResponse:
    """The page wants its slash."""
    return RedirectResponse(f"/viewer/{cell}/")


@router.get("/{cell}/{path:path}")
async def viewer_page(cell: str, request: Request, gallery: GalleryDep) -> Response:
    """The viewer's page; the path is what the page calls its view, or nothing."""
    import httpx2  # noqa: PLC0415 - the service starts sooner without it

    port = await gallery.port(cell)
    async with httpx2.AsyncClient(trust_env=False) as client:
        found = await client.get(f"http://127.0.0.1:{port}/")
    content = found.content.replace(b"</head>", SHOWN_ONLY, 1)
    headers = {"etag": f'"{sha256(content).hexdigest()[:32]}"', "cache-control": "no-cache", **OWN_PROCESS}
    if request.headers.get("if-none-match") == headers["etag"]:
        return Response(status_code=NOT_MODIFIED, headers=headers)
    return Response(content, found.status_code, headers, media_type="text/html")


@router.websocket("/{cell}")
async def viewer_socket(websocket: WebSocket, cell: str, gallery: GalleryDep) -> None:
    """What the viewer draws, passed on as it is. What the page sends cannot reach the robot: the viewer has no way to it."""
    await _connect_view(websocket, cell, "", gallery)


@router.websocket("/{cell}/{view}")
async def view_socket(websocket: WebSocket, cell: str, view: ViewPath, gallery: GalleryDep) -> None:
    """The same for a page that calls its view something, under which it says what it wants to see."""
    await _connect_view(websocket, cell, view, gallery)


async def _connect_view(websocket: WebSocket, cell: str, view: str, gallery: GalleryDep) -> None:
    try:
        port = await gallery.port(cell)
    except HeftError as error:
        await websocket.close(POLICY_VIOLATION, error.message.code)
        return
    offered = [Subprotocol(name) for name in websocket.scope.get("subprotocols", [])]
    inward = f"ws://127.0.0.1:{port}/{view}"
    async with connect(inward, subprotocols=offered or None, max_size=None, compression=None, proxy=None) as inner:
        await websocket.accept(inner.subprotocol)
        ways = [asyncio.create_task(_pass_inward(websocket, inner)), asyncio.create_task(_pass_outward(websocket, inner))]
        await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
        for way in ways:
            way.cancel()
        await asyncio.gather(*ways, return_exceptions=True)
    with suppress(RuntimeError, WebSocketDisconnect):
        await websocket.close(GOING_AWAY)


async def _pass_inward(websocket: WebSocket, inner: ClientConnection) -> None:
    with suppress(WebSocketDisconnect, ConnectionClosed, KeyError):
        while True:
            await inner.send(await websocket.receive_bytes())


async def _pass_outward(websocket: WebSocket, inner: ClientConnection) -> None:
    with suppress(WebSocketDisconnect, ConnectionClosed, RuntimeError):
        async for message in inner:
            await (websocket.send_text(message) if isinstance(message, str) else websocket.send_bytes(message))
