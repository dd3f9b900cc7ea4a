"""The tool library: saved, found again, changed, ordered by name, and what runs have found of each."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

import numpy as np
import pytest
from fastapi.testclient import TestClient

from core.cell.folder import load_cell
from core.errors import BadPayload
from core.payload.shapes import Box
from server.people.roles import Role
from server.runner.messages import Order
from server.runs import ledger as run_ledger
from server.runs.order import complete_payload, order_of
from server.runs.packml import Command
from server.runs.schemas import RunCreate
from server.runs.tables import RunRow
from server.service import Service
from tests.core.export.cloud import Cloud, cloud
from tests.core.export.known_result import answer
from tests.server.made_people import BOTH_STORES, As, Clock

CELL, OTHER = "lwr4_bench", "ur5e_line"
PATH = f"/api/cells/{CELL}/payloads"
BOX = {"kind": "box", "size_m": [0.12, 0.1, 0.2], "pose": {"xyz_m": [0.0, 0.0, 0.1], "rpy_rad": [0.0, 0.0, 0.0]}}
SHAFT = {"name": "shaft", "title": "Gripper with shaft", "box": BOX, "note": "Jaws closed", "mass_least_kg": 2.0, "mass_most_kg": 3.0}
PAYLOADS = load_cell(Path(__file__).parents[3] / "cells" / CELL).payloads

pytestmark = pytest.mark.usefixtures("nothing_planned")


@pytest.fixture
def engineer(signed_in: As) -> TestClient:
    return signed_in(Role.engineer)


@pytest.fixture
def saved(engineer: TestClient) -> str:
    made = engineer.post(PATH, json=SHAFT)
    assert made.status_code == 201, made.text
    return str(made.json()["id"])


def ended_run(service: Service, carried: str | None, payload: str, kg: float = 0.0, *, accepted: bool = True, cell: str = CELL) -> str:
    """A run that is Complete with the result of some cloud of points, heavier by so much in its centre."""
    body = cloud(0)
    found = answer(Cloud(np.append(body.masses, kg), np.vstack((body.points, body.com))), cell)
    with service.store.write() as db:
        known = None if carried is None else run_ledger.CarriedPayload(carried, None)
        order = RunCreate(cell=cell, payload=payload, payload_box=Box.model_validate(BOX))
        row = run_ledger.add_run(db, order, "account:anna", service.now(), carried=known)
        run_ledger.keep_steps(db, row, [None, Command.START, None, None, None], service.now())
        row.result = found.model_dump_json()
        if accepted:
            row.accepted_by, row.accepted_at = "account:anna", service.now()
        return row.id


@BOTH_STORES
def test_what_an_operator_saves_is_found_beside_the_payloads_of_the_cells_file(signed_in: As, clock: Clock) -> None:
    operator = signed_in(Role.operator)
    made = operator.post(PATH, json=SHAFT)
    assert made.status_code == 201, made.text
    shown = made.json()
    assert SHAFT.items() <= shown.items()
    assert (shown["saved_by"], shown["changed_by"]) == ("account:operator", None)
    assert datetime.fromisoformat(shown["saved_at"]) == clock()
    assert (shown["runs"], shown["last_accepted"], shown["flaw"], shown["reference"]) == (0, None, None, None)
    assert made.headers["location"] == f"{PATH}/{shown['id']}"
    viewer = signed_in(Role.viewer)
    assert viewer.get(made.headers["location"]).json() == shown
    listed = viewer.get(PATH).json()
    assert {each["name"]: each["id"] is None for each in listed} == {**dict.fromkeys(PAYLOADS, True), "shaft": False}
    assert [each["title"].lower() for each in listed] == sorted(each["title"].lower() for each in listed)
    block = next(each for each in listed if each["name"] == "steel_block")
    assert block["reference"]["mass_kg"] == PAYLOADS["steel_block"].mass_kg
    assert viewer.get(f"/api/cells/{OTHER}/payloads/{shown['id']}").status_code == 404
    assert "shaft" not in [each["name"] for each in viewer.get(f"/api/cells/{OTHER}/payloads").json()]


TAKEN = {"operator": "zone", "bench": "obstacle", "steel_block": "payload", "Steel_Block": "payload", "shaft": "saved", "SHAFT": "saved"}


def test_a_name_that_something_in_the_cell_has_is_refused_in_words(saved: str, engineer: TestClient) -> None:
    second = engineer.post(PATH, json=SHAFT | {"name": "second"}).json()["id"]
    for name, by in TAKEN.items():
        refused = engineer.post(PATH, json=SHAFT | {"name": name})
        assert (refused.status_code, refused.json()["type"]) == (409, "/problems/library-name-taken")
        assert refused.json()["parameters"] == {"name": name, "cell": CELL, "by": by}
        assert engineer.patch(f"{PATH}/{second}", json={"name": name}).status_code == 409
    assert engineer.patch(f"{PATH}/{saved}", json={"name": "shaft"}).status_code == 200


def test_a_zone_that_somebody_drew_keeps_its_name_from_the_library(engineer: TestClient, signed_in: As) -> None:
    shape = {"kind": "sphere", "radius_m": 0.2, "pose": {"xyz_m": [0.0, 1.6, 0.0]}}
    assert signed_in(Role.operator).post(f"/api/cells/{CELL}/zones", json={"name": "trolley", "shape": shape}).status_code == 201
    refused = engineer.post(PATH, json=SHAFT | {"name": "Trolley"})
    assert (refused.status_code, refused.json()["parameters"]["by"]) == (409, "zone")


POINT = {"mass_kg": 2.0, "first_moment_kg_m": [0, 0, 0.2], "inertia_kg_m2": [0, 0, 0, 0, 0, 0], "source": "CAD"}
OUTSIDE = {"mass_kg": 2.0, "first_moment_kg_m": [0, 0, 2.0], "inertia_kg_m2": [3, 0, 0, 3, 0, 1], "source": "CAD"}
WRONG: list[tuple[dict[str, object], int, str | None]] = [
        ({"mass_least_kg": 4.0}, 422, "mass_least_kg"),
        ({"mass_most_kg": 900.0}, 422, "sensor.range"),
        ({"box": BOX | {"pose": {"xyz_m": [4.0, 0.0, 0.0]}}}, 422, "box"),
        ({"reference": POINT}, 422, "reference"),
        ({"reference": OUTSIDE}, 422, "box"),
        ({"title": "two\nlines"}, 422, "title"),
        ({"title": " "}, 422, "title"),
        ({"name": "no name"}, 422, "name"),
        ({"box": None}, 422, None),
        ({"run": "none"}, 404, None),
]  # fmt: skip


def test_what_cannot_be_carried_is_refused_where_it_is_wrong(engineer: TestClient) -> None:
    for change, status, where in WRONG:
        refused = engineer.post(PATH, json=SHAFT | change)
        assert refused.status_code == status, refused.text
        assert where is None or where in refused.json()["flaws"][0]["where"]
    assert "shaft" not in [each["name"] for each in engineer.get(PATH).json()]


def test_an_engineer_renames_changes_and_deletes_and_the_audit_log_says_so(saved: str, engineer: TestClient, signed_in: As) -> None:
    operator = signed_in(Role.operator)
    assert operator.patch(f"{PATH}/{saved}", json={"title": "x"}).status_code == 403
    assert operator.delete(f"{PATH}/{saved}").status_code == 403
    changed = engineer.patch(f"{PATH}/{saved}", json={"name": "axle", "note": None, "mass_most_kg": 2.5, "title": None})
    assert changed.status_code == 200, changed.text
    shown = changed.json()
    assert (shown["name"], shown["title"], shown["note"], shown["mass_least_kg"], shown["mass_most_kg"]) == (
        "axle", SHAFT["title"], None, 2.0, 2.5,
    )  # fmt: skip
    assert (shown["changed_by"], shown["saved_by"]) == ("account:engineer", "account:engineer")
    assert engineer.delete(f"{PATH}/{saved}").status_code == 204
    assert engineer.get(f"{PATH}/{saved}").status_code == 404
    assert engineer.delete(f"{PATH}/{saved}").json()["type"] == "/problems/library-unknown"
    said = [each for each in engineer.get("/api/audit").json() if each["action"].startswith("payload.")]
    assert [(each["action"], each["detail"]["name"]) for each in reversed(said)] == [
        ("payload.save", "shaft"), ("payload.change", "axle"), ("payload.delete", "axle"),
    ]  # fmt: skip


def test_an_order_by_name_takes_box_and_mass_and_the_run_remembers_which_it_was(
    saved: str, engineer: TestClient, signed_in: As, service: Service
) -> None:
    mes = signed_in(Role.mes)
    run = mes.post("/api/runs", json={"cell": CELL, "payload": "shaft"}).json()
    assert (run["payload"], run["saved_payload"]) == ("shaft", saved)
    assert (run["order"]["payload_box"], run["order"]["mass_guess_kg"]) == (BOX, 2.5)
    heavier = mes.post("/api/runs", json={"cell": CELL, "payload": "shaft", "mass_guess_kg": 4.0}).json()
    assert heavier["order"]["mass_guess_kg"] == 4.0
    of_file = mes.post("/api/runs", json={"cell": CELL, "payload": "steel_block"}).json()
    assert of_file["saved_payload"] is None
    engineer.patch(f"{PATH}/{saved}", json={"name": "axle", "box": BOX | {"size_m": [0.3, 0.3, 0.3]}})
    found = mes.get("/api/runs", params={"saved_payload": saved}).json()
    assert [(each["run"], each["payload"]) for each in found] == [(heavier["run"], "shaft"), (run["run"], "shaft")]
    with service.store.read() as db:
        row = run_ledger.load_run(db, run["run"])
        told = order_of(row, service.cells.load(CELL), service.settings.data)
    assert (told.payload, told.known, told.payload_box.size_m) == ("shaft", None, (0.12, 0.1, 0.2))
    assert {each["name"]: each["runs"] for each in mes.get(PATH).json()}["axle"] == 2
    unknown = mes.post("/api/runs", json={"cell": CELL, "payload": "shaft"}).json()
    assert unknown["type"] == "/problems/runs-payload-unknown"
    assert {"axle", "steel_block"} <= set(unknown["parameters"]["payloads"])


def test_a_payload_saved_from_a_result_carries_what_was_found(service: Service, engineer: TestClient) -> None:
    run = ended_run(service, None, "gripper")
    body = {"name": "measured", "title": "As measured", "run": run}
    shown = engineer.post(PATH, json=body).json()
    parameters = cloud(0).parameters(np.eye(10))
    assert shown["box"] == BOX
    assert shown["reference"]["mass_kg"] == pytest.approx(parameters.phi[0])
    np.testing.assert_allclose(shown["reference"]["inertia_kg_m2"], parameters.phi[4:])
    assert run in shown["reference"]["source"]
    queued = told_of(service, "measured")
    assert queued.known is not None
    np.testing.assert_allclose(queued.known.parameters.phi, parameters.phi)
    elsewhere = ended_run(service, None, "gripper", cell=OTHER)
    assert engineer.post(PATH, json=body | {"name": "other", "run": elsewhere}).json()["type"] == "/problems/library-run-of-other-cell"


def told_of(service: Service, name: str) -> Order:
    """What the control process is told of an order by that name."""
    with service.store.write() as db:
        order, carried = complete_payload(db, RunCreate(cell=CELL, payload=name), service.cells.load(CELL))
        row = run_ledger.add_run(db, order, "account:anna", service.now(), carried=carried)
        return order_of(row, service.cells.load(CELL), service.settings.data)


def test_the_last_accepted_result_is_told_by_payload_whatever_its_name_was(
    saved: str, service: Service, clock: Clock, engineer: TestClient
) -> None:
    for kg in (0.0, 0.1):
        clock.go_on(seconds=1)
        last = ended_run(service, saved, f"shaft{round(10 * kg)}", kg)
    clock.go_on(seconds=1)
    ended_run(service, saved, "shaft", 0.5, accepted=False)
    ended_run(service, None, "gripper", 0.3)
    listed = {each["name"]: each for each in engineer.get(PATH).json()}
    found = listed["shaft"]["last_accepted"]
    assert (found["run"], found["accepted_by"], listed["shaft"]["runs"]) == (last, "account:anna", 3)
    assert found["mass_kg"] == pytest.approx(cloud(0).masses.sum() + 0.1)
    assert listed["gripper"]["last_accepted"]["mass_kg"] == pytest.approx(cloud(0).masses.sum() + 0.3)
    assert listed["steel_block"]["last_accepted"] is None


def test_one_whose_name_the_cells_file_takes_later_says_so_and_the_file_goes_first(
    saved: str, service: Service, engineer: TestClient
) -> None:
    path = service.settings.cells_folder / CELL / "cell.toml"
    path.write_text(path.read_text().replace("[payloads.steel_block]", "[payloads.shaft]"))
    listed = [each for each in engineer.get(PATH).json() if each["name"] == "shaft"]
    assert sorted(each["flaw"] is None for each in listed) == [False, True]
    assert told_of(service, "shaft").known is not None


def test_an_order_whose_payload_the_cell_no_longer_knows_is_refused(service: Service) -> None:
    with service.store.write() as db:
        row: RunRow = run_ledger.add_run(db, RunCreate(cell=CELL, payload="gone"), "account:anna", service.now())
        with pytest.raises(BadPayload, match="gone"):
            order_of(row, service.cells.load(CELL), service.settings.data)
