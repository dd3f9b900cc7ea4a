"""A cell's twin over the API: shown, added to by a job that may be refused, taken from; all of it written down."""

from __future__ import annotations

import time
from datetime import UTC, datetime
from multiprocessing import get_context
from pathlib import Path

import pytest
from fastapi.testclient import TestClient

from core.cell.cell import TWIN_FILE
from core.cell.folder import load_cell
from core.twin.file import read_twin, write_twin
from core.twin.twin import NOMINAL, Entry, Fitted, Twin
from server.jobs import jobs
from server.jobs.jobs import JobStatus
from server.jobs.kinds import ADDITION, AdditionOrder, DiagnosisOrder, additions
from server.people.roles import Role
from server.runner import twin_adding
from server.runner.messages import Answered, Failed
from server.service import Service
from tests.server.finished_diagnosis import explanation, finished_diagnosis
from tests.server.made_people import As

CELL = "lwr4_bench"
TWIN = f"/api/cells/{CELL}/twin"
DELAY = Entry(
    effect="time_delay",
    parameters={"delay_s": Fitted(value=0.012, std=0.0002, unit="s")},
    covariance=((0.0002**2,),),
    recording="faulty",
    sha256="0" * 64,
    added=datetime(2026, 3, 1, tzinfo=UTC),
    gap_before=2.4,
    gap_after=1.02,
)


@pytest.fixture
def late(service: Service) -> Path:
    """The folder of a cell whose twin is late."""
    cell = load_cell(service.cells.folder / CELL)
    write_twin(cell, Twin(effects=(DELAY,)))
    return cell.folder


def diagnosed(service: Service, recording: Path, *named: str) -> str:
    """A diagnosis that is done and names effects."""
    effects = [explanation(each, 0.9) for each in named]
    return finished_diagnosis(service.store, service.now(), DiagnosisOrder(recording=recording), effects=effects)


def ended(client: TestClient, place: str) -> dict:
    for _ in range(600):
        found = client.get(place).json()
        if found["state"] not in ("waiting", "running"):
            return found
        time.sleep(0.1)
    raise AssertionError(found)


def audited(signed_in: As) -> list[str]:
    return [entry["action"] for entry in signed_in(Role.admin).get("/api/audit").json()]


def test_a_twin_is_shown_and_an_effect_taken_out_of_it(service: Service, signed_in: As, late: Path) -> None:
    client = signed_in(Role.engineer)
    [shown] = client.get(TWIN).json()["effects"]
    assert shown["parameters"] == {"delay_s": {"value": 0.012, "std": 0.0002, "unit": "s"}}
    assert client.delete(f"{TWIN}/base_tilt").status_code == 404
    assert client.delete(f"{TWIN}/time_delay").json() == {"effects": []}
    assert not (late / TWIN_FILE).exists()
    assert read_twin(load_cell(late)) == NOMINAL
    assert audited(signed_in)[0] == "twin.remove"


def test_a_twin_file_that_somebody_changed_is_refused_in_words(signed_in: As, late: Path) -> None:
    (late / TWIN_FILE).write_text('{"effects": [{"effect": 3}]}')
    answer = signed_in(Role.viewer).get(TWIN)
    assert answer.status_code == 422
    assert answer.json()["kind"] == "bad-twin"


def test_what_a_recording_does_not_show_is_not_added_and_the_reason_stands_in_the_job(
    service: Service, signed_in: As, tmp_path: Path
) -> None:
    client = signed_in(Role.engineer)
    diagnosis = diagnosed(service, tmp_path / "no recording", "time_delay")
    answer = client.post(TWIN, json={"diagnosis": diagnosis, "effect": "time_delay"})
    assert answer.status_code == 202, answer.text
    found = ended(client, answer.headers["location"])
    assert found["state"] == "failed"
    assert "no recording" in found["reason"]["text"]
    assert client.get(TWIN).json() == {"effects": []}
    assert audited(signed_in)[0] == "twin.queue"


def test_an_effect_that_the_diagnosis_does_not_name_is_refused_at_once(service: Service, signed_in: As, tmp_path: Path) -> None:
    client = signed_in(Role.engineer)
    diagnosis = diagnosed(service, tmp_path, "time_delay")
    refused = client.post(TWIN, json={"diagnosis": diagnosis, "effect": "base_tilt"})
    assert refused.status_code == 422
    assert "time_delay" in refused.json()["detail"]
    assert client.post(TWIN, json={"diagnosis": "none", "effect": "base_tilt"}).status_code == 404


def test_an_effect_that_no_twin_takes_is_refused_at_once_with_the_reason(service: Service, signed_in: As, tmp_path: Path) -> None:
    client = signed_in(Role.engineer)
    refused = explanation("time_delay", 0.9) | {"addable": False, "why_not": "time_delay closing 1 % of the gap"}
    older = {key: value for key, value in explanation("base_tilt", 0.1).items() if key != "addable"}
    order = DiagnosisOrder(recording=tmp_path)
    diagnosis = finished_diagnosis(service.store, service.now(), order, effects=[refused, older])
    for effect, why in (("time_delay", "time_delay closing 1 % of the gap"), ("base_tilt", "does not say")):
        answer = client.post(TWIN, json={"diagnosis": diagnosis, "effect": effect})
        assert answer.status_code == 422
        assert why in answer.json()["detail"]


def test_nothing_is_taken_out_while_something_is_being_added(service: Service, signed_in: As, late: Path, tmp_path: Path) -> None:
    order = AdditionOrder(cell=CELL, effect="base_tilt", diagnosis="x", recording=tmp_path)
    with service.store.write() as db:
        jobs.add_job(db, ADDITION, order, CELL, "account:anna", service.now())  # nobody has woken the worker
    assert signed_in(Role.engineer).delete(f"{TWIN}/time_delay").status_code == 409
    assert (late / TWIN_FILE).exists()


def test_an_addition_is_cancelled_in_its_own_cell_and_leaves_the_twin_as_it_was(
    service: Service, signed_in: As, late: Path, tmp_path: Path
) -> None:
    order = AdditionOrder(cell=CELL, effect="base_tilt", diagnosis="x", recording=tmp_path)
    with service.store.write() as db:
        addition = jobs.add_job(db, ADDITION, order, CELL, "account:anna", service.now()).id  # nobody has woken the worker
    client, before = signed_in(Role.engineer), (late / TWIN_FILE).read_bytes()
    assert client.delete(f"/api/cells/other/twin/additions/{addition}").status_code == 404
    answer = client.delete(f"{TWIN}/additions/{addition}").json()
    assert (answer["state"], answer["reason"]["text"], answer["twin"]) == ("cancelled", "cancelled by account:engineer.", None)
    assert client.delete(f"{TWIN}/additions/{addition}").status_code == 409
    assert audited(signed_in)[0] == "twin.cancel"
    assert (late / TWIN_FILE).read_bytes() == before


def test_what_was_fitted_is_said_and_in_the_cells_folder_once_the_job_is_done(
    service: Service, late: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(twin_adding, "give_way", lambda: None)
    monkeypatch.setattr(twin_adding, "with_effect", lambda twin, *_, **__: twin.with_entry(DELAY.move_parameters({"delay_s": 0.003})))
    hearing, saying = get_context("spawn").Pipe(duplex=False)
    twin_adding.main(load_cell(late), tmp_path, "time_delay", saying)
    answer = hearing.recv()
    assert isinstance(answer, Answered)
    assert read_twin(load_cell(late)).effects[0].parameters["delay_s"].value == pytest.approx(0.012)
    with service.store.write() as db:
        order = AdditionOrder(cell=CELL, effect="time_delay", diagnosis="x", recording=tmp_path)
        row = jobs.add_job(db, ADDITION, order, CELL, "account:anna", service.now())
        row.state, row.result = JobStatus.done, answer.text
        additions(service.cells).also(db, row)
    assert Twin.model_validate_json(answer.text) == read_twin(load_cell(late))
    assert read_twin(load_cell(late)).effects[0].parameters["delay_s"].value == pytest.approx(0.015)
    monkeypatch.setattr(twin_adding, "with_effect", lambda twin, *_, **__: twin.with_entry(DELAY.move_parameters({"delay_s": 99.0})))
    twin_adding.main(load_cell(late), tmp_path, "time_delay", saying)
    assert isinstance(hearing.recv(), Failed)
    assert read_twin(load_cell(late)).effects[0].parameters["delay_s"].value == pytest.approx(0.015)
