"""Control passes between two people at two tablets: by one tap of each, by time, or not at all; a robot that moves goes on."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect

from tests.server.real_service import Console, RealService
from tests.web.judgement import check_looks
from tests.web.looks import glimpse, look
from tests.web.people import BEN, PASSWORD, add_operator
from tests.web.screens import show, signed_in
from tests.web.tablet import LANDSCAPE, PHONE, Tablet

LEFT = re.compile(r"in 0:[0-3]\d")


@pytest.fixture
def anna(service: RealService, browser: Browser, person: Console) -> Iterator[Tablet]:
    """The first operator's tablet, in control."""
    add_operator(person)
    with signed_in(service, browser) as at:
        at.page.locator(".header .who").tap()
        at.press("Take control")
        at.wait(".who-mine")
        yield at
        assert at.complaints == []


@pytest.fixture
def ben(service: RealService, browser: Browser, anna: Tablet) -> Iterator[Tablet]:
    """Another operator's, who looks on."""
    with signed_in(service, browser, BEN, PASSWORD) as at:
        expect(at.page.locator(".header .who")).to_contain_text("operator has control")
        yield at
        assert at.complaints == []


def check_in_control(at: Tablet, other: Tablet) -> None:
    """One of two, by what both show."""
    expect(at.page.locator(".who-mine")).to_have_count(1)
    expect(other.page.locator(".who-mine")).to_have_count(0)


def test_control_is_handed_over_by_one_tap_of_each(anna: Tablet, ben: Tablet):
    anna.taps = ben.taps = 0
    ben.press("Ask for control")
    request = anna.page.locator(".control-request")
    expect(request).to_contain_text("ben (Tablet")
    expect(request).to_contain_text(LEFT)
    expect(ben.page.locator(".control-request")).to_contain_text(LEFT)
    check_in_control(anna, ben)
    check_looks(glimpse(anna.page, "asked for control"))
    check_it_is_one_line_on_a_phone(anna)
    anna.press("Hand over")
    check_in_control(ben, anna)
    assert anna.taps + ben.taps == 2
    expect(anna.page.locator(".remark")).to_contain_text("Control handed over to ben")
    expect(ben.page.locator(".remark")).to_contain_text("You have control now.")
    check_looks(look(anna.page, "control, of somebody else"))


def check_it_is_one_line_on_a_phone(at: Tablet) -> None:
    """Which unfolds by a tap."""
    at.page.set_viewport_size(PHONE)
    details = at.page.locator(".control-request .asked")
    expect(details).to_be_hidden()
    line = at.page.get_by_role("button", name="ben asks for control.")
    expect(line).to_contain_text(re.compile(r"0:[0-3]\d"))
    line.tap()
    expect(details).to_contain_text("A moving robot goes on.")
    expect(details).to_be_visible()
    line.tap()
    expect(details).to_be_hidden()
    at.page.set_viewport_size(LANDSCAPE)
    expect(details).to_be_visible()
    expect(line).to_be_hidden()


def test_whoever_has_control_stands_in_the_header_with_screen_and_time(anna: Tablet, ben: Tablet):
    anna.page.get_by_label("Name of this screen").fill("Line 3")
    anna.press("Release control")
    expect(ben.page.locator(".header .who")).to_contain_text("none")
    anna.press("Take control")
    expect(ben.page.locator(".header .who")).to_have_text(re.compile(r"operator has control.*Line 3, since \d\d:\d\d"))
    ben.page.locator(".header .who").tap()
    facts = ben.page.locator(".control-page .facts")
    expect(facts).to_contain_text("Line 3")
    expect(facts).to_contain_text(re.compile(r"\d\d:\d\d:\d\d"))


@pytest.mark.thorough
def test_a_request_that_is_declined_leaves_control_where_it_is_and_says_so_until_it_is_read(anna: Tablet, ben: Tablet):
    ben.press("Ask for control")
    anna.press("Keep control")
    told = ben.page.locator(".remark")
    expect(told).to_contain_text("operator keeps control.")
    check_in_control(anna, ben)
    ben.page.wait_for_timeout(9_000)  # what passes by itself would have gone
    expect(told).to_be_visible()
    ben.press("Close")
    expect(told).to_have_count(0)
    expect(ben.page.get_by_role("button", name="Ask for control")).to_be_visible()


def test_a_request_can_be_withdrawn(anna: Tablet, ben: Tablet):
    ben.press("Ask for control")
    anna.page.locator(".control-request").wait_for()
    ben.press("Withdraw")
    for at in (anna, ben):
        expect(at.page.locator(".control-request")).to_have_count(0)
    check_in_control(anna, ben)


@pytest.mark.thorough
def test_control_that_nobody_answers_for_passes_by_time_and_the_first_screen_says_so_until_it_is_read(anna: Tablet, ben: Tablet):
    ben.press("Ask for control")
    anna.page.locator(".control-request").wait_for()
    ben.page.locator(".who-mine").wait_for(timeout=45_000)
    check_in_control(ben, anna)
    told = anna.page.locator(".remark")
    expect(told).to_contain_text("Control passed to ben")
    expect(told).to_contain_text("not answered in time")
    anna.page.wait_for_timeout(9_000)
    expect(told).to_be_visible()


def test_a_robot_that_moves_goes_on_while_control_passes_and_is_held_when_it_is_released(anna: Tablet, ben: Tablet, person: Console):
    anna.hurry()
    anna.tap(anna.page.get_by_role("link", name="Run"))
    anna.press("Plan")
    anna.wait(".preview table")
    anna.press("Release…")
    anna.press("START")
    anna.page.get_by_role("button", name="Hold").wait_for()
    run = anna.page.url.rsplit("/", 1)[1]
    show(ben, "runs", run)
    ben.press("Ask for control")
    anna.press("Hand over")
    check_in_control(ben, anna)
    expect(ben.page.get_by_role("button", name="Hold")).to_be_visible()
    expect(anna.page.get_by_role("button", name="Hold")).to_have_count(0)
    states = [
        event["event"]["state"]
        for event in person.http.get(f"/api/runs/{run}/events", params={"kind": "event"}).json()
        if event["event"]["kind"] == "state_changed"
    ]
    assert states[-1] == "Execute"
    assert not {"Holding", "Held"} & set(states)
    ben.page.locator(".header .who").tap()
    expect(ben.page.get_by_role("button", name="Release control")).to_contain_text("puts the robot on hold")
    ben.press("Release control")
    assert person.wait(run, "Held")["reason_kind"] == "hold-asked"
    expect(anna.page.locator(".header .who")).to_contain_text("none")
    anna.press("Resume")
    person.wait(run, "Execute")
    check_in_control(anna, ben)
    anna.press("STOP")
    person.wait(run, "Stopped")


def test_control_of_ones_own_moves_to_another_screen_by_one_tap(service: RealService, browser: Browser, anna: Tablet):
    with signed_in(service, browser) as second:
        expect(second.page.locator(".header .who")).to_contain_text("You (other device)")
        second.press("Take control here")
        check_in_control(second, anna)
        expect(anna.page.locator(".remark", has_text="Control is now on your other screen")).to_be_visible()
        assert second.complaints == []
