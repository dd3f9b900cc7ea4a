"""Results over the API: read, taken for good, compared, listed over time, written as controllers take them."""

from __future__ import annotations

import dataclasses
import re

import numpy as np
import pytest
from fastapi.testclient import TestClient

from core.cell.folder import load_cell
from core.estimation.result import Result
from core.export.exports import TARGETS
from core.requirement.verdict import judge_estimate
from core.robot.model import RobotModel
from server.people.roles import Role
from server.service import Service
from tests.core.export.cloud import cloud
from tests.core.export.known_result import answer
from tests.core.export.readers import READERS
from tests.server.finished_run import finished_run
from tests.server.made_people import As, Clock

CELL, OTHER = "lwr4_bench", "ur5e_line"


def ended_run(service: Service, result: Result | None, cell: str = CELL, payload: str = "gripper") -> str:
    """A run that is Complete with this result; Stopped where there is none."""
    return finished_run(service.store, service.now(), result, cell=cell, payload=payload)


def heavier(by_kg: float) -> Result:
    """The answer of a run whose payload has one more point mass in its centre."""
    body = cloud(0)
    body = dataclasses.replace(body, masses=np.append(body.masses, by_kg), points=np.vstack((body.points, body.com)))
    return answer(body, CELL)


@pytest.fixture
def run(service: Service) -> str:
    return ended_run(service, answer(cloud(0), CELL))


@pytest.fixture
def viewer(signed_in: As) -> TestClient:
    return signed_in(Role.viewer)


def test_an_operator_accepts_a_result_once_and_by_name(run: str, signed_in: As, viewer: TestClient) -> None:
    assert viewer.get(f"/api/runs/{run}").json()["accepted_by"] is None
    operator = signed_in(Role.operator)
    accepted = operator.post(f"/api/runs/{run}/acceptance")
    assert accepted.status_code == 200, accepted.text
    shown = viewer.get(f"/api/runs/{run}").json()
    assert (shown["accepted_by"], shown["accepted_at"][:4]) == ("account:operator", "2026")
    again = operator.post(f"/api/runs/{run}/acceptance")
    assert again.status_code == 409
    assert "by operator" in again.json()["detail"]
    said = [entry for entry in signed_in(Role.admin).get("/api/audit").json() if entry["action"] == "run.accept"]
    assert [entry["detail"]["run"] for entry in said] == [run]


@pytest.mark.parametrize("path", ["result", "exports", "exports/ur"])
def test_a_run_without_a_result_has_nothing_to_read_or_export(path: str, service: Service, viewer: TestClient) -> None:
    empty = ended_run(service, None)
    refused = viewer.get(f"/api/runs/{empty}/{path}")
    assert refused.status_code == 409
    assert "no result" in refused.json()["detail"]


def test_a_run_without_a_result_is_neither_accepted_nor_compared(service: Service, run: str, signed_in: As) -> None:
    empty = ended_run(service, None)
    operator = signed_in(Role.operator)
    assert operator.post(f"/api/runs/{empty}/acceptance").status_code == 409
    assert operator.get(f"/api/runs/{run}/comparison/{empty}").status_code == 409
    assert operator.get(f"/api/runs/{run}/comparison/none").status_code == 404


def test_two_runs_are_compared_with_the_significance_of_every_difference(service: Service, run: str, viewer: TestClient) -> None:
    same, other = ended_run(service, heavier(0.0)), ended_run(service, heavier(0.2))
    alike = viewer.get(f"/api/runs/{run}/comparison/{same}").json()
    assert (alike["frame"], alike["comparison"]["differ"], alike["comparison"]["chance"]) == ("sensor", False, pytest.approx(1.0))
    apart = viewer.get(f"/api/runs/{run}/comparison/{other}").json()["comparison"]
    assert apart["differ"]
    mass = apart["parameters"][0]
    assert mass["value"] == pytest.approx(0.2)
    assert mass["times_std"] == pytest.approx(0.2 / mass["std"])
    back = viewer.get(f"/api/runs/{other}/comparison/{run}").json()["comparison"]
    assert back["parameters"][0]["value"] == pytest.approx(-0.2)


def test_runs_of_two_cells_are_compared_at_the_flange(service: Service, viewer: TestClient) -> None:
    """One body on two flanges, seen from sensors that are mounted differently."""
    runs = []
    for name in (CELL, OTHER):
        mount = load_cell(service.cells.folder / name).sensor.mount
        assert mount is not None
        at_sensor = cloud(0).moved(mount.rotation.T, -mount.rotation.T @ mount.translation)
        runs.append(ended_run(service, answer(at_sensor, name), name))
    found = viewer.get(f"/api/runs/{runs[0]}/comparison/{runs[1]}").json()
    assert found["frame"] == "flange"
    assert max(abs(each["value"]) for each in found["comparison"]["parameters"]) < 1e-9


def test_a_series_of_runs_is_answered_with_its_scatter(service: Service, run: str, viewer: TestClient) -> None:
    runs = [run, ended_run(service, heavier(0.0)), ended_run(service, heavier(0.2)), ended_run(service, heavier(0.2))]
    found = viewer.get("/api/series", params={"run": runs, "condition": ["a", "a", "b", "b"]}).json()
    series, mass = found["series"], found["series"]["parameters"][0]
    assert (found["frame"], series["runs"], series["differ"]) == ("sensor", runs, True)
    assert series["apart"] is None
    one_off = viewer.get("/api/series", params={"run": runs[:3]}).json()["series"]["apart"]
    assert (one_off["run"], one_off["parameter"]) == (runs[2], "m")
    assert mass["repeatability_std"] == pytest.approx(0.0, abs=1e-9)
    assert mass["reproducibility_std"] == pytest.approx(0.2 / np.sqrt(2.0))
    assert mass["mean"] == pytest.approx(np.mean(mass["values"]), abs=1e-3)
    assert viewer.get("/api/series", params={"run": [run, "none"]}).status_code == 404
    refused = viewer.get("/api/series", params={"run": runs, "condition": ["a"]})
    assert refused.status_code == 422 and "one for each of the 4 runs" in refused.text
    assert viewer.get("/api/series", params={"run": runs, "prior_percent": 2.0}).status_code == 422


def test_every_target_is_listed_with_what_it_loses_and_its_file_is_sent(run: str, service: Service, viewer: TestClient) -> None:
    listed = viewer.get(f"/api/runs/{run}/exports").json()
    assert listed["uncertainty"]["frame"] == "flange"
    assert [each["target"] for each in listed["targets"]] == [target.name for target in TARGETS]
    lost = {each["target"]: [lack["name"] for lack in each["lost"]] for each in listed["targets"]}
    assert lost["kuka_sunrise"] == ["Ixy", "Ixz", "Iyz"]
    assert lost["mujoco"] == []
    assert [each["target"] for each in listed["targets"] if not each["holds_uncertainty"]] == ["kuka_sunrise"]
    assert listed["uncertainty"]["mass_half_width_kg"] > 0.0
    sent = viewer.get(f"/api/runs/{run}/exports/mujoco")
    assert re.search(rf'filename="run-{run}-\w+-\d{{4}}-\d\d-\d\d-inertial.xml"', sent.headers["content-disposition"])
    mount = load_cell(service.cells.folder / CELL).sensor.mount
    assert mount is not None
    m, com, _ = READERS["mujoco"](sent.text)
    assert m == pytest.approx(cloud(0).masses.sum())
    np.testing.assert_allclose(com, cloud(0).moved(mount.rotation, mount.translation).com, atol=1e-8)
    assert viewer.get(f"/api/runs/{run}/exports/fanuc").status_code == 422


def test_nothing_is_written_along_the_sensors_axes_as_if_they_were_the_flanges(run: str, service: Service, viewer: TestClient) -> None:
    file = service.cells.folder / CELL / "cell.toml"
    file.write_text("".join(line for line in file.read_text().splitlines(keepends=True) if not line.startswith("mount.")))
    listed = viewer.get(f"/api/runs/{run}/exports").json()
    assert listed["uncertainty"] is None
    assert {each["refused"]["code"] for each in listed["targets"]} == {"export-no-mount"}
    assert [each["target"] for each in listed["targets"]] == [target.name for target in TARGETS]
    refused = viewer.get(f"/api/runs/{run}/exports/xarm")
    assert refused.status_code == 422 and "sensor.mount.xyz_m" in refused.json()["detail"]


def test_what_is_not_determined_is_not_made_up_for_a_target_that_needs_it(service: Service, viewer: TestClient) -> None:
    whole = answer(cloud(0), CELL)
    assert whole.estimate is not None
    phi = [*whole.estimate.phi[:4], *[None] * 6]
    covariance = [[value if i < 4 and j < 4 else None for j, value in enumerate(row)] for i, row in enumerate(whole.estimate.covariance)]
    static = whole.model_copy(update={"estimate": whole.estimate.model_copy(update={"phi": phi, "covariance": covariance})})
    run = ended_run(service, static)
    refused = {each["target"]: each["refused"] for each in viewer.get(f"/api/runs/{run}/exports").json()["targets"]}
    assert refused["xarm"] is None
    assert "Ixx: found not determined" in refused["ur"]["text"]
    assert viewer.get(f"/api/runs/{run}/exports/ur").status_code == 422
    assert viewer.get(f"/api/runs/{run}/exports/xarm").status_code == 200


def test_runs_of_a_cell_and_tool_are_listed_page_by_page_with_what_they_found(service: Service, clock: Clock, viewer: TestClient) -> None:
    made = []
    for k in range(5):
        clock.go_on(seconds=1)
        made.append(ended_run(service, heavier(0.01 * k)))
        ended_run(service, heavier(0.0), payload="steel_block")
    wanted, pages = {"cell": CELL, "payload": "gripper", "limit": "2"}, []
    for _ in range(3):
        pages.append(viewer.get("/api/runs", params=wanted).json())
        wanted["before"] = pages[-1][-1]["run"]
    page = pages[-1]
    assert [each["run"] for page in pages for each in page] == made[::-1]
    assert {each["payload"] for each in page} == {"gripper"}
    assert page[-1]["result"]["mass_kg"] == pytest.approx(cloud(0).masses.sum())
    assert len(page[-1]["result"]["offset"]) == 6


def test_whether_a_result_is_good_enough_stands_in_it_and_in_the_list(service: Service, run: str, viewer: TestClient) -> None:
    found = answer(cloud(0), CELL)
    cell = load_cell(service.cells.folder / CELL)
    judged = found.model_copy(update={"requirement": judge_estimate(cell, RobotModel.of_cell(cell), found.estimate)})
    made = ended_run(service, judged)
    requirement = viewer.get(f"/api/runs/{made}/result").json()["requirement"]
    assert requirement["adequacy"]["good_enough"]
    assert requirement["adequacy"]["parameter"]["unit"] in ("kg", "m", "kg m2")
    assert requirement["message"]["text"].startswith("Good enough for this cell: ")
    assert viewer.get(f"/api/runs/{made}").json()["result"]["good_enough"] is True
    assert viewer.get(f"/api/runs/{run}/result").json()["requirement"] is None
    assert viewer.get(f"/api/runs/{run}").json()["result"]["good_enough"] is None
