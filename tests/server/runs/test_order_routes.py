"""The queue: who sent what, what it waits for, what STOP would end, and who took it back why."""

from __future__ import annotations

from typing import Any

import pytest
from fastapi.testclient import TestClient

from server.people.roles import Role
from server.runs import ledger as run_ledger
from server.runs.order_routes import WAITS, WaitsFor
from server.runs.packml import Command, State
from server.runs.schemas import RunOrder
from server.service import Service
from tests.server.made_people import As
from tests.server.real_service import wait_for

pytestmark = pytest.mark.usefixtures("nothing_planned")

ORDER = {"cell": "lwr4_bench", "payload": "steel_block"}


def at(nobody: TestClient, client: TestClient) -> TestClient:
    client.portal = nobody.portal
    return client


def test_the_queue_has_position_sender_and_what_stop_ends(nobody, service: Service, signed_in: As, with_key):
    mes, operator = at(nobody, with_key(Role.mes)), at(nobody, signed_in(Role.operator))
    runs = [mes.post("/api/runs", json=ORDER).json()["run"] for _ in range(2)]
    other = operator.post("/api/runs", json={"cell": "ur5e_line", "payload": "cylinder"}).json()["run"]
    wait_for(lambda: len(service.conductor.active) == 2, "both cells to have a run")
    found = operator.get("/api/orders").json()
    assert [(each["cell"], each["position"], each["run"]["run"]) for each in found] == [
        ("lwr4_bench", 0, runs[0]), ("lwr4_bench", 1, runs[1]), ("ur5e_line", 0, other),
    ]  # fmt: skip
    assert [each["waits_for"] for each in found] == ["plan", "order", "plan"]
    assert [each["ended_by_stop"] for each in found] == [True, False, True]
    assert found[0]["run"]["requested_by"].startswith("key:")
    assert operator.get("/api/orders", params={"cell": "ur5e_line"}).json() == found[2:]
    assert operator.post("/api/now/lwr4_bench/stop").status_code == 200
    assert operator.get(f"/api/runs/{runs[1]}").json()["state"] == "Resetting"


def test_an_order_is_taken_back_with_who_and_why(nobody, service: Service, signed_in: As):
    operator, viewer = at(nobody, signed_in(Role.operator)), at(nobody, signed_in(Role.viewer))
    runs = [operator.post("/api/runs", json=ORDER).json()["run"] for _ in range(2)]
    assert viewer.delete(f"/api/runs/{runs[1]}").status_code == 403
    ended = operator.delete(f"/api/runs/{runs[1]}", params={"why": "wrong tool"}).json()
    assert (ended["state"], ended["reason_kind"]) == ("Stopped", "cancelled")
    assert ended["reason"]["parameters"] == {"who": "account:operator", "why": "wrong tool"}
    assert "wrong tool" in ended["reason"]["text"]
    assert [each["run"]["run"] for each in viewer.get("/api/orders").json()] == [runs[0]]
    deed = next(entry for entry in at(nobody, signed_in(Role.admin)).get("/api/audit").json() if entry["action"] == "run.cancel")
    assert deed["detail"] == {"run": runs[1], "why": "wrong tool"}


def test_the_websocket_tells_the_queue_at_once_as_it_changes_and_signs_of_life_between(nobody, service: Service, signed_in: As):
    operator = at(nobody, signed_in(Role.operator))
    with operator.websocket_connect("/api/orders/live", headers={"Origin": "http://testserver"}) as live:
        assert live.receive_json()["orders"] == []
        assert live.receive_json()["orders"] is None
        runs = [operator.post("/api/runs", json=ORDER).json()["run"] for _ in range(2)]
        assert told(live, 2) == runs
        operator.delete(f"/api/runs/{runs[1]}")
        assert told(live, 1) == runs[:1]


def told(live: Any, count: int) -> list[str]:
    """The queue once it is so long."""
    for _ in range(50):
        orders = live.receive_json()["orders"]
        if orders is not None and len(orders) == count:
            return [each["run"]["run"] for each in orders]
    raise AssertionError(f"the queue never had {count} orders")


@pytest.mark.parametrize("state", State)
def test_whatever_needs_a_person_or_a_free_path_is_said_to_wait_for_it(state: State):
    rests = {State.RESETTING: "plan", State.IDLE: "release", State.HELD: "resume", State.SUSPENDED: "path", State.ABORTED: "clear"}
    assert WAITS.get(state) == (WaitsFor(rests[state]) if state in rests else None)


def test_an_aborted_run_that_no_process_has_keeps_the_queue_until_it_is_cleared(nobody, service: Service, signed_in: As):
    with service.store.write() as db:
        row = run_ledger.add_run(db, RunOrder(cell="ur5e_line"), "account:anna", service.now())
        run_ledger.keep_steps(db, row, [None, Command.START, None, Command.ABORT, None], service.now())
    (found,) = signed_in(Role.viewer).get("/api/orders").json()
    assert (found["waits_for"], found["ended_by_stop"], found["position"]) == ("clear", False, 0)
