"""A line that was lost, a page that was loaded again, a robot that lost its console: the screen says what the service says."""

from __future__ import annotations

import signal
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect

from tests.server.real_service import Console, RealService, wait_for
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.tablet import Tablet, tablet

UNREACHABLE = "ERR_INTERNET_DISCONNECTED"
"""What the browser says of every question that it could not put."""


@pytest.fixture
def watching(service: RealService, browser: Browser) -> Iterator[Tablet]:
    """A tablet that is signed in and looks on."""
    with tablet(browser, service) as at:
        at.without_viewer()
        at.open()
        at.sign_in()
        yield at


def test_a_screen_without_a_line_says_so_and_shows_what_happened_meanwhile_once_it_is_back(watching: Tablet, person: Console):
    run = person.queue()
    watching.wait(".command-bar .press-stop")
    watching.press("Open the run")
    watching.wait("main h2, main table")
    watching.page.context.set_offline(True)
    watching.wait(".lost-layer")
    expect(watching.page.get_by_role("button", name="STOP")).to_have_count(0)
    check_looks(look(watching.page, "connection lost"))
    person.http.delete(f"/api/runs/{run}")
    person.wait(run, "Stopped")
    watching.page.context.set_offline(False)
    watching.page.locator(".lost-layer").wait_for(state="detached")
    assert watching.page.locator("main [data-state]").get_attribute("data-state") == "Stopped"
    expect(watching.page.locator(".ended")).to_contain_text(person.run(run)["reason"]["text"])
    check_that_loading_it_again_changes_nothing(watching)
    assert [said for said in watching.complaints if UNREACHABLE not in said] == []


def test_a_page_of_which_nothing_is_known_yet_says_why_and_fills_by_itself(watching: Tablet, person: Console):
    run = person.queue()
    person.http.delete(f"/api/runs/{run}")
    person.wait(run, "Stopped")
    wait_for(lambda: person.http.get("/api/now").json() == [], "the cell to be free")
    watching.page.wait_for_timeout(1000)  # what the page is told of it
    about_it = f"**/api/runs/{run}"
    watching.page.context.route(about_it, lambda route: route.abort())
    watching.page.goto(f"http://{watching.service.address}/#/runs/{run}")
    expect(watching.page.get_by_role("heading", level=1)).to_have_text("Loading")
    expect(watching.page.locator("main")).to_contain_text("loads by itself")
    check_looks(look(watching.page, "nothing known"))
    watching.page.context.unroute(about_it)
    expect(watching.page.get_by_role("heading", level=1)).not_to_have_text("Loading")
    assert [said for said in watching.complaints if "ERR_FAILED" not in said] == []


def test_an_answer_that_broke_off_is_asked_for_again(watching: Tablet):
    cell = "**/api/cells/lwr4_bench"
    watching.page.context.route(cell, lambda route: route.fulfill(body="{", content_type="application/json"), times=1)
    with watching.page.expect_response(cell) as broken:
        watching.page.reload()
    assert broken.value.text() == "{"
    watching.wait(".setup .cell-facts")
    assert watching.complaints == []


def test_a_service_that_answers_nothing_at_all_is_a_lost_line_too_and_is_found_again(watching: Tablet):
    expect(watching.page.locator(".lost-layer")).to_have_count(0)
    watching.service.send(signal.SIGSTOP)
    try:
        watching.wait(".lost-layer")
    finally:
        watching.service.send(signal.SIGCONT)
    expect(watching.page.locator(".lost-layer")).to_have_count(0)
    expect(watching.page.locator(".header")).to_contain_text("Online")
    assert watching.complaints == []


def check_that_loading_it_again_changes_nothing(at: Tablet) -> None:
    before = at.page.inner_text("main")
    at.page.reload()
    at.wait(".ended h1")
    assert at.page.inner_text("main") == before


@pytest.mark.thorough
def test_a_run_that_lost_its_console_is_gone_on_with_from_another_screen(watching: Tablet, person: Console):
    run = moving(person)
    person.answering.clear()
    person.wait(run, "Held")
    watching.page.goto(f"http://{watching.service.address}/#/runs/{run}")
    expect(watching.page.locator(".held-notice")).to_contain_text("Connection to the console in control was late (")
    expect(watching.page.locator(".held-notice")).to_contain_text("more for Resume")
    check_looks(look(watching.page, "held by a lost link"))
    watching.press("Resume")
    person.wait(run, "Execute")
    expect(watching.page.locator(".held-notice")).to_have_count(0)
    expect(watching.page.locator(".header")).to_contain_text("You have control")
    watching.press("STOP")
    person.wait(run, "Stopped")
    assert watching.complaints == []


@pytest.mark.thorough
def test_an_aborted_run_is_so_on_every_screen_until_somebody_has_looked(watching: Tablet, person: Console):
    run = moving(person)
    assert person.command(run, "abort").status_code == 200
    person.wait(run, "Aborted")
    watching.page.goto(f"http://{watching.service.address}/#/runs/{run}")
    watching.wait(".ended [data-state=Aborted]")
    expect(watching.page.locator(".ended")).to_contain_text(person.run(run)["reason"]["text"])
    check_looks(look(watching.page, "aborted"))
    watching.press("Clear")
    watching.wait(".ended [data-state=Stopped]")
    assert person.run(run)["state"] == "Stopped"
    assert watching.complaints == []


def moving(person: Console) -> str:
    """A run whose robot moves, in somebody's control."""
    person.take_control()
    run = person.queue(pace="real_time")
    person.wait(run, "Idle")
    assert person.release(run).status_code == 200
    person.wait_moving(run)
    return run
