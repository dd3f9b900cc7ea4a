"""A run that has its cell, with a robot that does what the test says: what a database, a disk or a link that fails does to it."""

from __future__ import annotations

import errno
import time
from collections.abc import Callable
from typing import Any

import pytest
from fastapi.testclient import TestClient
from sqlalchemy.exc import OperationalError
from starlette.testclient import WebSocketDenialResponse
from starlette.websockets import WebSocketDisconnect

from core.errors import Cause
from core.events import PhaseStarted, RobotStopped, StepFinished
from core.planning.summary import PlanSummary
from core.sessions.leased import LEASE_S, Renewal
from server.people.roles import Role
from server.runner.live_schemas import LiveBatch
from server.runner.messages import End, Failed, Happened, Hold, Ready, Release, Resume, Sampled
from server.runner.plan_schemas import RunPlan
from server.runner.release_hash import release_sha256
from server.runs import journal as run_journal
from server.runs import ledger as run_ledger
from server.runs.lease import next_fence
from server.service import Service
from server.store.store import Store
from tests.server.made_people import As
from tests.server.scripted_process import ScriptedProcess
from tests.server.sentence import sentence

CELL = "lwr4_bench"


class Stage:
    """The running app with one run, its robot, and the operator who is in control of it."""

    def __init__(self, service: Service, operator: TestClient, anybody: TestClient) -> None:
        self.service, self.operator, self.anybody, self.number = service, operator, anybody, 0
        self.run = operator.post("/api/runs", json={"cell": CELL, "payload": "steel_block"}).json()["run"]
        until(lambda: getattr(ScriptedProcess, "newest", None) is not None and ScriptedProcess.newest.order.run == self.run)
        self.robot = ScriptedProcess.newest
        with service.store.write() as db:
            self.fence = next_fence(db, CELL)
        self.on_loop(service.control.take, CELL, "account:operator", self.fence, LEASE_S)

    def on_loop(self, function: Callable[..., Any], *arguments: Any) -> Any:
        async def call() -> Any:
            return function(*arguments)

        assert self.anybody.portal is not None
        return self.anybody.portal.call(call)

    @property
    def sent(self) -> dict[str, float]:
        self.number += 1
        stamp = self.service.control.clock()
        self.on_loop(self.service.control.renew, CELL, "account:operator", Renewal(self.fence, self.number, stamp))
        return {"fence": self.fence, "number": self.number, "stamp_s": stamp}

    def shown(self) -> dict[str, Any]:
        return dict(self.operator.get(f"/api/runs/{self.run}").json())

    def plan(self) -> None:
        order = self.robot.order
        sha256 = release_sha256("digest", order.cell, order.payload_box)
        summary = PlanSummary(cell=CELL, poses=[], home_s=1.0, robot_s=30.0, plan_s=1.0, least_margin_m=0.1)
        self.robot.say(Ready(RunPlan(sha256=sha256, plan_digest="digest", summary=summary, paths=[], throws=[])))
        until(lambda: self.shown()["state"] == "Idle")

    def release(self) -> Any:
        shown = self.operator.get(f"/api/runs/{self.run}/plan").json()
        body = {"plan_sha256": shown["plan"]["sha256"], "offer": shown["offer"], "sent": self.sent}
        return self.operator.post(f"/api/runs/{self.run}/release", json=body)

    def command(self, name: str) -> Any:
        return self.operator.post(f"/api/runs/{self.run}/commands", json={"command": name, "sent": self.sent})

    def moves(self) -> None:
        """Planned, released, under way."""
        self.plan()
        assert self.release().status_code == 200
        self.robot.say(Happened(PhaseStarted(phase="transfer", toward="x-", step=1, steps=7)))
        until(lambda: self.shown()["state"] == "Execute")


def until(condition: Callable[[], object], seconds: float = 10.0) -> None:
    """Polls."""
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.005)


@pytest.fixture
def stage(monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest) -> Stage:
    monkeypatch.setattr("server.runs.active_run.ControlProcess", ScriptedProcess)
    monkeypatch.setattr("server.runs.conductor.warm_up", lambda: None)
    monkeypatch.setattr("server.runs.store_follower.RETRY_S", 0.02)
    monkeypatch.setattr("server.runs.store_follower.PROBE_S", 0.05)
    monkeypatch.setattr("server.runs.active_run.STORE_LOOK_S", 0.02)
    monkeypatch.setattr("server.runs.active_run.RELEASE_PATIENCE_S", 0.3)
    anybody: TestClient = request.getfixturevalue("nobody")
    signed_in: As = request.getfixturevalue("signed_in")
    operator = signed_in(Role.operator)
    operator.portal = anybody.portal
    found = Stage(request.getfixturevalue("service"), operator, anybody)
    request.addfinalizer(lambda: ends(found))
    return found


def ends(stage: Stage) -> None:
    """The robot's process ends, so that the service can."""
    stage.robot.say(Failed("Commanded", sentence("the test is over")), None)


class Away:
    """A database that can be taken away from the run alone: requests still read it."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.gone = False
        write, check = Store.write, Store.check_writable

        def refuse() -> None:
            if self.gone:
                raise OperationalError("away", None, Exception("away"))

        def writing(store: Store) -> Any:
            refuse()
            return write(store)

        def checking(store: Store) -> None:
            refuse()
            check(store)

        monkeypatch.setattr(Store, "write", writing)
        monkeypatch.setattr(Store, "check_writable", checking)


@pytest.fixture
def away(monkeypatch: pytest.MonkeyPatch) -> Away:
    return Away(monkeypatch)


def held(cause: Cause) -> Callable[[Stage], bool]:
    """Whether the robot was told to hold for this."""
    return lambda stage: any(
        isinstance(each, Hold) and each.lateness is not None and each.lateness.cause is cause for each in stage.robot.told
    )


def test_a_database_that_is_away_for_a_moment_stops_nothing_and_gets_everything_afterwards(stage, away):
    stage.moves()
    away.gone = True
    for step in range(1, 4):
        stage.robot.say(Happened(StepFinished(step=step, steps=7)))
    until(lambda: stage.shown()["finished_steps"] == 3)
    assert not held(Cause.STORE)(stage)
    away.gone = False
    until(lambda: stage.service.conductor.of_run(stage.run)._follower.behind_s == 0.0)
    with stage.service.store.read() as db:
        assert run_ledger.load_run(db, stage.run).finished_steps == 3
        told = run_ledger.list_events(db, stage.run, 0)
    assert [sequence for sequence, _ in told] == list(range(1, stage.shown()["sequence"] + 1))


def test_a_database_that_stays_away_holds_the_robot_and_a_resume_waits_until_it_is_back(stage, away, monkeypatch):
    monkeypatch.setattr("server.runs.active_run.STORE_PATIENCE_S", 0.2)
    stage.moves()
    away.gone = True
    until(lambda: held(Cause.STORE)(stage))
    hold = next(each for each in stage.robot.told if isinstance(each, Hold))
    stop = RobotStopped(
        error="ControlLost", message=sentence("the database is late"), restart=1, final=False, held=True, lateness=hold.lateness
    )
    stage.robot.say(Happened(stop))
    until(lambda: stage.shown()["state"] == "Held")
    assert stage.shown()["reason_kind"] == "store-late"
    assert stage.shown()["lateness"]["limit_s"] == 0.2
    refused = stage.command("resume")
    assert refused.status_code == 503, refused.text
    assert not any(isinstance(each, Resume) for each in stage.robot.told)
    away.gone = False
    until(lambda: stage.command("resume").status_code == 200)
    assert any(isinstance(each, Resume) for each in stage.robot.told)


def test_nothing_begins_to_move_while_the_database_is_away(stage, away):
    stage.plan()
    away.gone = True
    refused = stage.release()
    assert refused.status_code == 503, refused.text
    assert refused.json()["kind"] == "store-unavailable"
    assert not any(isinstance(each, Release) for each in stage.robot.told)
    assert stage.shown()["state"] == "Idle"
    away.gone = False
    until(lambda: stage.release().status_code == 200)


def test_a_release_is_refused_where_the_disk_has_no_room_for_what_the_run_leaves(stage, monkeypatch):
    stage.plan()
    usage = type("Usage", (), {"free": 70_000_000})
    monkeypatch.setattr("server.runs.releases.shutil.disk_usage", lambda _: usage)
    refused = stage.release()
    assert refused.status_code == 507, refused.text
    assert refused.json()["type"] == "/problems/runs-disk-too-full"
    assert "70 MB are free" in refused.json()["detail"]
    assert stage.shown()["state"] == "Idle"


def test_a_journal_without_room_ends_the_motion_and_the_state_is_told_from_memory(stage, away, monkeypatch):
    stage.moves()
    away.gone = True

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(run_journal.os, "fdatasync", full)
    stage.robot.say(Happened(StepFinished(step=1, steps=7)))
    until(lambda: any(isinstance(each, End) for each in stage.robot.told))
    stopped = stage.anybody.post(f"/api/now/{CELL}/stop")
    assert stopped.status_code == 200, stopped.text
    stage.robot.say(Failed("Commanded", sentence("told to")), None)
    until(lambda: stage.shown()["state"] == "Stopped")
    assert stage.service.conductor.of_run(stage.run) is not None, "the database lacks it"
    monkeypatch.undo()
    until(lambda: stage.service.conductor.of_run(stage.run) is None)
    assert stage.shown()["state"] == "Stopped"
    assert stage.shown()["finished_steps"] == 1


def test_whoever_begins_to_watch_a_robot_on_hold_sees_its_newest_samples(stage):
    stage.moves()
    batch = LiveBatch(
        phase="hold:x+", t_s=[12.0], wrench=[[1.0] * 6], reconstructed=None, phi=[None] * 10, phi_std=[None] * 10, q_rad=[0.0] * 7,
        nearest=None, progress=0.4, eta_s=20.0,
    )  # fmt: skip
    stage.robot.say(Sampled(batch))
    until(lambda: stage.shown()["progress"] == 0.4)
    headers = {"origin": "http://testserver"}
    with stage.operator.websocket_connect(f"/api/runs/{stage.run}/live", headers=headers) as watching:
        while (message := watching.receive_json())["kind"] != "samples":
            pass
    assert message["t_s"] == [12.0]


def test_robots_are_told_to_anybody_as_they_change_and_again_and_again(stage):
    with stage.anybody.websocket_connect("/api/now/live") as watching:
        first, second = watching.receive_json(), watching.receive_json()
        assert [(each["cell"], each["run"], each["state"]) for each in first["robots"]] == [(CELL, stage.run, "Resetting")], first
        assert second["robots"] == first["robots"]
        stage.plan()
        while watching.receive_json()["robots"][0]["state"] != "Idle":
            pass


def test_whoever_watches_a_cell_is_told_its_run_and_who_is_in_control(stage):
    stage.moves()
    with stage.operator.websocket_connect(f"/api/cells/{CELL}/live", headers={"origin": "http://testserver"}) as watching:
        told = watching.receive_json()
        assert told["run"] | {"ends_at": None, "sequence": 0} == stage.shown() | {"ends_at": None, "sequence": 0}
        assert (told["control"]["holder"], told["control"]["fence"]) == ("account:operator", stage.fence)
        stage.on_loop(stage.service.control.let_go, CELL, "account:operator", stage.fence)
        while watching.receive_json()["control"]["holder"] is not None:
            pass


def test_who_is_not_signed_in_or_watches_what_there_is_not_is_told_so(stage):
    with pytest.raises(WebSocketDenialResponse) as refused, stage.anybody.websocket_connect(f"/api/cells/{CELL}/live"):
        pass
    assert refused.value.status_code == 401
    headers = {"origin": "http://testserver"}
    with (
        stage.operator.websocket_connect("/api/cells/nowhere/live", headers=headers) as watching,
        pytest.raises(WebSocketDisconnect) as unknown,
    ):
        watching.receive_json()
    assert unknown.value.code == 1008


def test_a_command_whose_process_ends_at_once_is_answered_and_kept(stage):
    class Hasty(ScriptedProcess):
        def tell(self, message: Any) -> None:
            super().tell(message)
            if isinstance(message, End):
                self.say(Failed("Commanded", message.reason), None)

    stage.robot.__class__ = Hasty
    assert stage.command("stop").status_code == 200
    until(lambda: stage.shown()["state"] == "Stopped")
    assert stage.shown()["reason_kind"] == "stop-asked"
