"""What needs a person is on every page until somebody has acknowledged it, and stays in the history."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect

from tests.server.real_service import Console, RealService
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.people import PASSWORD
from tests.web.screens import on_page, show, signed_in
from tests.web.tablet import Tablet


@pytest.fixture
def at(service: RealService, browser: Browser, person: Console) -> Iterator[Tablet]:
    """A tablet on the page of the history; nothing needs a person."""
    for alarm in person.http.get("/api/alarms/open").json():
        person.http.post(f"/api/alarms/{alarm['id']}/acknowledgement")
    with on_page(service, browser, "History", ".history h1") as found:
        expect(found.page.get_by_role("link", name="Alarms: 0 open")).to_be_visible()
        yield found
        assert found.complaints == []


@pytest.fixture
def aborted(person: Console, at: Tablet) -> Iterator[str]:
    """A run that was aborted while it moved, and that nobody has cleared."""
    person.take_control()
    run = person.queue(pace="real_time")
    person.wait(run, "Idle")
    assert person.release(run).status_code == 200
    person.wait(run, "Execute", "Held")  # a busy computer puts it on hold
    assert person.command(run, "abort").status_code == 200
    person.wait(run, "Aborted")
    yield run
    clear(person, run)


def clear(person: Console, run: str) -> None:
    if person.run(run)["state"] == "Aborted":
        person.take_control()
        while person.command(run, "clear").status_code == 409:
            person.wait(run, "Aborted")


def test_an_alarm_is_on_every_page_until_it_is_acknowledged_and_in_the_history_afterwards(at: Tablet, aborted: str, person: Console):
    band = at.page.locator(".alarm-band")
    expect(band).to_contain_text("Run aborted: aborted by operator.")
    expect(at.page.get_by_role("link", name="Alarms: 1 open")).to_be_visible()
    check_looks(look(at.page, "history with an alarm"))
    at.tap(band.get_by_role("button", name="Acknowledge"))
    expect(band).to_have_count(0)
    at.tap(at.page.get_by_role("link", name="Alarms: 1 open"))
    alarm = at.page.locator("[data-kind=run_aborted]")
    expect(alarm).to_contain_text("High")
    expect(alarm).to_contain_text("lwr4_bench")
    expect(alarm).to_contain_text("What to do: Check the cell, then clear the run.")
    expect(alarm).to_contain_text("Acknowledged by operator,")
    expect(alarm.get_by_role("button", name="Acknowledge")).to_have_count(0)
    check_looks(look(at.page, "alarms"))
    clear(person, aborted)
    expect(alarm).to_have_count(0)
    expect(at.page.get_by_role("link", name="Alarms: 0 open")).to_be_visible()
    past = at.page.locator(".alarm-past").first
    expect(past).to_contain_text("Run aborted: aborted by operator.")
    expect(past).to_contain_text("Acknowledged by operator,")
    check_looks(look(at.page, "past alarms"))


def test_an_alarm_that_nobody_has_acknowledged_stays_when_it_is_over_and_the_run_says_it_once(at: Tablet, aborted: str, person: Console):
    show(at, "runs", aborted)
    at.wait(".ended")
    expect(at.page.get_by_role("link", name="Alarms: 1 open")).to_be_visible()
    expect(at.page.locator(".alarm-band")).to_have_count(0)
    clear(person, aborted)
    show(at, "alarms")
    alarm = at.page.locator("[data-kind=run_aborted]")
    expect(alarm).to_contain_text("over since")
    at.tap(alarm.get_by_role("button", name="Acknowledge"))
    expect(alarm).to_have_count(0)


def test_who_only_watches_sees_alarms_and_acknowledges_none(
    service: RealService, browser: Browser, at: Tablet, aborted: str, person: Console
):
    person.http.post("/api/accounts", json={"name": "vera", "password": PASSWORD, "roles": ["viewer"]})
    with signed_in(service, browser, "vera", PASSWORD) as watching:
        show(watching, "alarms")
        expect(watching.page.locator("[data-kind=run_aborted]")).to_be_visible()
        expect(watching.page.get_by_role("button", name="Acknowledge")).to_have_count(0)
