"""While a robot moves its state has to be kept: a store that is locked or away is noticed at once, also when nothing is to be written."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from sqlalchemy.exc import SQLAlchemyError

from server.store import Store

log = logging.getLogger("heft.runs")

LATE_S = 0.15
"""A write that takes longer is too late for a robot that moves."""
PERIOD_S = 0.05
"""Of the looks at a store that nobody writes to."""

Found = TypeVar("Found")


class StoreWatch:
    """Does one run's writes, one after the other in a thread of their own, and looks at the store in between.

    Args:
        moving: whether it matters now.
        too_late: is told, once or several times, with a sentence.
    """

    def __init__(self, store: Store, moving: Callable[[], bool], too_late: Callable[[str], None]) -> None:
        self._store, self._moving, self._too_late = store, moving, too_late
        self._writer = ThreadPoolExecutor(1, "run-store")

    def close(self) -> None:
        """What is being written may still end."""
        self._writer.shutdown(wait=False)

    async def written(self, write: Callable[[], Found]) -> Found:
        """Writes; where that takes too long, it is told while it goes on."""
        loop = asyncio.get_running_loop()
        late = loop.call_later(LATE_S, self._tell)
        try:
            return await loop.run_in_executor(self._writer, write)
        finally:
            late.cancel()

    async def look(self) -> None:
        """Goes on until it is cancelled."""
        while True:
            await asyncio.sleep(PERIOD_S)
            if self._moving():
                try:
                    await self.written(self._store.check_writable)
                except SQLAlchemyError as error:
                    log.error("the store cannot be written: %s", type(error).__name__)
                    self._tell()

    def _tell(self) -> None:
        if self._moving():
            limit = f"{1e3 * LATE_S:.0f} ms"
            self._too_late(f"the run's state could not be written within {limit}; the robot was stopped. See to the database and its disk.")
