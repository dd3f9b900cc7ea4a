"""What a release is bound to, from an order to the answer: the plan that waits, made for the cell as the order has it."""

from __future__ import annotations

from typing import Any

import pytest
from fastapi.testclient import TestClient

from core.planning.summary import PlanSummary
from core.sessions.leased import LEASE_S, Renewal
from server.people.roles import Role
from server.runner.messages import Ready, Release
from server.runner.plan_schemas import RunPlan
from server.runner.release_hash import release_sha256
from server.runs.lease import next_fence
from server.service import Service
from tests.server.made_people import As
from tests.server.real_service import wait_for
from tests.server.scripted_process import ObedientProcess, ScriptedProcess

CELL = "lwr4_bench"

pytestmark = pytest.mark.usefixtures("nothing_planned")


def show_plan(service: Service, run: str) -> ScriptedProcess:
    """The control process of a run has its plan, for the cell that it was told of."""
    wait_for(lambda: service.conductor.of_run(run), "the run to have its cell")
    robot = ObedientProcess.newest
    assert robot.order.run == run
    sha256 = release_sha256("digest", robot.order.cell, robot.order.payload_box)
    summary = PlanSummary(cell=CELL, poses=[], home_s=1.0, robot_s=30.0, plan_s=1.0, least_margin_m=0.1)
    robot.say(Ready(RunPlan(sha256=sha256, plan_digest="digest", summary=summary, paths=[], throws=[])))
    return robot


def release(service: Service, operator: TestClient, run: str, monkeypatch: pytest.MonkeyPatch) -> tuple[int, dict[str, Any]]:
    """By somebody who has just taken control and looks at the plan that waits."""
    wait_for(lambda: operator.get(f"/api/runs/{run}").json()["state"] == "Idle", "the plan to wait")
    with service.store.write() as db:
        fence = next_fence(db, CELL)
    control = service.control
    stamp_s, who = control.clock(), f"account:{Role.operator}"
    monkeypatch.setattr(control, "clock", lambda: stamp_s)  # a busy machine takes longer than the lease

    async def take() -> None:
        control.take(CELL, who, fence, LEASE_S)
        control.renew(CELL, who, Renewal(fence, 1, stamp_s))

    assert operator.portal is not None
    operator.portal.call(take)
    shown = operator.get(f"/api/runs/{run}/plan").json()
    sent = {"fence": fence, "number": 2, "stamp_s": stamp_s}
    body = {"plan_sha256": shown["plan"]["sha256"], "offer": shown["offer"], "sent": sent}
    answer = operator.post(f"/api/runs/{run}/release", json=body)
    return answer.status_code, answer.json()


@pytest.fixture
def operator(nobody: TestClient, signed_in: As) -> TestClient:
    client = signed_in(Role.operator)
    client.portal = nobody.portal  # one loop for all, as in a real service
    return client


@pytest.mark.parametrize("speed_m_s", [None, 0.1, 0.25])
def test_a_run_that_was_ordered_slow_is_released(
    speed_m_s: float | None, service: Service, operator: TestClient, with_key: As, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = with_key(Role.mes).post("/api/runs", json={"cell": CELL, "payload": "steel_block", "speed_m_s": speed_m_s}).json()["run"]
    robot = show_plan(service, run)
    status, answer = release(service, operator, run, monkeypatch)
    assert status == 200, answer
    assert any(isinstance(message, Release) for message in robot.told)


@pytest.mark.parametrize(("limit", "status"), [("0.2", 200), ("0.05", 409)])
def test_a_limit_that_has_changed_since_voids_a_slow_plan_where_that_is_too_fast_for_it(
    limit: str, status: int, service: Service, operator: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = operator.post("/api/runs", json={"cell": CELL, "payload": "steel_block", "speed_m_s": 0.1}).json()["run"]
    robot = show_plan(service, run)
    path = service.settings.cells_folder / CELL / "cell.toml"
    before = path.read_text()
    assert "cartesian_speed_m_s = 0.25" in before
    path.write_text(before.replace("cartesian_speed_m_s = 0.25", f"cartesian_speed_m_s = {limit}"))
    found, answer = release(service, operator, run, monkeypatch)
    assert found == status, answer
    assert any(isinstance(message, Release) for message in robot.told) == (status == 200)
