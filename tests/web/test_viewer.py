"""The picture of the cell in the page of a tablet, drawn without a graphics card beside the service and the run."""

from __future__ import annotations

from io import BytesIO
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image
from playwright.sync_api import Browser, Page, expect

from tests.server.real_service import Console, RealService
from tests.web.finger import middle_of, pinch
from tests.web.screens import show, signed_in

DRAWN_MS = 120_000
CHANGED, PIXELS = 30, 300
"""By how much of 255 a pixel differs that shows something else, and how many of them are seen."""
DRAWN_AGAIN_MS = 6000
DRAWING_MS = 3000


def test_the_box_that_is_typed_is_drawn_while_it_is_typed_and_nothing_of_visers_own_is_seen(service: RealService, browser: Browser) -> None:
    with signed_in(service, browser, drawn=True) as at:
        page = at.page
        before = picture(page)
        page.get_by_role("textbox", name="z").fill("0.5")
        assert wait_for_change(page, before), "a longer box is seen"
        frame = page.frame_locator("iframe.viewer")
        expect(frame.locator(".mantine-Notification-root")).to_be_hidden()
        expect(frame.locator(".mantine-Paper-root").first).to_be_hidden()
        floating = frame.locator("[data-dock-root] > :not(:first-child)")
        assert not any(each.is_visible() for each in floating.all())


@pytest.mark.thorough
def test_a_view_is_turned_by_its_button_and_stays_so_from_the_plan_into_the_run(
    service: RealService, browser: Browser, person: Console
) -> None:
    person.take_control()
    run = person.queue(pace="real_time", hold_s=10.0)
    person.wait(run, "Idle")
    with signed_in(service, browser, drawn=True) as at:
        page = show(at, "runs", run)
        at.wait(".preview .path-player")
        first = picture(page)
        at.tap(page.get_by_role("button", name="Top", exact=True))
        assert wait_for_change(page, first)
        above = picture(page)
        page.locator("[name=moment]").fill("3")
        expect(page.locator(".path-player label")).to_contain_text("transfer")
        assert wait_for_change(page, above), "the planned robot stands somewhere on its way"
        kept = page.locator("iframe.viewer").evaluate("frame => { frame.kept = true; return frame.src }")
        assert person.release(run).status_code == 200
        at.wait(".running")
        assert page.locator("iframe.viewer").evaluate("frame => frame.kept && frame.src") == kept, "one picture goes through the run"
        at.tap(page.get_by_role("button", name="Reset", exact=True))
        assert wait_for_change(page, above)


def test_a_picture_that_takes_seconds_keeps_the_page_from_nothing(service: RealService, browser: Browser) -> None:
    with signed_in(service, browser, drawn=True) as at:
        at.until_drawn()
        viewer = at.page.locator("iframe.viewer").element_handle().content_frame()
        assert viewer is not None
        viewer.evaluate("ms => setTimeout(() => { const until = performance.now() + ms; while (performance.now() < until); })", DRAWING_MS)
        at.page.evaluate("() => { window.beats = 0; setInterval(() => { window.beats += 1 }, 50) }")
        drawn_ms = viewer.evaluate("() => performance.now()")  # answered when the picture is done
        assert drawn_ms > DRAWING_MS
        assert at.page.evaluate("() => window.beats") > DRAWING_MS / 50 / 4, "beats while the viewer draws"


@pytest.mark.thorough
def test_a_pinch_zooms_the_picture_and_never_the_page(service: RealService, browser: Browser) -> None:
    with signed_in(service, browser, drawn=True) as at:
        page = at.page
        before, stood = picture(page), place_of(page)
        middle = middle_of(page.locator("iframe.viewer"))
        pinch(page, middle, 40, 140)
        assert wait_for_change(page, before), "the robot is nearer"
        assert place_of(page) == stood
        nearer = picture(page)
        pinch(page, middle, 140, 40)
        assert wait_for_change(page, nearer), "the robot is farther away"
        assert place_of(page) == stood


def place_of(page: Page) -> list[float]:
    """How far the page is zoomed, and where it is scrolled to."""
    found: list[float] = page.evaluate(
        "() => { const {scale, offsetLeft, offsetTop} = visualViewport, main = document.querySelector('main');"
        " return [scale, offsetLeft, offsetTop, scrollX, scrollY, main.scrollLeft, main.scrollTop] }"
    )
    return found


def picture(page: Page) -> NDArray[np.float64]:
    """(height, width, 3), of the cell once it is drawn and nothing changes in it."""
    page.frame_locator("iframe.viewer").locator("canvas[data-engine]").wait_for(timeout=DRAWN_MS)
    last = look(page)
    for _ in range(20):
        page.wait_for_timeout(DRAWN_AGAIN_MS / 4)
        now = look(page)
        if now.std() > 1.0 and count_changed(now, last) < PIXELS:
            return now
        last = now
    raise AssertionError("the picture comes to no rest")


def wait_for_change(page: Page, before: NDArray[np.float64]) -> bool:
    """Whether the picture becomes another one."""
    for _ in range(10):
        page.wait_for_timeout(DRAWN_AGAIN_MS / 4)
        if count_changed(look(page), before) > PIXELS:
            return True
    return False


def look(page: Page) -> NDArray[np.float64]:
    """(height, width, 3), what the frame shows."""
    shown = page.locator("iframe.viewer").screenshot()
    return np.asarray(Image.open(BytesIO(shown)).convert("RGB"), dtype=float)


def count_changed(one: NDArray[np.float64], other: NDArray[Any]) -> int:
    """Pixels that show something else; all of them where the pictures have not the same size."""
    if one.shape != other.shape:
        return int(one.shape[0] * one.shape[1])
    return int((np.abs(one - other).max(axis=2) > CHANGED).sum())
