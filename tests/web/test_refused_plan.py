"""A plan that is refused: why stands on the screen in words, and what is in the way by its name beside the cell.

That it stands out in the cell itself is drawn on the graphics card: `tests/server/viewer/test_routes.py` asks the scene.
"""

from __future__ import annotations

import pytest
from playwright.sync_api import Browser, expect

from tests.server.real_service import Console, RealService
from tests.server.zone_at import AT_THE_ROBOT, zone_at
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import signed_in


@pytest.mark.thorough
def test_what_is_in_the_way_is_named_beside_the_cell_until_the_next_plan(service: RealService, browser: Browser) -> None:
    person = Console(service)
    with signed_in(service, browser) as at:
        page = at.page
        with zone_at(person, AT_THE_ROBOT) as zone:
            at.press("Take control and plan")
            at.wait(".ended .in-the-way")
            expect(page.get_by_role("heading", level=1)).to_have_text("No safe plan found")
            expect(page.locator(".in-the-way")).to_contain_text(zone)
            expect(page.locator("footer .next")).to_contain_text("Nothing has moved.")
            expect(page.locator("iframe.viewer")).to_be_visible()
            check_looks(look(page, "refused"))
        at.press("New run")
        at.press("Plan")
        at.wait(".preview table")
        expect(page.locator("iframe.viewer")).to_be_visible()
        expect(page.locator(".in-the-way")).to_have_count(0)
        at.press("STOP")
        at.wait(".ended")
        expect(page.get_by_role("heading", level=1)).to_have_text("The run was stopped")
        assert at.complaints == []
    person.leave()


def test_a_box_that_reaches_into_the_bench_is_refused_in_words_of_the_box_and_the_button_leads_to_it(
    service: RealService, browser: Browser, person: Console
) -> None:
    with signed_in(service, browser) as at:
        page = at.page
        page.get_by_role("textbox", name="z").fill("0.9")
        at.press("Take control and plan")
        at.wait(".ended .in-the-way")
        expect(page.locator(".ended .told").first).to_have_text("The tool’s box reaches 0.496 m into bench at home.")
        expect(page.locator(".in-the-way")).to_contain_text("bench")
        expect(page.locator(".remedies button")).to_have_text(["Payload box", "Tool", "Home position"])
        expect(page.locator(".remark")).to_have_count(0, timeout=15_000)  # that control was taken is said for some seconds
        check_looks(look(page, "refused box"))
        page.get_by_role("textbox", name="z").wait_for(state="detached")
        at.press("Payload box")
        box = page.locator("#field-box input")
        expect(box.first).to_be_focused()
        expect(box.nth(2)).to_have_value("0.900")
        box.nth(2).fill("")
        expect(page.locator("#field-box .flaw")).to_contain_text("Enter three lengths above 0")
        expect(page.locator("footer .next")).to_contain_text("Correct the payload box first.")
        check_looks(look(page, "no box"))
        box.nth(2).fill("0.08")
        expect(page.locator(".flaw")).to_have_count(0)
        assert at.complaints == []
