"""Who watches slowly loses samples, never events, and holds nobody up."""

from __future__ import annotations

import asyncio
import json

import pytest

from server.runner.live_schemas import LiveBatch
from server.runs.broadcast import MOST_EVENTS, MOST_SAMPLES, Broadcast, TooSlowError, drain


def batch(k: int) -> LiveBatch:
    """Of two samples, at 10 k and 10 k + 1 s."""
    times = [10.0 * k, 10.0 * k + 1.0]
    return LiveBatch(
        phase="hold:x+", t_s=times, wrench=[[t] * 6 for t in times], reconstructed=None, phi=[None] * 10, phi_std=[None] * 10,
        q_rad=[0.0], nearest=None, progress=0.5, eta_s=None,
    )  # fmt: skip


def times_of(texts: list[str]) -> list[list[float]]:
    """Of the samples in each batch."""
    return [json.loads(text)["t_s"] for text in texts if text[0] == "{"]


async def collected(broadcast: Broadcast, into: list[str]) -> None:
    async def send(text: str) -> None:
        into.append(text)

    await drain(broadcast.subscribe(), send)


def test_everybody_gets_every_event_in_order_and_the_end():
    async def scene() -> tuple[list[str], list[str]]:
        broadcast, first, second = Broadcast(), [], []
        async with asyncio.TaskGroup() as tasks:
            tasks.create_task(collected(broadcast, first))
            tasks.create_task(collected(broadcast, second))
            await asyncio.sleep(0)
            for k in range(500):
                broadcast.event(k + 1, f"e{k}")
            broadcast.end()
        return first, second

    first, second = asyncio.run(scene())
    assert first == second == [f"e{k}" for k in range(500)]


def test_of_samples_the_newest_win_and_events_between_them_stay():
    async def scene() -> list[str]:
        broadcast, seen = Broadcast(), []
        subscription = broadcast.subscribe()
        for k in range(1000):
            broadcast.samples(batch(k))
            if k % 100 == 0:
                broadcast.event(k + 1, f"e{k}")
        broadcast.end()

        async def send(text: str) -> None:
            seen.append(text)

        await drain(subscription, send)
        return seen

    seen = asyncio.run(scene())
    assert [text for text in seen if text[0] == "e"] == [f"e{k}" for k in range(0, 1000, 100)]
    assert times_of(seen) == [batch(k).t_s for k in range(1000 - MOST_SAMPLES, 1000)]


def test_a_client_that_does_not_read_is_given_up_while_the_others_lose_nothing():
    async def scene() -> tuple[bool, list[str]]:
        broadcast, seen, closed = Broadcast(), [], []

        async def stuck() -> None:
            async def never(_: str) -> None:
                await asyncio.Event().wait()

            try:
                await drain(broadcast.subscribe(), never, patience_s=0.05)
            except TooSlowError:
                closed.append(True)

        async with asyncio.TaskGroup() as tasks:
            stalled = tasks.create_task(stuck())
            tasks.create_task(collected(broadcast, seen))
            await asyncio.sleep(0)
            k = 0
            while not stalled.done():
                broadcast.event(k + 1, f"e{k}")
                k += 1
                await asyncio.sleep(0)
            broadcast.end()
        return closed == [True], [seen == [f"e{j}" for j in range(k)]]

    closed, complete = asyncio.run(scene())
    assert closed
    assert complete == [True]


def test_events_that_nobody_takes_end_the_subscription_instead_of_filling_the_memory():
    async def scene() -> None:
        broadcast = Broadcast()
        subscription = broadcast.subscribe()
        for k in range(3 * MOST_EVENTS):
            broadcast.event(k + 1, f"e{k}")

        async def send(_: str) -> None: ...

        await drain(subscription, send)

    with pytest.raises(TooSlowError, match=str(MOST_EVENTS)):
        asyncio.run(scene())


def test_who_comes_after_the_end_is_told_so_at_once():
    broadcast = Broadcast()
    broadcast.end()
    seen: list[str] = []
    asyncio.run(collected(broadcast, seen))
    assert seen == []


def test_what_a_client_knows_already_is_not_sent_again():
    broadcast, seen = Broadcast(), []
    subscription = broadcast.subscribe()
    for k in range(10):
        broadcast.event(k, f"e{k}")
    broadcast.end()

    async def send(text: str) -> None:
        seen.append(text)

    asyncio.run(drain(subscription, send, after=6))
    assert seen == ["e7", "e8", "e9"]


def test_a_thin_subscription_gets_the_newest_sample_of_every_second_batch_and_every_event():
    broadcast, seen = Broadcast(), []
    subscription = broadcast.subscribe(thin=True)
    for k in range(6):
        broadcast.samples(batch(k))
    broadcast.event(1, "e1")
    broadcast.end()

    async def send(text: str) -> None:
        seen.append(text)

    asyncio.run(drain(subscription, send))
    assert seen[0] == "e1"
    assert times_of(seen) == [[1.0], [21.0], [41.0]]
    assert [json.loads(text)["wrench"] for text in seen[1:]] == [[[t] * 6] for t in (1.0, 21.0, 41.0)]
