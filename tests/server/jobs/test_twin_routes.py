"""A cell's twin over the API: shown, added to as a diagnosis found it, taken from; at once, and all of it written down."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest
from fastapi.testclient import TestClient

from core.cell.cell import TWIN_FILE
from core.cell.folder import load_cell
from core.twin.file import read_twin, write_twin
from core.twin.twin import NOMINAL, Entry, Fitted, Twin
from server.jobs import jobs
from server.jobs.kinds import DIAGNOSIS, DiagnosisOrder
from server.people.roles import Role
from server.runner import work
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


@pytest.fixture(autouse=True)
def _no_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever is asked here is answered by the service itself."""

    def start(*_: object, **__: object) -> None:
        raise AssertionError

    monkeypatch.setattr(work, "start_process", start)


def tilt(**changes: Any) -> dict[str, Any]:
    """A tilted base as a diagnosis finds it."""
    values = {f"about_{axis}_rad": {"value": 0.01, "std": 0.001, "unit": "rad"} for axis in "xy"}
    return explanation("base_tilt", 0.9) | {"parameters": values, "covariance": [[1e-6], [0.0, 1e-6]]} | changes


def diagnosed(service: Service, *effects: dict[str, Any], began: Twin = NOMINAL, **changes: Any) -> str:
    """A diagnosis that is done, of a recording that nobody needs any more."""
    origin = {"recording": "faulty", "sha256": "0" * 64, "cell": CELL, "joints": 7, "twin": began.hashes}
    gap = {"before": 2.4, "after": 1.0, "held_out": [], "by_channel": {}}
    found = {"effects": effects, "origin": origin, "gap": gap} | changes
    return finished_diagnosis(service.store, service.now(), DiagnosisOrder(recording=Path("gone"), cell=CELL), **found)


def add(client: TestClient, diagnosis: str, effect: str = "base_tilt") -> Any:
    return client.post(TWIN, json={"diagnosis": diagnosis, "effect": effect})


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


def test_what_a_diagnosis_found_is_in_the_twin_with_the_answer(service: Service, signed_in: As, late: Path) -> None:
    client = signed_in(Role.engineer)
    answer = add(client, diagnosed(service, tilt(), began=Twin(effects=(DELAY,))))
    assert answer.status_code == 200, answer.text
    assert [entry["effect"] for entry in answer.json()["effects"]] == ["time_delay", "base_tilt"]
    assert client.get(TWIN).json() == answer.json()
    added = read_twin(load_cell(late)).effects[1]
    assert added.covariance == ((1e-6, 0.0), (0.0, 1e-6))
    assert (added.recording, added.sha256, added.gap_before, added.gap_after) == ("faulty", "0" * 64, 2.4, 1.0)
    assert added.added == service.now()
    assert audited(signed_in)[0] == "twin.add"


def test_nothing_is_added_to_a_twin_that_has_changed_since_the_diagnosis(service: Service, signed_in: As, late: Path) -> None:
    client, before = signed_in(Role.engineer), (late / TWIN_FILE).read_bytes()
    refused = add(client, diagnosed(service, tilt()))  # it began with the nominal twin
    assert (refused.status_code, refused.json()["kind"]) == (422, "bad-twin")
    assert "found a change of time_delay since the diagnosis" in refused.json()["detail"]
    assert str(late.parent) not in refused.text
    assert (late / TWIN_FILE).read_bytes() == before
    client.delete(f"{TWIN}/time_delay")
    assert add(client, diagnosed(service, tilt())).status_code == 200
    assert add(client, diagnosed(service, tilt())).status_code == 200  # it replaces what it found itself


def test_what_cannot_be_added_is_refused_with_the_reason(service: Service, signed_in: As) -> None:
    client = signed_in(Role.engineer)
    against = {"addable": False, "why_not": "base_tilt closing 1 % of the gap"}
    elsewhere = {"recording": "faulty", "sha256": "0" * 64, "cell": "ur5e_line", "joints": 6, "twin": {}}
    for diagnosis, why in (
        (diagnosed(service, explanation("time_delay", 0.9)), "expected one that the diagnosis names: time_delay"),
        (diagnosed(service), "it names none"),
        (diagnosed(service, tilt(**against)), "base_tilt closing 1 % of the gap"),
        (diagnosed(service, tilt(), origin=None), "an earlier version made, expected one with all that a twin needs; diagnose"),
        (diagnosed(service, tilt(), origin=elsewhere), "a recording of the cell 'ur5e_line'"),
    ):
        refused = add(client, diagnosis)
        assert refused.status_code == 422
        assert why in refused.json()["detail"]
    assert add(client, "none").status_code == 404
    with service.store.write() as db:
        waiting = jobs.add_job(db, DIAGNOSIS, DiagnosisOrder(recording=Path("gone")), None, "account:anna", service.now()).id
    assert add(client, waiting).status_code == 409
    assert client.get(TWIN).json() == {"effects": []}
    assert "twin.add" not in audited(signed_in)


def test_an_effect_that_does_not_exist_any_more_can_still_be_taken_out(signed_in: As, late: Path) -> None:
    write = (late / TWIN_FILE).write_text
    write((late / TWIN_FILE).read_text().replace('"time_delay"', '"time_travel"'))
    assert signed_in(Role.engineer).delete(f"{TWIN}/time_travel").json() == {"effects": []}
