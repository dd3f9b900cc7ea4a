"""The audit log is searched by who, what, when and what it mentions, and verified from the console as from the command line."""

from __future__ import annotations

import pytest
from fastapi.testclient import TestClient
from sqlalchemy import text

from server.people import audit
from server.people.roles import Role
from server.service import Service
from tests.server.made_people import BOTH_STORES, As, Clock


@pytest.fixture
def admin(signed_in: As, service: Service, clock: Clock) -> TestClient:
    """Somebody who may read the log, with four entries in it, an hour apart."""
    for who, action, detail in (
        ("account:anna", "run.release", {"run": "r1", "plan": "50%_off"}),
        ("key:line-3", "run.queue", {"run": "r2"}),
        ("account:anna", "zone.move", {"zone": "operator"}),
        ("account:ben", "runaway.stop", {"run": "r1"}),
    ):
        with service.store.write() as db:
            audit.record(db, who, action, detail, now=clock())
        clock.go_on(hours=1)
    return signed_in(Role.admin)


def numbers(client: TestClient, **query: str | int) -> list[int]:
    answer = client.get("/api/audit", params=query)
    assert answer.status_code == 200, answer.text
    return [each["number"] for each in answer.json()]


QUESTIONS: list[tuple[dict[str, str | int], list[int]]] = [
    ({}, [4, 3, 2, 1]),
    ({"who": "account:anna"}, [3, 1]),
    ({"who": "account:ann"}, []),
    ({"action": "run.release"}, [1]),
    ({"action": "run"}, [2, 1]),
    ({"action": "r_n"}, []),
    ({"mentions": "r1"}, [4, 1]),
    ({"mentions": "50%_"}, [1]),
    ({"mentions": "5%o"}, []),
    ({"since": "2026-03-01T10:00:00Z"}, [4, 3]),
    ({"until": "2026-03-01T11:00:00+02:00"}, [1]),
    ({"who": "account:anna", "mentions": "operator", "before": 4, "limit": 1}, [3]),
]


@BOTH_STORES
def test_all_that_is_asked_for_has_to_hold(admin: TestClient) -> None:
    assert [numbers(admin, **query) for query, _ in QUESTIONS] == [found for _, found in QUESTIONS]


@pytest.mark.parametrize("query", [{"since": "2026-03-01T10:00:00"}, {"whoever": "anna"}, {"who": ""}, {"mentions": "a\x00b"}])
def test_a_question_that_cannot_be_understood_is_refused(admin: TestClient, query: dict[str, str]) -> None:
    assert admin.get("/api/audit", params=query).status_code == 422


def test_who_and_what_can_be_searched_for_is_told(admin: TestClient) -> None:
    told = admin.get("/api/audit/names").json()
    assert told == {
        "who": ["account:anna", "account:ben", "key:line-3"],
        "actions": ["run.queue", "run.release", "runaway.stop", "zone.move"],
    }


@BOTH_STORES
def test_an_unbroken_chain_is_told_with_the_hash_to_keep(admin: TestClient) -> None:
    told = admin.get("/api/audit/verification").json()
    assert (told["unbroken"], told["entries"], told["flaw"]) == (True, 4, None)
    assert told["hash"] == admin.get("/api/audit").json()[0]["hash"]
    assert admin.get("/api/audit/verification", params={"expect": told["hash"]}).json()["unbroken"]


def test_a_changed_entry_is_told_by_its_number(admin: TestClient, service: Service) -> None:
    with service.store.write() as db:
        db.execute(text("DROP TRIGGER audit_no_update"))
        db.execute(text("UPDATE audit SET who = 'account:eve' WHERE number = 3"))
    told = admin.get("/api/audit/verification").json()
    assert (told["unbroken"], told["entries"]) == (False, 2)
    assert (told["flaw"]["code"], told["flaw"]["parameters"]["number"]) == ("people-audit-entry-changed", 3)


def test_an_end_that_was_cut_off_is_told_by_a_hash_seen_earlier(admin: TestClient, service: Service) -> None:
    last = admin.get("/api/audit/verification").json()["hash"]
    with service.store.write() as db:
        db.execute(text("DROP TRIGGER audit_no_delete"))
        db.execute(text("DELETE FROM audit WHERE number = 4"))
    told = admin.get("/api/audit/verification", params={"expect": last}).json()
    assert (told["unbroken"], told["entries"], told["flaw"]["code"]) == (False, 3, "people-audit-hash-missing")
    assert admin.get("/api/audit/verification").json()["unbroken"]
