"""A Wi-Fi between a console and a service on one machine: a proxy that delays what passes, as radio does.

What one side sends is under way for as long as its profile draws, each direction by itself. TCP keeps the order, so what comes late holds
up all behind it on its connection. In a gap nothing arrives on any connection; what should have, arrives at its end.
"""

from __future__ import annotations

import asyncio
import threading
import time
from asyncio import Queue, StreamReader, StreamWriter
from collections.abc import Callable
from dataclasses import dataclass
from types import TracebackType
from typing import Self

import numpy as np
from numpy.typing import NDArray

GAP_EVERY_S = 60.0
GAP_S = (0.5, 2.0)
"""Shortest and longest gap."""
LARGEST_BYTES = 65_536
"""Of what is delayed as one."""
MOST_UNDER_WAY = 256
"""Pieces on one connection in one direction, before its sender has to wait."""


@dataclass(frozen=True)
class Profile:
    """How long something is under way in one direction.

    Args:
        one_way: (share that takes longer, s), from everything and the shortest to the least share and the longest; in between both
            are interpolated by their logarithms.
        gaps: whether nothing passes for a while every minute.
    """

    name: str
    one_way: tuple[tuple[float, float], ...]
    gaps: bool = False

    def drawn_s(self, rng: np.random.Generator, count: int) -> NDArray[np.float64]:
        """(count,), s, independent of each other."""
        shares, delays = np.log(np.array(self.one_way)).T
        return np.asarray(np.exp(np.interp(np.log1p(-rng.random(count)), shares[::-1], delays[::-1])))


_POOR = ((1.0, 0.0025), (0.5, 0.008), (0.1, 0.02), (5e-3, 0.138), (5e-4, 0.798), (1e-9, 0.9))
GOOD = Profile("good", ((1.0, 0.0025), (1e-9, 0.015)))
"""Round trip 5 to 30 ms."""
POOR = Profile("poor", _POOR)
"""Round trip 150 ms at the 99th percentile, 800 ms at the 99.9th; one way at most 900 ms, for whatever is longer is a gap."""
GAPS = Profile("gaps", _POOR, gaps=True)
"""As `POOR`; nothing passes for 0.5 to 2 s once a minute."""
PROFILES = {profile.name: profile for profile in (GOOD, POOR, GAPS)}


class Gaps:
    """One gap begins every 60 s, the first within 60 s of the line's beginning, uniformly; each is 0.5 to 2 s long, uniformly.

    Args:
        present: without it there is none.
    """

    def __init__(self, present: bool, seed: int) -> None:
        self._present, self._seed = present, seed
        self._first_s = float(np.random.default_rng((seed, 0)).uniform(0.0, GAP_EVERY_S))

    def _of(self, number: int) -> tuple[float, float]:
        begin = self._first_s + number * GAP_EVERY_S
        return begin, begin + float(np.random.default_rng((self._seed, 1, number)).uniform(*GAP_S))

    def within(self, begin_s: float, end_s: float) -> list[tuple[float, float]]:
        """Begin and end of the gaps that overlap with an interval, s since the line began."""
        if not self._present:
            return []
        numbers = range(max(0, int((begin_s - self._first_s) // GAP_EVERY_S)), max(0, int((end_s - self._first_s) // GAP_EVERY_S) + 1))
        found = [self._of(number) for number in numbers]
        return [(begin, end) for begin, end in found if begin <= end_s and end > begin_s]

    def passes_s(self, due_s: float) -> float:
        """When that arrives which should at `due_s`."""
        return max([due_s, *(end for begin, end in self.within(due_s, due_s) if begin <= due_s)])


class Way:
    """One direction of one connection."""

    def __init__(self, profile: Profile, gaps: Gaps, rng: np.random.Generator) -> None:
        self._profile, self._gaps, self._rng = profile, gaps, rng
        self._last_s = 0.0

    def arrival_s(self, sent_s: float) -> float:
        """When what is sent now arrives, s since the line began: never before what was sent earlier."""
        due_s = self._gaps.passes_s(sent_s + float(self._profile.drawn_s(self._rng, 1)[0]))
        self._last_s = max(self._last_s, due_s)
        return self._last_s


class WifiLine:
    """Listens on a port of its own and passes everything on, late.

    Args:
        port: of the service on this machine.
        seed: of the delays, by the order of connections and of what is sent on each, and of the gaps.
    """

    def __init__(self, port: int, profile: Profile, seed: int = 0, clock: Callable[[], float] = time.monotonic) -> None:
        self.profile, self.gaps = profile, Gaps(profile.gaps, seed)
        self._to, self._seed, self._clock = port, seed, clock
        self._connections = 0
        self._began_s = clock()
        self._ready = threading.Event()
        self._thread = threading.Thread(target=lambda: asyncio.run(self._serve()), name="wifi", daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        self._ready.wait()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        self._loop.call_soon_threadsafe(self._over.set)
        self._thread.join()

    @property
    def address(self) -> str:
        """To connect to instead of the service's."""
        return f"127.0.0.1:{self._port}"

    @property
    def now_s(self) -> float:
        """Since it began."""
        return self._clock() - self._began_s

    async def _serve(self) -> None:
        self._loop, self._over = asyncio.get_running_loop(), asyncio.Event()
        server = await asyncio.start_server(self._connected, "127.0.0.1", 0)
        self._port: int = server.sockets[0].getsockname()[1]
        self._ready.set()
        await self._over.wait()
        server.close()

    async def _connected(self, reader: StreamReader, writer: StreamWriter) -> None:
        out, back = (Way(self.profile, self.gaps, np.random.default_rng((self._seed, 2, self._connections, k))) for k in range(2))
        self._connections += 1
        try:
            far_reader, far_writer = await asyncio.open_connection("127.0.0.1", self._to)
        except OSError:  # nobody listens there now
            writer.close()
            return
        try:
            async with asyncio.TaskGroup() as both:
                both.create_task(self._carry(reader, far_writer, out))
                both.create_task(self._carry(far_reader, writer, back))
        except* OSError:  # one side is gone without a word: so is the other then
            writer.transport.abort()
            far_writer.transport.abort()
        finally:
            writer.close()
            far_writer.close()

    async def _carry(self, reader: StreamReader, writer: StreamWriter, way: Way) -> None:
        under_way: Queue[tuple[float, bytes]] = Queue(MOST_UNDER_WAY)
        async with asyncio.TaskGroup() as both:
            both.create_task(self._deliver(under_way, writer))
            piece = b"-"
            while piece:
                piece = await reader.read(LARGEST_BYTES)
                await under_way.put((way.arrival_s(self.now_s), piece))

    async def _deliver(self, under_way: Queue[tuple[float, bytes]], writer: StreamWriter) -> None:
        """An empty piece is the end."""
        while True:
            arrives_s, piece = await under_way.get()
            await asyncio.sleep(max(0.0, arrives_s - self.now_s))
            if not piece:
                writer.write_eof()
                return
            writer.write(piece)
            await writer.drain()
