"""Everybody sees the browsers that they are signed in with, and ends those that they no longer hold."""

from __future__ import annotations

from fastapi.testclient import TestClient

from server.people import accounts
from server.people.roles import Role
from server.service import Service
from tests.server.made_people import BOTH_STORES, PASSWORD, As, Clock


def ids(client: TestClient) -> list[str]:
    return [each["id"] for each in client.get("/api/sessions").json()]


@BOTH_STORES
def test_somebody_sees_their_own_sessions_with_browser_and_address_and_which_one_asks(nobody: TestClient, signed_in: As) -> None:
    signed_in(Role.operator)
    here = signed_in(Role.viewer)
    body = {"name": "viewer", "password": PASSWORD}
    assert nobody.post("/api/session", json=body, headers={"User-Agent": "Tablet 7"}).status_code == 200
    found = here.get("/api/sessions").json()
    assert len(found) == 2
    assert {(each["browser"], each["current"]) for each in found} == {("Tablet 7", False), (None, True)}
    assert {each["address"] for each in found} == {"testclient"}


@BOTH_STORES
def test_one_that_is_ended_is_out_at_once_and_the_log_says_so(signed_in: As) -> None:
    here, elsewhere = signed_in(Role.viewer), signed_in(Role.viewer)
    assert elsewhere.get("/api/session").status_code == 200
    there = next(each["id"] for each in elsewhere.get("/api/sessions").json() if each["current"])
    assert here.delete(f"/api/sessions/{there}").status_code == 204
    assert elsewhere.get("/api/session").status_code == 401
    assert len(ids(here)) == 1
    last = signed_in(Role.admin).get("/api/audit").json()[0]
    assert (last["who"], last["action"], last["detail"]) == ("account:viewer", "session.end", {"session": there})


def test_all_others_end_and_this_one_stays(signed_in: As) -> None:
    here, *others = (signed_in(Role.viewer) for _ in range(4))
    stranger = signed_in(Role.operator)
    assert here.delete("/api/sessions").status_code == 204
    assert [each.get("/api/session").status_code for each in (here, *others, stranger)] == [200, 401, 401, 401, 200]


def test_nobody_ends_a_session_of_somebody_else_nor_one_by_half_its_name(signed_in: As) -> None:
    viewer, admin = signed_in(Role.viewer), signed_in(Role.admin)
    (named,) = ids(viewer)
    for session in (named, named[:8]):
        answer = admin.delete(f"/api/sessions/{session}")
        assert (answer.status_code, answer.json()["type"]) == (404, "/problems/people-session-unknown")
    assert viewer.delete(f"/api/sessions/{named[:8]}").status_code == 404
    assert viewer.get("/api/session").status_code == 200


def test_what_names_a_session_opens_nothing(signed_in: As, nobody: TestClient) -> None:
    client = signed_in(Role.viewer)
    (named,) = ids(client)
    nobody.cookies.set("heft_session", named)
    assert nobody.get("/api/session").status_code == 401


def test_a_key_of_the_same_name_as_an_account_sees_and_ends_none_of_its_sessions(signed_in: As, nobody: TestClient) -> None:
    viewer, admin = signed_in(Role.viewer), signed_in(Role.admin)
    key = admin.post("/api/keys", json={"name": "viewer", "role": "mes"}).json()["key"]
    machine = {"Authorization": f"Bearer {key}"}
    assert nobody.get("/api/sessions", headers=machine).json() == []
    assert nobody.delete("/api/sessions", headers=machine).status_code == 204
    assert nobody.delete(f"/api/sessions/{ids(viewer)[0]}", headers=machine).status_code == 404
    assert viewer.get("/api/session").status_code == 200


def test_one_that_has_expired_is_not_shown(signed_in: As, clock: Clock) -> None:
    signed_in(Role.viewer)
    clock.go_on(minutes=61)
    assert len(ids(signed_in(Role.viewer))) == 1
    assert signed_in(Role.admin).get("/api/accounts").json()[1]["sessions"] == 1


def test_accounts_show_how_many_browsers_they_are_signed_in_with(signed_in: As) -> None:
    admin = signed_in(Role.admin)
    signed_in(Role.viewer), signed_in(Role.viewer)
    shown = {each["name"]: each["sessions"] for each in admin.get("/api/accounts").json()}
    assert shown == {"admin": 1, "viewer": 2}
    assert admin.patch("/api/accounts/viewer", json={}).json()["sessions"] == 0
    assert {each["name"]: each["sessions"] for each in admin.get("/api/accounts").json()} == {"admin": 1, "viewer": 0}


@BOTH_STORES
def test_a_key_shows_when_it_was_used_last(signed_in: As, nobody: TestClient, service: Service, clock: Clock) -> None:
    admin = signed_in(Role.admin)
    key = admin.post("/api/keys", json={"name": "line", "role": "mes"}).json()
    assert key["used_at"] is None
    clock.go_on(minutes=5)
    assert nobody.get("/api/runs", headers={"Authorization": f"Bearer {key['key']}"}).status_code == 200
    service.later.submit(lambda: None).result(10)  # its last use is written down by now
    with service.store.read() as db:
        assert [row.used_at for row in db.query(accounts.ApiKey)] == [clock()]
