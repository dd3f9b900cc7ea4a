"""A run ordered with a payload of the tool library, on a real service: from saving it to the result that the library then shows."""

from __future__ import annotations

import numpy as np
import pytest

from core.cell.folder import load_cell
from tests.server.real_service import ROOT, Console, RealService

PATH = "/api/cells/lwr4_bench/payloads"
BOX = load_cell(ROOT / "cells" / "lwr4_bench").payloads["steel_block"].box


@pytest.fixture(scope="module")
def service(real: RealService) -> RealService:
    return real


@pytest.mark.thorough
def test_a_run_with_a_saved_payload_comes_through_remembers_it_and_the_library_shows_what_was_found(console: Console) -> None:
    body = {"name": "housing", "title": "Housing", "box": BOX.model_dump(mode="json"), "mass_least_kg": 2.2, "mass_most_kg": 2.8}
    saved = console.http.post(PATH, json=body)
    assert saved.status_code == 201, saved.text
    address = saved.headers["location"]
    run = console.queue(payload="housing")
    console.wait(run, "Idle", "Stopped")
    assert console.release(run).status_code == 200
    done = console.finish(run)
    assert done["state"] == "Complete", done
    assert (done["payload"], done["saved_payload"], done["order"]["mass_guess_kg"]) == ("housing", saved.json()["id"], 2.5)

    result = console.http.get(f"/api/runs/{run}/result").json()
    assert result["mass_kg"] == pytest.approx(2.5, abs=5 * result["mass_std_kg"] + 1e-3)  # the virtual robot carries what is expected,
    np.testing.assert_allclose(result["com_m"], BOX.pose.xyz_m, atol=1e-3)  # spread evenly over the box
    assert (console.http.get(address).json()["runs"], console.http.get(address).json()["last_accepted"]) == (1, None)
    assert console.http.post(f"/api/runs/{run}/acceptance").status_code == 200

    assert console.http.patch(address, json={"name": "case"}).status_code == 200
    shown = console.http.get(address).json()
    assert (shown["name"], shown["runs"], shown["last_accepted"]["run"]) == ("case", 1, run)
    assert (shown["last_accepted"]["mass_kg"], shown["last_accepted"]["com_m"]) == (result["mass_kg"], result["com_m"])
    assert shown["last_accepted"]["accepted_by"] == "account:operator"
    [listed] = console.http.get("/api/runs", params={"saved_payload": saved.json()["id"]}).json()
    assert (listed["run"], listed["payload"]) == (run, "housing")
