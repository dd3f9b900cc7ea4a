"""A websocket that says what there is to say as it changes, without being asked; it ends with the other side."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from contextlib import suppress
from typing import TypeVar

from fastapi import WebSocket
from pydantic import BaseModel
from starlette.websockets import WebSocketDisconnect

LOOK_S = 0.1
"""How often it is looked whether something has changed."""
PATIENCE_S = 4.0
"""How long one message may take to leave."""

State = TypeVar("State")


async def keep_telling(
    websocket: WebSocket, look: Callable[[], State], word: Callable[[State, bool], Awaitable[BaseModel]], pulse_s: float
) -> None:
    """Accepts it and tells, until the other side is gone or does not read.

    Args:
        look: what is told at once when it has changed.
        word: the message of it, given whether it has changed since the last one.
        pulse_s: time after which something is told although nothing has changed, so that silence means a lost connection.
    """
    loop = asyncio.get_running_loop()

    async def keep() -> None:
        said, at = None, loop.time()
        while True:
            state = look()
            if state != said or loop.time() - at >= pulse_s:
                async with asyncio.timeout(PATIENCE_S):
                    message = await word(state, state != said)
                    await websocket.send_text(message.model_dump_json())
                said, at = state, loop.time()
            await asyncio.sleep(LOOK_S)

    async def wait_until_gone() -> None:
        with suppress(WebSocketDisconnect):
            while True:
                await websocket.receive_text()

    await websocket.accept()
    tasks = [asyncio.create_task(keep()), asyncio.create_task(wait_until_gone())]
    done, pending = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    for task in pending:
        task.cancel()
    for task in done:
        with suppress(WebSocketDisconnect, RuntimeError, TimeoutError):  # RuntimeError: closed while something was sent
            await task
