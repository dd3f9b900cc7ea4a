"""The way to a cell's viewer: on the same origin, for those who are signed in, and nowhere else."""

from __future__ import annotations

import asyncio
from contextlib import suppress

from fastapi import APIRouter, Request, Response, WebSocket
from fastapi.responses import RedirectResponse
from starlette.websockets import WebSocketDisconnect
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed
from websockets.typing import Subprotocol

from core.errors import HeftError
from server.viewer.gallery import GalleryDep

router = APIRouter(prefix="/viewer", tags=["viewer"], include_in_schema=False)

KEPT = ("content-type", "content-encoding", "etag", "cache-control")
POLICY_VIOLATION, GOING_AWAY = 1008, 1001


@router.get("/{cell}")
async def to_viewer(cell: str) -> RedirectResponse:
    """The page wants its slash."""
    return RedirectResponse(f"/viewer/{cell}/")


@router.get("/{cell}/{path:path}")
async def viewer_page(cell: str, path: str, request: Request, gallery: GalleryDep) -> Response:
    """The viewer's page and what belongs to it."""
    import httpx2  # noqa: PLC0415  the service starts sooner without it

    port = await gallery.port(cell)
    wanted = {name: request.headers[name] for name in ("accept-encoding", "if-none-match") if name in request.headers}
    async with (
        httpx2.AsyncClient(trust_env=False) as client,
        client.stream("GET", f"http://127.0.0.1:{port}/{path}", headers=wanted) as found,
    ):
        content = b"".join([chunk async for chunk in found.aiter_raw()])
    return Response(content, found.status_code, {name: found.headers[name] for name in KEPT if name in found.headers})


@router.websocket("/{cell}")
async def viewer_socket(websocket: WebSocket, cell: str, gallery: GalleryDep) -> None:
    """What the viewer draws, passed on as it is. What the page sends cannot reach the robot: the viewer has no way to it."""
    try:
        port = await gallery.port(cell)
    except HeftError as error:
        await websocket.close(POLICY_VIOLATION, error.message.code)
        return
    offered = [Subprotocol(name) for name in websocket.scope.get("subprotocols", [])]
    async with connect(f"ws://127.0.0.1:{port}", subprotocols=offered or None, max_size=None, compression=None, proxy=None) as inner:
        await websocket.accept(inner.subprotocol)
        ways = [asyncio.create_task(_pass_inward(websocket, inner)), asyncio.create_task(_pass_outward(websocket, inner))]
        await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
        for way in ways:
            way.cancel()
        await asyncio.gather(*ways, return_exceptions=True)
    with suppress(RuntimeError):
        await websocket.close(GOING_AWAY)


async def _pass_inward(websocket: WebSocket, inner: ClientConnection) -> None:
    with suppress(WebSocketDisconnect, ConnectionClosed, KeyError):
        while True:
            await inner.send(await websocket.receive_bytes())


async def _pass_outward(websocket: WebSocket, inner: ClientConnection) -> None:
    with suppress(WebSocketDisconnect, ConnectionClosed, RuntimeError):
        async for message in inner:
            await (websocket.send_text(message) if isinstance(message, str) else websocket.send_bytes(message))
