"""Who asked to be told is told when a run has ended: signed, at least once, again until it is taken or three days have passed."""

from __future__ import annotations

import asyncio
import hmac
import json
import logging
from collections.abc import Callable
from datetime import datetime, timedelta
from functools import cached_property
from hashlib import sha256
from typing import TYPE_CHECKING, Annotated

from sqlalchemy import select
from sqlalchemy.exc import SQLAlchemyError
from sqlalchemy.orm import Session

from core.words.message import Message
from server.http.dependencies import depend_on
from server.runs.reason import dump_message
from server.runs.schemas import RunPublic
from server.runs.tables import Delivery, Webhook
from server.store.store import Store

if TYPE_CHECKING:  # the service starts sooner without it
    import httpx2

log = logging.getLogger("heft.webhooks")

SIGNATURE, TIMESTAMP, DELIVERY = "Heft-Signature", "Heft-Timestamp", "Heft-Delivery"
TIMEOUT_S = 5.0
LONGEST_WAIT_S = 3600
GIVE_UP_AFTER = timedelta(days=3)
POLL_S = 1.0


def enqueue(db: Session, run: RunPublic, new_id: Callable[[datetime], str], now: datetime) -> None:
    """One delivery to each webhook, in the transaction that ends the run: none is lost, whatever happens next."""
    body = run.model_dump_json()
    for webhook in db.scalars(select(Webhook)):
        db.add(Delivery(id=new_id(now), webhook=webhook.id, body=body, attempts=0, made_at=now, due_at=now))


def add_test(db: Session, webhook: str, new_id: Callable[[datetime], str], now: datetime) -> Delivery:
    """A delivery that tells of no run; it is sent once, by whoever asked for it, and is never due."""
    body = json.dumps({"test": True, "webhook": webhook, "sent_at": now.isoformat()})
    delivery = Delivery(id=new_id(now), webhook=webhook, body=body, attempts=0, made_at=now, due_at=None)
    db.add(delivery)
    return delivery


def signature(secret: str, timestamp: str, body: str) -> str:
    """HMAC-SHA-256 over the time and the body, hexadecimal."""
    return hmac.new(secret.encode(), f"{timestamp}.{body}".encode(), sha256).hexdigest()


class Deliverer:
    """Sends what is due."""

    def __init__(self, store: Store, now: Callable[[], datetime], transport: httpx2.AsyncBaseTransport | None = None) -> None:
        self._store, self._now, self._transport = store, now, transport
        self._task: asyncio.Task[None] | None = None

    @cached_property
    def _client(self) -> httpx2.AsyncClient:
        import httpx2  # noqa: PLC0415 - nothing may ever be due

        return httpx2.AsyncClient(timeout=TIMEOUT_S, follow_redirects=False, transport=self._transport, trust_env=False)

    async def start(self) -> None:
        """Goes on until `close`."""
        self._task = asyncio.create_task(self._run_forever())

    async def close(self) -> None:
        """What is not delivered stays in the store."""
        if self._task is not None:
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)
        if "_client" in vars(self):  # there was something to send
            await self._client.aclose()

    async def _run_forever(self) -> None:
        while True:
            try:
                await self.deliver_due()
            except SQLAlchemyError:
                log.exception("deliveries could not be read")
            await asyncio.sleep(POLL_S)

    async def deliver_due(self) -> int:
        """Sends everything that is due, side by side, and returns how many there were."""
        due = await asyncio.to_thread(self._due)
        await asyncio.gather(*(self.deliver(delivery, webhook) for delivery, webhook in due))
        return len(due)

    def _due(self) -> list[tuple[Delivery, Webhook]]:
        query = select(Delivery, Webhook).join(Webhook, Webhook.id == Delivery.webhook)
        query = query.where(Delivery.due_at <= self._now()).order_by(Delivery.due_at).limit(20)
        with self._store.read() as db:
            return [(delivery, webhook) for delivery, webhook in db.execute(query)]

    async def deliver(self, delivery: Delivery, webhook: Webhook) -> None:
        """Sends one message now, and notes what came of it."""
        timestamp = str(round(self._now().timestamp()))
        signed = f"sha256={signature(webhook.secret, timestamp, delivery.body)}"
        headers = {"Content-Type": "application/json", DELIVERY: delivery.id, TIMESTAMP: timestamp, SIGNATURE: signed}
        import httpx2  # noqa: PLC0415 - nothing may ever be due

        try:
            answer = await self._client.post(webhook.url, content=delivery.body, headers=headers)
            error = None if answer.is_success else Message.of("runs-delivery-refused", status=answer.status_code)
        except (httpx2.HTTPError, httpx2.InvalidURL) as failure:
            error = Message.of("runs-delivery-failed", error=type(failure).__name__, reason=str(failure)[:300])
        await asyncio.to_thread(self._note, delivery.id, error)

    def _note(self, delivery: str, error: Message | None) -> None:
        now = self._now()
        with self._store.write() as db:
            row = db.get(Delivery, delivery)
            if row is None:
                return
            row.attempts, row.last_error = row.attempts + 1, None if error is None else dump_message(error)
            if error is None:
                row.delivered_at, row.due_at = now, None
            elif row.due_at is not None:
                row.due_at = now + timedelta(seconds=min(2 ** min(row.attempts, 20), LONGEST_WAIT_S))
                row.due_at = None if row.due_at - row.made_at > GIVE_UP_AFTER else row.due_at


DelivererDep = Annotated[Deliverer, depend_on("deliverer")]
