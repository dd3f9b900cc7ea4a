"""A proposed motion on a real service: planned, shown, released and made after the run that it continues, both in one recording."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.recording.folder import read_recording
from server.runs.schemas import RunPublic
from tests.server.finished_diagnosis import SWINGS, diagnosed_run, stopped_in_its_first_hold
from tests.server.real_service import ROOT, Console, RealService, real_service


@pytest.fixture(scope="module")
def service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RealService]:
    """One of its own: others count the runs of the shared one."""
    with real_service(tmp_path_factory.mktemp("motions")) as running:
        yield running


@pytest.mark.thorough  # tests/web/test_proposed_motion.py goes the same way, at the screen
def test_a_proposed_motion_is_made_like_any_run_and_its_recording_holds_both(service: RealService, console: Console) -> None:
    first = stopped_in_its_first_hold(console)
    diagnosis = diagnosed_run(service, first, next_experiment=SWINGS)
    queued = console.http.post(f"/api/diagnoses/{diagnosis}/motion", json={"pace": "as_fast_as_possible"})
    assert queued.status_code == 202, queued.text
    run = queued.json()["run"]
    console.wait(run, "Idle")
    plan = console.http.get(f"/api/runs/{run}/plan").json()["plan"]
    assert [(pose["axis"], pose["rotation_s"] is not None) for pose in plan["summary"]["poses"]] == [("y+", True)]
    assert console.release(run, plan_sha256="0" * 64).status_code == 409
    assert console.release(run).status_code == 200
    done = RunPublic.model_validate(console.finish(run))
    assert done.state == "Complete", done
    assert (done.continues, done.diagnosis) == (first, diagnosis)
    check_recording(service, first, run)
    check_result(console, run)
    again = console.http.post("/api/diagnoses", json={"run": run})
    assert again.status_code == 202, again.text


def check_recording(service: RealService, first: str, run: str) -> None:
    """The old samples as they were, then the new ones after a gap; the old recording is left alone."""
    before, both = (read_recording(service.data / "recordings" / each / "recording") for each in (first, run))
    n = len(before)
    np.testing.assert_array_equal(both.wrench[:n], before.wrench)
    np.testing.assert_array_equal(both.t[:n], before.t)
    assert both.t[n] - both.t[n - 1] > 10.0
    assert {"hold:y+", "rotate:x"} <= set(both.phase[n:])
    assert not np.array_equal(both.wrench[n : n + 20], before.wrench[:20]), "the noise is another one"


def check_result(console: Console, run: str) -> None:
    """From both together; what one motion cannot show is not made up."""
    answer = console.http.get(f"/api/runs/{run}/result").json()
    truth = load_cell(ROOT / "cells" / "lwr4_bench").payloads["steel_block"].parameters
    assert abs(answer["mass_kg"] - truth.mass) < 5 * answer["mass_std_kg"] + 1e-3
    assert console.http.get(f"/api/runs/{run}/report").status_code == 200
    assert console.http.get(f"/api/runs/{run}/exports").status_code == 200
