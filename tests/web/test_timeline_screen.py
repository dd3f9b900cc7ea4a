"""Which effect came when: runs picked in the history, what their diagnoses tell together, and those that are not diagnosed yet."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, expect

from server.jobs.kinds import DiagnosisOrder
from server.service import utc_now
from server.store.store import Store
from tests.server.finished_diagnosis import explanation, finished_diagnosis
from tests.server.real_service import RealService
from tests.web.finished_answers import said
from tests.web.finished_runs import CELL, TOOL, drawn_result, finished_runs
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import on_page, show
from tests.web.tablet import Tablet


def tilted_by(angle_rad: float) -> dict[str, Any]:
    """An answer that names a base that is not level."""
    size = {"about_x_rad": {"value": angle_rad, "std": 2e-4, "unit": "rad"}}
    tilt = explanation("base_tilt", 0.95) | {"title": said("effect-base-tilt-title"), "parameters": size}
    return {"verdict": "explained", "effects": [tilt]}


@pytest.fixture(scope="module")
def runs(service: RealService) -> list[str]:
    """Four runs on four days: nothing, a tilt, a larger one, and one that nobody has diagnosed."""
    found = finished_runs(service, [drawn_result(seed) for seed in range(4)])
    answers: list[dict[str, Any]] = [{"verdict": "no_gap"}, tilted_by(0.01), tilted_by(0.02)]
    store = Store(service.store_url)
    for run, answer in zip(found, answers, strict=False):
        order = DiagnosisOrder(recording=Path(run), run=run, cell=CELL, tool=TOOL)
        finished_diagnosis(store, utc_now(), order, **answer)
    store.close()
    return found


@pytest.fixture
def at(service: RealService, browser: Browser, runs: list[str]) -> Iterator[Tablet]:
    """A tablet on the history."""
    with on_page(service, browser, "History", ".run-list tbody tr") as found:
        yield found
        assert found.complaints == []


def test_runs_picked_in_the_history_tell_which_effect_came_when(at: Tablet, runs: list[str]) -> None:
    page = at.page
    page.get_by_label("Tool").select_option(TOOL)
    for run in reversed(runs):
        row = page.locator(".run-list tbody tr").filter(has=page.locator(f'a[href="#/runs/{run}"]'))
        row.get_by_role("checkbox").tap()
    at.press("Effects over time")
    expect(page.locator(".verdict-words")).to_have_text("Came between 1 and 2: a base that is not level.")
    row = page.get_by_role("row").filter(has=page.get_by_role("rowheader", name="base not level"))
    cells = row.get_by_role("cell")
    expect(cells.nth(0)).to_have_text("– not seen")
    expect(cells.nth(1)).to_contain_text("✓ there 0.573± 0.022°")
    expect(cells.nth(2)).to_contain_text("✓ there 1.146± 0.022°")
    missing = page.locator("section", has=page.get_by_role("heading", name="Not diagnosed yet"))
    expect(missing.get_by_role("button", name="Diagnose")).to_have_count(1)
    check_looks(look(page, "effects over time"))
    page.get_by_role("columnheader").nth(2).get_by_role("link").tap()
    expect(page.locator(".page.gap, .page.diagnosis").first).to_be_visible()


def test_one_diagnosed_run_is_too_few(at: Tablet, runs: list[str]) -> None:
    page = show(at, "timeline", runs[0], runs[3])
    expect(page.locator(".verdict")).to_have_text("At least two diagnosed recordings are needed.")


def test_an_uploaded_recording_is_added_under_its_name(service: RealService, at: Tablet, runs: list[str]) -> None:
    store = Store(service.store_url)
    finished_diagnosis(store, utc_now(), DiagnosisOrder(recording=Path("upload-1"), cell=CELL, name="Friday, new cable"), verdict="no_gap")
    store.close()
    page = show(at, "timeline", runs[1])
    offered = page.get_by_role("listitem").filter(has_text="Friday, new cable")
    offered.get_by_role("button", name="Add").tap()
    expect(page.locator(".verdict-words").last).to_have_text("Went between 1 and 2: a base that is not level.")
    expect(page.get_by_role("columnheader").nth(2)).to_have_text("2 Friday, new cable")
    expect(offered).to_have_count(0)
    check_looks(look(page, "effects over time with an upload"))
