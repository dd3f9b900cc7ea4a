"""A webhook is tried before it is needed: a test delivery goes out signed, once, and says what came of it."""

from __future__ import annotations

import hashlib
import hmac
import json
from collections.abc import Callable

import httpx2
import pytest
from fastapi.testclient import TestClient

from server.people.roles import Role
from server.runs import ledger as run_ledger
from server.runs.schemas import RunOrder
from server.runs.webhooks import Deliverer, enqueue
from server.service import Service
from tests.server.made_people import As, Clock

SECRET = "0123456789abcdef"


@pytest.fixture
def plant(service: Service, monkeypatch: pytest.MonkeyPatch) -> Callable[[Callable[[httpx2.Request], httpx2.Response]], None]:
    """Says what answers deliveries from now on."""

    def answer_with(answer: Callable[[httpx2.Request], httpx2.Response]) -> None:
        client = httpx2.AsyncClient(transport=httpx2.MockTransport(answer))
        monkeypatch.setattr(Deliverer, "_client", client)

    return answer_with


@pytest.fixture
def admin(signed_in: As) -> TestClient:
    return signed_in(Role.admin)


@pytest.fixture
def webhook(admin: TestClient) -> str:
    made = admin.post("/api/webhooks", json={"url": "http://plant/ended", "secret": SECRET})
    return str(made.json()["id"])


def test_a_test_goes_out_signed_and_is_listed_as_one(admin: TestClient, webhook: str, plant: Callable[..., None]) -> None:
    seen: list[httpx2.Request] = []
    plant(lambda request: seen.append(request) or httpx2.Response(204))
    told = admin.post(f"/api/webhooks/{webhook}/test").json()
    assert (told["run"], told["attempts"], told["due_at"], told["last_error"]) == (None, 1, None, None)
    assert told["delivered_at"] is not None
    (request,) = seen
    body = json.loads(request.content)
    assert (body["test"], body["webhook"]) == (True, webhook)
    signed = f"{request.headers['Heft-Timestamp']}.{request.content.decode()}".encode()
    assert request.headers["Heft-Signature"] == f"sha256={hmac.new(SECRET.encode(), signed, hashlib.sha256).hexdigest()}"
    assert admin.get(f"/api/webhooks/{webhook}/deliveries").json() == [told]
    assert admin.get("/api/audit").json()[0]["action"] == "webhook.test"


def test_a_test_that_fails_says_why_and_is_not_sent_again(
    admin: TestClient, webhook: str, plant: Callable[..., None], clock: Clock, service: Service
) -> None:
    def refuse(request: httpx2.Request) -> httpx2.Response:
        raise httpx2.ConnectError("name not known", request=request)

    plant(refuse)
    told = admin.post(f"/api/webhooks/{webhook}/test").json()
    assert (told["delivered_at"], told["due_at"]) == (None, None)
    assert told["last_error"]["code"] == "runs-delivery-failed"
    assert told["last_error"]["parameters"]["reason"] == "name not known"
    clock.go_on(days=1)
    assert service.deliverer._due() == []


def test_a_delivery_of_a_run_names_it(admin: TestClient, webhook: str, service: Service) -> None:
    now = service.now()
    with service.store.write() as db:
        row = run_ledger.add_run(db, RunOrder(cell="lwr4_bench"), "key:mes", now)
        enqueue(db, run_ledger.build_answer(row), run_ledger.new_id, now)
    assert [each["run"] for each in admin.get(f"/api/webhooks/{webhook}/deliveries").json()] == [row.id]


def test_what_there_is_not_cannot_be_tried(admin: TestClient) -> None:
    answer = admin.post("/api/webhooks/none/test")
    assert (answer.status_code, answer.json()["type"]) == (404, "/problems/runs-webhook-unknown")
