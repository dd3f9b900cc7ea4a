"""Several runs of one payload as a series: what the service found, in words first, then drawn and in numbers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Browser, expect

from tests.server.real_service import Console, RealService
from tests.web.finished_runs import TOOL, drawn_result, finished_runs
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import on_page, show
from tests.web.tablet import Tablet

COUNT, ODD, HEAVIER_KG = 5, 2, 0.031


@pytest.fixture(scope="module")
def alike(service: RealService) -> list[str]:
    """Runs that scatter as they state."""
    return finished_runs(service, [drawn_result(seed) for seed in range(COUNT)])


@pytest.fixture(scope="module")
def one_off(service: RealService, alike: list[str]) -> list[str]:
    """The same with one that is heavier."""
    (odd,) = finished_runs(service, [drawn_result(77, heavier_kg=HEAVIER_KG)])
    # runs stand on the page in the order of time, whatever the order in the address
    return [*alike[:ODD], odd, *alike[ODD:]]


@pytest.fixture
def at(service: RealService, browser: Browser, alike: list[str], one_off: list[str]) -> Iterator[Tablet]:
    """A tablet on the history."""
    with on_page(service, browser, "History", ".run-list tbody tr") as found:
        yield found
        assert found.complaints == []


def test_three_runs_and_more_are_picked_in_the_history_and_shown_as_a_series(at: Tablet, alike: list[str]) -> None:
    at.page.get_by_label("Tool").select_option(TOOL)
    for run in alike[:4]:
        row = at.page.locator(".run-list tbody tr").filter(has=at.page.locator(f'a[href="#/runs/{run}"]'))
        row.get_by_role("checkbox").tap()
    expect(at.page.locator(".command-bar")).to_contain_text("the 4 chosen runs as a series")
    at.press("Compare")
    expect(at.page.locator(".series .verdict-words")).to_have_text("= These 4 runs agree")
    expect(at.page.locator(".series")).to_contain_text("Chance of a scatter at least this large")


def test_every_parameter_is_drawn_run_by_run_with_what_they_say_together(at: Tablet, alike: list[str], service: RealService) -> None:
    page = show(at, "series", *alike)
    expect(page.locator(".series .verdict-words")).to_have_text(f"= These {COUNT} runs agree")
    expect(page.locator(".spread svg")).to_have_count(10)
    expect(page.locator(".spread .run")).to_have_count(10 * COUNT)
    expect(page.locator(".spread .run.apart")).to_have_count(0)
    mass = asked(service, alike)["parameters"][0]
    expect(page.get_by_role("img", name="Mass, run by run")).to_have_accessible_name(f"Mass, run by run; together {together(mass)}")
    row = page.locator(".series-table").nth(1).get_by_role("row").filter(has=page.get_by_role("rowheader", name="Mass"))
    expect(row).to_contain_text(two_digits(mass["repeatability_std"]))
    check_looks(look(page, "series"))


def test_the_run_that_differs_is_named_first_with_what_it_differs_in(at: Tablet, one_off: list[str], service: RealService) -> None:
    page = show(at, "series", *one_off)
    found = asked(service, sorted(one_off))
    odd = found["runs"].index(found["apart"]["run"]) + 1
    assert found["apart"]["run"] == one_off[ODD]
    verdict = page.locator(".series .verdict")
    expect(verdict.locator(".verdict-words")).to_contain_text(f"≠ Run {odd} differs in mass: 0.0")
    expect(verdict.locator(".verdict-words")).to_contain_text("more than its interval")
    expect(verdict).to_contain_text("The others agree")
    expect(page.locator(".spread .run.apart")).to_have_count(10)
    expect(page.get_by_role("rowheader", name=f"≠ {odd}", exact=True)).to_be_visible()
    check_looks(look(page, "series with a run that differs"))


def test_conditions_add_the_reproducibility_and_the_address_keeps_them(at: Tablet, alike: list[str]) -> None:
    page = show(at, "series", *alike)
    expect(page.get_by_role("columnheader", name="s_R", exact=True)).to_have_count(0)
    page.get_by_label("Conditions").select_option("By day")
    expect(page.get_by_role("columnheader", name="s_R", exact=True)).to_have_count(1)
    assert "conditions=day" in page.url
    page.reload()
    expect(page.get_by_role("columnheader", name="s_R", exact=True)).to_have_count(1)


def test_without_a_reference_cad_is_refused_in_words_and_the_series_stays(at: Tablet, alike: list[str]) -> None:
    page = show(at, "series", *alike)
    page.get_by_label("CAD known to").select_option("2")
    expect(page.get_by_role("alert")).to_contain_text("reference")
    expect(page.locator(".series .verdict-words")).to_have_text(f"= These {COUNT} runs agree")
    expect(page.get_by_label("CAD known to")).to_have_value("")
    (complaint,) = at.complaints
    assert "422" in complaint and "prior_percent=2" in complaint
    at.complaints.clear()


def test_cad_has_its_share_where_the_runs_name_a_reference(at: Tablet, service: RealService) -> None:
    page = show(at, "series", *finished_runs(service, [drawn_result(seed, referenced=True) for seed in range(3)]))
    expect(page.get_by_role("columnheader", name="CAD", exact=True)).to_have_count(0)
    page.get_by_label("CAD known to").select_option("1")
    expect(page.get_by_role("columnheader", name="CAD", exact=True)).to_have_count(1)
    expect(page.locator(".series .verdict")).to_contain_text("what was known before: drawing 7")


def test_a_comparison_of_two_leads_to_their_series(at: Tablet, alike: list[str]) -> None:
    page = show(at, "history", *alike[:2])
    at.tap(page.get_by_role("link", name="Repeatability and value together"))
    expect(page.locator(".series .verdict-words")).to_have_text("= These 2 runs agree")


def asked(service: RealService, runs: list[str]) -> dict[str, Any]:
    """The series as the service has it."""
    console = Console(service)
    answer = console.http.get("/api/series", params={"run": runs})
    console.leave()
    return dict(answer.json()["series"])


def together(row: dict[str, Any]) -> str:
    """In the words of the screen."""
    half = two_digits(row["half_width"])
    return f"{row['mean']:.{len(half.partition('.')[2])}f} ± {half} {row['unit']}"


def two_digits(value: float) -> str:
    """As a person reads it."""
    places = -int(f"{value:.1e}".partition("e")[2]) + 1
    return f"{value:.{max(0, places)}f}"
