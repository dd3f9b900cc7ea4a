"""Cells over HTTP: listed, read whatever is wrong with them, taken in by an engineer."""

from __future__ import annotations

from pathlib import Path

import pytest

from server.people.roles import Role
from server.service import Service
from server.settings import Settings
from tests.server.hostile_uploads import HOSTILE, sound, zipped
from tests.server.made_people import As

ZIP = {"content-type": "application/zip"}


def other() -> bytes:
    """A sound cell of another name."""
    files = sound()
    return zipped(files | {"cell.toml": files["cell.toml"].replace(b'name = "lwr4_bench"', b'name = "second"', 1)})


def test_a_new_service_has_the_cells_at_hand(signed_in: As) -> None:
    cells = signed_in(Role.viewer).get("/api/cells").json()
    assert {cell["name"]: cell["flaw"] for cell in cells} == {"lwr4_bench": None, "ur5e_line": None}


def test_a_cell_is_read_with_its_units_and_its_hash(signed_in: As, service: Service) -> None:
    answer = signed_in(Role.viewer).get("/api/cells/lwr4_bench").json()
    assert answer["cell"]["limits"]["cartesian_speed_m_s"] == 0.25
    assert answer["sha256"] == service.cells.digest("lwr4_bench")


def change(settings: Settings, before: str, after: str, file: str = "cell.toml") -> None:
    """By hand, in the folder of the cells."""
    path = settings.cells_folder / "lwr4_bench" / file
    text = path.read_text()
    assert before in text
    path.write_text(text.replace(before, after, 1))


def test_a_cell_whose_file_cannot_be_read_is_listed_and_answers_with_its_flaw(signed_in: As, settings: Settings) -> None:
    change(settings, "clearance_m = 0.03", "clearance_m = -1.0")
    viewer = signed_in(Role.viewer)
    listed = {cell["name"]: cell for cell in viewer.get("/api/cells").json()}["lwr4_bench"]
    flaw = {"where": "lwr4_bench/cell.toml: limits.clearance_m", "found": "-1.0", "expected": "greater than 0"}
    assert listed["title"] is None
    assert [flaw.items() <= each.items() for each in listed["flaws"]] == [True]
    flaw = listed["flaws"][0]
    answer = viewer.get("/api/cells/lwr4_bench")
    assert answer.status_code == 200
    assert (answer.json()["cell"], answer.json()["flaws"], answer.json()["drawn"]) == (None, [flaw], False)
    change(settings, "clearance_m = -1.0", "clearance_m = 0.03")
    assert viewer.get("/api/cells/lwr4_bench").json()["flaws"] == []


CONTRADICTING = {
    "a floor above the base": ("cell.toml", "floor_z_m = -0.75", "floor_z_m = 0.4", "cell.toml: floor_z_m", True),
    "another name": ("cell.toml", 'name = "lwr4_bench"', 'name = "other"', "cell.toml: name", False),
    "home outside the limits": ("cell.toml", "home_rad = [0.0, -0.35", "home_rad = [0.0, -2.35", "cell.toml: robot.home_rad", False),
    "a robot that does not parse": ("robot.urdf", "</robot>", "", "robot.urdf", False),
    "a robot that is not there": ("cell.toml", "home_rad", 'urdf = "none.urdf"\nhome_rad', "cell.toml: robot.urdf", False),
}


@pytest.mark.parametrize("what", CONTRADICTING)
def test_a_cell_that_contradicts_itself_is_read_says_so_and_takes_no_run(
    what: str, signed_in: As, settings: Settings, nothing_planned: None
) -> None:
    file, before, after, where, drawn = CONTRADICTING[what]
    change(settings, before, after, file)
    operator = signed_in(Role.operator)
    answer = operator.get("/api/cells/lwr4_bench")
    assert answer.status_code == 200
    shown = answer.json()
    assert shown["cell"]["name"] == "lwr4_bench"
    assert shown["cell"]["limits"]["clearance_m"] == 0.03
    assert [flaw["where"] for flaw in shown["flaws"]] == [f"lwr4_bench/{where}"]
    assert shown["drawn"] is drawn
    refused = operator.post("/api/runs", json={"cell": "lwr4_bench", "payload": "steel_block"})
    assert refused.status_code == 422
    assert refused.json()["flaws"] == shown["flaws"]
    assert operator.get("/api/control/lwr4_bench").status_code == 200
    assert operator.get("/api/cells/lwr4_bench/twin").status_code == 200


@pytest.mark.parametrize(("text", "found"), [("{", "JSON that does not parse"), ('{"effects": [{}]}', "no such key")])
def test_a_twin_that_no_longer_fits_is_a_flaw_of_a_cell_that_is_shown(text: str, found: str, signed_in: As, settings: Settings) -> None:
    (settings.cells_folder / "lwr4_bench" / "twin.json").write_text(text)
    shown = signed_in(Role.viewer).get("/api/cells/lwr4_bench").json()
    assert shown["drawn"] is True
    assert shown["flaws"][0]["where"].startswith("lwr4_bench/twin.json")
    assert found in shown["flaws"][0]["found"]


def test_an_engineer_takes_a_cell_in_and_it_is_written_down(signed_in: As) -> None:
    engineer = signed_in(Role.engineer)
    assert engineer.post("/api/cells/validate", content=other(), headers=ZIP).json() == {"name": "second", "sha256": None}
    assert engineer.get("/api/cells/second").status_code == 404
    answer = engineer.post("/api/cells", content=other(), headers=ZIP)
    assert (answer.status_code, answer.headers["location"]) == (201, "/api/cells/second")
    assert engineer.get("/api/cells/second").json()["sha256"] == answer.json()["sha256"]
    assert engineer.post("/api/cells", content=other(), headers=ZIP).status_code == 409
    assert engineer.put("/api/cells/second", content=other(), headers=ZIP).status_code == 200
    assert engineer.put("/api/cells/lwr4_bench", content=other(), headers=ZIP).status_code == 422
    actions = [entry["action"] for entry in engineer.get("/api/audit").json()]
    assert actions == ["cell.replace", "cell.create"]


@pytest.mark.parametrize("what", ["../ in the zip", "billion laughs", "mesh absolute", "a zip bomb"])
def test_a_hostile_upload_is_answered_with_a_problem_and_leaves_nothing(what: str, signed_in: As, settings: Settings) -> None:
    before = sorted(settings.data.rglob("*"))
    answer = signed_in(Role.engineer).post("/api/cells", content=HOSTILE[what](), headers=ZIP)
    assert answer.status_code == 422
    assert answer.json()["flaws"][0]["expected"]
    assert [each for each in sorted(settings.data.rglob("*")) if each not in before] == []


def test_an_upload_that_is_no_zip_by_its_header_is_refused(signed_in: As) -> None:
    answer = signed_in(Role.engineer).post("/api/cells", content=b"{}", headers={"content-type": "application/json"})
    assert (answer.status_code, answer.json()["type"]) == (422, "/problems/uploads-no-zip")
    assert answer.json()["kind"] == "unprocessable"


@pytest.mark.parametrize("name", ["..", "%2e%2e", "a b", "a%2fb", ".old-lwr4_bench", "lwr4_bench%00"])
def test_a_name_that_could_lead_elsewhere_is_refused(name: str, signed_in: As) -> None:
    assert signed_in(Role.viewer).get(f"/api/cells/{name}").status_code in (404, 422)


def test_cells_given_by_a_folder_are_used_as_they_are(tmp_path: Path, settings: Settings) -> None:
    from server.cells.folder import CellFolder

    (tmp_path / "mine").mkdir()
    folder = CellFolder(tmp_path / "mine")
    folder.prepare()
    assert folder.names() == []
