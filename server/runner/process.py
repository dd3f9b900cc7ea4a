"""The server's end of a control process."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import AsyncIterator

from core.sessions.leased import Renewal
from server.runner.context import CONTEXT, started
from server.runner.messages import Failed, FromChild, Order, ToChild
from server.runner.pipe import Speaker

CONTROL = "server.runner.control"
"""The module whose `main` controls a robot."""


class ControlProcess:
    """One run's process; belongs to the running event loop.

    Args:
        order: what it is to do.
    """

    def __init__(self, order: Order) -> None:
        self._connection, theirs = CONTEXT.Pipe()
        self._process = started(CONTROL, order, theirs, name=f"heft-run-{order.run}")
        theirs.close()
        self._speaker: Speaker[ToChild] = Speaker(self._connection, Renewal)
        self._heard: asyncio.Queue[FromChild | None] = asyncio.Queue()
        self._loop = asyncio.get_running_loop()
        threading.Thread(target=self._listen, name="runner", daemon=True).start()

    @property
    def pid(self) -> int:
        """Of the process."""
        return self._process.pid or 0

    def tell(self, message: ToChild) -> None:
        """Returns at once."""
        self._speaker.tell(message)

    async def messages(self) -> AsyncIterator[FromChild]:
        """What the process says until it has ended; a `Failed` of our own where it died without a word."""
        last: FromChild | None = None
        while (message := await self._heard.get()) is not None:
            last = message
            yield message
        await asyncio.to_thread(self._process.join)
        if self._process.exitcode != 0 and not isinstance(last, Failed):
            code = self._process.exitcode
            yield Failed("ControlProcessLost", f"the control process ended with code {code}; its robot got no more commands. See the log.")

    def kill(self) -> None:
        """For a process that does not end when it is told to."""
        self._process.kill()

    def _listen(self) -> None:
        while True:
            try:
                message = self._connection.recv()
            except (EOFError, OSError):
                message = None
            self._loop.call_soon_threadsafe(self._heard.put_nowait, message)
            if message is None:
                return
