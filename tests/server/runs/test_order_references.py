"""What the plant calls an order goes along with its run, and how the run ended is told apart."""

from __future__ import annotations

import json

import pytest
from sqlalchemy import select

from server.people.roles import Role
from server.runs import ledger as run_ledger
from server.runs.order import order_of
from server.runs.packml import Command, RunOutcome
from server.runs.reason import CANCELLED, Reason, explain_command, set_reason
from server.runs.schemas import RunCreate
from server.runs.tables import Delivery, Webhook
from server.service import Service
from tests.server.made_people import As
from tests.server.sentence import sentence

CELL = "lwr4_bench"
pytestmark = pytest.mark.usefixtures("nothing_planned")

REFERENCES = {"order_id": "JO-2026-004711", "work_order": "Werk 3 / Auftrag 88120", "serial_number": "SN-000482"}
ORDER = {"cell": CELL, "payload": "steel_block"}


def test_references_come_back_with_the_run_wherever_it_is_told(signed_in: As) -> None:
    mes, viewer = signed_in(Role.mes), signed_in(Role.viewer)
    run = mes.post("/api/runs", json=ORDER | REFERENCES).json()
    other = mes.post("/api/runs", json=ORDER | {"order_id": "J" * 100}).json()
    assert {name: run[name] for name in REFERENCES} == REFERENCES
    assert {name: run["order"][name] for name in REFERENCES} == REFERENCES
    assert {name: viewer.get(f"/api/runs/{run['run']}").json()[name] for name in REFERENCES} == REFERENCES
    assert (other["order_id"], other["work_order"], other["serial_number"]) == ("J" * 100, None, None)
    for name, value in REFERENCES.items():
        assert [each["run"] for each in viewer.get("/api/runs", params={name: value}).json()] == [run["run"]]
    assert viewer.get("/api/runs", params={"order_id": "J"}).json() == []


@pytest.mark.parametrize("value", ["", "x" * 101, "two\nlines", "a\x00b", 7])
def test_a_reference_is_one_line_of_at_most_a_hundred_characters(value: object, signed_in: As) -> None:
    refused = signed_in(Role.mes).post("/api/runs", json=ORDER | {"order_id": value})
    assert (refused.status_code, refused.json()["type"]) == (422, "/problems/request-unfit")
    assert "order_id" in refused.json()["flaws"][0]["where"]


def test_an_order_without_its_payload_is_refused_and_nothing_is_queued(signed_in: As) -> None:
    mes = signed_in(Role.mes)
    for order in ({"cell": CELL}, {"cell": CELL, "payload": None}):
        refused = mes.post("/api/runs", json=order)
        assert (refused.status_code, refused.json()["kind"]) == (422, "bad-request")
        assert "payload" in refused.json()["flaws"][0]["where"]
    unknown = mes.post("/api/runs", json={"cell": CELL, "payload": "feather"}).json()
    assert (unknown["type"], unknown["status"]) == ("/problems/runs-payload-unknown", 422)
    assert "steel_block" in unknown["parameters"]["payloads"]
    assert mes.get("/api/runs").json() == []


def test_a_filter_that_there_is_not_is_refused_instead_of_ignored(signed_in: As) -> None:
    assert signed_in(Role.viewer).get("/api/runs", params={"orderid": "JO-1"}).status_code == 422


def test_the_control_process_is_told_the_references_of_its_order(service: Service) -> None:
    with service.store.write() as db:
        row = run_ledger.add_run(db, RunCreate.model_validate(ORDER | REFERENCES), "key:mes", service.now())
        told = order_of(row, service.cells.load(CELL), service.settings.data)
    assert told.reference.model_dump() == REFERENCES


ENDS: dict[RunOutcome, tuple[list[Command | None], Reason | None, bool]] = {
    RunOutcome.COMPLETED: ([None, Command.START, None, None, None], None, False),
    RunOutcome.CANCELLED: ([None, Command.STOP, None], Reason(CANCELLED, sentence("no longer wanted")), False),
    RunOutcome.REFUSED: ([Command.STOP, None], Reason("no-path", sentence("no way")), True),
    RunOutcome.STOPPED: ([None, Command.START, None, Command.STOP, None], explain_command("stop", "account:anna"), False),
    RunOutcome.ABORTED: ([None, Command.START, None, Command.ABORT, None], Reason("too-close", sentence("too close")), True),
}


@pytest.mark.parametrize("outcome", ENDS)
def test_every_end_has_its_outcome_which_the_webhook_the_list_and_the_events_tell(
    outcome: RunOutcome, service: Service, signed_in: As
) -> None:
    path, reason, aborted = ENDS[outcome]
    viewer = signed_in(Role.viewer)
    with service.store.write() as db:
        db.add(Webhook(id="hook", url="http://mes", secret="s" * 16, made_by="account:admin", made_at=service.now()))
        row = run_ledger.add_run(db, RunCreate.model_validate(ORDER | REFERENCES), "key:mes", service.now())
        row.aborted, run = aborted, row.id
        set_reason(row, reason)
        told = run_ledger.keep_steps(db, row, path, service.now())
    with service.store.read() as db:
        body = json.loads(db.scalar(select(Delivery.body)) or "")
    assert (body["outcome"], body["order_id"], body["run"]) == (outcome, REFERENCES["order_id"], run)
    assert body["job_state"] == ("Ended" if outcome is RunOutcome.COMPLETED else "Aborted")
    assert told[-1].event.model_dump()["outcome"] == outcome
    assert [message.event.model_dump()["outcome"] for message in told[:-1]] == [None] * (len(told) - 1)
    assert [each["run"] for each in viewer.get("/api/runs", params={"outcome": outcome}).json()] == [run]
    assert viewer.get("/api/runs", params={"outcome": "cancelled" if outcome != "cancelled" else "stopped"}).json() == []


def test_an_aborted_run_that_was_cleared_stays_aborted(service: Service) -> None:
    with service.store.write() as db:
        row = run_ledger.add_run(db, RunCreate.model_validate(ORDER), "key:mes", service.now())
        run_ledger.keep_steps(db, row, [None, Command.ABORT, None, Command.CLEAR, None], service.now())
        assert (row.state, row.outcome) == ("Stopped", "aborted")
