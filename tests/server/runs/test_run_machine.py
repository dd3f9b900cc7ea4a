"""Every command in every state by every role, in whatever order, against the running app: what the table says happens, and nothing else."""

from __future__ import annotations

import shutil
import time
from dataclasses import dataclass
from typing import Any

import pytest
from fastapi.testclient import TestClient
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule, run_state_machine_as_test

from core.errors import Cause, Lateness
from core.events import PhaseStarted, RobotStopped
from core.planning.summary import PlanSummary
from core.sessions.leased import LEASE_S, Renewal
from server.people.roles import Role
from server.runner.messages import End, Failed, Happened, MotionEnded, Ready
from server.runner.plan_schemas import RunPlan
from server.runner.release_hash import release_sha256
from server.runs.lease import next_fence
from server.service import Service
from tests.server.made_people import As
from tests.server.scripted_process import ScriptedProcess
from tests.server.sentence import sentence

CELL = "lwr4_bench"
AFTER: dict[str, dict[str, str]] = {
    "Resetting": {"stop": "Stopping", "abort": "Aborting"},
    "Idle": {"release": "Starting", "stop": "Stopping", "abort": "Aborting"},
    "Starting": {"stop": "Stopping", "abort": "Aborting"},
    "Execute": {"hold": "Holding", "stop": "Stopping", "abort": "Aborting"},
    "Holding": {"stop": "Stopping", "abort": "Aborting"},
    "Held": {"resume": "Unholding", "stop": "Stopping", "abort": "Aborting"},
    "Unholding": {"stop": "Stopping", "abort": "Aborting"},
    "Suspended": {"stop": "Stopping", "abort": "Aborting"},
    "Completing": {"stop": "Stopping", "abort": "Aborting"},
    "Stopping": {"abort": "Aborting"},
    "Aborting": {},
    "Aborted": {"clear": "Stopped"},
    "Stopped": {},
}
"""The table of docs/runs.md once more, written down from it."""
COMMANDS = ("release", "hold", "resume", "stop", "abort", "clear")
ALLOWED = {command: {Role.operator, Role.engineer} for command in COMMANDS} | {"release": {Role.operator}}
MOVES = ("Starting", "Execute", "Holding", "Unholding", "Suspended", "Held")


@dataclass
class Plant:
    """The running app and who stands round it."""

    service: Service
    portal: TestClient
    clients: dict[Role, TestClient]

    def on_loop(self, function: Any, *arguments: Any) -> Any:
        """Calls it where the app runs."""

        async def call() -> Any:
            return function(*arguments)

        assert self.portal.portal is not None
        return self.portal.portal.call(call)


@pytest.fixture
def scripted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Before the app starts: its robots do what the test says."""
    monkeypatch.setattr("server.runs.active_run.ControlProcess", ScriptedProcess)
    monkeypatch.setattr("server.runs.conductor.warm_up", lambda: None)


@pytest.fixture
def plant(scripted: None, nobody: TestClient, service: Service, signed_in: As) -> Plant:
    clients = {role: signed_in(role) for role in Role}
    for client in clients.values():
        client.portal = nobody.portal  # one loop for all, as in a real service
    return Plant(service, nobody, clients)


class Runs(RuleBasedStateMachine):
    """One run after the other; `state` is what the model says."""

    plant: Plant

    @initialize()
    def queue(self) -> None:
        order = {"cell": CELL, "payload": "steel_block"}
        answer = self.plant.clients[Role.operator].post("/api/runs", json=order)
        assert answer.status_code == 202, answer.text
        self.run, self.state, self.ended, self.number = answer.json()["run"], "Resetting", False, 0
        until = time.monotonic() + 10
        while getattr(ScriptedProcess, "newest", None) is None or ScriptedProcess.newest.order.run != self.run:
            assert time.monotonic() < until, "the run did not begin"
            time.sleep(0.002)
        self.robot = ScriptedProcess.newest

    def shown(self) -> dict[str, Any]:
        found: dict[str, Any] = self.plant.clients[Role.viewer].get(f"/api/runs/{self.run}").json()
        del found["ends_at"]  # goes on with the clock
        return found

    def settled(self, state: str) -> None:
        """What the robot said has reached the store."""
        self.state = state
        until = time.monotonic() + 5
        while self.shown()["state"] != state:
            assert time.monotonic() < until, (self.shown()["state"], state)
            time.sleep(0.002)

    def sent(self, role: Role) -> dict[str, float]:
        """Of whoever has just taken control and answered a stamp; engineers cannot take it, so theirs is nobody's."""
        self.number += 1
        control, who = self.plant.service.control, f"account:{role}"
        stamp = control.clock()
        if role is Role.operator:
            with self.plant.service.store.write() as db:
                self.fence = next_fence(db, CELL)
            self.plant.on_loop(control.take, CELL, who, self.fence, LEASE_S)
            self.plant.on_loop(control.renew, CELL, who, Renewal(self.fence, self.number, stamp))
        return {"fence": getattr(self, "fence", 0), "number": self.number, "stamp_s": stamp}

    @rule(command=st.sampled_from(COMMANDS), role=st.sampled_from(list(Role)))
    def command(self, command: str, role: Role) -> None:
        client, before = self.plant.clients[role], self.shown()
        if command == "release":
            plan = self.plant.clients[Role.viewer].get(f"/api/runs/{self.run}/plan")
            shown = plan.json() if plan.status_code == 200 else {"plan": {"sha256": "0" * 64}, "offer": "1.0.x"}
            body = {"plan_sha256": shown["plan"]["sha256"], "offer": shown["offer"], "sent": self.sent(role)}
            answer = client.post(f"/api/runs/{self.run}/release", json=body)
        else:
            answer = client.post(f"/api/runs/{self.run}/commands", json={"command": command, "sent": self.sent(role)})
        in_control = role is Role.operator or command in ("stop", "abort")
        if role not in ALLOWED[command]:
            assert answer.status_code == 403, answer.text
        elif command in AFTER[self.state] and in_control and not (command == "clear" and not self.ended):
            assert answer.status_code == 200, answer.text
            self.state = AFTER[self.state][command]
        else:
            assert answer.status_code == 409, answer.text
        if answer.status_code != 200:
            assert self.shown() == before

    @rule(role=st.sampled_from(list(Role)))
    def cancel(self, role: Role) -> None:
        answer = self.plant.clients[role].delete(f"/api/runs/{self.run}")
        if role not in (Role.operator, Role.mes):
            assert answer.status_code == 403
        elif self.state in ("Resetting", "Idle"):
            assert answer.status_code == 200
            self.state = "Stopping"
        else:
            assert answer.status_code == 409

    @precondition(lambda self: self.state == "Resetting")
    @rule()
    def plan_is_ready(self) -> None:
        order = self.robot.order
        sha256 = release_sha256("digest", order.cell, order.payload_box)
        summary = PlanSummary(cell=CELL, poses=[], home_s=1.0, robot_s=30.0, plan_s=1.0, least_margin_m=0.1)
        self.robot.say(Ready(RunPlan(sha256=sha256, plan_digest="digest", summary=summary, paths=[], throws=[])))
        self.settled("Idle")

    @precondition(lambda self: self.state in ("Starting", "Unholding", "Suspended"))
    @rule()
    def a_phase_begins(self) -> None:
        self.robot.say(Happened(PhaseStarted(phase="transfer", toward="x+", step=1, steps=7)))
        self.settled("Execute")

    @precondition(lambda self: self.state in ("Starting", "Execute", "Unholding"))
    @rule()
    def the_guard_stops_the_robot(self) -> None:
        self.robot.say(Happened(RobotStopped(error="TooClose", message=sentence("too close"), restart=1, final=False)))
        self.settled("Suspended")

    @precondition(lambda self: self.state == "Holding")
    @rule()
    def it_stands_as_asked(self) -> None:
        self.robot.say(Happened(RobotStopped(error="Held", message=sentence("held"), restart=1, final=False, held=True)))
        self.settled("Held")

    @precondition(lambda self: self.state in ("Starting", "Execute", "Holding", "Unholding"))
    @rule(cause=st.sampled_from([Cause.NETWORK, Cause.PAGE, Cause.SERVICE, Cause.STORE, Cause.CONTROL_PROCESS]))
    def something_is_late(self, cause: Cause) -> None:
        late = Lateness(cause=cause, late_s=1.2, limit_s=1.0)
        stop = RobotStopped(error="ControlLost", message=sentence("late"), restart=1, final=False, held=True, lateness=late)
        self.robot.say(Happened(stop))
        self.settled("Held")
        found = self.shown()
        assert found["lateness"] == late.model_dump(mode="json")
        assert found["reason_kind"] == f"{cause.replace('_', '-')}-late"
        assert found["held_since"] is not None

    @precondition(lambda self: self.state == "Held")
    @rule()
    def nobody_comes_back(self) -> None:
        self.robot.say(Happened(RobotStopped(error="HoldExpired", message=sentence("nobody"), restart=1, final=True)))
        self.robot.say(Failed("HoldExpired", sentence("nobody came back")), None)
        self.settled("Stopped")
        assert self.shown()["reason_kind"] == "hold-expired"
        self._end()

    @precondition(lambda self: self.state == "Execute")
    @rule()
    def it_is_home(self) -> None:
        self.robot.say(MotionEnded())
        self.settled("Completing")

    @precondition(lambda self: not self.ended)
    @rule()
    def it_fails(self) -> None:
        after = {"Resetting": "Stopped", "Idle": "Stopped", "Stopping": "Stopped"}.get(self.state, "Aborted")
        self.robot.say(Failed("BadState", sentence("the sensor is dead")), None)
        self.settled(after)
        self._end()

    def _end(self) -> None:
        self.ended = True
        until = time.monotonic() + 5
        while self.plant.service.conductor.of_run(self.run) is not None:
            assert time.monotonic() < until
            time.sleep(0.002)

    @invariant()
    def the_app_says_what_the_model_says(self) -> None:
        found = self.shown()
        assert found["state"] == self.state
        offered = set(AFTER[self.state]) - {"release"}
        assert set(found["commands"]) == offered
        assert found["safety_rated"] is False
        if self.state in ("Stopping", "Aborting"):
            assert any(isinstance(message, End) for message in self.robot.told)
        assert found["released"] or self.state not in MOVES

    def teardown(self) -> None:
        if not self.ended:
            self.it_fails()
        if self.state == "Aborted":
            self.command("clear", Role.operator)
        assert self.shown()["state"] == "Stopped"
        shutil.rmtree(self.plant.service.conductor.folder / self.run, ignore_errors=True)


@pytest.mark.parametrize("runs", [12, pytest.param(25, marks=pytest.mark.thorough)])
def test_commands_do_what_the_table_says_in_whatever_order(plant: Plant, runs: int) -> None:
    Runs.plant = plant
    careful = settings(
        max_examples=runs, stateful_step_count=25, deadline=None, derandomize=True, database=None, suppress_health_check=list(HealthCheck)
    )
    run_state_machine_as_test(Runs, settings=careful)
