"""Messages of viser reach a page that begins to wait for them just as they are written.

viser 1.1.1 sets an `asyncio.Event` from the thread that draws. An event belongs to its loop: set between the look at its value and the wait
for it, it wakes nobody, and as it is set then, setting it again wakes nobody either. A page that has been hit stands still from there on.
"""

from __future__ import annotations

import asyncio
from dataclasses import dataclass, field

from viser.infra import _infra
from viser.infra._async_message_buffer import AsyncMessageBuffer


class LoopEvent(asyncio.Event):
    """Can be set in its loop alone; from elsewhere by `call_soon_threadsafe`, which viser does each time, too."""

    def set(self) -> None:
        """Nothing in another thread."""
        if asyncio._get_running_loop() is not None:
            super().set()


@dataclass
class WakenedBuffer(AsyncMessageBuffer):
    """What has been drawn, for those who look and for those to come."""

    message_event: asyncio.Event = field(default_factory=LoopEvent)


def wake_pages() -> None:
    """Has all servers of viser that are begun from now on use it."""
    _infra.AsyncMessageBuffer = WakenedBuffer  # type: ignore[attr-defined]  # it offers no other way to name a buffer
