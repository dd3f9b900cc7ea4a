"""The motion that a diagnosis proposes, queued as a run: for the robot and the payload that were diagnosed, and for nothing else."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import pytest
from fastapi.testclient import TestClient

from core.cell.cell import CELL_FILE
from core.cell.folder import load_cell
from core.payload.shapes import Box
from server.jobs import jobs
from server.jobs.kinds import DIAGNOSIS, DiagnosisOrder
from server.people.roles import Role
from server.runner.run_folder import RECORDING
from server.runs import ledger as run_ledger
from server.runs.reason import Reason
from server.runs.schemas import RunCreate
from server.service import Service
from tests.server.finished_diagnosis import SWINGS, finished_diagnosis, standing_recording
from tests.server.made_people import As
from tests.server.scripted_process import ScriptedProcess
from tests.server.sentence import sentence

CELL, PAYLOAD = "lwr4_bench", "steel_block"
ROOMY = Box(size_m=(0.3, 0.3, 0.3))


@pytest.fixture
def first_run(nothing_planned: None, service: Service) -> str:
    """A run that was stopped early, with a box of its own; the robot only stood."""
    with service.store.write() as db:
        order = RunCreate.model_validate({"cell": CELL, "payload": PAYLOAD, "seed": 7, "payload_box": ROOMY})
        run = run_ledger.add_run(db, order, "account:anna", service.now())
        run_ledger.end(db, run, Reason("stopped", sentence("stopped")), service.now())
    standing_recording(recording_of(service, run.id), service.cells.load(CELL), PAYLOAD)
    return run.id


def recording_of(service: Service, run: str) -> Path:
    return (service.settings.recordings_folder / run / RECORDING).absolute()


def diagnosed(service: Service, run: str, proposed: dict[str, Any] | None = SWINGS) -> str:
    order = DiagnosisOrder(recording=recording_of(service, run), run=run, cell=CELL)
    return finished_diagnosis(service.store, service.now(), order, next_experiment=proposed)


def asked(client: TestClient, diagnosis: str, key: str | None = None, **body: object) -> Any:
    headers = {} if key is None else {"Idempotency-Key": key}
    return client.post(f"/api/diagnoses/{diagnosis}/motion", json=body, headers=headers)


def begun(run: str) -> ScriptedProcess:
    """What was made for the run."""
    until = time.monotonic() + 10
    while getattr(ScriptedProcess, "newest", None) is None or ScriptedProcess.newest.order.run != run:
        assert time.monotonic() < until, "the run did not begin"
        time.sleep(0.002)
    return ScriptedProcess.newest


def refused(answer: Any) -> str:
    assert answer.status_code == 409, answer.text
    return str(answer.json()["detail"])


def test_the_run_is_told_the_stops_the_recording_and_the_box_of_the_run_that_it_continues(
    signed_in: As, service: Service, first_run: str
) -> None:
    operator, diagnosis = signed_in(Role.operator), diagnosed(service, first_run)
    answer = asked(operator, diagnosis, payload=PAYLOAD, pace="as_fast_as_possible")
    assert answer.status_code == 202, answer.text
    run = answer.json()
    assert answer.headers["location"] == f"/api/runs/{run['run']}"
    assert int(answer.headers["retry-after"]) > 0
    assert (run["continues"], run["diagnosis"], run["state"]) == (first_run, diagnosis, "Resetting")
    order = begun(run["run"]).order
    assert order.continues is not None
    assert order.continues.recording == recording_of(service, first_run)
    assert [stop.model_dump(mode="json", exclude_none=True)["down"] for stop in order.continues.stops] == [[0.0, 1.0, 0.0]]
    assert (order.payload, order.payload_box, order.seed, order.pace) == (PAYLOAD, ROOMY, 8, "as_fast_as_possible")
    said = [entry for entry in signed_in(Role.admin).get("/api/audit").json() if entry["action"] == "run.queue"]
    assert said[-1]["detail"] == {"run": run["run"], "cell": CELL, "diagnosis": diagnosis}


def test_an_order_system_queues_it_once_and_cannot_release_it(with_key: As, service: Service, first_run: str) -> None:
    mes, diagnosis = with_key(Role.mes), diagnosed(service, first_run)
    runs = {asked(mes, diagnosis, key="motion-1").json()["run"] for _ in range(3)}
    assert len(runs) == 1
    assert asked(mes, diagnosed(service, first_run), key="motion-1").status_code == 422
    body = {"plan_sha256": "0" * 64, "offer": "1.0.x", "sent": {"fence": 1, "number": 1, "stamp_s": 1.0}}
    assert mes.post(f"/api/runs/{runs.pop()}/release", json=body).status_code == 403
    assert asked(with_key(Role.viewer), diagnosis).status_code == 403


@pytest.mark.parametrize(
    ("proposed", "why"),
    [
        (None, "proposes no motion"),
        (SWINGS | {"stops": [], "motion": "the same run with a second payload"}, "the same run with a second payload"),
        (SWINGS | {"planned": False, "refused": "no path to y-"}, "no path to y-"),
    ],
    ids=["nothing", "another payload", "no room"],
)
def test_a_diagnosis_that_proposes_no_motion_that_can_be_made_says_why(
    proposed: dict[str, Any] | None, why: str, signed_in: As, service: Service, first_run: str
) -> None:
    assert why in refused(asked(signed_in(Role.operator), diagnosed(service, first_run, proposed)))


def test_another_payload_than_the_diagnosed_one_is_refused(signed_in: As, service: Service, first_run: str) -> None:
    why = refused(asked(signed_in(Role.operator), diagnosed(service, first_run), payload="gripper"))
    assert '"steel_block", not with "gripper"' in why


@pytest.mark.parametrize(
    ("line", "instead", "why"),
    [
        ('sensor_frame = "ft_sensor"', 'sensor_frame = "link7"', "another robot"),
        (f'name = "{CELL}"\n', f'name = "{CELL}"\ngravity_m_s2 = [0.0, 0.5, -9.8]\n', "gravity"),
    ],
)
def test_a_cell_that_has_changed_since_is_refused(
    line: str, instead: str, why: str, signed_in: As, service: Service, first_run: str
) -> None:
    file = service.cells.folder / CELL / CELL_FILE
    assert line in file.read_text()
    file.write_text(file.read_text().replace(line, instead))
    load_cell(file.parent)
    said = refused(asked(signed_in(Role.operator), diagnosed(service, first_run)))
    assert "has changed since the recording" in said
    assert why in said


def test_an_uploaded_recording_is_continued_where_its_cell_and_payload_are_known(
    signed_in: As, service: Service, nothing_planned: None, tmp_path: Path
) -> None:
    operator = signed_in(Role.operator)

    def uploaded(name: str, cell: str | None, payload: str | None) -> Any:
        order = DiagnosisOrder(recording=standing_recording(tmp_path / name, payload=payload), cell=cell)
        return asked(operator, finished_diagnosis(service.store, service.now(), order, next_experiment=SWINGS))

    assert uploaded("good", CELL, PAYLOAD).json()["continues"] is None
    assert "no cell of this service" in refused(uploaded("elsewhere", None, PAYLOAD))
    assert "has no name" in refused(uploaded("nameless", CELL, None))
    assert "another robot" in refused(uploaded("other", "ur5e_line", "cylinder"))


def test_a_diagnosis_that_is_not_done_or_whose_recording_is_gone_is_refused(signed_in: As, service: Service, first_run: str) -> None:
    operator = signed_in(Role.operator)
    gone = DiagnosisOrder(recording=service.settings.recordings_folder / "gone", cell=CELL)
    assert "gone" in refused(asked(operator, finished_diagnosis(service.store, service.now(), gone, next_experiment=SWINGS)))
    waiting = diagnosed(service, first_run)
    with service.store.write() as db:
        jobs.load_job(db, DIAGNOSIS, waiting).result = None
    assert "only one that is done" in refused(asked(operator, waiting))
