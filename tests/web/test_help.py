"""Help on every screen, the manual, and the tour of who is here for the first time."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, WebSocketRoute, expect

from tests.server.real_service import RealService
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import show, signed_in
from tests.web.tablet import Tablet, tablet

PLACES = ("", "orders", "gap", "trials", "history", "cells", "alarms", "control", "settings", "admin")
STEPS = 7


@pytest.fixture(scope="module")
def at(service: RealService, browser: Browser) -> Iterator[Tablet]:
    with signed_in(service, browser) as found:
        yield found
        assert found.complaints == []


@pytest.fixture
def newcomer(service: RealService, browser: Browser) -> Iterator[Tablet]:
    """Somebody whose browser has never been here."""
    with signed_in(service, browser) as found:
        yield found
        assert found.complaints == []


def test_every_page_says_what_it_is_for_what_can_be_done_and_what_its_words_mean(at: Tablet):
    titles: list[str] = []
    for place in PLACES:
        page = show(at, place)
        page.wait_for_selector("main h1")
        at.press("Help")
        panel = page.locator(".help-panel")
        expect(panel.get_by_role("heading").first).to_be_focused()
        titles.append(panel.get_by_role("heading").first.inner_text())
        assert panel.locator("li").count() > 0
        assert [text for text in panel.locator("dt, dd").all_inner_texts() if not text.strip()] == []
        page.keyboard.press("Escape")
        expect(panel).to_have_count(0)
    assert len({*titles}) == len(PLACES), "each has words of its own"


def test_the_help_looks_as_everything_does_and_leads_to_the_manual(at: Tablet):
    page = show(at, "cells")
    page.wait_for_selector(".zone-editor")
    at.press("Help")
    expect(page.locator(".help-panel")).to_contain_text("Protected zone")
    check_looks(look(page, "help"))
    at.tap(page.get_by_role("link", name="Open the manual"))
    expect(page.locator(".manual #cells")).to_be_in_viewport()
    expect(page.locator(".help-panel")).to_have_count(0)
    at.tap(page.locator(".manual nav").get_by_role("link", name="glossary"))
    expect(page.get_by_role("heading", name="Glossary")).to_be_visible()
    expect(page.get_by_role("row", name="protected zone Where people may be")).to_be_visible()
    at.tap(page.locator(".manual nav").get_by_role("link", name="gap", exact=True))
    at.tap(page.locator(".manual table").get_by_role("link", name="contacts"))
    expect(page.locator(".manual [id='7-contacts-by-hand']")).to_be_in_viewport()
    show(at, "manual", "none-of-that-name")
    expect(page.get_by_role("heading", name="Page not found")).to_be_visible()


def test_who_is_not_signed_in_is_helped_too(service: RealService, browser: Browser):
    with tablet(browser, service) as at:
        at.open()
        at.press("Help")
        expect(at.page.locator(".help-panel")).to_contain_text("Anybody may stop a robot without signing in")


def test_the_tour_leads_from_payload_to_result_by_keys_alone_and_is_offered_once(newcomer: Tablet):
    page = newcomer.page
    page.get_by_role("button", name="Start the tour").focus()
    page.keyboard.press("Enter")
    for number in range(1, STEPS + 1):
        heading = page.get_by_role("heading", name=f"Tour: {number} of {STEPS}")
        expect(heading).to_be_focused()
        expect(page.locator(".tour-frame")).to_be_visible()
        assert_clear_of_bars(page)
        if number == 2:
            check_looks(look(page, "a step of the tour"))
        page.keyboard.press("Tab")
        page.keyboard.press("Enter")
    expect(page.locator(".tour-card")).to_have_count(0)
    assert re.search(r"#/(history|runs/\w+)$", page.url), page.url
    page.reload()
    show(newcomer, "")
    page.wait_for_selector(".setup .cell-facts")
    expect(page.get_by_role("button", name="Start the tour")).to_have_count(0)
    newcomer.press("Help")
    newcomer.press("Start the tour")
    expect(page.locator(".tour-card")).to_be_visible()
    page.keyboard.press("Escape")
    expect(page.locator(".tour-card")).to_have_count(0)


BOXES = """() => ['.header', '.tour-card', '.command-bar'].map(each => document.querySelector(each).getBoundingClientRect().toJSON())"""


def assert_clear_of_bars(page: Page) -> None:
    """The card lies over no STOP and nothing else of the bars, however the screen is held."""
    before = page.viewport_size
    for size in ({"width": 390, "height": 844}, {"width": 800, "height": 1280}, {"width": 1180, "height": 820}):
        page.set_viewport_size({"width": size["width"], "height": size["height"]})
        header, card, bar = page.evaluate(BOXES)
        assert card["bottom"] <= bar["top"] + 1, size
        assert card["top"] >= header["bottom"] - 1, size
    if before:
        page.set_viewport_size(before)


def test_a_tour_that_is_not_wanted_is_not_offered_again_to_that_person(newcomer: Tablet):
    newcomer.press("Not now")
    newcomer.page.reload()
    newcomer.page.wait_for_selector(".setup .cell-facts")
    expect(newcomer.page.locator(".tour-offer")).to_have_count(0)


def test_nobody_is_led_around_while_a_robot_moves(service: RealService, browser: Browser):
    routes: list[WebSocketRoute] = []
    with tablet(browser, service) as at:
        at.without_viewer()
        at.page.context.route_web_socket("**/api/now/live", lambda route: routes.append(route))  # noqa: PLW0108 - Playwright marks what it is given
        at.open()
        at.sign_in()
        at.press("Start the tour")
        expect(at.page.locator(".tour-card")).to_be_visible()
        moving = {"cell": "ur5e_line", "run": "1", "state": "Execute", "moving": True, "since": None, "safety_rated": False}
        routes[-1].send(json.dumps({"at": "2026-03-01T08:00:00Z", "robots": [moving]}))
        expect(at.page.locator(".tour-card")).to_have_count(0)
        at.press("Help")
        expect(at.page.get_by_role("button", name="Start the tour")).to_be_disabled()
        expect(at.page.locator(".help-panel")).to_contain_text("not available while a robot moves")
