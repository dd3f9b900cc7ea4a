"""Runs over time, and two of them side by side: what stands on the screen is what the service found."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Browser, expect

from tests.server.real_service import Console, RealService
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import on_page
from tests.web.tablet import Tablet

INTERVAL = 1.96


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
        done.append(console.wait(run, "Complete"))
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
    return "< 0.1 %" if chance < 1e-3 else f"{100 * chance:.{0 if chance >= 0.1 else 1}f} %"


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
