"""Every screen in a language with words 40 % longer than English: all of them come from its catalogue, and there is room for them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.core.new_cell.small_arm import arm, joint, link
from tests.server.finished_trial import finished_trial
from tests.server.real_service import Console, RealService
from tests.web.finished_answers import ANSWERS, diagnosed
from tests.web.judgement import check_nothing_is_cut_off
from tests.web.looks import Look, glimpse
from tests.web.people import BEN, PASSWORD, add_operator
from tests.web.plain_words import MARK, words_of_no_catalogue
from tests.web.screens import signed_in
from tests.web.tablet import PATIENCE_MS, Tablet, tablet

ADDRESS = "?words=longer"
UNREACHABLE = "ERR_INTERNET_DISCONNECTED"
"""What the browser says of every question that it could not put."""


@pytest.fixture(scope="module")
def complete(service: RealService) -> Iterator[str]:
    """A run with an accepted result; there is a key and, as long as it is looked at, a webhook as well."""
    console = Console(service)
    console.http.post("/api/keys", json={"name": "line", "role": "mes"})
    webhook = console.http.post("/api/webhooks", json={"url": "http://127.0.0.1:9/ended"}).json()["id"]
    console.take_control()
    run = console.queue()
    console.wait(run, "Idle")
    assert console.release(run).status_code == 200
    assert console.finish(run)["state"] == "Complete"
    assert console.http.post(f"/api/runs/{run}/acceptance").is_success
    console.leave()
    yield run
    console = Console(service)
    console.http.delete(f"/api/webhooks/{webhook}")
    console.leave()


@pytest.fixture
def at(service: RealService, browser: Browser) -> Iterator[Tablet]:
    """A tablet whose words are longer; nobody is signed in."""
    with tablet(browser, service) as found:
        found.hurry()
        found.without_viewer()
        found.open(ADDRESS)
        yield found
        assert [said for said in found.complaints if UNREACHABLE not in said] == []


def enter(at: Tablet) -> None:
    at.page.locator("input[name=username]").fill("operator")
    at.page.locator("input[name=password]").fill(at.service.password)
    at.tap(at.page.locator("form button"))
    at.wait(".navigation")


def check(at: Tablet, screen: str, names: frozenset[str] = frozenset()) -> None:
    """It shows longer words, none beside them but what somebody has called something, and all of them."""
    expect(at.page.locator("footer .next")).to_contain_text(MARK)
    assert words_of_no_catalogue(at.page) - names == set(), screen
    looks: list[Look] = glimpse(at.page, screen)
    check_nothing_is_cut_off(looks)


@pytest.mark.thorough
def test_pages_have_longer_words_and_room_for_them(at: Tablet, service: RealService, complete: str):
    check(at, "sign in")
    enter(at)
    pages = {
        "": ".setup .cell-facts", "nonsense": ".not-there",
        "settings": ".settings h1", "history": ".run-list tbody tr", "cells": ".zone-places .tile",
        f"history/{complete}/{complete}": ".comparison-table", f"runs/{complete}": ".result .downloads",
        "tools": ".tool-tile", "new-cell": ".new-cell .steps",
        "orders": ".orders .empty", "alarms": ".alarms h1", "control": ".control-page .facts",
        "gap": "h1", "trials": "h1", f"trials/{finished_trial(service)}": ".opened-trials",
        "admin/account": ".own-sessions li", "admin/people": ".admin .tiles li", "admin/keys": ".admin .tiles li",
        "admin/webhooks": ".admin .tiles li", "admin/audit": ".audit-entries tbody tr", "admin/connections": ".admin .tiles li",
        "admin/service": ".admin .libraries",
        **{f"gap/{diagnosed(service, verdict)}": ".diagnosis h1" for verdict in ANSWERS},
    }  # fmt: skip
    for place, shows in pages.items():
        at.page.evaluate("place => { location.hash = place }", f"#/{place}")
        at.wait(shows)
        check(at, place)


@pytest.mark.thorough
def test_a_run_has_longer_words_and_room_for_them_from_its_plan_to_its_end(at: Tablet, service: RealService, browser: Browser):
    enter(at)
    proceed = at.page.locator(".command-bar .press-primary")
    proceed.tap()
    at.wait(".planning, .preview")
    check(at, "planning or plan")
    at.wait(".preview table")
    at.wait(".command-bar .press-primary")
    check(at, "plan")
    proceed.tap()
    at.wait(".press-start")
    check(at, "about to start")
    at.tap(at.page.locator(".press-start"))
    at.wait(".running .estimate-so-far dl")
    check(at, "running")
    with tablet(browser, service) as nobody:
        nobody.open(ADDRESS)
        nobody.wait(".active-robots")
        check(nobody, "sign in beside a robot that moves")
    at.page.context.set_offline(True)
    at.wait(".lost-layer")
    check(at, "connection lost")
    at.page.context.set_offline(False)
    at.page.locator(".lost-layer").wait_for(state="detached")
    at.page.reload()
    at.wait(".held-notice")
    at.wait(".press-start")
    check(at, "held by a lost link")
    at.tap(at.page.locator(".press-stop"))
    at.wait(".ended")
    check(at, "stopped")


def test_control_that_is_asked_for_has_longer_words_and_room_for_them(at: Tablet, service: RealService, browser: Browser, person: Console):
    add_operator(person)
    enter(at)
    at.tap(at.page.locator(".header .who"))
    at.tap(at.page.locator(".command-bar .press-primary"))
    at.wait(".who-mine")
    check(at, "control")
    with signed_in(service, browser, BEN, PASSWORD) as asking:
        asking.press("Ask for control")
        at.wait(".control-request")
        check(at, "control that is asked for")
        at.tap(at.page.locator(".control-request .press-plain"))
        at.page.locator(".control-request").wait_for(state="detached")
        asking.press("Ask for control")
        at.tap(at.page.locator(".control-request .press-primary"))
        at.wait(".remark")
        check(at, "control that was handed over")


BOX = {"size_m": [0.12, 0.09, 0.18], "pose": {"xyz_m": [0.0, 0.0, 0.09]}}
TOOL = {"name": "shaft1", "title": "Shaft1", "note": "Jaws1", "box": BOX, "mass_least_kg": 2.0, "mass_most_kg": 3.0}


def test_the_tool_library_has_longer_words_and_room_for_them(at: Tablet, person: Console):
    saved = person.http.post("/api/cells/lwr4_bench/payloads", json=TOOL)
    assert saved.status_code == 201, saved.text
    enter(at)
    page = at.page
    page.evaluate("location.hash = '#/tools'")
    tile = page.locator(".tool-tile", has_text="Shaft1")
    edit, delete = tile.locator(".row button.press").nth(1), tile.locator(".row button.press").nth(2)
    at.tap(delete)
    check(at, "a tool that may be deleted")
    page.reload()
    at.tap(edit)
    page.locator(".tool-form").wait_for()
    check(at, "a tool that is changed")
    page.locator(".tool-form input").first.fill("")
    check(at, "a tool without a name")
    page.reload()
    at.tap(page.locator(".tools > div > .press").first)
    page.locator(".tool-form").wait_for()
    check(at, "a new tool")
    person.http.delete(saved.headers["location"])


def test_zones_have_longer_words_and_room_for_them(at: Tablet):
    enter(at)
    page = at.page
    page.evaluate("location.hash = '#/cells'")
    at.wait(".zone-places .tile")
    at.tap(page.locator(".zone-add .press").first)
    check(at, "a zone that is to be drawn")
    at.tap(page.locator(".zone-editor .tile[role=status] .press").first)
    page.locator(".zone-changing").wait_for()
    check(at, "a new zone", ZONE_NAMES)
    page.locator(".zone-changing input").first.fill("operator")
    check(at, "a zone whose name is taken", ZONE_NAMES)


ZONE_NAMES = frozenset({"zone"})
LINKS = frozenset({"arm", "urdf", "base", "flange", "hand", "small"})
LACKING = arm(
    link("hand") + joint("grip", "flange", "hand", kind="fixed", rest=""),
    joints={3: joint("joint3", "link2", "link3", axis="0 0 1", rest="<limit/>")},
).replace(link("link4"), link("link4", inertial=""))


@pytest.mark.thorough
def test_a_new_cell_has_longer_words_and_room_for_them_at_every_step(at: Tablet, tmp_path: Path):
    enter(at)
    page, file = at.page, tmp_path / "arm.urdf"
    file.write_text(LACKING)
    page.evaluate("location.hash = '#/new-cell'")
    at.wait(".new-cell .steps")
    page.locator("input[type=file]").set_input_files(file)
    proceed, heading = page.locator(".command-bar .press-primary"), page.locator(".new-cell h2").first
    page.locator(".new-cell input[type=radio]").first.wait_for()
    check(at, "new cell: description", LINKS)
    for step in ("arm", "joints", "home", "sensor", "room", "check"):
        before = heading.inner_text()
        at.tap(proceed)
        expect(heading).not_to_have_text(before, timeout=PATIENCE_MS)
        if step == "arm":
            page.locator(".new-cell input[type=radio]").nth(2).check(force=True)
        if step == "room":
            page.locator(".new-cell select").first.select_option("link5")
            page.locator(".new-cell select").last.select_option("link2")
            at.tap(page.locator(".new-cell .two .press"))
            page.locator(".new-cell .option small").wait_for(timeout=PATIENCE_MS)
        check(at, f"new cell: {step}", LINKS)
