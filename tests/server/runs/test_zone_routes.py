"""Zones over HTTP: where the people are, what that contradicts, and the way back."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Any

import pytest
import trimesh
from fastapi.testclient import TestClient

from server.cells.zones import positions, with_zones_as_they_are
from server.people.roles import Role
from server.runner.messages import Failed, ZoneChanged
from server.runs.active_run import ActiveRun
from server.service import Service
from tests.server.made_people import BOTH_STORES, As, Clock
from tests.server.real_service import wait_for
from tests.server.scripted_process import ScriptedProcess
from tests.server.sentence import sentence

CELL = "/api/cells/lwr4_bench"
ZONE = f"{CELL}/zones/operator"
IN_FILE = [1.35, 0.0, 0.625]
ON_THE_BASE = [0.0, 0.0, 0.0]
OVER_THE_ARM = [0.95, 0.0, 0.625]
"""Beside the base, but where the arm is at home."""
OPERATOR = {"kind": "box", "size_m": [1.0, 3.0, 2.75]}


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
    there = with_zones_as_they_are(cell, known).zones[0].shape
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


def place(client: TestClient, xyz_m: list[float], at: str = "2026-03-01T08:00:00Z") -> dict[str, Any]:
    answer = client.put(ZONE, json={"pose": {"xyz_m": xyz_m}, "measured_at": at})
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def shown_at(client: TestClient) -> list[float]:
    return list(client.get(CELL).json()["cell"]["zones"][0]["shape"]["pose"]["xyz_m"])


def test_a_cell_with_a_zone_over_the_robot_stays_readable_and_says_what_is_wrong(signed_in: As) -> None:
    operator = signed_in(Role.operator)
    moved_there = place(operator, ON_THE_BASE)
    flaw = {
        "where": "lwr4_bench/cell.toml: zones.operator.shape",
        "found": "the robot's base 0.500 m inside it",
        "expected": "the base outside (at most 0.001 m inside)",
    }
    assert [flaw.items() <= each.items() for each in moved_there["flaws"]] == [True]
    flaw = moved_there["flaws"][0]
    assert moved_there["contradiction"]["text"] == f"{flaw['where']}: found {flaw['found']}, expected {flaw['expected']}"
    answer = operator.get(CELL)
    assert answer.status_code == 200
    shown = answer.json()
    assert (shown["flaws"], shown["in_the_way"], shown["drawn"]) == ([flaw], ["operator"], True)
    assert shown_at(operator) == ON_THE_BASE
    listed = {cell["name"]: cell for cell in operator.get("/api/cells").json()}
    assert listed["lwr4_bench"]["flaws"] == [flaw]
    assert listed["lwr4_bench"]["title"]
    assert listed["ur5e_line"]["flaw"] is None
    far = place(operator, IN_FILE, "2026-03-01T08:00:00.1Z")
    assert (far["contradiction"], far["flaws"]) == (None, [])
    assert operator.get(CELL).json()["flaws"] == []


def test_a_run_in_such_a_cell_is_refused_with_the_flaw_but_one_that_was_made_is_found_again(nothing_planned: None, signed_in: As) -> None:
    operator = signed_in(Role.operator)
    order, key = {"cell": "lwr4_bench", "payload": "steel_block"}, {"Idempotency-Key": "once"}
    made = operator.post("/api/runs", json=order, headers=key).json()["run"]
    place(operator, ON_THE_BASE)
    answer = operator.post("/api/runs", json=order)
    assert (answer.status_code, answer.json()["kind"]) == (422, "bad-cell")
    assert answer.json()["flaws"] == operator.get(CELL).json()["flaws"]
    assert operator.post("/api/runs", json=order, headers=key).json()["run"] == made
    operator.post(f"{ZONE}/undo")
    assert operator.post("/api/runs", json=order).status_code == 202


def test_a_run_that_waits_when_the_zone_comes_ends_with_the_flaw_as_its_reason(
    nothing_planned: None, service: Service, signed_in: As
) -> None:
    operator = signed_in(Role.operator)
    _, second = (operator.post("/api/runs", json={"cell": "lwr4_bench", "payload": "steel_block"}).json()["run"] for _ in range(2))
    wait_for(lambda: "lwr4_bench" in service.conductor.active, "the first run to have the cell")
    place(operator, ON_THE_BASE)
    ScriptedProcess.newest.say(Failed("NoPath", sentence("the first run is over")), None)
    wait_for(lambda: operator.get(f"/api/runs/{second}").json()["state"] == "Stopped", "the run that waited to be refused")
    run = operator.get(f"/api/runs/{second}").json()
    assert run["reason_kind"] == "bad-cell"
    assert "zones.operator.shape: found the robot's base 0.500 m inside it" in run["reason"]["text"]


@BOTH_STORES
def test_a_zone_is_put_back_to_where_it_was_and_to_where_the_file_has_it(signed_in: As, clock: Clock) -> None:
    operator = signed_in(Role.operator)
    place(operator, [1.5, 0.0, 0.625])
    assert place(operator, ON_THE_BASE, "2026-03-01T08:00:00.1Z")["previous"]["pose"]["xyz_m"] == [1.5, 0.0, 0.625]
    (known,) = operator.get(CELL).json()["moved"]
    assert (known["previous"]["pose"]["xyz_m"], known["in_file"]["pose"]["xyz_m"]) == ([1.5, 0.0, 0.625], IN_FILE)
    clock.go_on(seconds=5)
    back = operator.post(f"{ZONE}/undo", json={"moves": known["moves"]}).json()
    assert (back["shape"]["pose"]["xyz_m"], back["previous"]["pose"]["xyz_m"], back["flaws"]) == ([1.5, 0.0, 0.625], ON_THE_BASE, [])
    assert datetime.fromisoformat(back["received_at"]) == clock()
    assert datetime.fromisoformat(back["measured_at"]) == datetime(2026, 3, 1, 8, 0, 0, 100_000, tzinfo=UTC)
    assert operator.post(f"{ZONE}/undo").json()["shape"]["pose"]["xyz_m"] == ON_THE_BASE
    assert operator.post(f"{ZONE}/undo", json={"to": "file"}).json()["shape"]["pose"]["xyz_m"] == IN_FILE
    assert shown_at(operator) == IN_FILE
    entries = signed_in(Role.engineer).get("/api/audit").json()
    assert [entry["action"] for entry in entries] == ["zone.undo", "zone.undo", "zone.undo", "zone.move", "zone.move"]
    assert entries[0]["detail"]["to"] == "file"


def test_the_first_move_is_undone_to_where_the_file_has_the_zone(signed_in: As) -> None:
    operator = signed_in(Role.operator)
    assert place(operator, ON_THE_BASE)["previous"]["pose"]["xyz_m"] == IN_FILE
    assert operator.post(f"{ZONE}/undo").json()["shape"]["pose"]["xyz_m"] == IN_FILE


def test_who_stands_still_under_a_tracker_can_still_be_put_back(signed_in: As) -> None:
    operator = signed_in(Role.operator)
    for tenth in range(3):
        place(operator, ON_THE_BASE, f"2026-03-01T08:00:00.{tenth}Z")
    assert operator.post(f"{ZONE}/undo").json()["shape"]["pose"]["xyz_m"] == IN_FILE


def test_a_tracker_whose_clock_is_behind_goes_on_after_an_undo(signed_in: As, clock: Clock) -> None:
    operator = signed_in(Role.operator)
    clock.go_on(minutes=5)
    place(operator, ON_THE_BASE)
    assert operator.post(f"{ZONE}/undo").status_code == 200
    assert place(operator, [1.6, 0.0, 0.625], "2026-03-01T08:00:00.1Z")["shape"]["pose"]["xyz_m"] == [1.6, 0.0, 0.625]


def test_an_undo_of_what_nobody_saw_or_did_is_refused(signed_in: As) -> None:
    operator = signed_in(Role.operator)
    assert operator.post(f"{ZONE}/undo").status_code == 409
    seen = place(operator, ON_THE_BASE)["moves"]
    place(operator, [1.5, 0.0, 0.625], "2026-03-01T08:00:00.1Z")
    assert operator.post(f"{ZONE}/undo", json={"moves": seen}).status_code == 409
    assert operator.post(f"{CELL}/zones/nobody/undo").status_code == 404
    assert shown_at(operator) == [1.5, 0.0, 0.625]


def test_the_run_is_told_where_the_zone_is_after_an_undo(
    nothing_planned: None, service: Service, signed_in: As, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[ZoneChanged] = []
    monkeypatch.setattr(ActiveRun, "tell_zone_change", lambda _, changed: told.append(changed))
    operator = signed_in(Role.operator)
    assert operator.post("/api/runs", json={"cell": "lwr4_bench", "payload": "steel_block"}).status_code == 202
    wait_for(lambda: "lwr4_bench" in service.conductor.active, "the run to have its cell")
    place(operator, ON_THE_BASE)
    operator.post(f"{ZONE}/undo")
    wait_for(lambda: len(told) == 2, "the run to be told", lambda: told)
    assert [changed.shape and changed.shape.pose.xyz_m for changed in told] == [(0.0, 0.0, 0.0), tuple(IN_FILE)]


def test_a_place_is_looked_at_before_the_zone_moves_there(signed_in: As) -> None:
    operator = signed_in(Role.operator)

    def flaws_at(xyz_m: list[float]) -> list[str]:
        answer = operator.post(f"{ZONE}/check", json={"shape": {**OPERATOR, "pose": {"xyz_m": xyz_m}}})
        assert answer.status_code == 200, answer.text
        return [flaw["where"] for flaw in answer.json()["flaws"]]

    assert flaws_at([1.5, 0.0, 0.625]) == []
    assert flaws_at(ON_THE_BASE) == ["lwr4_bench/cell.toml: zones.operator.shape"]
    assert flaws_at(OVER_THE_ARM) == ["lwr4_bench/cell.toml: robot.home_rad"]
    assert operator.post(f"{CELL}/zones/nobody/check", json={"shape": OPERATOR}).status_code == 404
    assert shown_at(operator) == IN_FILE
    assert operator.get(CELL).json()["moved"] == []


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


TROLLEY = {"kind": "cylinder", "radius_m": 0.3, "length_m": 1.5, "pose": {"xyz_m": [0.0, 1.6, 0.0]}}


def draw(client: TestClient, name: str = "trolley", **changed: Any) -> Any:
    return client.post(f"{CELL}/zones", json={"name": name, "shape": TROLLEY | changed})


def zones_of(client: TestClient) -> dict[str, Any]:
    return {zone["name"]: zone["shape"] for zone in client.get(CELL).json()["cell"]["zones"]}


@BOTH_STORES
def test_a_zone_is_drawn_resized_deleted_and_brought_back_and_the_log_has_it_all(signed_in: As) -> None:
    operator = signed_in(Role.operator)
    made = draw(operator)
    assert (made.status_code, made.json()["previous"], made.json()["shape"]["radius_m"]) == (201, None, 0.3)
    assert list(zones_of(operator)) == ["operator", "trolley"]
    larger = operator.put(f"{CELL}/zones/trolley/shape", json={"shape": TROLLEY | {"radius_m": 0.4}})
    assert (larger.status_code, larger.json()["previous"]["radius_m"]) == (200, 0.3)
    gone = operator.delete(f"{CELL}/zones/trolley")
    assert (gone.status_code, gone.json()["shape"]) == (200, None)
    assert list(zones_of(operator)) == ["operator"]
    (place,) = operator.get(CELL).json()["moved"]
    assert (place["zone"], place["previous"]["radius_m"], place["in_file"]) == ("trolley", 0.4, None)
    assert operator.post(f"{CELL}/zones/trolley/undo", json={"moves": place["moves"]}).status_code == 200
    assert zones_of(operator)["trolley"]["radius_m"] == 0.4
    entries = signed_in(Role.engineer).get("/api/audit").json()
    assert [entry["action"] for entry in entries] == ["zone.undo", "zone.delete", "zone.reshape", "zone.create"]
    assert operator.post(f"{CELL}/zones/trolley/undo", json={"to": "file"}).json()["shape"] is None


def test_a_zone_of_the_file_is_deleted_and_its_file_brings_it_back(signed_in: As) -> None:
    operator = signed_in(Role.operator)
    assert operator.delete(ZONE).status_code == 200
    assert zones_of(operator) == {}
    assert moved(operator, 1.5, "2026-03-01T08:00:01Z") == 404
    assert operator.delete(ZONE).status_code == 404
    assert operator.post(f"{ZONE}/undo", json={"to": "file"}).status_code == 200
    assert shown_at(operator) == IN_FILE


def test_a_zone_that_is_a_mesh_is_followed_deleted_and_brought_back_but_not_drawn(signed_in: As, service: Service) -> None:
    folder = service.cells.load("lwr4_bench").folder
    trimesh.creation.box((0.6, 0.8, 1.8)).export(folder / "people.stl")
    mesh = {"kind": "mesh", "file": "people.stl", "pose": {"xyz_m": [-1.6, 0.5, 0.9]}}
    with (folder / "cell.toml").open("a") as file:
        file.write('\n[[zones]]\nname = "people"\nshape = { kind = "mesh", file = "people.stl", pose.xyz_m = [-1.6, 0.5, 0.9] }\n')
    operator, people = signed_in(Role.operator), f"{CELL}/zones/people"
    there = {"pose": {"xyz_m": [-1.5, 0.4, 0.9]}, "measured_at": "2026-03-01T08:00:00Z"}
    followed = operator.put(people, json=there)
    assert (followed.status_code, followed.json()["shape"]["file"], followed.json()["flaws"]) == (200, "people.stl", []), followed.text
    assert zones_of(operator)["people"]["pose"]["xyz_m"] == [-1.5, 0.4, 0.9]
    assert operator.delete(people).status_code == 200
    assert list(zones_of(operator)) == ["operator"]
    assert operator.post(f"{people}/undo", json={"to": "file"}).json()["shape"]["pose"]["xyz_m"] == [-1.6, 0.5, 0.9]
    drawn = operator.post(f"{CELL}/zones", json={"name": "drawn", "shape": mesh})
    assert drawn.status_code == 422
    assert list(zones_of(operator)) == ["operator", "people"]


def test_a_zone_that_was_resized_here_keeps_its_size_when_a_tracker_moves_it(signed_in: As, clock: Clock) -> None:
    operator = signed_in(Role.operator)
    assert operator.put(f"{ZONE}/shape", json={"shape": {"kind": "sphere", "radius_m": 0.5, "pose": {"xyz_m": IN_FILE}}}).status_code == 200
    clock.go_on(seconds=2)
    assert place(operator, [1.5, 0.0, 0.625], "2026-03-01T08:00:01Z")["shape"]["kind"] == "sphere"
    assert zones_of(operator)["operator"]["radius_m"] == 0.5


@pytest.mark.parametrize(
    ("name", "owner"),
    [("operator", "another zone"), ("Operator", "another zone"), ("bench", "an obstacle"), ("link2", "a link of the robot"),
     ("payload", "the payload or the floor"), ("steel_block", "a payload of cell.toml"), ("shaft", "a payload of the tool library"),
     ("SHAFT", "a payload of the tool library")],
)  # fmt: skip
def test_a_new_zone_needs_a_name_that_nothing_in_the_cell_has(name: str, owner: str, signed_in: As) -> None:
    operator = signed_in(Role.operator)
    operator.post(f"{CELL}/payloads", json={"name": "shaft", "title": "Shaft", "box": {"kind": "box", "size_m": [0.1, 0.1, 0.1]}})
    asked = operator.post(f"{CELL}/zones/{name}/check", json={"shape": TROLLEY, "new": True})
    refused = draw(operator, name)
    assert (refused.status_code, refused.json()["kind"]) == (409, "bad-zone"), refused.text
    assert asked.json()["flaws"] == refused.json()["flaws"]
    assert [(flaw["code"], flaw["found"]) for flaw in refused.json()["flaws"]] == [
        ("zone-name-taken", f'the name "{name.lower()}", which {owner} has')
    ]
    assert operator.get(CELL).json()["moved"] == []


@pytest.mark.parametrize(
    ("changed", "code"),
    [
        ({"radius_m": 0.005}, "zone-too-small"),
        ({"radius_m": 600.0}, "zone-too-large"),
        ({"pose": {"xyz_m": [300.0, 0.0, 0.0]}}, "zone-too-far"),
        ({"pose": {"xyz_m": ON_THE_BASE}}, "cell-base-inside"),
        ({"pose": {"xyz_m": [0.5, 0.0, 0.6]}}, "robot-home-too-close"),
    ],
)
def test_a_drawn_zone_that_is_a_slip_or_stands_on_the_robot_at_home_is_refused_in_words(
    changed: dict[str, Any], code: str, signed_in: As
) -> None:
    operator = signed_in(Role.operator)
    asked = operator.post(f"{CELL}/zones/trolley/check", json={"shape": TROLLEY | changed, "new": True})
    refused = draw(operator, **changed)
    assert (asked.status_code, refused.status_code) == (200, 409), refused.text
    assert [flaw["code"] for flaw in asked.json()["flaws"]] == [flaw["code"] for flaw in refused.json()["flaws"]] == [code]
    assert draw(operator).status_code == 201
    reshaped = operator.put(f"{CELL}/zones/trolley/shape", json={"shape": TROLLEY | changed})
    assert [flaw["code"] for flaw in reshaped.json()["flaws"]] == [code]


def test_what_another_zone_contradicts_keeps_nobody_from_drawing_one(signed_in: As) -> None:
    operator = signed_in(Role.operator)
    place(operator, ON_THE_BASE)
    assert draw(operator).status_code == 201
    assert operator.post(f"{CELL}/zones", json={"name": "trolley", "shape": TROLLEY}).status_code == 409


def test_who_only_watches_changes_no_zone(signed_in: As) -> None:
    viewer = signed_in(Role.viewer)
    assert draw(viewer).status_code == 403
    assert viewer.put(f"{ZONE}/shape", json={"shape": TROLLEY}).status_code == 403
    assert viewer.delete(ZONE).status_code == 403


def test_the_run_is_told_of_zones_that_come_grow_and_go(
    nothing_planned: None, service: Service, signed_in: As, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[ZoneChanged] = []
    monkeypatch.setattr(ActiveRun, "tell_zone_change", lambda _, changed: told.append(changed))
    operator = signed_in(Role.operator)
    assert operator.post("/api/runs", json={"cell": "lwr4_bench", "payload": "steel_block"}).status_code == 202
    wait_for(lambda: "lwr4_bench" in service.conductor.active, "the run to have its cell")
    draw(operator)
    operator.put(f"{CELL}/zones/trolley/shape", json={"shape": TROLLEY | {"radius_m": 0.4}})
    operator.delete(f"{CELL}/zones/trolley")
    wait_for(lambda: len(told) == 3, "the run to be told", lambda: told)
    sizes = [getattr(changed.shape, "radius_m", None) for changed in told]
    assert (sizes, {changed.zone for changed in told}) == ([0.3, 0.4, None], {"trolley"})
