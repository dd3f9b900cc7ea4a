"""Runs are found by words wherever in the history they are."""

from __future__ import annotations

import pytest
from fastapi.testclient import TestClient
from sqlalchemy import select, text

from server.people.roles import Role
from server.runs import ledger as run_ledger
from server.runs.packml import Command
from server.runs.run_search import contain_words
from server.runs.schemas import RunCreate
from server.runs.tables import RunRow
from server.service import Service
from tests.server.made_people import BOTH_STORES, As, Clock

CELL = "lwr4_bench"
ORDERED: dict[str, dict[str, str]] = {
    "first": {"payload": "gripper", "serial_number": "SN-0001", "order_id": "JO_1", "work_order": "100% of 7"},
    "second": {"payload": "steel_block", "serial_number": "SN-0012", "order_id": "JO-2"},
    "third": {"payload": "steel_block", "serial_number": "sn-0013"},
}
"""Each on a day of its own from the first of March on, the last one by Ben, who took it back."""
FOUND: dict[str, set[str]] = {
    "sn-0001": {"first"},
    "SN-001": {"second", "third"},
    "gripper": {"first"},
    "steel sn-0013": {"third"},
    "steel sn-0001": set(),
    "ben": {"third"},
    "cancelled BEN": {"third"},
    "2026-03-02": {"second"},
    "2026-03-02 2026-03-01": set(),
    "9999-12-31": set(),
    "jo_": {"first"},
    "jo": {"first", "second"},
    "0%": {"first"},
    "%": {"first"},
    "account:": set(),
    "": {"first", "second", "third"},
}


@pytest.fixture
def runs(service: Service, clock: Clock) -> dict[str, str]:
    made = {}
    for name, ordered in ORDERED.items():
        with service.store.write() as db:
            order = RunCreate.model_validate({"cell": CELL, **ordered})
            row = run_ledger.add_run(db, order, "account:ben" if name == "third" else "account:anna", service.now())
            run_ledger.keep_steps(db, row, [Command.STOP, None], service.now())
            row.outcome = "cancelled" if name == "third" else "stopped"
            made[name] = row.id
        clock.go_on(days=1)
    return made


@pytest.fixture
def viewer(signed_in: As) -> TestClient:
    return signed_in(Role.viewer)


@BOTH_STORES
def test_a_run_is_found_by_whatever_a_plant_knows_it_by(runs: dict[str, str], viewer: TestClient) -> None:
    names = {run: name for name, run in runs.items()}
    for search, expected in (FOUND | {runs["second"][-8:].upper(): {"second"}}).items():
        found = viewer.get("/api/runs", params={"search": search}).json()
        assert {names[each["run"]] for each in found} == expected, search
        assert [each["run"] for each in found] == sorted((each["run"] for each in found), reverse=True)
    assert viewer.get("/api/runs", params={"search": "sn", "payload": "gripper"}).json()[0]["run"] == runs["first"]
    assert viewer.get("/api/runs", params={"search": "sn", "cell": "ur5e_line"}).json() == []
    assert viewer.get("/api/runs", params={"search": "x" * 201}).status_code == 422


def test_a_run_is_found_behind_hundreds_of_others_without_reading_their_plans(
    runs: dict[str, str], service: Service, viewer: TestClient
) -> None:
    with service.store.write() as db:
        for k in range(600):
            run_ledger.add_run(db, RunCreate(cell=CELL, payload="gripper", serial_number=f"X-{k}"), "account:anna", service.now())
    found = viewer.get("/api/runs", params={"cell": CELL, "search": "sn-0001"}).json()
    assert [each["run"] for each in found] == [runs["first"]]
    query = select(RunRow.id).where(RunRow.cell == CELL, *contain_words("sn-0001")).order_by(RunRow.id.desc()).limit(500)
    with service.store.read() as db:
        sql = query.compile(db.connection(), compile_kwargs={"literal_binds": True})
        way = [row[-1] for row in db.execute(text(f"EXPLAIN QUERY PLAN {sql}".replace(":", r"\:")))]
    assert way == ["SEARCH runs USING COVERING INDEX ix_runs_searched (cell=?)"]
