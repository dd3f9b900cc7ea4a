"""A plan that is refused: why stands on the screen in words, and what is in the way by its name beside the cell.

That it stands out in the cell itself is drawn on the graphics card: `tests/server/viewer/test_routes.py` asks the scene.
"""

from __future__ import annotations

from playwright.sync_api import Browser, expect

from tests.server.real_service import Console, RealService
from tests.server.zone_at import AT_THE_ROBOT, zone_at
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import signed_in


def test_what_is_in_the_way_is_named_beside_the_cell_until_the_next_plan(service: RealService, browser: Browser) -> None:
    person = Console(service)
    with signed_in(service, browser) as at:
        page = at.page
        at.without_viewer()
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
