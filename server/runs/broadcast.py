"""One run's events and samples to everybody who watches, each at their own pace.

One plain loop of `await client.send()` stands still for all as soon as one client does not read. Here every client has a bounded
queue: of samples the newest win, events are never dropped; who does not take an event for `PATIENCE_S` is closed.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import AsyncIterator, Awaitable, Callable

from core.errors import HeftError
from server.runner.live_schemas import LiveBatch

MOST_SAMPLES = 10
"""Batches of samples that wait for one client: a fifth of a second."""
MOST_EVENTS = 2000
"""A run has some hundred; who falls behind by more is closed and resumes by sequence number."""
PATIENCE_S = 4.0
"""How long one message may take to leave."""


class TooSlowError(HeftError):
    """A client that does not read what it is sent."""


class Subscription:
    """What one client has not been sent yet.

    Args:
        thin: whether every second batch with its newest sample is enough, as for a screen that draws them.
    """

    def __init__(self, *, thin: bool = False) -> None:
        self.thin = thin
        self._events: deque[tuple[int, str]] = deque()
        self._samples: deque[str] = deque(maxlen=MOST_SAMPLES)
        self._something = asyncio.Event()
        self._ended = False
        self._overrun = False

    def event(self, sequence: int, text: str) -> None:
        """Something that must arrive."""
        self._overrun = self._overrun or len(self._events) >= MOST_EVENTS
        if not self._overrun:
            self._events.append((sequence, text))
        self._something.set()

    def samples(self, text: str) -> None:
        """Something that is soon replaced by something newer."""
        self._samples.append(text)
        self._something.set()

    def end(self) -> None:
        """Nothing more will come."""
        self._ended = True
        self._something.set()

    async def messages(self, after: int = 0) -> AsyncIterator[str]:
        """Events behind a sequence number first, in their order, then the newest samples; until the end.

        Raises:
            TooSlowError: more events wait than a client may leave waiting.
        """
        while True:
            await self._something.wait()
            self._something.clear()
            while self._events or self._samples:
                sequence, text = self._events.popleft() if self._events else (after + 1, self._samples.popleft())
                if sequence > after:
                    yield text
            if self._overrun:
                raise TooSlowError("runs-watcher-behind", events=MOST_EVENTS)
            if self._ended:
                return


class Broadcast:
    """Of one run."""

    def __init__(self) -> None:
        self._subscriptions: set[Subscription] = set()
        self._batches = 0
        self._ended = False

    def __len__(self) -> int:
        """How many watch."""
        return len(self._subscriptions)

    def subscribe(self, *, thin: bool = False) -> Subscription:
        """Everything from now on; where it is `thin`, less of the samples."""
        subscription = Subscription(thin=thin)
        self._subscriptions.add(subscription)
        if self._ended:
            subscription.end()
        return subscription

    def unsubscribe(self, subscription: Subscription) -> None:
        """The client is gone."""
        self._subscriptions.discard(subscription)

    def event(self, sequence: int, text: str) -> None:
        """To everybody, whatever it takes; sequence numbers count up."""
        for subscription in self._subscriptions:
            subscription.event(sequence, text)

    def samples(self, batch: LiveBatch) -> None:
        """To everybody who keeps up; written only as somebody watches it."""
        self._batches += 1
        all_of_it = [each for each in self._subscriptions if not each.thin]
        thin = [each for each in self._subscriptions if each.thin] if self._batches % 2 else []
        for seen, watching in ((batch, all_of_it), (batch.newest_row, thin)):
            text = seen.model_dump_json() if watching else ""
            for subscription in watching:
                subscription.samples(text)

    def end(self) -> None:
        """The run is over."""
        self._ended = True
        for subscription in self._subscriptions:
            subscription.end()


async def drain(
    subscription: Subscription, send: Callable[[str], Awaitable[None]], *, after: int = 0, patience_s: float = PATIENCE_S
) -> None:
    """Sends one client everything behind a sequence number until the run is over.

    Raises:
        TooSlowError: a message did not leave within `patience_s`, or too many events wait.
    """
    async for text in subscription.messages(after):
        try:
            async with asyncio.timeout(patience_s):
                await send(text)
        except TimeoutError:
            raise TooSlowError("runs-watcher-too-slow", limit_s=patience_s) from None
