"""What needs a person is noticed: in the runs, the cells, the disk, the database, the webhooks; it is told, acknowledged and remembered."""

from __future__ import annotations

from collections import namedtuple
from datetime import timedelta
from typing import Any

import pytest
from fastapi.testclient import TestClient
from sqlalchemy.exc import OperationalError

from core.words.message import Message
from server.alarms import of_service
from server.people.roles import Role
from server.runs import ledger as run_ledger
from server.runs.packml import Command, State
from server.runs.reason import Reason
from server.runs.schemas import RunOrder
from server.runs.tables import Delivery, Webhook
from server.service import Service
from tests.server.made_people import As

pytestmark = pytest.mark.usefixtures("nothing_planned")

CELL = "lwr4_bench"
CAUSE = Message.of("runs-ended")


def look(nobody: TestClient, service: Service) -> None:
    assert nobody.portal is not None
    nobody.portal.call(service.alarms.look)


def add_run(service: Service, *path: Command | None, reason: str, who: str = "account:anna", released: bool = True) -> str:
    """A run that no process has, taken through states."""
    with service.store.write() as db:
        row = run_ledger.add_run(db, RunOrder(cell=CELL, payload="steel_block"), who, service.now())
        row.released = released
        run_ledger.set_reason(row, Reason(reason, CAUSE))
        run_ledger.keep_steps(db, row, path, service.now())
        return row.id


def kinds(client: TestClient) -> list[str]:
    return [alarm["kind"] for alarm in client.get("/api/alarms/open").json()]


@pytest.mark.parametrize(
    ("reason", "kind"), [("no-room", "run_aborted"), ("sensor-frozen", "sensor_lost"), ("robot-state-late", "robot_lost")]
)
def test_an_aborted_run_is_told_with_what_failed_until_it_is_cleared_and_acknowledged(nobody, service, signed_in: As, reason, kind):
    run = add_run(service, None, Command.START, None, Command.ABORT, None, reason=reason)
    operator = signed_in(Role.operator)
    operator.portal = nobody.portal
    look(nobody, service)
    (alarm,) = operator.get("/api/alarms/open").json()
    assert (alarm["kind"], alarm["severity"], alarm["cell"], alarm["run"]) == (kind, "high", CELL, run)
    assert alarm["message"]["parameters"]["cause"]["code"] == CAUSE.code
    assert alarm["advice"]["text"]
    assert operator.post(f"/api/alarms/{alarm['id']}/acknowledgement").json()["acknowledged_by"] == "account:operator"
    assert kinds(operator) == [kind]
    with service.store.write() as db:
        run_ledger.keep_steps(db, run_ledger.load_run(db, run), [Command.CLEAR, None], service.now())
    look(nobody, service)
    assert kinds(operator) == []
    (past,) = operator.get("/api/alarms").json()
    assert (past["id"], past["acknowledged_by"]) == (alarm["id"], "account:operator")
    assert past["cleared_at"] is not None


def test_a_stopped_run_is_told_once_and_not_where_nothing_had_moved(nobody, service, signed_in: As):
    operator = signed_in(Role.operator)
    operator.portal = nobody.portal
    add_run(service, Command.STOP, None, reason="cancelled", released=False)
    look(nobody, service)
    assert kinds(operator) == []
    add_run(service, None, Command.START, None, Command.STOP, None, reason="stop-asked")
    look(nobody, service)
    (alarm,) = operator.get("/api/alarms/open").json()
    assert alarm["kind"] == "run_stopped"
    operator.post(f"/api/alarms/{alarm['id']}/acknowledgement")
    look(nobody, service)
    assert kinds(operator) == []


def test_acknowledging_is_audited_and_needs_a_person_at_the_cell_or_an_administrator(nobody, service, signed_in: As):
    add_run(service, None, Command.START, None, Command.STOP, None, reason="stop-asked")
    look(nobody, service)
    clients = {role: signed_in(role) for role in Role}
    for client in clients.values():
        client.portal = nobody.portal
    alarm = clients[Role.viewer].get("/api/alarms/open").json()[0]["id"]
    for role in (Role.viewer, Role.mes):
        assert clients[role].post(f"/api/alarms/{alarm}/acknowledgement").status_code == 403
    assert clients[Role.engineer].post(f"/api/alarms/{alarm}/acknowledgement").status_code == 200
    assert clients[Role.admin].post(f"/api/alarms/{alarm}/acknowledgement").status_code == 404
    deeds = [entry for entry in clients[Role.admin].get("/api/audit").json() if entry["action"] == "alarm.acknowledge"]
    assert [(deed["who"], deed["detail"]["alarm"]) for deed in deeds] == [("account:engineer", alarm)]


def test_an_order_of_a_machine_that_waits_for_its_release_is_told_and_a_persons_own_is_not(nobody, service, signed_in: As):
    for who in ("account:anna", "key:mes-line-3"):
        run = add_run(service, None, reason="", who=who, released=False)
        look(nobody, service)
        assert kinds(signed_in(Role.viewer)) == (["order_waits"] if who.startswith("key") else [])
        with service.store.write() as db:
            run_ledger.keep_steps(db, run_ledger.load_run(db, run), [Command.STOP, None], service.now())
    look(nobody, service)
    assert kinds(signed_in(Role.viewer)) == []


Usage = namedtuple("Usage", "total used free")


@pytest.mark.parametrize(("free", "expected"), [(10**11, []), (10**9, ["disk_nearly_full"]), (10**8, ["disk_full"])])
def test_a_disk_is_told_before_runs_cannot_be_recorded(nobody, service, signed_in: As, monkeypatch, free, expected):
    monkeypatch.setattr(of_service.shutil, "disk_usage", lambda _: Usage(10**12, 0, free))
    look(nobody, service)
    assert kinds(signed_in(Role.viewer)) == expected


def test_what_cannot_be_judged_silences_no_other_alarm(nobody, service, signed_in: As, monkeypatch):
    def vanish(_: object) -> None:
        raise OSError("the folder is gone")

    monkeypatch.setattr(of_service.shutil, "disk_usage", vanish)
    add_run(service, None, Command.START, None, Command.ABORT, None, reason="no-room")
    look(nobody, service)
    assert kinds(signed_in(Role.viewer)) == ["run_aborted"]


def test_a_cell_that_cannot_be_used_is_told_until_it_can(nobody, service, signed_in: As):
    file = service.cells.folder / CELL / "cell.toml"
    good = file.read_text()
    file.write_text(good.replace("[robot]", "[robot"))
    look(nobody, service)
    (alarm,) = signed_in(Role.viewer).get("/api/alarms/open").json()
    assert (alarm["kind"], alarm["cell"]) == ("cell_flawed", CELL)
    assert alarm["message"]["parameters"]["flaw"]["code"]
    file.write_text(good)
    look(nobody, service)
    assert kinds(signed_in(Role.viewer)) == []


def test_a_webhook_that_does_not_take_what_it_is_sent_is_told_until_it_does_and_is_acknowledged(nobody, service, signed_in: As):
    now = service.now()
    with service.store.write() as db:
        db.add(Webhook(id="w", url="http://mes.invalid/", secret="x" * 16, made_by="account:admin", made_at=now))
        db.flush()
        db.add(Delivery(id="d", webhook="w", body="{}", attempts=2, made_at=now, due_at=now + timedelta(days=1)))
    look(nobody, service)
    assert kinds(signed_in(Role.viewer)) == []
    change_delivery(service, attempts=3)
    look(nobody, service)
    assert kinds(signed_in(Role.viewer)) == ["webhook_failing"]
    change_delivery(service, delivered_at=now, due_at=None)
    look(nobody, service)
    admin = signed_in(Role.admin)
    admin.portal = nobody.portal
    (alarm,) = admin.get("/api/alarms/open").json()
    assert alarm["cleared_at"] is not None
    admin.post(f"/api/alarms/{alarm['id']}/acknowledgement")
    assert kinds(admin) == []


def change_delivery(service: Service, **changed: Any) -> None:
    with service.store.write() as db:
        row = db.get(Delivery, "d")
        for name, value in changed.items():
            setattr(row, name, value)


def test_a_database_that_is_away_is_told_without_it_and_written_down_when_it_is_back(nobody, service, signed_in: As, monkeypatch):
    def away() -> None:
        raise OperationalError("x", None, Exception("away"))

    with monkeypatch.context() as broken:
        broken.setattr(service.store, "check_writable", away)
        look(nobody, service)
        assert [row.kind for row in service.alarms.book.open] == ["store_away"]
    look(nobody, service)
    assert service.alarms.book.open == []
    (past,) = signed_in(Role.viewer).get("/api/alarms").json()
    assert past["kind"] == "store_away"
    assert past["cleared_at"] is not None


def test_the_websocket_tells_all_at_once_then_what_changes_and_signs_of_life_between(nobody, service, signed_in: As):
    viewer = signed_in(Role.viewer)
    viewer.portal = nobody.portal
    with viewer.websocket_connect("/api/alarms/live", headers={"Origin": "http://testserver"}) as live:
        assert live.receive_json()["alarms"] == []
        assert live.receive_json()["alarms"] is None
        add_run(service, None, Command.START, None, Command.STOP, None, reason="stop-asked")
        look(nobody, service)
        told = next(found for _ in range(5) if (found := live.receive_json()["alarms"]) is not None)
        assert [alarm["kind"] for alarm in told] == ["run_stopped"]


@pytest.mark.parametrize("told", [False, True], ids=["untold", "told"])
def test_a_run_that_is_over_is_no_alarm_any_more_where_a_newer_one_has_moved(nobody, service, signed_in: As, clock, told: bool):
    """One that was told meanwhile stays open until somebody has seen it, but lasts no longer."""
    nobody.portal.call(service.alarms.close)  # nobody else looks meanwhile
    add_run(service, None, Command.START, None, Command.STOP, None, reason="stop-asked")
    if told:
        look(nobody, service)
        assert kinds(signed_in(Role.viewer)) == ["run_stopped"]
    clock.go_on(seconds=1)
    newer = add_run(service, None, Command.START, None, None, None, reason="")
    with service.store.read() as db:
        assert run_ledger.load_run(db, newer).state == State.COMPLETE
    look(nobody, service)
    alarms = signed_in(Role.viewer).get("/api/alarms/open").json()
    assert [(alarm["kind"], alarm["cleared_at"] is None) for alarm in alarms] == ([("run_stopped", False)] if told else [])
