"""Control is asked for, handed over and released over HTTP; the robot of a run under way notices nothing but its release."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import pytest

from tests.server.real_service import QUICK, Console, RealService, wait_for

PASSWORD = "correct horse battery"
CELL = "ur5e_line"


class Asker(Console):
    """Another person, who asks for control instead of taking it."""

    def __init__(self, service: RealService, name: str) -> None:
        super().__init__(service, CELL)
        self.http.post("/api/accounts", json={"name": name, "password": PASSWORD, "roles": ["operator"]})
        answer = self.http.post("/api/session", json={"name": name, "password": PASSWORD})
        assert answer.status_code == 200, answer.text
        self.http.headers["X-CSRF-Token"] = answer.json()["csrf_token"]

    def ask(self) -> int:
        """And answers the stamps from now on; the fence of the request."""
        answer = self.http.post(f"/api/control/{CELL}/request", json={"device": "Tablet 2"})
        assert answer.status_code == 200, answer.text
        self.keep(answer.json()["request"]["fence"])
        return self.fence


@pytest.fixture(scope="module")
def service(real: RealService) -> RealService:
    return real


@pytest.fixture
def anna(service: RealService) -> Iterator[Console]:
    person = Console(service, CELL)
    person.take_control()
    yield person
    person.leave()


@pytest.fixture
def ben(service: RealService) -> Iterator[Asker]:
    person = Asker(service, "ben")
    yield person
    if control(person)["holder"] == "account:ben":
        person.http.delete(f"/api/control/{CELL}", params={"fence": person.fence})
    person.leave()


def control(at: Console) -> dict[str, Any]:
    return dict(at.http.get(f"/api/control/{CELL}").json())


def decide(at: Console, asked: int, *, accept: bool) -> int:
    body = {"fence": at.fence, "request": asked, "accept": accept}
    return int(at.http.post(f"/api/control/{CELL}/request/answer", json=body).status_code)


def test_a_request_is_told_declined_asked_anew_and_accepted(anna: Console, ben: Asker):
    first = ben.ask()
    request = control(anna)["request"]
    assert (request["fence"], request["who"], request["device"], request["accepted"]) == (first, "account:ben", "Tablet 2", False)
    assert request["asked_at"] < request["passes_at"]
    assert decide(ben, first, accept=True) == 409
    assert decide(anna, first, accept=False) == 200
    told = control(ben)
    assert (told["holder"], told["request"], told["last_request"]["outcome"]) == ("account:operator", None, "declined")
    second = ben.ask()
    assert second > first
    assert decide(anna, first, accept=True) == 409
    assert decide(anna, second, accept=True) == 200
    wait_for(lambda: control(ben)["fence"] == second, "control to pass")
    told = control(ben)
    assert (told["holder"], told["device"], told["last_request"]["outcome"]) == ("account:ben", "Tablet 2", "accepted")
    assert told["last_request"]["holder"] == "account:operator"
    assert decide(anna, second, accept=True) == 409
    wait_for(lambda: "control.pass" in deeds(anna), "the handover in the audit log")
    assert deeds(anna)[:5] == ["control.pass", "control.accept", "control.ask", "control.decline", "control.ask"]


def deeds(admin: Console) -> list[str]:
    """What was done with control, newest first."""
    return [entry["action"] for entry in admin.http.get("/api/audit").json() if entry["action"].startswith("control.")]


def test_a_run_goes_on_while_control_passes_and_is_held_when_it_is_released(anna: Console, ben: Asker):
    run = anna.http.post("/api/runs", json={"cell": CELL, "payload": "cylinder", **QUICK, "pace": "real_time"}).json()["run"]
    anna.wait(run, "Idle")
    assert anna.release(run).status_code == 200
    anna.wait(run, "Execute")
    asked = ben.ask()
    assert decide(anna, asked, accept=True) == 200
    wait_for(lambda: control(ben)["fence"] == asked, "control to pass")
    assert anna.command(run, "hold").status_code == 409
    assert anna.run(run)["state"] == "Execute"
    assert "Held" not in states(ben, run)
    assert ben.http.delete(f"/api/control/{CELL}", params={"fence": asked}).status_code == 200
    held = anna.wait(run, "Held")
    assert held["reason_kind"] == "hold-asked"
    assert held["reason"]["parameters"]["who"] == "account:ben"
    assert control(anna)["holder"] is None
    anna.take_control()
    assert anna.command(run, "resume").status_code == 200
    anna.wait(run, "Execute")
    anna.command(run, "stop")
    anna.wait(run, "Stopped")


def states(at: Console, run: str) -> list[str]:
    events = [message["event"] for message in at.http.get(f"/api/runs/{run}/events", params={"kind": "event"}).json()]
    return [event["state"] for event in events if event["kind"] == "state_changed"]


def test_a_request_is_withdrawn_and_asking_where_nobody_is_in_control_gives_it_at_once(anna: Console, ben: Asker):
    asked = ben.ask()
    assert ben.http.delete(f"/api/control/{CELL}/request", params={"fence": asked}).json()["last_request"]["outcome"] == "withdrawn"
    anna.http.delete(f"/api/control/{CELL}", params={"fence": anna.fence})
    asked = ben.ask()
    wait_for(lambda: control(ben)["fence"] == asked, "control")
    assert control(ben)["last_request"]["outcome"] == "vacant"


def test_a_handover_is_told_over_the_socket_of_the_cell(anna: Console, ben: Asker):
    with ben.socket(f"/api/cells/{CELL}/live") as live:
        asked = ben.ask()
        heard = wait_for_told(live, lambda said: said["request"] is not None)
        assert heard["request"]["fence"] == asked
        decide(anna, asked, accept=True)
        heard = wait_for_told(live, lambda said: said["fence"] == asked)
        assert (heard["holder"], heard["request"]) == ("account:ben", None)


def wait_for_told(live: Any, condition: Any) -> dict[str, Any]:
    for _ in range(200):
        said = dict(json.loads(live.recv(timeout=5))["control"])
        if condition(said):
            return said
    raise AssertionError("never told")
