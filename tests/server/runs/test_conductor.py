"""A run is given its cell or changed without it, never both."""

from __future__ import annotations

import asyncio
import threading
import time

import pytest
from fastapi.testclient import TestClient
from sqlalchemy.orm import Session

from core.cell.cell import Cell
from server.people.roles import Role
from server.runs.idle import IdleRuns
from server.runs.tables import RunRow
from server.service import Service
from tests.server.made_people import As

ORDER = {"cell": "lwr4_bench", "payload": "steel_block"}


def test_a_run_that_is_cancelled_while_it_is_its_turn_leaves_the_cell_to_the_next(
    nothing_planned: None, nobody: TestClient, service: Service, signed_in: As, monkeypatch: pytest.MonkeyPatch
) -> None:
    operator = signed_in(Role.operator)
    operator.portal = nobody.portal
    read, go_on = threading.Event(), threading.Event()
    first = IdleRuns.first

    def slowly(self: IdleRuns) -> list[RunRow]:
        found = first(self)
        if found:
            read.set()
            go_on.wait(10)
        return found

    monkeypatch.setattr(IdleRuns, "first", slowly)
    run = operator.post("/api/runs", json=ORDER).json()["run"]
    assert read.wait(10)
    answers = []
    cancelling = threading.Thread(target=lambda: answers.append(operator.delete(f"/api/runs/{run}").status_code))
    cancelling.start()
    cancelling.join(0.5)  # unless it waits for its turn
    go_on.set()
    cancelling.join()
    assert answers == [200]
    following = operator.post("/api/runs", json=ORDER).json()["run"]
    until = time.monotonic() + 10
    while (active := service.conductor.active.get("lwr4_bench")) is None or active.id != following:
        assert time.monotonic() < until, active and active.id
        time.sleep(0.01)
    assert operator.get(f"/api/runs/{run}").json()["state"] == "Stopped"


def test_a_run_whose_turn_comes_while_the_service_ends_waits_for_the_next_start(
    nothing_planned: None, nobody: TestClient, service: Service, signed_in: As, monkeypatch: pytest.MonkeyPatch
) -> None:
    operator, conductor = signed_in(Role.operator), service.conductor
    reading, go_on = threading.Event(), threading.Event()
    load = conductor.load_plannable_cell

    def slowly(db: Session, name: str) -> Cell:
        reading.set()
        go_on.wait(10)
        return load(db, name)

    monkeypatch.setattr(conductor, "load_plannable_cell", slowly)
    run = operator.post("/api/runs", json=ORDER).json()["run"]
    assert reading.wait(10)
    assert nobody.portal is not None
    ending = nobody.portal.start_task_soon(conductor.close)
    nobody.portal.call(asyncio.sleep, 0.1)
    go_on.set()
    ending.result(10)
    assert conductor.active == {}
    assert operator.get(f"/api/runs/{run}").json()["state"] == "Resetting"
