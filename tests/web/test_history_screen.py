"""Runs over time, and two of them side by side: what stands on the screen is what the service found."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Route, expect

from tests.server.real_service import Console, RealService
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.patient_cells import console_service
from tests.web.screens import on_page
from tests.web.tablet import Tablet

INTERVAL = 1.96


@pytest.fixture(scope="module")
def service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RealService]:
    """One with no runs but these, which are counted."""
    with console_service(tmp_path_factory.mktemp("history")) as running:
        yield running


@pytest.fixture(scope="module")
def runs(service: RealService) -> list[dict[str, Any]]:
    """Two runs of one tool, the earlier one first."""
    console = Console(service)
    console.take_control()
    done = []
    for seed in (11, 12):
        run = console.queue(payload="gripper", seed=seed)
        console.wait(run, "Idle")
        assert console.release(run).status_code == 200
        done.append(console.finish(run))
    console.leave()
    return done


@pytest.fixture
def at(service: RealService, browser: Browser) -> Iterator[Tablet]:
    """A tablet on the history."""
    with on_page(service, browser, "History", ".run-list tbody tr") as found:
        yield found
        assert found.complaints == []


def test_runs_are_listed_newest_first_with_their_mass_and_who_released_them(at: Tablet, runs: list[dict[str, Any]]):
    at.page.get_by_label("Tool").select_option("gripper")
    rows = at.page.locator(".run-list tbody tr")
    expect(rows).to_have_count(len(runs))
    for row, run in zip(rows.all(), reversed(runs), strict=True):
        expect(row).to_contain_text(mass_in_words(run["result"]))
        expect(row).to_contain_text("released by operator, not accepted")
        expect(row.get_by_role("link")).to_have_attribute("href", f"#/runs/{run['run']}")
    at.page.get_by_label("Shown over time").select_option("offset_fz")
    expect(at.page.get_by_role("img", name="Sensor offset, force z, N")).to_be_visible()
    check_looks(look(at.page, "history"))


def test_runs_are_searched_and_sorted_and_the_address_keeps_it(at: Tablet, runs: list[dict[str, Any]], service: RealService):
    at.page.get_by_label("Tool").select_option("gripper")
    rows = at.page.locator(".run-list tbody tr")
    expect(rows).to_have_count(len(runs))
    links = rows.get_by_role("link")
    lighter, heavier = sorted(runs, key=lambda run: float(run["result"]["mass_kg"]))
    at.press("Mass")
    expect(at.page.get_by_role("columnheader", name="Mass")).to_have_attribute("aria-sort", "ascending")
    expect(links.first).to_have_attribute("href", f"#/runs/{lighter['run']}")
    at.press("Mass")
    expect(links.first).to_have_attribute("href", f"#/runs/{heavier['run']}")
    search = at.page.get_by_label("Search")
    search.fill(f"complete {lighter['run'][-8:]}")
    expect(rows).to_have_count(1)
    expect(links).to_have_attribute("href", f"#/runs/{lighter['run']}")
    assert "tool=gripper" in at.page.url and "sort=mass.down" in at.page.url
    at.page.reload()
    expect(rows).to_have_count(1)
    expect(search).to_have_value(f"complete {lighter['run'][-8:]}")
    search.fill(f"2020-01-01 {lighter['run'][-8:]}")
    expect(rows).to_have_count(0)
    search.fill(f"account {lighter['run'][-8:]}")
    expect(rows).to_have_count(0)
    hide_recent_runs(at)
    search.fill(lighter["run"][-8:])
    expect(links).to_have_attribute("href", f"#/runs/{lighter['run']}")  # of all runs, as the service finds it
    at.page.unroute("**/api/runs?*")
    search.fill("no such thing")
    expect(at.page.get_by_role("status").filter(has_text="No run contains")).to_contain_text("no such thing")
    check_looks(look(at.page, "history without a find"))
    at.press("Show all")
    expect(rows).to_have_count(len(runs))


def hide_recent_runs(at: Tablet) -> None:
    """As if there were hundreds of newer ones: without a search the service tells of none of these."""
    at.page.route("**/api/runs?*", lambda route: route.continue_() if "search=" in route.request.url else route.fulfill(json=[]))


def test_serial_numbers_and_orders_have_columns_where_somebody_gave_them(at: Tablet, runs: list[dict[str, Any]]):
    expect(at.page.get_by_role("columnheader", name="Serial number")).to_have_count(0)
    given = {run["run"]: {"serial_number": f"SN-{9 + k}", "order_id": f"PO-{k}", "work_order": "W7"} for k, run in enumerate(runs)}

    def answered(route: Route) -> None:
        response = route.fetch()
        route.fulfill(response=response, json=[run | given.get(run["run"], {}) for run in response.json()])

    at.page.route("**/api/runs?*", answered)
    rows = at.page.locator(".run-list tbody tr")
    expect(rows.filter(has_text="SN-9")).to_contain_text("PO-0")
    expect(rows.filter(has_text="SN-9")).to_contain_text("work order W7")
    at.press("Serial number")
    expect(rows.first).to_contain_text("SN-9")  # as people count, before SN-10
    at.page.get_by_label("Search").fill("sn-10")
    expect(rows).to_have_count(1)
    check_looks(look(at.page, "history with serial numbers"))


def test_what_is_shown_over_time_is_saved_with_moments_and_intervals(at: Tablet, runs: list[dict[str, Any]]):
    at.page.get_by_label("Tool").select_option("gripper")
    expect(at.page.locator(".run-list tbody tr")).to_have_count(len(runs))
    at.tap(at.page.locator(".plot-tools summary"))
    with at.page.expect_download() as saved:
        at.press("CSV")
    assert re.fullmatch(r"history-lwr4_bench-gripper-mass-\d{4}-\d\d-\d\d\.csv", saved.value.suggested_filename)
    head, *rows = Path(saved.value.path()).read_text().splitlines()
    assert head.startswith("time,") and head.endswith(",Mass (kg)")
    assert len(rows) == len(runs)
    for row, run in zip(rows, runs, strict=True):
        when, low, high, mass = row.split(",")
        assert when.startswith(run["ended_at"][:19])
        assert float(mass) == pytest.approx(run["result"]["mass_kg"])
        assert float(low) < float(mass) < float(high)


def test_two_runs_side_by_side_show_the_differences_that_the_service_found(at: Tablet, runs: list[dict[str, Any]], service: RealService):
    at.page.get_by_label("Tool").select_option("gripper")
    expect(at.page.get_by_role("button", name="Compare")).to_be_disabled()
    expect(at.page.get_by_role("checkbox")).to_have_count(len(runs))
    for box in at.page.get_by_role("checkbox").all():
        box.tap()
    at.press("Compare")
    at.wait(".comparison-table")
    found = compared(service, *(run["run"] for run in runs))
    verdict = at.page.locator(".comparison .verdict")
    expect(verdict).to_contain_text("≠ The runs differ" if found["differ"] else "= No significant difference")
    expect(verdict).to_contain_text(f"one payload: {in_per_cent(found['chance'])}")
    for title, differences in (("Payload", found["com"]), ("Offsets of the sensor", found["offset"])):
        table = at.page.locator(".comparison-table").filter(has_text=title)
        for difference in differences:
            row = table.locator("tbody tr").filter(has=at.page.get_by_role("rowheader", name=NAMES[difference["name"]], exact=True))
            expect(row).to_contain_text(significance(difference))
    check_looks(look(at.page, "comparison"))


def test_a_result_is_set_beside_the_run_before_and_tells_how_well_unseen_motions_are_predicted(
    at: Tablet, runs: list[dict[str, Any]], service: RealService
):
    before, last = (run["run"] for run in runs)
    at.page.goto(f"http://{service.address}/#/runs/{last}")
    beside = at.page.get_by_role("link", name="Full comparison")
    expect(beside).to_have_attribute("href", f"#/history/{before}/{last}")
    verified = asked(service, f"/api/runs/{last}/result")["verification"]
    assert verified
    for each in verified:
        expect(at.page.locator(".result aside")).to_contain_text(f"{each['ratio']:.2f} × expected")


NAMES = {"cx": "Centre of mass x", "cy": "Centre of mass y", "cz": "Centre of mass z"} | {
    f"{kind[0].lower()}{axis}": f"{kind} {axis}" for kind in ("Force", "Torque") for axis in "xyz"
}


def significance(difference: dict[str, Any]) -> str:
    """In the words of the screen."""
    times = abs(difference["value"]) / (INTERVAL * difference["std"])
    if times <= 1:
        return "= agrees"
    shown = f"{times:.1f}" if times < 10 else f"{times:,.0f}".replace(",", "\u202f")
    return f"≠ significant ({shown} × the interval)"


def in_per_cent(chance: float) -> str:
    """As fine as anybody needs it."""
    if not 1e-3 <= chance <= 0.999:
        return "< 0.1 %" if chance < 0.5 else "> 99.9 %"
    return f"{100 * chance:.{0 if chance >= 0.1 else 1}f} %"


def mass_in_words(result: dict[str, Any]) -> str:
    """With as many decimals as give its interval two digits."""
    half_kg = INTERVAL * result["mass_std_kg"]
    return f"{result['mass_kg']:.{1 - math.floor(math.log10(half_kg))}f}"


def compared(service: RealService, first: str, second: str) -> dict[str, Any]:
    return dict(asked(service, f"/api/runs/{first}/comparison/{second}")["comparison"])


def asked(service: RealService, path: str) -> dict[str, Any]:
    console = Console(service)
    answer = console.http.get(path)
    console.leave()
    return dict(answer.json())
