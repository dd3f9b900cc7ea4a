"""A cell made of a robot's description, step by step: nothing stays of what is left, and what is imported was checked as an upload is."""

from __future__ import annotations

import io
import zipfile
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from fastapi.testclient import TestClient

from core.cell.folder import load_cell
from core.cell.urdf import check_urdf
from server.people.roles import Role
from server.settings import Settings
from tests.core.new_cell.small_arm import arm, joint, link
from tests.server.made_people import As, Clock

FILE = {"content-type": "application/octet-stream"}
ZIP = {"content-type": "application/zip"}
HAND = link("hand") + joint("grip", "flange", "hand", kind="fixed", rest="")
BARE = arm(joints={3: joint("joint3", "link2", "link3", axis="0 0 1", rest="<limit/>")}).replace(link("link4"), link("link4", inertial=""))
CORNERS = ("0 0 0", "0.1 0 0", "0 0.1 0", "0 0 0.1")
FACETS = "".join(
    "facet normal 0 0 1\nouter loop\n" + "".join(f"vertex {corner}\n" for corner in CORNERS if corner != left) + "endloop\nendfacet\n"
    for left in CORNERS
)
MESH = f"solid a\n{FACETS}endsolid a\n"
SENSOR = {
    "name": "ACME 200", "noise_std": [0.1] * 3 + [0.005] * 3, "range": [200.0] * 3 + [10.0] * 3, "resolution": [0.05] * 3 + [0.002] * 3,
}  # fmt: skip


@pytest.fixture
def engineer(signed_in: As) -> TestClient:
    return signed_in(Role.engineer)


def packed(**files: str) -> bytes:
    whole = io.BytesIO()
    with zipfile.ZipFile(whole, "w") as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return whole.getvalue()


def begun(engineer: TestClient, text: str) -> str:
    """A draft of one file whose robot was read; its address."""
    made = engineer.post("/api/drafts", params={"name": "arm.urdf"}, content=text, headers=FILE)
    assert made.status_code == 201, made.text
    path = f"/api/drafts/{made.json()['draft']}"
    read = engineer.post(f"{path}/robot", json={"file": "robot/arm.urdf"})
    assert read.status_code == 200, read.text
    return path


def put(engineer: TestClient, path: str, **wanted: Any) -> Any:
    return engineer.put(f"{path}/cell", json={"name": "line3", "base_frame": "base", "sensor_frame": "flange"} | wanted)


def beside_cells(settings: Settings) -> list[str]:
    return sorted(folder.name for folder in settings.cells_folder.iterdir() if folder.name.startswith("."))


def about(found: dict[str, Any], **named: str) -> list[str]:
    """Codes of the notes that name this."""
    return [note["code"] for note in found["notes"] if named.items() <= note["parameters"].items()]


def test_from_one_file_to_the_imported_cell_with_what_the_description_lacks(engineer: TestClient, settings: Settings) -> None:
    path = begun(engineer, BARE)
    outline = engineer.post(f"{path}/robot", json={"file": "robot/arm.urdf"}).json()
    assert (outline["robot"], outline["base_frame"], outline["sensor_frame"]) == ("small", "base", "flange")
    assert [each["name"] for each in outline["links"]][:2] == ["base", "link1"]
    made = put(engineer, path)
    assert made.status_code == 200, made.text
    found = made.json()
    assert {"newcell-range-taken", "newcell-velocity-taken", "newcell-effort-taken"} <= set(about(found, joint="joint3"))
    assert about(found, link="link4") == ["newcell-mass-taken"]
    assert {"newcell-sensor-not-stated", "newcell-zones-none"} <= {each["message"]["code"] for each in found["findings"]}
    assert engineer.get(f"{path}/picture").content.startswith(b"\x89PNG")
    limits = {"lower_rad": -2.0, "upper_rad": 2.5, "velocity_rad_s": 1.5, "effort_n_m": 80.0, "acceleration_rad_s2": 4.0}
    values = {
        "title": "The third line", "joints": {"joint3": limits}, "masses_kg": {"link4": 3.5}, "sensor": SENSOR, "floor_z_m": -0.4,
        "home_rad": found["cell"]["robot"]["home_rad"], "limits": {"cartesian_speed_m_s": 0.2},
        "payload_box": {"size_m": [0.1, 0.1, 0.12], "pose": {"xyz_m": [0.0, 0.0, 0.06]}},
    }  # fmt: skip
    again = put(engineer, path, values=values).json()
    assert about(again, joint="joint3") == []
    assert about(again, link="link4") == []
    assert {each["name"]: each for each in again["joints"]}["joint3"] == {"name": "joint3", **limits}
    assert "newcell-sensor-not-stated" not in {each["message"]["code"] for each in again["findings"]}
    imported = engineer.post(f"{path}/import", json={"name": "line3"})
    assert imported.status_code == 201, imported.text
    cell = load_cell(settings.cells_folder / "line3")
    assert (cell.title, cell.floor_z_m, cell.sensor.name, cell.limits.cartesian_speed_m_s) == ("The third line", -0.4, "ACME 200", 0.2)
    assert (cell.payload_box.size_m, cell.robot.acceleration_rad_s2[2]) == ((0.1, 0.1, 0.12), 4.0)
    urdf = check_urdf(cell.urdf, "robot.urdf")
    assert {each.name: each.mass for each in urdf.bodies}["link4"] == 3.5
    assert engineer.get(path).status_code == 404
    assert beside_cells(settings) == []
    said = [each["detail"]["cell"] for each in engineer.get("/api/audit").json() if each["action"] == "cell.create"]
    assert said == ["line3"]


RING = '<collision><origin xyz="0 0 0.24"/><geometry><sphere radius="0.3"/></geometry></collision>'


@pytest.mark.thorough
def test_pairs_that_are_left_out_are_proposed_declared_and_taken_back(engineer: TestClient, settings: Settings) -> None:
    path = begun(engineer, arm(links={1: link("link1", shapes=RING)}))
    proposed = put(engineer, path).json()
    told = {(each["first"], each["second"]): (each["is_left_out"], each["why"]["code"]) for each in proposed["pairs"]}
    assert told == {("link3", "link1"): (True, "newcell-pair-overlaps")}
    assert unwatched(proposed) == [("link3", "link1")]
    chosen = put(engineer, path, values={"adjacent": [["link1", "link3"], ["link5", "link2"]]}).json()
    told = {(each["first"], each["second"]): (each["is_left_out"], each["why"]["code"]) for each in chosen["pairs"]}
    assert told == {("link3", "link1"): (True, "newcell-pair-overlaps"), ("link5", "link2"): (True, "newcell-pair-declared")}
    assert unwatched(chosen) == [("link1", "link3"), ("link5", "link2")]
    watched = put(engineer, path, values={"adjacent": []}).json()
    assert [(each["first"], each["is_left_out"]) for each in watched["pairs"]] == [("link3", False)]
    assert unwatched(watched) == []
    assert "newcell-shapes-overlap" in [each["message"]["code"] for each in watched["findings"]]
    refused = put(engineer, path, values={"adjacent": [], "home_rad": [0.0, 2.4, 0.0, 2.75, 0.0, 0.0]})
    assert (refused.status_code, refused.json()["flaws"][0]["code"]) == (422, "robot-home-too-close")
    unknown = put(engineer, path, values={"adjacent": [["link5", "nothing"]]})
    assert (unknown.status_code, unknown.json()["flaws"][0]["code"]) == (422, "cell-no-such-link")
    assert put(engineer, path, values={"adjacent": [["link5"]]}).status_code == 422
    assert put(engineer, path, values={"adjacent": [["link1", "link3"]]}).status_code == 200
    assert engineer.post(f"{path}/import", json={"name": "line3"}).status_code == 201
    assert load_cell(settings.cells_folder / "line3").robot.adjacent == (("link1", "link3"),)


def unwatched(found: dict[str, Any]) -> list[tuple[str, str]]:
    """Pairs that the findings name as left out."""
    said = [each["message"] for each in found["findings"] if each["message"]["code"] == "newcell-pair-unwatched"]
    return [(each["parameters"]["first"], each["parameters"]["second"]) for each in said]


@pytest.mark.thorough
def test_what_is_left_is_gone_and_so_is_what_nobody_goes_on_with(
    engineer: TestClient, settings: Settings, clock: Clock, signed_in: As
) -> None:
    path = begun(engineer, arm())
    assert put(engineer, path).status_code == 200
    assert len(beside_cells(settings)) == 1
    assert engineer.delete(path).status_code == 204
    assert beside_cells(settings) == []
    assert engineer.delete(path).json()["type"] == "/problems/drafts-unknown"
    old = begun(engineer, arm())
    clock.go_on(seconds=timedelta(hours=3).total_seconds())
    later = signed_in(Role.engineer)
    assert later.get(old).status_code == 404
    assert beside_cells(settings) == []
    assert {each["name"] for each in later.get("/api/cells").json()} == {"lwr4_bench", "ur5e_line"}


@pytest.mark.thorough
def test_packages_with_xacro_and_meshes_are_found_in_a_zip_however_it_was_packed(engineer: TestClient) -> None:
    shape = '<collision><geometry><mesh filename="package://arm_description/meshes/base.STL"/></geometry></collision>'
    described = arm().replace(link("base"), link("base", shapes=shape)).replace('<robot name="small">', "")
    xacro = f'<robot name="${{arg_name}}" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="called" default="small"/>{described}'
    xacro = xacro.replace('name="${arg_name}"', 'name="$(arg called)"')
    package = {
        "package.xml": "<package><name>arm_description</name></package>", "urdf/arm.urdf.xacro": xacro, "meshes/base.STL": MESH,
        "scripts/run.py": "raise SystemExit", ".github/x.xml": "<x/>",
    }  # fmt: skip
    for folder in ("", "arm_description/", "some-repository/deeper/arm_description/"):
        made = engineer.post("/api/drafts", content=packed(**{f"{folder}{name}": text for name, text in package.items()}), headers=ZIP)
        assert made.status_code == 201, made.text
        path, described_by = f"/api/drafts/{made.json()['draft']}", made.json()["descriptions"]
        assert [each["arguments"] for each in described_by] == [[{"name": "called", "default": "small"}]]
        read = engineer.post(f"{path}/robot", json={"file": described_by[0]["file"], "arguments": {"called": "tall"}})
        assert read.status_code == 200, read.text
        assert read.json()["robot"] == "tall"
        made = put(engineer, path)
        assert made.status_code == 200, made.text
        assert engineer.delete(path).status_code == 204


@pytest.fixture
def refusing(engineer: TestClient) -> str:
    """A draft of an arm with a hand."""
    return begun(engineer, arm(HAND))


def test_what_cannot_be_made_is_refused_in_words_and_goes_on_from_there(refusing: str, engineer: TestClient, settings: Settings) -> None:
    hand = put(engineer, refusing).json()
    assert (hand["kind"], "newcell-links-of-none" in hand["type"]) == ("bad-robot", True)
    assert str(settings.cells_folder) not in str(hand)
    assert put(engineer, refusing, behind="tool").status_code == 200
    for wrong, code in (
        ({"values": {"joints": {"grip": {"velocity_rad_s": 1.0}}}}, "newcell-joint-unknown"),
        ({"values": {"joints": {"joint1": {"lower_rad": 1.0, "upper_rad": 0.5}}}}, "newcell-range-empty"),
        ({"values": {"masses_kg": {"base": 1.0}}}, "newcell-link-unmoved"),
        ({"values": {"home_rad": [0.0]}}, "cell-not-one-for-each-joint"),
        ({"values": {"home_rad": [3.0] + [0.5] * 5}}, "cell-home-outside-limits"),
        ({"base_frame": "nowhere"}, "newcell-no-such-link"),
    ):
        refused = put(engineer, refusing, behind="tool", **wrong)
        assert refused.status_code == 422, wrong
        assert refused.json()["flaws"][0]["code"] == code
    folded = put(engineer, refusing, behind="tool", values={"home_rad": [0.0, 2.7, 0.0, 2.7, 0.0, 2.7]})
    assert folded.status_code == 422
    assert engineer.get(f"{refusing}/picture").status_code == 200
    assert engineer.post(f"{refusing}/import", json={"name": "other"}).json()["type"] == "/problems/drafts-not-made"


def test_a_cell_of_that_name_is_not_replaced(engineer: TestClient) -> None:
    path = begun(engineer, arm())
    assert put(engineer, path, name="lwr4_bench").status_code == 200
    assert engineer.post(f"{path}/import", json={"name": "lwr4_bench"}).json()["type"] == "/problems/uploads-cell-exists"
    assert put(engineer, path, name="line4").status_code == 200
    assert engineer.post(f"{path}/import", json={"name": "line4"}).status_code == 201


HOSTILE: dict[str, tuple[dict[str, str], bytes, dict[str, str]]] = {
    "no zip": ({}, b"nothing", ZIP),
    "a name that leads outside": ({}, packed(**{"../arm.urdf": arm()}), ZIP),
    "no description": ({}, packed(**{"readme.xml": "<x/>"}), ZIP),
    "a file of another kind": ({"name": "arm.sh"}, b"x", FILE),
    "a file without a name": ({}, b"x", FILE),
    "a name with a folder": ({"name": "../arm.urdf"}, b"x", FILE),
    "another type": ({}, b"{}", {"content-type": "text/xml"}),
}


def test_what_is_no_description_is_refused_and_leaves_nothing(engineer: TestClient, settings: Settings) -> None:
    for what, (params, content, headers) in HOSTILE.items():
        refused = engineer.post("/api/drafts", params=params, content=content, headers=headers)
        assert refused.status_code == 422, what
        assert beside_cells(settings) == [], what


def test_a_description_reads_and_runs_nothing_outside_of_its_draft(engineer: TestClient, tmp_path: Path) -> None:
    secret = tmp_path / "secret.xacro"
    secret.write_text('<robot xmlns:xacro="x"><link name="secret"/></robot>')
    include = f'<robot name="a" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="{secret}"/></robot>'
    mesh = '<collision><geometry><mesh filename="/etc/hostname.stl"/></geometry></collision>'
    for name, text in (("arm.xacro", include), ("arm.urdf", arm().replace(link("base"), link("base", shapes=mesh)))):
        made = engineer.post("/api/drafts", params={"name": name}, content=text, headers=FILE)
        path = f"/api/drafts/{made.json()['draft']}"
        read = engineer.post(f"{path}/robot", json={"file": f"robot/{name}"})
        refused = read if read.status_code != 200 else put(engineer, path)
        assert (refused.status_code, refused.json()["kind"]) == (422, "bad-robot")
        assert "secret" not in str(refused.json().get("links"))
    unread = engineer.post("/api/drafts", params={"name": "arm.urdf"}, content=arm(), headers=FILE).json()["draft"]
    assert put(engineer, f"/api/drafts/{unread}").json()["type"] == "/problems/drafts-not-read"
    assert engineer.get(f"/api/drafts/{unread}/picture").json()["type"] == "/problems/drafts-no-picture"
    assert engineer.post(f"/api/drafts/{unread}/robot", json={"file": "../x"}).json()["type"] == "/problems/drafts-file-unknown"
