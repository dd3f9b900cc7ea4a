"""The screen in control loses its link: what it says meanwhile, and how its run goes on; before the release, how good the link is."""

from __future__ import annotations

import json
import re
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import datetime, timedelta

import pytest
from playwright.sync_api import Browser, WebSocketRoute, expect

from tests.server.real_service import Console, RealService
from tests.web.judgement import check_looks
from tests.web.looks import glimpse, look
from tests.web.patient_cells import LEASE_S
from tests.web.screens import show, signed_in
from tests.web.tablet import Tablet, tablet

UNREACHABLE = "ERR_INTERNET_DISCONNECTED"
"""What the browser says of every question that it could not put."""
TICK_MS = 250
"""How often the page asks itself whether it is still heard; it opens a lost socket again sooner."""
NOTES_LAYERS = """addEventListener('DOMContentLoaded', () => {
    window.layers = 0;
    const look = () => { window.layers += document.querySelectorAll('.lost-layer').length };
    new MutationObserver(look).observe(document.body, {childList: true, subtree: true});
})"""


@contextmanager
def plan_shown(service: RealService, browser: Browser, link: dict[str, object] | None = None) -> Iterator[Tablet]:
    """A tablet in control, with a plan on it whose holds are long.

    Args:
        link: figures of the link that it is told in place of the real ones.
    """

    def relay(route: WebSocketRoute) -> None:
        def change(message: str | bytes) -> None:
            told = json.loads(message)
            route.send(json.dumps(told | {"control": told["control"] | {"link": link}}))

        route.connect_to_server().on_message(change)

    with tablet(browser, service) as at:
        if link is not None:
            at.page.route_web_socket("**/api/cells/lwr4_bench/live", relay)
        at.hurry(hold_s=20.0)
        at.without_viewer()
        at.open()
        at.sign_in()
        at.press("Take control and plan")
        at.wait(".preview table")
        yield at


@pytest.fixture
def planned(service: RealService, browser: Browser, person: Console) -> Iterator[Tablet]:
    """A plan on a tablet; `person` leaves no run behind."""
    with plan_shown(service, browser) as at:
        yield at


@pytest.fixture
def moving(planned: Tablet) -> Tablet:
    """The same once its robot moves."""
    planned.press("Release")
    planned.press("START")
    planned.wait(".running [role=status], [data-state=Execute]")
    planned.page.get_by_role("button", name="Hold").wait_for()
    return planned


def run_of(at: Tablet) -> str:
    return at.page.url.rsplit("/", 1)[1]


def test_a_lost_link_fills_the_screen_and_its_run_is_resumed_by_one_tap(moving: Tablet, person: Console) -> None:
    run, page = run_of(moving), moving.page
    fence = person.http.get("/api/control/lwr4_bench").json()["fence"]
    page.context.set_offline(True)
    layer = page.get_by_role("alertdialog")
    layer.wait_for()
    expect(layer).to_contain_text("lwr4_bench")
    expect(layer).to_contain_text("Running")
    expect(layer).to_contain_text(f"stops by itself within {LEASE_S} s of a lost connection and keeps its place")
    expect(layer).to_contain_text("STOP on this screen does not work now")
    expect(layer).to_contain_text(re.compile(r"Since \d\d:\d\d:\d\d, for 0:\d\d"))
    for name in ("STOP", "Hold", "Resume"):
        expect(page.get_by_role("button", name=name)).to_have_count(0)
    check_looks(look(page, "lost link"))
    person.wait(run, "Held")
    page.context.set_offline(False)
    layer.wait_for(state="detached")
    assert page.locator(".header [data-state]").get_attribute("data-state") == "Held"
    expect(page.locator(".held-notice")).to_have_text(re.compile(rf"Connection to this console was late \(\d.*s, limit {LEASE_S} s\)"))
    expect(page.locator(".header")).to_contain_text("You have control")
    check_looks(glimpse(page, "held by a lost link"))
    moving.press("Resume")
    person.wait(run, "Execute")
    expect(page.get_by_role("button", name="Hold")).to_be_visible()
    assert person.http.get("/api/control/lwr4_bench").json()["fence"] == fence
    assert [said for said in moving.complaints if UNREACHABLE not in said] == []


def test_a_page_that_stands_still_holds_the_robot_and_is_named_as_the_cause(moving: Tablet, person: Console) -> None:
    run, page = run_of(moving), moving.page
    page.evaluate("still_ms => { const until = performance.now() + still_ms; while (performance.now() < until); }", 8000)
    assert person.wait(run, "Held")["reason_kind"] == "page-late"
    expect(page.locator(".held-notice")).to_contain_text("The page of this console did not respond for")
    moving.press("Resume")
    person.wait(run, "Execute")
    assert moving.complaints == []


def test_a_frozen_service_is_a_lost_link_too_and_is_named_as_the_cause(moving: Tablet, person: Console) -> None:
    run, page = run_of(moving), moving.page
    moving.service.send(signal.SIGSTOP)
    try:
        page.get_by_role("alertdialog").wait_for()
    finally:
        moving.service.send(signal.SIGCONT)
    page.get_by_role("alertdialog").wait_for(state="detached")
    assert person.wait(run, "Held")["reason_kind"] == "service-late"
    expect(page.locator(".held-notice")).to_contain_text("The service was late (")
    moving.press("Resume")
    person.wait(run, "Execute")


def test_after_a_reload_the_same_tap_takes_control_and_resumes(moving: Tablet, person: Console) -> None:
    run, page = run_of(moving), moving.page
    page.reload()
    person.wait(run, "Held")
    resume = page.get_by_role("button", name="Resume")
    expect(resume).to_contain_text("takes control")
    moving.tap(resume)
    person.wait(run, "Execute")
    expect(page.locator(".header")).to_contain_text("You have control")
    assert moving.complaints == []


def test_signing_out_gives_control_back(moving: Tablet, person: Console) -> None:
    run = run_of(moving)
    moving.tap(moving.page.get_by_role("link", name="Settings"))
    moving.press("Sign out")
    moving.wait("form.sign-in")
    assert person.http.get("/api/control/lwr4_bench").json()["holder"] is None
    person.wait(run, "Held")
    assert moving.complaints == []


def test_a_screen_that_only_looks_on_does_not_say_what_the_robot_does(service: RealService, browser: Browser, moving: Tablet) -> None:
    with signed_in(service, browser) as watching:
        show(watching, "runs", run_of(moving))
        watching.wait("[data-state=Execute], [data-state=Held]")  # a busy computer puts it on hold
        expect(watching.page.locator(".header .who")).to_contain_text("other device")
        watching.page.context.set_offline(True)
        layer = watching.page.get_by_role("alertdialog")
        expect(layer).to_contain_text("has control on another device. This screen does not know what the robot is doing now.")
        expect(layer).not_to_contain_text("stops by itself")
        watching.page.context.set_offline(False)
        layer.wait_for(state="detached")


def test_a_socket_that_breaks_once_covers_nothing(service: RealService, browser: Browser) -> None:
    opened: list[WebSocketRoute] = []
    with tablet(browser, service) as at:
        at.page.add_init_script(NOTES_LAYERS)
        at.page.route_web_socket("**/api/now/live", lambda route: (opened.append(route), route.connect_to_server()))
        clock, now = at.page.clock, datetime.now()
        clock.install(time=now)
        clock.pause_at(now + timedelta(hours=1))  # a busy computer must not make the page wait longer than it says here
        at.open()
        with at.page.expect_websocket(lambda socket: socket.url.endswith("/api/now/live")) as again:
            opened[0].close()
            clock.run_for(TICK_MS)
        for _ in range(4):
            again.value.wait_for_event("framereceived")
            clock.run_for(TICK_MS)
        assert at.page.evaluate("window.layers") == 0


@pytest.mark.thorough
def test_a_minute_of_a_run_is_followed_without_asking_again(moving: Tablet) -> None:
    asked: list[str] = []
    moving.page.on("request", lambda request: asked.append(request.url) if "/api/" in request.url else None)
    moving.page.wait_for_timeout(20_000)
    expect(moving.page.get_by_role("button", name="Hold")).to_be_visible()
    assert len(asked) <= 3, asked


def test_the_link_is_shown_before_the_release(planned: Tablet) -> None:
    told = planned.page.locator(".link-figures")
    expect(told).to_contain_text(re.compile(rf"round trip \d+ ms \(99 % below \d+ ms\), lost .* %, longest gap .* s \(limit {LEASE_S} s\)"))
    expect(told).to_contain_text(f"If the connection is lost for {LEASE_S} s the robot stops and waits.")
    expect(told.locator(".abnormal")).to_have_count(0)


@pytest.mark.thorough
def test_a_poor_link_is_warned_of_before_the_release_and_refuses_nothing(service: RealService, browser: Browser, person: Console) -> None:
    figures = {
        "round_trip_p50_s": 0.045,
        "round_trip_p99_s": 0.62,
        "lost_share": 0.013,
        "longest_gap_s": 2.61,
        "answers": 900,
        "window_s": 60,
    }
    with plan_shown(service, browser, figures | {"advised": False}) as at:
        told = at.page.locator(".link-figures")
        expect(told.locator(".abnormal")).to_contain_text("the run would probably be put on hold")
        expect(told).to_contain_text("round trip 45 ms (99 % below 620 ms), lost 1.3 %, longest gap 2.6 s")
        check_looks(look(at.page, "poor link"))
        expect(at.page.get_by_role("button", name=re.compile("Release|Review the plan again"))).to_be_enabled()


def test_a_stopped_run_is_continued_as_a_new_one(service: RealService, browser: Browser, person: Console) -> None:
    person.take_control()
    run = person.queue(pace="real_time")
    person.wait(run, "Idle")
    assert person.release(run).status_code == 200
    while person.run(run)["finished_steps"] == 0:
        person.wait_moving(run)
    person.command(run, "stop")
    ended = person.wait(run, "Stopped")
    with signed_in(service, browser) as at:
        show(at, "runs", run)
        expect(at.page.locator(".ended")).to_contain_text(f"Finished and recorded: {ended['finished_steps']} of {ended['steps']} steps")
        check_looks(look(at.page, "ended, to be continued"))
        at.press("Continue the run")
        at.wait(".preview table")
        assert run_of(at) != run
        rest = at.page.request.get(f"http://{service.address}/api/runs/{run_of(at)}").json()
        assert rest["continues"] == run
        at.press("STOP")
        at.wait(".ended")
