"""Who is let in, for how long, and how guessing is slowed down; on either database."""

from __future__ import annotations

import pytest
from fastapi.testclient import TestClient
from sqlalchemy import select

from server.http.openapi import COOKIE
from server.people.accounts import Account, ApiKey, SignIn
from server.people.login_limit import LIMITS
from server.people.roles import Role
from server.service import Service
from tests.server.made_people import BOTH_STORES, PASSWORD, As, Clock


def sign_in(client: TestClient, name: str, password: str) -> int:
    return client.post("/api/session", json={"name": name, "password": password}).status_code


@BOTH_STORES
def test_an_admin_makes_an_account_that_signs_in(nobody: TestClient, signed_in: As, service: Service) -> None:
    admin = signed_in(Role.admin)
    answer = admin.post("/api/accounts", json={"name": "anna", "password": PASSWORD, "roles": ["operator"]})
    assert answer.status_code == 201
    assert sign_in(nobody, "anna", PASSWORD) == 200
    assert nobody.get("/api/session").json()["roles"] == ["operator"]
    with service.store.read() as db:
        account = db.get(Account, "anna")
        assert account is not None
        assert account.password_hash.startswith("$argon2id$")


@BOTH_STORES
def test_a_session_ends_unused_and_ends_anyway(signed_in: As, service: Service, clock: Clock) -> None:
    def status(client: TestClient) -> int:
        found = client.get("/api/session").status_code
        service.later.submit(lambda: None).result(10)  # its last use is written down by now
        return found

    client = signed_in(Role.viewer)
    clock.go_on(minutes=59)
    assert status(client) == 200
    clock.go_on(minutes=59)
    assert status(client) == 200
    clock.go_on(minutes=61)
    assert status(client) == 401
    client = signed_in(Role.viewer)
    for _ in range(12):
        assert status(client) == 200
        clock.go_on(minutes=59)
    clock.go_on(minutes=13)
    assert client.get("/api/session").status_code == 401


def test_the_cookie_cannot_be_read_by_pages_nor_travel_with_others(nobody: TestClient, signed_in: As) -> None:
    signed_in(Role.viewer)
    answer = nobody.post("/api/session", json={"name": "viewer", "password": PASSWORD})
    cookie = answer.headers["set-cookie"].lower()
    assert cookie.startswith(COOKIE)
    assert "httponly" in cookie
    assert "samesite=strict" in cookie


def test_neither_token_nor_key_stands_in_the_store(nobody: TestClient, signed_in: As, service: Service) -> None:
    admin = signed_in(Role.admin)
    key = admin.post("/api/keys", json={"name": "line", "role": "mes"}).json()["key"]
    token = admin.cookies[COOKIE]
    with service.store.read() as db:
        assert all(key not in str(vars(row)) for row in db.scalars(select(ApiKey)))
        assert all(token not in str(vars(row)) for row in db.scalars(select(SignIn)))


@BOTH_STORES
def test_a_key_works_until_it_expires_or_is_revoked(nobody: TestClient, signed_in: As, clock: Clock) -> None:
    admin = signed_in(Role.admin)
    made = [admin.post("/api/keys", json={"name": f"line{k}", "role": "mes", "valid_days": 2}).json()["key"] for k in range(2)]

    def asks(key: str) -> int:
        return nobody.get("/api/session", headers={"Authorization": f"Bearer {key}"}).status_code

    assert [asks(key) for key in made] == [200, 200]
    assert admin.delete("/api/keys/line0").status_code == 204
    assert [asks(key) for key in made] == [401, 200]
    assert asks(made[1] + "x") == 401
    clock.go_on(days=2)
    assert [asks(key) for key in made] == [401, 401]


@pytest.mark.parametrize("role", ["operator", "admin"])
def test_no_machine_gets_a_role_that_moves_robots_or_makes_accounts(role: str, signed_in: As) -> None:
    answer = signed_in(Role.admin).post("/api/keys", json={"name": "line", "role": role})
    assert answer.status_code == 422
    assert "a machine neither" in answer.json()["detail"]


@BOTH_STORES
def test_guessing_gets_slow_and_a_right_password_waits_too(nobody: TestClient, signed_in: As, clock: Clock) -> None:
    signed_in(Role.viewer)
    free = LIMITS["pair"].free
    assert [sign_in(nobody, "viewer", "wrong") for _ in range(free)] == [401] * free
    answer = nobody.post("/api/session", json={"name": "viewer", "password": PASSWORD})
    assert answer.status_code == 429
    wait = int(answer.headers["retry-after"])
    clock.go_on(seconds=wait)
    assert sign_in(nobody, "viewer", "wrong") == 401
    longer = int(nobody.post("/api/session", json={"name": "viewer", "password": PASSWORD}).headers["retry-after"])
    assert longer == 2 * wait
    clock.go_on(seconds=longer)
    assert sign_in(nobody, "viewer", PASSWORD) == 200


def test_waits_double_up_to_the_longest() -> None:
    limit = LIMITS["pair"]
    waits = [limit.wait(count).total_seconds() for count in range(1, 40)]
    assert waits[: limit.free - 1] == [0] * (limit.free - 1)
    assert waits[limit.free - 1 : limit.free + 3] == [1, 2, 4, 8]
    assert max(waits) == limit.longest.total_seconds()


def test_an_unknown_name_is_refused_in_the_same_words(nobody: TestClient, signed_in: As) -> None:
    signed_in(Role.viewer)
    answers = [nobody.post("/api/session", json={"name": name, "password": "wrong"}) for name in ("viewer", "stranger")]
    assert answers[0].json()["detail"] == answers[1].json()["detail"]


def test_who_is_disabled_is_out_at_once(signed_in: As) -> None:
    viewer, admin = signed_in(Role.viewer), signed_in(Role.admin)
    assert viewer.get("/api/session").status_code == 200
    assert admin.patch("/api/accounts/viewer", json={"disabled": True}).status_code == 200
    assert viewer.get("/api/session").status_code == 401
    assert sign_in(viewer, "viewer", PASSWORD) == 401


def test_the_last_admin_cannot_be_locked_out(signed_in: As) -> None:
    admin = signed_in(Role.admin)
    for change in ({"disabled": True}, {"roles": ["viewer"]}):
        assert admin.patch("/api/accounts/admin", json=change).status_code == 409
    assert admin.get("/api/accounts").status_code == 200


def test_a_new_password_ends_all_other_sessions(nobody: TestClient, signed_in: As) -> None:
    client, elsewhere = signed_in(Role.viewer), signed_in(Role.viewer)
    new = "another long password"
    assert client.put("/api/session/password", json={"password": "wrong", "new_password": new}).status_code == 403
    assert client.put("/api/session/password", json={"password": PASSWORD, "new_password": "short"}).status_code == 422
    assert client.put("/api/session/password", json={"password": PASSWORD, "new_password": new}).status_code == 204
    assert elsewhere.get("/api/session").status_code == 401
    assert client.get("/api/session").status_code == 200
    assert (sign_in(nobody, "viewer", PASSWORD), sign_in(nobody, "viewer", new)) == (401, 200)
