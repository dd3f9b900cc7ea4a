"""The server's end of a control process."""

from __future__ import annotations

import asyncio
import logging
import threading
from collections.abc import AsyncIterator
from multiprocessing.connection import Connection
from multiprocessing.context import ForkServerProcess

from core.sessions.leased import Renewal
from core.words.message import Message
from server.runner.context import CONTEXT, start_process
from server.runner.messages import Beat, Failed, FromChild, Order, PageLate, ToChild
from server.runner.pipe import Speaker

log = logging.getLogger("heft.runs")

CONTROL = "server.runner.control"
"""The module whose `main` controls a robot."""


class ControlProcess:
    """One run's process; belongs to the running event loop, which does not wait until it is there.

    A service that has just begun is still importing the engine: its first process comes seconds later. What it is told until then waits in
    the pipe.

    Args:
        order: what it is to do.
    """

    def __init__(self, order: Order) -> None:
        self._connection, theirs = CONTEXT.Pipe()
        self._speaker: Speaker[ToChild] = Speaker(self._connection, Renewal, Beat, PageLate)
        self._heard: asyncio.Queue[FromChild | None] = asyncio.Queue()
        self._loop = asyncio.get_running_loop()
        self._process: ForkServerProcess | None = None
        self._lock = threading.Lock()
        self._killed = False
        threading.Thread(target=self._run, args=(order, theirs), name="runner", daemon=True).start()

    def tell(self, message: ToChild) -> None:
        """Returns at once."""
        self._speaker.tell(message)

    async def messages(self) -> AsyncIterator[FromChild]:
        """What the process says until it has ended; a `Failed` of our own where it died without a word."""
        last: FromChild | None = None
        while (message := await self._heard.get()) is not None:
            last = message
            yield message
        code = await asyncio.to_thread(self._join)
        if code != 0 and not isinstance(last, Failed):
            yield Failed("ControlProcessLost", _describe_end(code))

    def kill(self) -> None:
        """For a process that does not end when it is told to."""
        with self._lock:
            self._killed = True
            if self._process is not None:
                self._process.kill()

    def _join(self) -> int | None:
        """The exit code; None of a process that could not be started."""
        if self._process is None:
            return None
        self._process.join()
        return self._process.exitcode

    def _run(self, order: Order, theirs: Connection) -> None:
        try:
            process = start_process(CONTROL, order, theirs, name=f"heft-run-{order.run}")
        except (OSError, EOFError):
            log.exception("the control process of run %s could not be started", order.run)
            self._loop.call_soon_threadsafe(self._heard.put_nowait, None)
            return
        finally:
            theirs.close()
        with self._lock:
            self._process = process
            if self._killed:
                process.kill()
        self._listen()

    def _listen(self) -> None:
        while True:
            try:
                message = self._connection.recv()
            except (EOFError, OSError):
                message = None
            self._loop.call_soon_threadsafe(self._heard.put_nowait, message)
            if message is None:
                return


def _describe_end(code: int | None) -> Message:
    return Message.of("runs-control-process-not-started") if code is None else Message.of("runs-control-process-lost", exit_code=code)
