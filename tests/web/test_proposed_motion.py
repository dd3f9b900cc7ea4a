"""From a diagnosis that is not settled over the motion that it proposes to the diagnosis of both, by touch, on a real service."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect

from tests.server.finished_diagnosis import SWINGS, diagnosed_run, explanation, stopped_in_its_first_hold
from tests.server.real_service import Console, RealService, real_service
from tests.web.judgement import check_looks
from tests.web.looks import glimpse, look
from tests.web.screens import show, signed_in

PATIENCE_MS = 180_000
TIED = ("time_delay", "sensor_lowpass")


@pytest.fixture(scope="module")
def service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RealService]:
    """One of its own: others count the runs of the shared one."""
    with real_service(tmp_path_factory.mktemp("motion")) as running:
        yield running


@pytest.fixture(scope="module")
def first(service: RealService) -> str:
    """A run that somebody made, who has left."""
    person = Console(service)
    person.take_control()
    run = stopped_in_its_first_hold(person)
    person.leave()
    return run


@pytest.fixture(scope="module")
def unsettled(service: RealService, first: str) -> str:
    """The diagnosis of that run, as its job would leave it, were this found."""
    tie = {"ids": TIED, "distance_sigma": 2.0, "why": "both are late", "splits": SWINGS["motion"]}
    effects = [explanation(effect, probability) for effect, probability in zip(TIED, (0.6, 0.4), strict=True)]
    return diagnosed_run(service, first, verdict="ambiguous", effects=effects, indistinguishable=[tie], next_experiment=SWINGS)


@pytest.mark.thorough
def test_an_operator_is_led_from_what_is_open_to_the_diagnosis_of_both_recordings(
    service: RealService, browser: Browser, first: str, unsettled: str
) -> None:
    with signed_in(service, browser) as at:
        page = show(at, "gap", unsettled)
        expect(page.get_by_role("heading", level=1)).to_contain_text("Measure once more")
        check_looks(look(page, "not settled, with a motion"))
        at.press("Plan this motion")
        at.wait(".preview table")
        expect(page.locator(".proposed-by")).to_contain_text("The motion that a diagnosis proposed.")
        expect(page.locator(".poses tbody th")).to_have_text(re.compile(r"^y\+ ↻"))
        check_looks(look(page, "plan of a motion"))
        at.press("Take control")
        again = page.get_by_role("button", name="Review the plan again")
        expect(page.get_by_role("button", name="Release").or_(again)).to_be_visible()
        if again.is_visible():
            again.tap()
        at.press("Release")
        at.press("START")
        at.wait(".running")
        motion = page.url.rsplit("/", 1)[1]
        both = page.get_by_role("button", name="Diagnose both together")
        expect(both).to_be_visible(timeout=PATIENCE_MS)
        expect(page.locator("footer .next")).to_contain_text("Diagnose both together to see what is settled")
        check_looks(glimpse(page, "result of a motion"))
        at.tap(both)
        expect(page).to_have_url(re.compile(r"#/gap/.+"))
        expect(page.locator(".job-progress h2, .gap-verdict h1").first).to_be_visible()
        following = page.url.rsplit("/", 1)[1]
        answer = page.request.get(f"http://{service.address}/api/diagnoses/{following}").json()
        assert (answer["run"], answer["cell"]) == (motion, "lwr4_bench")
        asked = page.request.get(f"http://{service.address}/api/runs/{motion}").json()
        assert (asked["continues"], asked["diagnosis"]) == (first, unsettled)
        expect(page.locator(".gap-verdict h1")).to_be_visible(timeout=PATIENCE_MS)
        done = page.request.get(f"http://{service.address}/api/diagnoses/{following}").json()["result"]
        assert "rotate:x" in done["gap"]["held_out"], "the answer is of both"
        show(at, "gap", unsettled)
        expect(page.locator(".next-motion", has_text=motion)).to_contain_text("Complete")
        assert at.complaints == []
