"""Which effect came when, from the diagnoses of several runs."""

from __future__ import annotations

from datetime import timedelta
from pathlib import Path
from typing import Any

from server.jobs import jobs
from server.jobs.kinds import DIAGNOSIS, DiagnosisOrder
from server.people.roles import Role
from server.service import Service
from tests.server.finished_diagnosis import explanation, finished_diagnosis
from tests.server.finished_run import finished_run
from tests.server.made_people import As, Clock

DELAYED: dict[str, Any] = {
    "effects": [explanation("time_delay", 0.95) | {"parameters": {"delay_s": {"value": 0.012, "std": 0.0004, "unit": "s"}}}]
}


def run_with(service: Service, clock: Clock, **found: Any) -> str:
    """A run of the next day, and its diagnosis with this answer."""
    clock.go_on(days=1)
    run = finished_run(service.store, clock(), None, cell="lwr4_bench", payload="gripper")
    finished_diagnosis(service.store, clock(), DiagnosisOrder(recording=Path(run), run=run), **found)
    return run


def test_an_effect_that_a_later_run_shows_came_between_the_two(service: Service, clock: Clock, signed_in: As) -> None:
    healthy = run_with(service, clock, verdict="no_gap")
    late = run_with(service, clock, **DELAYED)
    clock.go_on(days=1)
    unknown = finished_run(service.store, clock(), None, cell="lwr4_bench", payload="gripper")
    found = signed_in(Role.viewer).get("/api/timeline", params={"run": [unknown, late, healthy]}).json()
    assert [each["run"] for each in found["recordings"]] == [healthy, late]
    assert found["undiagnosed"] == [unknown]
    (effect,) = found["timeline"]["effects"]
    assert effect["id"] == "time_delay"
    assert [sighting["state"] for sighting in effect["sightings"]] == ["absent", "present"]
    assert effect["sightings"][1]["parameters"]["delay_s"]["value"] == 0.012
    (message,) = found["timeline"]["summary"]
    assert (message["code"], message["parameters"]["first"], message["parameters"]["then"]) == ("timeline-came", "1", "2")


def test_the_newest_diagnosis_of_a_run_counts(service: Service, clock: Clock, signed_in: As) -> None:
    run = run_with(service, clock, **DELAYED)
    newer = finished_diagnosis(service.store, clock() + timedelta(hours=1), DiagnosisOrder(recording=Path(run), run=run), verdict="no_gap")
    found = signed_in(Role.viewer).get("/api/timeline", params={"run": [run]}).json()
    assert [(each["run"], each["diagnosis"]) for each in found["recordings"]] == [(run, newer)]
    assert found["timeline"]["effects"] == []


def test_uploaded_recordings_have_their_place_among_runs_by_the_time_of_their_upload(service: Service, clock: Clock, signed_in: As) -> None:
    healthy = run_with(service, clock, verdict="no_gap")
    clock.go_on(days=1)
    order = DiagnosisOrder(recording=Path("upload-1"), cell="lwr4_bench", name="Friday, new cable")
    uploaded = finished_diagnosis(service.store, clock(), order, **DELAYED)
    later = run_with(service, clock, verdict="no_gap")
    asked = {"run": [later, healthy], "diagnosis": [uploaded]}
    found = signed_in(Role.viewer).get("/api/timeline", params=asked).json()
    assert [(each["run"], each["name"]) for each in found["recordings"]] == [(healthy, None), (None, "Friday, new cable"), (later, None)]
    assert found["recordings"][1]["diagnosis"] == uploaded
    assert [message["code"] for message in found["timeline"]["summary"]] == ["timeline-came", "timeline-went"]


def test_an_upload_whose_diagnosis_is_not_done_is_left_out_and_told(service: Service, clock: Clock, signed_in: As) -> None:
    with service.store.write() as db:
        waiting = jobs.add_job(db, DIAGNOSIS, DiagnosisOrder(recording=Path("upload-2")), None, "account:anna", clock()).id
    found = signed_in(Role.viewer).get("/api/timeline", params={"diagnosis": [waiting]}).json()
    assert (found["recordings"], found["undiagnosed"]) == ([], [waiting])
    assert signed_in(Role.viewer).get("/api/timeline", params={"diagnosis": ["none"]}).status_code == 404


def test_runs_of_which_one_is_not_known_are_refused(service: Service, clock: Clock, signed_in: As) -> None:
    run = run_with(service, clock, **DELAYED)
    assert signed_in(Role.viewer).get("/api/timeline", params={"run": [run, "none"]}).status_code == 404


def test_diagnoses_that_began_with_different_twins_are_not_held_against_each_other(service: Service, clock: Clock, signed_in: As) -> None:
    origin = {"recording": "one", "sha256": "0" * 64, "cell": "lwr4_bench", "joints": 7, "robot": None, "begins_s": 0.0, "twin": {}}
    one = run_with(service, clock, **DELAYED, origin=origin)
    other = run_with(service, clock, **DELAYED, origin=origin | {"twin": {"base_tilt": "1" * 64}})
    refused = signed_in(Role.viewer).get("/api/timeline", params={"run": [one, other]})
    assert refused.status_code == 422
    assert "another twin" in refused.text
