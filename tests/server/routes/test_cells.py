"""Cells over HTTP: listed, read, taken in by an engineer, with their zones where the people are."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

import pytest
from fastapi.testclient import TestClient

from server.roles import Role
from server.service import Service
from server.settings import Settings
from server.zones import positions, with_zones_where_they_are
from tests.server.hostile_uploads import HOSTILE, sound, zipped
from tests.server.people import BOTH_STORES, As, Clock

ZIP = {"content-type": "application/zip"}
ZONE = "/api/cells/lwr4_bench/zones/operator"


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


def test_a_cell_that_was_broken_by_hand_is_listed_with_its_flaw(signed_in: As, settings: Settings) -> None:
    file = settings.cells_folder / "lwr4_bench" / "cell.toml"
    file.write_text(file.read_text().replace("clearance_m = 0.03", "clearance_m = -1.0"))
    viewer = signed_in(Role.viewer)
    flaws = {cell["name"]: cell["flaw"] for cell in viewer.get("/api/cells").json()}
    assert "limits.clearance_m: found -1.0" in flaws["lwr4_bench"]
    answer = viewer.get("/api/cells/lwr4_bench")
    assert (answer.status_code, answer.json()["type"]) == (422, "/problems/bad-cell")


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
    assert (answer.status_code, answer.json()["type"]) == (422, "/problems/unprocessable")


@pytest.mark.parametrize("name", ["..", "%2e%2e", "a b", "a%2fb", ".old-lwr4_bench", "lwr4_bench%00"])
def test_a_name_that_could_lead_elsewhere_is_refused(name: str, signed_in: As) -> None:
    assert signed_in(Role.viewer).get(f"/api/cells/{name}").status_code in (404, 422)


def moved(client: TestClient, x: float, at: str) -> int:
    return client.put(ZONE, json={"pose": {"xyz_m": [x, 0.0, 0.625]}, "measured_at": at}).status_code


@BOTH_STORES
def test_a_zone_stands_where_it_was_last_seen(signed_in: As, service: Service) -> None:
    operator = signed_in(Role.operator)
    assert moved(operator, 1.5, "2026-03-01T08:00:00Z") == 200
    assert moved(operator, 1.6, "2026-03-01T09:00:00.5+01:00") == 200
    shown = operator.get("/api/cells/lwr4_bench").json()["cell"]["zones"][0]
    assert shown["shape"]["pose"]["xyz_m"] == [1.6, 0.0, 0.625]
    cell = service.cells.load("lwr4_bench")
    with service.store.read() as db:
        known = positions(db, "lwr4_bench")
    assert known["operator"].moves == 2
    there = with_zones_where_they_are(cell, known).zones[0].shape
    assert there.corners.mean(axis=0) == pytest.approx([1.6, 0.0, 0.625])
    assert cell.zones[0].shape.pose.xyz_m[0] == 1.35


def test_a_zone_that_was_moved_says_by_whom_and_when_and_the_service_what_time_it_is(signed_in: As, clock: Clock) -> None:
    operator = signed_in(Role.operator)
    assert operator.get("/api/cells/lwr4_bench").json()["moved"] == []
    assert moved(operator, 1.5, "2026-03-01T08:00:00Z") == 200
    answer = operator.get("/api/cells/lwr4_bench").json()
    assert datetime.fromisoformat(answer["read_at"]) == clock()
    (place,) = answer["moved"]
    assert (place["zone"], place["moves"], place["moved_by"]) == ("operator", 1, f"account:{Role.operator.value}")
    assert datetime.fromisoformat(place["measured_at"]) == datetime(2026, 3, 1, 8, tzinfo=UTC)


def test_measurements_out_of_order_repeated_or_from_the_future_are_refused(signed_in: As, clock: Clock) -> None:
    operator = signed_in(Role.operator)
    assert moved(operator, 1.5, "2026-03-01T08:00:00Z") == 200
    assert moved(operator, 1.4, "2026-03-01T08:00:00Z") == 409
    assert moved(operator, 1.4, "2026-03-01T07:59:59Z") == 409
    assert moved(operator, 1.4, "2026-03-01T08:00:02Z") == 409
    assert moved(operator, 1.4, "2026-03-01T08:00:01") == 422
    clock.go_on(seconds=2)
    assert moved(operator, 1.4, "2026-03-01T08:00:02Z") == 200


def test_a_zone_over_the_robot_is_kept_and_what_it_contradicts_is_said(signed_in: As) -> None:
    body = {"pose": {"xyz_m": [0.0, 0.0, 0.0]}, "measured_at": "2026-03-01T08:00:00Z"}
    answer = signed_in(Role.operator).put(ZONE, json=body)
    assert answer.status_code == 200
    assert "zones.operator.shape" in answer.json()["contradiction"]
    far = {"pose": {"xyz_m": [1.35, 0.0, 0.625]}, "measured_at": "2026-03-01T08:00:00.1Z"}
    assert signed_in(Role.operator).put(ZONE, json=far).json()["contradiction"] is None


@pytest.mark.parametrize(
    ("address", "body", "status"),
    [
        (ZONE.replace("operator", "nobody"), {"pose": {}, "measured_at": "2026-03-01T08:00:00Z"}, 404),
        (ZONE.replace("lwr4_bench", "none"), {"pose": {}, "measured_at": "2026-03-01T08:00:00Z"}, 404),
        (ZONE, {"pose": {"xyz_m": [1e9, 0, 0]}, "measured_at": "2026-03-01T08:00:00Z"}, 422),
        (ZONE, {"pose": {"xyz_m": ["1", 0, 0]}, "measured_at": "2026-03-01T08:00:00Z"}, 422),
        (ZONE, {"pose": {}, "shape": {}, "measured_at": "2026-03-01T08:00:00Z"}, 422),
        (ZONE, {"pose": {}}, 422),
    ],
)
def test_a_move_that_means_nothing_is_refused(address: str, body: dict[str, object], status: int, signed_in: As) -> None:
    assert signed_in(Role.operator).put(address, json=body).status_code == status


def test_cells_given_by_a_folder_are_used_as_they_are(tmp_path: Path, settings: Settings) -> None:
    from server.cell_folder import CellFolder

    (tmp_path / "mine").mkdir()
    folder = CellFolder(tmp_path / "mine")
    folder.prepare()
    assert folder.names() == []
