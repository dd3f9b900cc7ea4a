"""Logs of other programs on their way through the service, from their files to a diagnosis."""

from __future__ import annotations

import gzip
import io
import json
import time
import zipfile
from collections.abc import Callable, Iterable
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from fastapi.testclient import TestClient
from typer.testing import CliRunner

from core.cli.main import app
from core.estimation.result import Result
from core.recording.folder import read_recording
from core.recording.logs.tables import KINDS
from server.app import create_app
from server.imports.log_archive import LOG_KINDS
from server.people.roles import Role
from server.settings import Settings
from tests.core.cli.test_import_log import exported
from tests.core.recording.logs.foreign_logs import write_ati, write_csv, write_rtde, write_transforms, write_undecided
from tests.core.recording.logs.payload_log import MASS_KG
from tests.core.recording.logs.torque_log import ANSWERS, write_torque_log
from tests.server.made_people import As, Clock
from tests.torque_recordings import make

FILE = {"content-type": "application/octet-stream"}
LOGS = Path(__file__).parents[3] / "docs" / "logs"
KUKA, UR5 = LOGS / "kuka-med14", LOGS / "ur5-pushes"


@pytest.fixture
def operator(signed_in: As) -> TestClient:
    return signed_in(Role.operator)


def begin(client: TestClient) -> str:
    """The address of a new import."""
    begun = client.post("/api/imports")
    assert begun.status_code == 201, begun.text
    return str(begun.headers["location"])


def send(client: TestClient, *files: Path) -> str:
    """The address of an import with these files, of which a folder goes as a zip."""
    path = begin(client)
    for file in files:
        name, content = (f"{file.name}.zip", zipped(file.iterdir())) if file.is_dir() else (file.name, file.read_bytes())
        sent = client.put(f"{path}/files/{name}", content=content, headers=FILE)
        assert sent.status_code == 200, sent.text
    return path


def zipped(files: Iterable[Path], *into: str) -> bytes:
    """A zip of the files, in each of these folders."""
    whole = io.BytesIO()
    with zipfile.ZipFile(whole, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in files:
            for folder in into or ("bag/",):
                archive.write(file, f"{folder}{file.name}")
    return whole.getvalue()


def read(client: TestClient, path: str, **answers: str) -> dict[str, Any]:
    """How far the log is understood."""
    answered = client.put(f"{path}/reading", json={"answers": answers})
    assert answered.status_code == 200, answered.text
    found: dict[str, Any] = answered.json()["reading"]
    return found


def refused(client: TestClient, path: str, **body: Any) -> tuple[int, str]:
    answered = client.put(f"{path}/reading", json=body)
    problem = answered.json()
    return answered.status_code, problem["flaws"][0]["code"] if problem["flaws"] else problem["type"].rpartition("/")[2]


def left(settings: Settings) -> list[Path]:
    """Whatever lies in the folder of imports."""
    return list(settings.imports_folder.rglob("*"))


FORMATS: dict[str, tuple[Callable[[Path], Path | tuple[Path, ...]], int, str]] = {
    "csv": (write_csv, -1, "sensor"),
    "rtde": (write_rtde, 1, "base"),
    "ati with poses": (write_ati, 1, "sensor"),
    "ros 1": (lambda folder: write_transforms(folder, "ros1"), 1, "sensor"),
    "ros 2, sqlite": (lambda folder: write_transforms(folder, "sqlite"), 1, "sensor"),
    "ros 2, mcap": (lambda folder: next(write_transforms(folder, "mcap").glob("*.mcap")), 1, "sensor"),
}


@pytest.mark.parametrize(
    "form", [form if form in ("csv", "rtde", "ros 2, mcap") else pytest.param(form, marks=pytest.mark.thorough) for form in FORMATS]
)
def test_a_log_is_understood_without_a_question_and_is_a_recording_then(operator: TestClient, tmp_path: Path, form: str) -> None:
    write, sign, axes = FORMATS[form]
    made = write(tmp_path)
    path = send(operator, *(made if isinstance(made, tuple) else (made,)))
    found = read(operator, path)
    understood = found["understood"]
    assert (found["question"], found["contradiction"]) == (None, None)
    assert (understood["sign"], understood["axes"]) == (sign, axes)
    assert understood["mass_kg"] == pytest.approx(MASS_KG, rel=0.01)
    assert {len(line["values"]) for part in ("force_n", "torque_n_m", "down") for line in found["preview"][part]} == {
        len(found["preview"]["t_s"])
    }
    with zipfile.ZipFile(io.BytesIO(operator.get(f"{path}/recording").content)) as archive:
        archive.extractall(tmp_path / "unpacked")
    (folder,) = (tmp_path / "unpacked").iterdir()
    recording = read_recording(folder)
    assert len(recording) == understood["rows_kept"]
    assert recording.orientation is not None
    assert (folder / "map.toml").read_text() == operator.get(f"{path}/mapping").text


@pytest.mark.parametrize("log", [KUKA, UR5])
def test_logs_of_real_arms_become_recordings_that_are_kept_for_a_diagnosis(
    operator: TestClient, settings: Settings, signed_in: As, log: Path
) -> None:
    path = send(operator, *sorted(log.iterdir()))
    found = read(operator, path)
    assert (found["question"], found["contradiction"]) == (None, None)
    queued = operator.post(f"{path}/diagnosis", json={"name": "other people's"})
    assert queued.status_code == 202, queued.text
    assert (queued.json()["name"], queued.json()["cell"]) == ("other people's", None)
    assert operator.delete(queued.headers["location"]).status_code == 200
    assert left(settings) == []
    assert operator.get(path).json()["type"] == "/problems/imports-unknown"
    (kept,) = settings.recordings_folder.glob("upload-*")
    assert len(read_recording(kept)) == found["understood"]["rows_kept"]
    entries = {each["action"]: each["detail"] for each in signed_in(Role.engineer).get("/api/audit").json()}
    sent = [text.split()[0] for key, text in entries["recording.import"].items() if key.startswith("file_")]
    assert (entries["recording.import"]["recording"], sorted(sent)) == (kept.name, sorted(file.name for file in log.iterdir()))


@pytest.mark.thorough
def test_a_log_of_a_real_arm_is_diagnosed(operator: TestClient) -> None:
    path = send(operator, *sorted(UR5.iterdir()))
    read(operator, path)
    done = until_over(operator, operator.post(f"{path}/diagnosis", json={}).headers["location"])
    assert (done["state"], done["result"] is not None) == ("done", True)


def until_over(client: TestClient, place: str) -> dict[str, Any]:
    for _ in range(6000):
        found: dict[str, Any] = client.get(place).json()
        if found["state"] in ("done", "failed"):
            return found
        time.sleep(0.1)
    raise AssertionError(found)


def test_what_cannot_be_told_is_asked_one_after_the_other_with_the_likely_answer(operator: TestClient, tmp_path: Path) -> None:
    path = send(operator, write_undecided(tmp_path))
    asked = read(operator, path)
    assert asked["understood"] is None
    assert (asked["question"]["key"], asked["question"]["likely"]) == ("wrench.axes", "sensor")
    assert asked["question"]["reason"]["code"] == "import-why-wrench-axes"
    for download in ("mapping", "recording"):
        assert operator.get(f"{path}/{download}").json()["type"] == "/problems/imports-question-open"
    assert operator.post(f"{path}/diagnosis", json={}).json()["type"] == "/problems/imports-question-open"
    then = read(operator, path, **{"wrench.axes": "sensor"})
    assert (then["question"]["key"], then["question"]["choices"]) == ("wrench.sign", ["1", "-1"])
    answers = {"wrench.axes": "sensor", "wrench.sign": "-1"}
    found = read(operator, path, **answers)
    assert (found["question"], found["understood"]["sign"]) == (None, -1)
    assert operator.get(path).json()["answers"] == answers


@pytest.mark.thorough
def test_a_slip_is_named_and_mended_by_changing_what_was_understood(operator: TestClient, tmp_path: Path) -> None:
    path = send(operator, Path(exported(tmp_path, scale=1000.0)[0]))
    found = read(operator, path)
    assert "N mm" in found["contradiction"]["text"]
    assert operator.post(f"{path}/diagnosis", json={}).json()["type"] == "/problems/imports-contradicted"
    (unit,) = (each for each in found["changes"] if each["key"] == "wrench.torque_unit")
    assert (unit["value"], "N mm" in unit["choices"]) == ("N m", True)
    assert read(operator, path, **{"wrench.torque_unit": "N mm"})["contradiction"] is None


def test_in_one_of_our_cells_the_joints_are_those_of_its_robot(operator: TestClient, tmp_path: Path) -> None:
    path = send(operator, Path(exported(tmp_path)[0]))
    answered = operator.put(f"{path}/reading", json={"cell": "lwr4_bench"}).json()
    assert answered["cell"] == "lwr4_bench"
    understood = answered["reading"]["understood"]
    assert (understood["motion"], understood["sensor_frame"], len(answered["reading"]["preview"]["joints_rad"])) == (
        "joints",
        "ft_sensor",
        7,
    )
    assert answered["reading"]["preview"]["down"] == []
    queued = operator.post(f"{path}/diagnosis", json={})
    assert (queued.status_code, queued.json()["cell"]) == (202, "lwr4_bench")
    assert operator.delete(queued.headers["location"]).status_code == 200


def test_the_zip_of_several_files_is_what_they_are_one_by_one(operator: TestClient, tmp_path: Path) -> None:
    path = begin(operator)
    content = zipped(write_ati(tmp_path), "")
    assert operator.put(f"{path}/files/both.zip", content=content, headers={"content-type": "application/zip"}).status_code == 200
    assert read(operator, path)["understood"]["clock"]["file"] == "ati.csv"


def test_files_come_and_go_before_it_is_read(operator: TestClient, settings: Settings, tmp_path: Path) -> None:
    ati, poses = write_ati(tmp_path)
    path = begin(operator)
    assert refused(operator, path) == (409, "imports-no-log-yet")
    for file in (ati, poses, write_csv(tmp_path)):
        assert operator.put(f"{path}/files/{file.name}", content=file.read_bytes(), headers=FILE).status_code == 200
    asked = read(operator, path)["question"]
    assert (asked["key"], asked["choices"], asked["likely"]) == ("wrench.file", ["ati.csv", "log.csv"], None)
    assert [each["file"] for each in operator.delete(f"{path}/files/log.csv").json()["files"]] == ["ati.csv", "poses.csv"]
    assert operator.get(path).json()["reading"] is None
    assert operator.get(f"{path}/mapping").json()["type"] == "/problems/imports-not-read"
    assert operator.delete(f"{path}/files/log.csv").json()["type"] == "/problems/imports-file-unknown"
    assert read(operator, path)["question"] is None
    for name in ("a.toml", "b.toml"):
        operator.put(f"{path}/files/{name}", content=(KUKA / "map.toml").read_bytes(), headers=FILE)
    assert refused(operator, path) == (409, "imports-several")
    assert operator.delete(path).status_code == 204
    assert left(settings) == []


def damaged() -> dict[str, tuple[str, bytes, str]]:
    """Files that are none, by what is wrong: name, content, and the code with which reading them is refused."""
    text = gzip.decompress((KUKA / "wrench.csv.gz").read_bytes())
    whole = (KUKA / "wrench.csv.gz").read_bytes()
    return {
        "cut off": ("wrench.csv.gz", whole[: len(whole) // 2], "recording-broken-csv"),
        "no mcap": ("log.mcap", b"\x89MCAP0\r\n\x01\xff", "bag-broken"),
        "no parquet": ("log.parquet", b"PAR1 nothing", "recording-broken-parquet"),
        "no bag": ("log.bag", b"#ROSBAG V2.0\n\xff\xff", "bag-broken"),
        "no database": ("log.db3", b"SQLite format 3\x00\xff", "bag-broken"),
        "names alone": ("log.csv", b"t,fx,fy,fz,tx,ty,tz\n", "recording-rows"),
        "text for numbers": ("log.csv", text.replace(b"1", b"x", 500), "recording-text-for-number"),
        "other columns": ("log.csv", b"a,b\n1,2\n3,4\n", "import-not-recognised"),
        "binary": ("log.csv", bytes(range(256)) * 100, ""),
        "a bomb": ("log.csv.gz", gzip.compress(b"t,fx\n" + b"0," * 50_000_000), ""),
    }


@pytest.mark.parametrize("what", damaged())
def test_a_broken_file_is_refused_in_a_sentence_and_leaves_no_recording(operator: TestClient, settings: Settings, what: str) -> None:
    name, content, code = damaged()[what]
    path = begin(operator)
    assert operator.put(f"{path}/files/{name}", content=content, headers=FILE).status_code == 200
    status, found = refused(operator, path)
    assert status == 422
    assert code in ("", found)
    assert sorted(file.name for file in left(settings) if file.is_file()) == [name]
    assert operator.get(path).json()["progress"] is None
    assert operator.delete(path).status_code == 204
    assert left(settings) == []


UNFIT = {
    "a name that leads outside": ("..%2F..%2Fx.csv", b"x", 404, ""),
    "a hidden file": (".x.csv", b"x", 422, "imports-name-unusual"),
    "backslashes": ("..%5Cx.csv", b"x", 422, "imports-name-unusual"),
    "a long name": ("x" * 200 + ".csv", b"x", 422, "imports-name-unusual"),
    "another kind": ("log.exe", b"x", 422, "imports-kind-unknown"),
    "nothing": ("log.csv", b"", 422, "imports-file-empty"),
    "no zip": ("bag.zip", b"nothing", 422, "uploads-not-unpackable"),
    "a zip without a log": ("bag.zip", zipped([Path(__file__)]), 422, "imports-no-log-inside"),
    "two of one name": ("bag.zip", zipped([KUKA / "wrench.csv.gz"], "a/", "b/"), 422, "uploads-two-recordings"),
}


@pytest.mark.parametrize("what", UNFIT)
def test_what_is_no_log_is_refused_when_it_is_sent_and_leaves_nothing(operator: TestClient, settings: Settings, what: str) -> None:
    name, content, status, code = UNFIT[what]
    path = begin(operator)
    sent = operator.put(f"{path}/files/{name}", content=content, headers=FILE)
    assert sent.status_code == status, sent.text
    assert code in ("", sent.json()["flaws"][0]["code"] if sent.json()["flaws"] else "")
    assert [file for file in left(settings) if file.name != "logs" and file.parent != settings.imports_folder] == []


def test_a_zip_leads_nowhere_and_a_recording_of_ours_is_sent_on(operator: TestClient, settings: Settings, tmp_path: Path) -> None:
    path = begin(operator)
    assert operator.put(f"{path}/files/a.zip", content=zipped([write_csv(tmp_path)], "../../"), headers=FILE).status_code == 200
    assert [file.relative_to(settings.imports_folder).parts[1:] for file in left(settings) if file.is_file()] == [
        ("logs", "a.zip", "log.csv")
    ]
    (tmp_path / "recording.json").write_text("{}")
    own = operator.put(f"{path}/files/b.zip", content=zipped([tmp_path / "recording.json"]), headers=FILE)
    assert own.json()["flaws"][0]["code"] == "imports-own-recording"


def test_a_robot_or_a_mapping_reads_nothing_outside_of_the_import(operator: TestClient, tmp_path: Path) -> None:
    path = send(operator, write_csv(tmp_path))
    content = (
        f'[wrench]\ntime = "time"\nforce = ["Fx", "Fy", "Fz"]\ntorque = ["Mx", "My", "Mz"]\n[joints]\ntime = "time"\nurdf = "{KUKA}/x"\n'
    )
    content += 'names = ["a"]\nbase_frame = "b"\nsensor_frame = "c"\nposition = ["x [mm]"]\n'
    assert operator.put(f"{path}/files/map.toml", content=content, headers=FILE).status_code == 200
    assert refused(operator, path) == (422, "files-leads-outside")
    assert refused(operator, path, cell="nowhere")[1] == "request-cell-unknown"
    assert refused(operator, path, answers={"wrench.nothing": "1"})[0] == 422
    assert refused(operator, path, answers={"a": "b" * 1000})[1] == "schema-string-too-long"


def test_what_nobody_goes_on_with_is_gone_and_so_is_what_an_earlier_service_left(
    operator: TestClient, settings: Settings, clock: Clock, signed_in: As, tmp_path: Path
) -> None:
    old = send(operator, write_csv(tmp_path))
    clock.go_on(seconds=timedelta(hours=3).total_seconds())
    later = signed_in(Role.operator)
    assert later.get(old).status_code == 404
    assert left(settings) == []
    begun = [later.post("/api/imports") for _ in range(11)]
    assert [each.status_code for each in begun] == [201] * 10 + [409]
    for each in begun[:10]:
        assert later.delete(each.headers["location"]).status_code == 204


def test_a_service_that_starts_anew_knows_none_of_them(tmp_path: Path) -> None:
    settings = Settings(data=tmp_path / "data")
    (settings.imports_folder / "0123").mkdir(parents=True)
    (settings.imports_folder / "0123" / "log.csv").write_text("x")
    with TestClient(create_app(settings)):
        assert left(settings) == []


def test_the_payload_of_a_log_is_identified_as_the_command_line_does_and_the_import_stays(operator: TestClient, tmp_path: Path) -> None:
    path = send(operator, write_csv(tmp_path))
    assert operator.post(f"{path}/identification").json()["type"] == "/problems/imports-not-read"
    read(operator, path)
    assert operator.get(f"{path}/result").json()["type"] == "/problems/imports-not-identified"
    answered = operator.post(f"{path}/identification")
    assert answered.status_code == 200, answered.text
    found = answered.json()["identified"]
    by_command = CliRunner().invoke(app, ["identify", str(tmp_path / "log.csv"), "--json", "-"])
    said = json.loads(by_command.stdout)
    assert (found["parameters"], found["covariance"]) == (said["estimate"]["phi"], said["estimate"]["covariance"])
    assert [each["code"] for each in found["warnings"]] == [each["code"] for each in said["warnings"]]
    assert abs(found["mass_kg"] - MASS_KG) < 1.96 * found["mass_std_kg"]
    assert 0.0 < found["budget"]["repeatability_std"][0] < found["mass_std_kg"]
    assert Result.model_validate_json(operator.get(f"{path}/result").content).estimate is not None
    for language, title in (("en", "Where the uncertainty comes from"), ("de", "Woher die Unsicherheit kommt")):
        page = operator.get(f"{path}/report", params={"language": language})
        assert title in page.text, language
        assert "sandbox" in page.headers["content-security-policy"]
    read(operator, path, **{"wrench.sign": "-1"})
    assert operator.get(path).json()["identified"] is None
    assert operator.get(f"{path}/report").status_code == 409
    assert operator.post(f"{path}/diagnosis", json={}).status_code == 202


@pytest.mark.thorough
def test_the_payload_of_a_log_is_held_against_what_its_cell_needs(operator: TestClient, tmp_path: Path) -> None:
    path = send(operator, Path(exported(tmp_path)[0]))
    assert operator.put(f"{path}/reading", json={"cell": "lwr4_bench"}).status_code == 200
    found = operator.post(f"{path}/identification").json()["identified"]
    assert found["requirement"]["adequacy"] is not None


@pytest.mark.thorough
def test_two_logs_of_joint_torques_with_and_without_the_payload_are_compared_as_the_command_line_does(
    operator: TestClient, tmp_path: Path
) -> None:
    pair = make(3, mass_kg=2.8, gain_std=0.005)
    paths, files = {}, {}
    for name, recording in (("with", pair.loaded), ("without", pair.empty)):
        files[name] = write_torque_log(tmp_path, name, recording)
        paths[name] = send(operator, *files[name])
    unread = operator.post(f"{paths['with']}/identification", json={"without": named(paths["without"])})
    assert unread.json()["type"] == "/problems/imports-not-read"
    for path in paths.values():
        found = read(operator, path, **ANSWERS)
        assert (found["question"], found["contradiction"]) == (None, None)
        understood, preview = found["understood"], found["preview"]
        assert (understood["force"], understood["sign"], understood["joint_torques"]["columns"][0]) == (None, None, "tau0")
        assert (preview["force_n"], len(preview["joint_torques_n_m"]), len(preview["joints_rad"])) == ([], 6, 6)
    itself = operator.post(f"{paths['with']}/identification", json={"without": named(paths["with"])})
    assert (itself.status_code, itself.json()["type"]) == (409, "/problems/imports-without-itself")
    assert operator.post(f"{paths['with']}/identification", json={"without": "nothing"}).json()["type"] == "/problems/imports-unknown"
    answered = operator.post(f"{paths['with']}/identification", json={"without": named(paths["without"])})
    assert answered.status_code == 200, answered.text
    found = answered.json()["identified"]
    assert answered.json()["without"] == ["without.csv", "arm.urdf"]
    for name, path in paths.items():
        with zipfile.ZipFile(io.BytesIO(operator.get(f"{path}/recording").content)) as archive:
            archive.extractall(tmp_path / f"unpacked {name}")
    (loaded,), (empty,) = ((tmp_path / f"unpacked {name}").iterdir() for name in paths)
    by_command = CliRunner().invoke(app, ["identify", str(loaded), "--without", str(empty), "--json", "-"])
    said = json.loads(by_command.stdout)
    assert (found["parameters"], found["covariance"]) == (said["estimate"]["phi"], said["estimate"]["covariance"])
    assert abs(found["mass_kg"] - pair.phi[0]) < 3.0 * found["mass_std_kg"]
    assert Result.model_validate_json(operator.get(f"{paths['with']}/result").content).joints
    assert "j5" in operator.get(f"{paths['with']}/report").text
    known = read(operator, paths["with"], **ANSWERS, **{"joints.torque_gain_std": "0.005"})
    assert {each["key"]: each["value"] for each in known["changes"]}["joints.torque_gain_std"] == "0.005"
    surer = operator.post(f"{paths['with']}/identification", json={"without": named(paths["without"])}).json()["identified"]
    assert surer["mass_std_kg"] < 0.5 * found["mass_std_kg"]
    assert abs(surer["mass_kg"] - pair.phi[0]) < 3.0 * surer["mass_std_kg"]
    alone = operator.post(f"{paths['with']}/identification").json()
    assert (alone["without"], alone["identified"]["mass_std_kg"] > surer["mass_std_kg"]) == ([], True)


def named(path: str) -> str:
    """The identifier of the import at an address."""
    return path.rpartition("/")[2]


def test_logs_of_two_arms_are_not_compared(operator: TestClient, tmp_path: Path) -> None:
    paths = []
    for seed in (1, 2):
        paths.append(send(operator, *write_torque_log(tmp_path, f"arm {seed}", make(seed).loaded)))
        read(operator, paths[-1], **ANSWERS)
    answered = operator.post(f"{paths[0]}/identification", json={"without": named(paths[1])})
    assert (answered.status_code, answered.json()["flaws"][0]["code"]) == (422, "recording-other-robot")


def test_who_may_not_diagnose_imports_nothing(signed_in: As) -> None:
    assert signed_in(Role.viewer).post("/api/imports").status_code == 403
    assert signed_in(Role.engineer).post("/api/imports").status_code == 201


def test_a_file_that_is_larger_than_an_upload_may_be_leaves_nothing(
    tmp_path: Path, clock: Clock, signed_in: As, settings: Settings
) -> None:
    client = signed_in(Role.operator)
    path = begin(client)
    sent = client.put(f"{path}/files/log.csv", content=b"0" * (settings.upload_max_bytes + 1), headers=FILE)
    assert (sent.status_code, sent.json()["type"]) == (413, "/problems/request-body-too-large")
    assert client.get(path).json()["files"] == []
    assert [file for file in left(settings) if file.is_file()] == []


def test_the_kinds_of_logs_are_those_that_the_engine_reads() -> None:
    assert LOG_KINDS == KINDS
