"""Webhooks: signed, at least once, again after failures, until they are given up."""

from __future__ import annotations

import asyncio
import hashlib
import hmac
from collections.abc import Iterator
from datetime import timedelta

import httpx2
import pytest

from server.runs import ledger as run_ledger
from server.runs.schemas import RunCreate
from server.runs.tables import Delivery, Webhook
from server.runs.webhooks import GIVE_UP_AFTER, Deliverer, enqueue
from server.settings import Settings
from tests.server.kept import Kept, kept
from tests.server.made_people import BOTH_STORES, Clock

SECRET = "0123456789abcdef"


pytestmark = BOTH_STORES


@pytest.fixture
def service(settings: Settings, clock: Clock) -> Iterator[Kept]:
    with kept(settings, clock) as found:
        yield found


class Plant:
    """Takes deliveries after so many failures, and keeps what it was sent."""

    def __init__(self, failures: int) -> None:
        self.failures = failures
        self.seen: list[httpx2.Request] = []

    def __call__(self, request: httpx2.Request) -> httpx2.Response:
        self.seen.append(request)
        if len(self.seen) <= self.failures:
            if len(self.seen) % 2:
                raise httpx2.ConnectTimeout("no answer", request=request)
            return httpx2.Response(503)
        return httpx2.Response(204)


def due(service: Kept) -> None:
    now = service.now()
    with service.store.write() as db:
        db.add(Webhook(id="hook", url="http://plant/ended", secret=SECRET, made_by="account:anna", made_at=now))
        db.flush()
        row = run_ledger.add_run(db, RunCreate(cell="lwr4_bench", payload="steel_block"), "key:mes", now)
        enqueue(db, run_ledger.build_answer(row), run_ledger.new_id, now)


def delivery(service: Kept) -> Delivery:
    with service.store.read() as db:
        return db.query(Delivery).one()


def deliver(service: Kept, clock: Clock, plant: Plant, rounds: int) -> Deliverer:
    async def work() -> None:
        deliverer = Deliverer(service.store, clock, httpx2.MockTransport(plant))
        for _ in range(rounds):
            await deliverer.deliver_due()
            clock.go_on(hours=1, seconds=1)
        await deliverer.close()

    asyncio.run(work())


def test_a_delivery_carries_its_id_and_a_signature_that_the_plant_can_check(service, clock):
    due(service)
    plant = Plant(failures=0)
    deliver(service, clock, plant, rounds=3)
    (request,) = plant.seen
    signed = f"{request.headers['Heft-Timestamp']}.{request.content.decode()}".encode()
    expected = hmac.new(SECRET.encode(), signed, hashlib.sha256).hexdigest()
    assert request.headers["Heft-Signature"] == f"sha256={expected}"
    assert request.headers["Heft-Delivery"] == delivery(service).id
    assert delivery(service).delivered_at is not None


def test_failures_are_tried_again_under_the_same_id_until_it_is_taken(service, clock):
    due(service)
    plant = Plant(failures=4)
    deliver(service, clock, plant, rounds=8)
    assert len(plant.seen) == 5
    assert len({request.headers["Heft-Delivery"] for request in plant.seen}) == 1
    assert delivery(service).attempts == 5
    assert delivery(service).due_at is None


def test_a_plant_that_never_answers_is_given_up_after_three_days_and_the_last_error_is_kept(service, clock):
    due(service)
    began = clock()
    plant = Plant(failures=10_000)
    deliver(service, clock, plant, rounds=round(GIVE_UP_AFTER / timedelta(hours=1)) + 5)
    found = delivery(service)
    assert found.due_at is None
    assert found.delivered_at is None
    assert "503" in found.last_error or "ConnectTimeout" in found.last_error
    assert len(plant.seen) < (clock() - began) / timedelta(hours=1)
