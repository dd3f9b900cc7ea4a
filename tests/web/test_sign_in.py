"""Whoever is not signed in sees what every robot does, and may stop it."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.server.real_service import Console, RealService, real_service
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.tablet import tablet


@pytest.fixture
def moving(person: Console) -> str:
    """A run whose robot moves."""
    person.take_control()
    run = person.queue(pace="real_time", hold_s=20.0)
    person.wait(run, "Idle")
    assert person.release(run).status_code == 200
    person.wait_moving(run)
    return run


def test_a_robot_that_moves_is_shown_and_stopped_without_signing_in(
    service: RealService, browser: Browser, person: Console, moving: str
) -> None:
    with tablet(browser, service) as at:
        at.open()
        robot = at.page.locator(".active-robots [data-cell=lwr4_bench]")
        with person.keep_moving(moving):
            expect(robot).to_contain_text("Running")
        expect(at.page.locator(".header")).to_contain_text("1 run is active")
        expect(at.page.locator(".header")).not_to_contain_text("Control")
        at.page.get_by_label("Name").fill("hans")
        check_looks(look(at.page, "sign in beside a robot that moves"))
        at.press("STOP lwr4_bench")
        person.wait(moving, "Stopped")
        expect(robot).to_have_count(0)
        expect(at.page.locator(".header")).to_contain_text("No run is active on this service")
        assert at.page.get_by_label("Name").input_value() == "hans"
        assert at.complaints == []
    (entry,) = [each for each in audited(person) if each["action"] == "run.stop" and each["detail"]["run"] == moving]
    assert entry["who"] == "nobody@127.0.0.1"


def test_where_no_run_is_active_nothing_is_said_about_robots_or_control(service: RealService, browser: Browser) -> None:
    with tablet(browser, service) as at:
        at.open()
        expect(at.page.locator(".header")).to_contain_text("No run is active on this service")
        expect(at.page.locator(".header")).not_to_contain_text("Control")
        expect(at.page.locator("body")).not_to_contain_text("obot stopped")
        expect(at.page.locator(".press-stop")).to_have_count(0)


def test_what_is_missing_is_said_in_the_words_of_the_page(service: RealService, browser: Browser) -> None:
    with tablet(browser, service) as at:
        at.open()
        at.press("Sign in")
        name = at.page.get_by_label("Name")
        expect(name).to_be_focused()
        expect(name).to_have_accessible_description("Enter your name")
        name.fill("operator")
        expect(at.page.locator("form")).not_to_contain_text("Enter your name")
        at.press("Sign in")
        expect(at.page.get_by_label("Password")).to_be_focused()
        expect(at.page.get_by_label("Password")).to_have_accessible_description("Enter your password")
        check_looks(look(at.page, "sign in without a password"))
        assert at.complaints == []


def audited(person: Console) -> list[dict]:
    """The end of the log."""
    return list(person.http.get("/api/audit", params={"limit": 200}).json())


def test_the_address_of_the_first_start_asks_for_a_password_of_ones_own_and_signs_in_with_nothing_else(
    browser: Browser, tmp_path: Path
) -> None:
    with real_service(tmp_path) as fresh, tablet(browser, fresh) as at:
        given = fresh.password
        at.page.goto(f"http://{fresh.address}/#/first/operator/{given}")
        expect(at.page.get_by_role("heading", name="Welcome to Heft")).to_be_visible()
        check_looks(look(at.page, "first sign-in"))
        at.page.get_by_label("New password for operator").fill("too short")
        at.press("Save and sign in")
        expect(at.page.get_by_role("alert")).to_have_text("At least 12 characters")
        at.page.get_by_label("New password for operator").fill("a password of my own")
        at.press("Save and sign in")
        expect(at.page.get_by_role("heading", name="Cell and tool")).to_be_visible()
        sign_in = {"name": "operator", "password": given}
        assert at.page.request.post(f"http://{fresh.address}/api/session", data=sign_in).status == 401
        assert at.complaints == []
