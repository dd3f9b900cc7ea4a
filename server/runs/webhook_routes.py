"""Who is told when a run has ended."""

from __future__ import annotations

import secrets
from datetime import datetime
from typing import Annotated

from fastapi import APIRouter
from pydantic import AnyHttpUrl, SecretStr, StringConstraints, field_validator
from sqlalchemy import select

from core.words.message import Message
from server.http.dependencies import NowDep, StoreDep
from server.http.errors import NotFound
from server.http.schemas import Answer, RequestBody
from server.people import audit
from server.people.auth import CallerDep
from server.runs import ledger as run_ledger
from server.runs.tables import Delivery, Webhook

router = APIRouter(prefix="/api/webhooks", tags=["webhooks"])


class WebhookBody(RequestBody):
    """Where to send; a secret is made where none is given."""

    url: AnyHttpUrl
    secret: Annotated[SecretStr, StringConstraints(min_length=16, max_length=128)] | None = None


class WebhookAnswer(Answer):
    """A webhook; its secret is shown once, when it is made."""

    id: str
    url: str
    made_by: str
    made_at: datetime
    secret: str | None = None


class DeliveryAnswer(Answer):
    """One message. `due_at` is null once it is delivered or given up."""

    id: str
    attempts: int
    made_at: datetime
    due_at: datetime | None
    delivered_at: datetime | None
    last_error: Message | None

    @field_validator("last_error", mode="before")
    @classmethod
    def _read(cls, kept: object) -> object:
        return Message.model_validate_json(kept) if isinstance(kept, str) else kept


LINKS = {
    "deliveries": {"operationId": "list_deliveries", "parameters": {"webhook": "$response.body#/id"}},
    "remove": {"operationId": "remove_webhook", "parameters": {"webhook": "$response.body#/id"}},
}
"""What can be asked of the webhook that was made (OpenAPI link objects)."""


@router.post("", status_code=201, responses={201: {"links": LINKS}})
def add_webhook(body: WebhookBody, store: StoreDep, caller: CallerDep, now: NowDep) -> WebhookAnswer:
    """Every run's end is sent there from now on, signed: `Heft-Signature: sha256=HMAC(secret, timestamp + "." + body)`."""
    secret = secrets.token_urlsafe(32) if body.secret is None else body.secret.get_secret_value()
    row = Webhook(id=run_ledger.new_id(now), url=str(body.url), secret=secret, made_by=caller.who, made_at=now)
    with store.write() as db:
        db.add(row)
        audit.record(db, caller.who, "webhook.create", {"webhook": row.id, "url": row.url}, now=now)
    return WebhookAnswer(id=row.id, url=row.url, made_by=row.made_by, made_at=row.made_at, secret=secret)


@router.get("")
def list_webhooks(store: StoreDep) -> list[WebhookAnswer]:
    """All, without their secrets."""
    with store.read() as db:
        rows = db.scalars(select(Webhook).order_by(Webhook.id))
        return [WebhookAnswer(id=row.id, url=row.url, made_by=row.made_by, made_at=row.made_at) for row in rows]


@router.delete("/{webhook}", status_code=204)
def remove_webhook(webhook: str, store: StoreDep, caller: CallerDep, now: NowDep) -> None:
    """Nothing is sent there any more, also not what is still due."""
    with store.write() as db:
        row = _require(db.get(Webhook, webhook), webhook)
        for delivery in db.scalars(select(Delivery).where(Delivery.webhook == webhook)):
            db.delete(delivery)
        db.flush()
        db.delete(row)
        audit.record(db, caller.who, "webhook.remove", {"webhook": webhook}, now=now)


@router.get("/{webhook}/deliveries")
def list_deliveries(webhook: str, store: StoreDep) -> list[DeliveryAnswer]:
    """The newest hundred."""
    with store.read() as db:
        _require(db.get(Webhook, webhook), webhook)
        query = select(Delivery).where(Delivery.webhook == webhook).order_by(Delivery.id.desc()).limit(100)
        return [DeliveryAnswer.model_validate(row) for row in db.scalars(query)]


def _require(row: Webhook | None, name: str) -> Webhook:
    if row is None:
        raise NotFound("runs-webhook-unknown", webhook=name[:80])
    return row
