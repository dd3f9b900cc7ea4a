"""A control process that does nothing by itself: the test says what its robot does."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator

from server.runner.messages import End, Failed, FromChild, Hold, Order, Release, Resume, ToChild
from tests.server.sentence import sentence


class ScriptedProcess:
    """In place of `server.runner.process.ControlProcess`; `newest` is the last one that was made."""

    newest: ScriptedProcess

    def __init__(self, order: Order) -> None:
        self.order = order
        self.told: list[ToChild] = []
        self._loop = asyncio.get_running_loop()
        self._said: asyncio.Queue[FromChild | None] = asyncio.Queue()
        ScriptedProcess.newest = self

    def tell(self, message: ToChild) -> None:
        if isinstance(message, End | Hold | Release | Resume):
            self.told.append(message)

    def say(self, *messages: FromChild | None) -> None:
        """From the test's thread; None is the end of the process."""
        for message in messages:
            self._loop.call_soon_threadsafe(self._said.put_nowait, message)

    async def messages(self) -> AsyncIterator[FromChild]:
        while (message := await self._said.get()) is not None:
            yield message

    def kill(self) -> None:
        self.say(Failed("ControlProcessLost", sentence("killed")), None)


class ObedientProcess(ScriptedProcess):
    """It plans nothing, and ends when it is told to."""

    def tell(self, message: ToChild) -> None:
        super().tell(message)
        if isinstance(message, End):
            self.say(Failed("Commanded", message.reason), None)
