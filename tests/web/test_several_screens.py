"""One screen decides, the others watch; what a screen shows it has from the service, also after it was loaded again."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, LocatorAssertions, expect

from tests.server.real_service import RealService
from tests.web.tablet import Tablet, tablet


@pytest.fixture
def deciding(service: RealService, browser: Browser) -> Iterator[Tablet]:
    """A tablet whose clock can be put forward, with a plan on it."""
    with tablet(browser, service) as at:
        at.page.clock.install()
        at.without_viewer()
        at.open()
        at.sign_in()
        at.page.locator(".command-bar .press-primary").tap()
        at.wait(".preview table")
        yield at


def button(at: Tablet, name: str) -> LocatorAssertions:
    return expect(at.page.get_by_role("button", name=name))


def test_a_plan_can_be_released_only_in_time_and_in_control_and_anybody_can_stop(deciding: Tablet, service: RealService, browser: Browser):
    button(deciding, "Release").to_be_visible()
    check_that_a_plan_shown_too_long_ago_is_shown_again_first(deciding)
    check_that_a_screen_loaded_again_knows_the_run_but_is_not_in_control(deciding)
    with tablet(browser, service) as watching:
        watching.without_viewer()
        watching.open()
        watching.sign_in()
        watching.press("Open the run")
        watching.wait(".preview table")
        expect(watching.page.locator(".header")).to_contain_text("You (other device)")
        button(watching, "Release").to_have_count(0)
        watching.press("STOP")
        for each in (watching, deciding):
            expect(each.page.locator(".header .state")).to_have_text("Stopped")
            button(each, "STOP").to_have_count(0)
        assert watching.complaints == deciding.complaints == []


def check_that_a_plan_shown_too_long_ago_is_shown_again_first(at: Tablet) -> None:
    """Also where the release was asked for already, and waits for its START."""
    at.press("Release")
    button(at, "START").to_be_visible()
    at.page.clock.fast_forward(61_000)
    button(at, "START").to_have_count(0)
    button(at, "Release").to_have_count(0)
    at.press("Review the plan again")
    button(at, "Release").to_be_visible()


def check_that_a_screen_loaded_again_knows_the_run_but_is_not_in_control(at: Tablet) -> None:
    """Control ended with the page that had it."""
    at.page.reload()
    at.wait(".preview table")
    button(at, "Release").to_have_count(0)
    at.press("Take control")
    button(at, "Release").to_be_visible()
