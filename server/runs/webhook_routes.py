"""Who is told when a run has ended."""

from __future__ import annotations

import asyncio
import json
import secrets
from datetime import datetime
from typing import Annotated

from fastapi import APIRouter
from pydantic import AnyHttpUrl, Field, SecretStr, StringConstraints, UrlConstraints
from sqlalchemy import select

from core.words.message import Message
from server.http.dependencies import NowDep, StoreDep
from server.http.errors import NotFound
from server.http.parameters import WebhookPath
from server.http.schemas import Answer, RequestBody
from server.people import audit
from server.people.auth import CallerDep
from server.runs import ledger as run_ledger
from server.runs import webhooks
from server.runs.tables import Delivery, Webhook
from server.runs.webhooks import DelivererDep

router = APIRouter(prefix="/api/webhooks", tags=["webhooks"])


class WebhookCreate(RequestBody):
    """Where to send; a secret is made where none is given."""

    url: Annotated[AnyHttpUrl, UrlConstraints(max_length=500)] = Field(
        description="Where the end of every run is sent, `http` or `https`.", examples=["https://mes.plant/hooks/heft"]
    )
    secret: Annotated[SecretStr, StringConstraints(min_length=16, max_length=128)] | None = Field(
        default=None, description="Signs what is sent, 16 to 128 characters; made where null.", examples=["a secret of sixteen or more"]
    )


class WebhookPublic(Answer):
    """A webhook; its secret is shown once, when it is made."""

    id: str = Field(description="Identifier of the webhook.", examples=["019ab1b0c0d1e2f3a4b5c6"])
    url: str = Field(description="Where the end of every run is sent.", examples=["https://mes.plant/hooks/heft"])
    made_by: str = Field(description="Who made it.", examples=["account:admin"])
    made_at: datetime = Field(description="When it was made.", examples=["2026-03-01T07:00:00Z"])
    secret: str | None = Field(default=None, description="Signs what is sent; shown once, when it is made.", examples=["Yw5Qm0bXb1l2Vx3k"])


class DeliveryPublic(Answer):
    """One message. `due_at` is null once it is delivered or given up; a test is sent once."""

    id: str = Field(description="Identifier of the message, as in the header `Heft-Delivery`.", examples=["019ab1c2ffe0d1c2b3a495"])
    run: str | None = Field(description="The run whose end it tells of; null for a test.", examples=["019ab1c2d3e44f1c2a9be7"])
    attempts: int = Field(description="How often it was tried.", examples=[1])
    made_at: datetime = Field(description="When the run ended.", examples=["2026-03-01T08:00:24Z"])
    due_at: datetime | None = Field(
        description="When it is tried again; null once it is delivered or given up.", examples=["2026-03-01T08:00:26Z"]
    )
    delivered_at: datetime | None = Field(description="When it was taken; null before.", examples=["2026-03-01T08:00:24Z"])
    last_error: Message | None = Field(description="Why the last try failed; null where it did not.")


LINKS = {
    "deliveries": {"operationId": "list_deliveries", "parameters": {"webhook": "$response.body#/id"}},
    "test": {"operationId": "test_webhook", "parameters": {"webhook": "$response.body#/id"}},
    "remove": {"operationId": "remove_webhook", "parameters": {"webhook": "$response.body#/id"}},
}
"""What can be asked of the webhook that was made (OpenAPI link objects)."""


@router.post("", status_code=201, responses={201: {"links": LINKS}})
def add_webhook(body: WebhookCreate, store: StoreDep, caller: CallerDep, now: NowDep) -> WebhookPublic:
    """Every run's end is sent there from now on, signed: `Heft-Signature: sha256=HMAC(secret, timestamp + "." + body)`."""
    secret = secrets.token_urlsafe(32) if body.secret is None else body.secret.get_secret_value()
    row = Webhook(id=run_ledger.new_id(now), url=str(body.url), secret=secret, made_by=caller.who, made_at=now)
    with store.write() as db:
        db.add(row)
        audit.record(db, caller.who, "webhook.create", {"webhook": row.id, "url": row.url}, now=now)
    return WebhookPublic(id=row.id, url=row.url, made_by=row.made_by, made_at=row.made_at, secret=secret)


@router.get("")
def list_webhooks(store: StoreDep) -> list[WebhookPublic]:
    """All, without their secrets."""
    with store.read() as db:
        rows = db.scalars(select(Webhook).order_by(Webhook.id))
        return [WebhookPublic(id=row.id, url=row.url, made_by=row.made_by, made_at=row.made_at) for row in rows]


@router.delete("/{webhook}", status_code=204)
def remove_webhook(webhook: WebhookPath, store: StoreDep, caller: CallerDep, now: NowDep) -> None:
    """Nothing is sent there any more, also not what is still due."""
    with store.write() as db:
        row = _require(db.get(Webhook, webhook), webhook)
        for delivery in db.scalars(select(Delivery).where(Delivery.webhook == webhook)):
            db.delete(delivery)
        db.flush()
        db.delete(row)
        audit.record(db, caller.who, "webhook.remove", {"webhook": webhook}, now=now)


@router.post("/{webhook}/test")
async def test_webhook(webhook: WebhookPath, store: StoreDep, deliverer: DelivererDep, caller: CallerDep, now: NowDep) -> DeliveryPublic:
    """Sends `{"test": true, "webhook": ..., "sent_at": ...}` at once, signed like every delivery, and answers with what came of it."""

    def begin() -> tuple[Delivery, Webhook]:
        with store.write() as db:
            row = _require(db.get(Webhook, webhook), webhook)
            audit.record(db, caller.who, "webhook.test", {"webhook": webhook}, now=now)
            return webhooks.add_test(db, webhook, run_ledger.new_id, now), row

    def outcome() -> DeliveryPublic:
        with store.read() as db:
            _require(db.get(Webhook, webhook), webhook)
            return _answer(db.get_one(Delivery, delivery.id))

    delivery, row = await asyncio.to_thread(begin)
    await deliverer.deliver(delivery, row)
    return await asyncio.to_thread(outcome)


@router.get("/{webhook}/deliveries")
def list_deliveries(webhook: WebhookPath, store: StoreDep) -> list[DeliveryPublic]:
    """The newest hundred."""
    with store.read() as db:
        _require(db.get(Webhook, webhook), webhook)
        query = select(Delivery).where(Delivery.webhook == webhook).order_by(Delivery.id.desc()).limit(100)
        return [_answer(row) for row in db.scalars(query)]


def _answer(row: Delivery) -> DeliveryPublic:
    return DeliveryPublic(
        id=row.id,
        run=json.loads(row.body).get("run"),
        attempts=row.attempts,
        made_at=row.made_at,
        due_at=row.due_at,
        delivered_at=row.delivered_at,
        last_error=None if row.last_error is None else Message.model_validate_json(row.last_error),
    )


def _require(row: Webhook | None, name: str) -> Webhook:
    if row is None:
        raise NotFound("runs-webhook-unknown", webhook=name[:80])
    return row
