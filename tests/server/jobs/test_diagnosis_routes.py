"""Diagnoses as jobs: of uploaded recordings, which are somebody else's files."""

from __future__ import annotations

import io
import json
import time
import zipfile
from pathlib import Path

import numpy as np
import pytest
from fastapi.testclient import TestClient

from core.errors import BadRecording
from core.gap.diagnosis import diagnose
from core.recording.folder import read_recording
from server.jobs import jobs
from server.jobs.kinds import DIAGNOSIS, DiagnosisOrder, diagnoses, locate_overlay
from server.people.roles import Role
from server.runner.overlay_schemas import OverlayPublic
from server.runs.recording_archive import unpack_recording
from server.service import Service
from tests.server.finished_diagnosis import finished_diagnosis, standing_recording
from tests.server.made_people import As

ZIP = {"Content-Type": "application/zip"}


@pytest.fixture(scope="module")
def standing(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return standing_recording(tmp_path_factory.mktemp("standing") / "recording")


def zipped(files: dict[str, bytes], *, symlink: str | None = None) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
        if symlink is not None:
            entry = zipfile.ZipInfo(symlink)
            entry.external_attr = 0o120777 << 16
            archive.writestr(entry, "/etc/passwd")
    return buffer.getvalue()


def files_of(folder: Path) -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in folder.iterdir()}


def waited(client: TestClient, place: str) -> dict:
    for _ in range(600):
        found = client.get(place).json()
        if found["state"] in ("done", "failed"):
            return found
        time.sleep(0.1)
    raise AssertionError(found)


def test_an_uploaded_recording_is_diagnosed_as_the_engine_does_it(signed_in: As, standing):
    client = signed_in(Role.engineer)
    answer = client.post("/api/diagnoses/uploads", content=zipped(files_of(standing)), headers=ZIP)
    assert answer.status_code == 202, answer.text
    found = waited(client, answer.headers["location"])
    assert found["state"] == "done"
    assert found["result"]["verdict"] == diagnose(read_recording(standing)).verdict
    listed = next(each for each in client.get("/api/diagnoses").json() if each["diagnosis"] == found["diagnosis"])
    assert (listed["summary"], listed["result"]) == (found["result"]["summary"], None)
    report = f"/api/diagnoses/{found['diagnosis']}/report"
    assert '<html lang="en">' in client.get(report).text
    assert '<html lang="de">' in client.get(report, params={"language": "de"}).text
    assert '<html lang="en">' in client.get(report, params={"language": "xx"}).text


def test_a_diagnosis_knows_the_cell_of_its_recording_and_starts_from_its_twin(signed_in: As, service: Service, standing) -> None:
    client = signed_in(Role.engineer)
    answer = client.post("/api/diagnoses/uploads?cell=lwr4_bench", content=zipped(files_of(standing)), headers=ZIP)
    found = waited(client, answer.headers["location"])
    assert (found["state"], found["cell"]) == ("done", "lwr4_bench")
    with service.store.read() as db:
        row = jobs.load_job(db, DIAGNOSIS, answer.json()["diagnosis"])
    _, cell, *_ = diagnoses(service.settings, service.cells).arguments(row)
    assert cell == service.cells.load("lwr4_bench")
    assert client.post("/api/diagnoses/uploads?cell=none", content=zipped(files_of(standing)), headers=ZIP).status_code == 404


def test_an_upload_has_the_name_that_it_was_given_and_its_report_is_named_after_it(signed_in: As, tmp_path: Path) -> None:
    client = signed_in(Role.engineer)
    files = files_of(standing_recording(tmp_path / "recording", payload="gripper"))
    query = {"cell": "lwr4_bench", "name": " Line 3, nach Kollision (früh) "}
    answer = client.post("/api/diagnoses/uploads", params=query, content=zipped(files), headers=ZIP)
    found = waited(client, answer.headers["location"])
    assert (found["name"], found["tool"]) == ("Line 3, nach Kollision (früh)", "gripper")
    sent = client.get(f"/api/diagnoses/{found['diagnosis']}/report").headers["content-disposition"]
    day = found["ended_at"][:10]
    assert f'filename="diagnosis-Line_3_nach_Kollision_fruh-gripper-{day}.html"' in sent
    refused = client.post("/api/diagnoses/uploads", params={"name": "a\nb"}, content=zipped(files), headers=ZIP)
    assert refused.status_code == 422


def test_a_recording_of_another_robot_or_cell_is_not_taken_for_this_cells_twin(signed_in: As, service: Service, tmp_path: Path) -> None:
    client = signed_in(Role.engineer)
    files = files_of(standing_recording(tmp_path / "recording"))
    asked = client.post("/api/diagnoses/uploads?cell=ur5e_line", content=zipped(files), headers=ZIP)
    assert (asked.status_code, asked.json()["type"]) == (422, "/problems/jobs-upload-of-other-cell")
    manifest = json.loads(files["recording.json"])
    del manifest["cell"]
    files["recording.json"] = json.dumps(manifest).encode()
    asked = client.post("/api/diagnoses/uploads?cell=ur5e_line", content=zipped(files), headers=ZIP)
    assert (asked.status_code, asked.json()["type"]) == (422, "/problems/jobs-upload-of-other-robot")
    assert list(service.settings.recordings_folder.glob("upload-*")) == []
    assert client.post("/api/diagnoses/uploads", content=zipped(files), headers=ZIP).status_code == 202


def test_every_verdict_comes_with_what_to_do_in_the_list_as_well(signed_in: As, service: Service, tmp_path: Path) -> None:
    made = finished_diagnosis(service.store, service.now(), DiagnosisOrder(recording=tmp_path), verdict="no_gap")
    client = signed_in(Role.viewer)
    (listed,) = client.get("/api/diagnoses").json()
    whole = client.get(f"/api/diagnoses/{made}").json()
    assert listed["instruction"] == whole["instruction"] == whole["result"]["instruction"]
    assert (listed["instruction"]["level"], listed["instruction"]["sentence"]["text"]) == ("nothing", "Nothing to do")


def test_a_list_names_what_stands_beside_the_verdict_and_matters(signed_in: As, service: Service, tmp_path) -> None:
    said = dict.fromkeys(("title", "sentence", "advice", "remark"), "text")
    seen = said | {"side": "reading", "parameters": {}, "times_expected": 2.0, "values": {}}
    also = [seen | {"id": "sensor_noise", "material": True}, seen | {"id": "joint_friction", "material": False}]
    diagnosis = finished_diagnosis(service.store, service.now(), DiagnosisOrder(recording=tmp_path), verdict="no_gap", also=also)
    older = finished_diagnosis(service.store, service.now(), DiagnosisOrder(recording=tmp_path), verdict="no_gap")
    listed = {each["diagnosis"]: each["also"] for each in signed_in(Role.viewer).get("/api/diagnoses").json()}
    assert (listed[diagnosis], listed[older]) == (["sensor_noise"], [])


def test_measured_and_simulated_are_there_to_plot_where_there_was_enough_to_compare(signed_in: As, service: Service, standing) -> None:
    client = signed_in(Role.engineer)
    place = client.post("/api/diagnoses/uploads", content=zipped(files_of(standing)), headers=ZIP).headers["location"]
    diagnosis = waited(client, place)["diagnosis"]
    nothing = client.get(f"{place}/overlay")
    assert nothing.status_code == 409
    assert "nothing to overlay" in nothing.json()["detail"]
    kept = OverlayPublic(t_s=[0.1], phase=["transfer"], channels=[])
    locate_overlay(service.settings, diagnosis).write_text(kept.model_dump_json())
    assert client.get(f"{place}/overlay").json() == kept.model_dump()


def test_a_recording_that_cannot_be_read_fails_with_its_reason(signed_in: As, standing):
    client = signed_in(Role.engineer)
    broken = files_of(standing) | {"recording.json": b"{}"}
    answer = client.post("/api/diagnoses/uploads", content=zipped(broken), headers=ZIP)
    found = waited(client, answer.headers["location"])
    assert found["state"] == "failed"
    assert "recording.json" in found["reason"]["text"]


def test_a_diagnosis_that_waits_or_runs_is_cancelled_and_its_recording_stays(signed_in: As, service: Service, tmp_path: Path) -> None:
    client = signed_in(Role.engineer)
    order = DiagnosisOrder(recording=standing_recording(tmp_path / "recording"))
    with service.store.write() as db:
        diagnosis = jobs.add_job(db, DIAGNOSIS, order, None, "account:anna", service.now()).id  # nobody has woken the worker
    answer = client.delete(f"/api/diagnoses/{diagnosis}").json()
    assert (answer["state"], answer["reason"]["text"]) == ("cancelled", "cancelled by engineer.")
    assert client.delete(f"/api/diagnoses/{diagnosis}").status_code == 409
    assert signed_in(Role.admin).get("/api/audit").json()[0]["action"] == "diagnosis.cancel"
    assert len(read_recording(order.recording)) == 400


def test_a_run_without_a_recording_cannot_be_diagnosed(signed_in: As):
    answer = signed_in(Role.engineer).post("/api/diagnoses", json={"run": "no-such-run"})
    assert answer.status_code == 404


def test_what_leads_elsewhere_in_a_zip_lands_in_the_folder_or_nowhere(tmp_path, standing):
    hostile = {f"../../{name}": content for name, content in files_of(standing).items()} | {"/etc/cron.d/x": b"", "evil.py": b""}
    (tmp_path / "upload").write_bytes(zipped(hostile))
    (tmp_path / "a" / "b").mkdir(parents=True)
    unpack_recording(tmp_path / "upload", tmp_path / "a" / "b" / "c")
    assert {file.name for file in (tmp_path / "a" / "b" / "c").iterdir()} == set(files_of(standing))
    assert sorted(file.name for file in tmp_path.iterdir()) == ["a", "upload"]
    np.testing.assert_array_equal(read_recording(tmp_path / "a" / "b" / "c").t, read_recording(standing).t)


@pytest.mark.parametrize(
    "content",
    [
        b"no zip at all",
        zipped({}),
        zipped({"samples.parquet": b"x"}),
        zipped({"a/recording.json": b"{}", "b/recording.json": b"{}"}),
        zipped({"recording.json": b"{}"} | {f"{k}.urdf": b"" for k in range(50)}),
        zipped({"recording.json": b"0" * 450_000_000}),
    ],
    ids=["no zip", "empty", "no manifest", "two recordings", "many files", "bomb"],
)
def test_what_is_no_recording_is_refused_and_leaves_nothing(tmp_path, content):
    (tmp_path / "upload").write_bytes(content)
    with pytest.raises(BadRecording):
        unpack_recording(tmp_path / "upload", tmp_path / "recording")
    assert [file.name for file in tmp_path.iterdir()] == ["upload"]


def test_a_link_in_a_zip_is_only_a_file_with_a_path_in_it(tmp_path, standing):
    (tmp_path / "upload").write_bytes(zipped(files_of(standing) | {}, symlink="x/robot2.urdf"))
    unpack_recording(tmp_path / "upload", tmp_path / "recording")
    assert not any(file.is_symlink() for file in (tmp_path / "recording").iterdir())
