"""What few people change of a run, folded away on the first page, and the plan that comes of it."""

from __future__ import annotations

import pytest
from playwright.sync_api import Browser, expect

from server.service import utc_now
from server.store.store import Store
from tests.server.finished_run import finished_run
from tests.server.real_service import Console, RealService
from tests.web.finished_runs import drawn_result
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import signed_in

PLANNED_MS = 180_000


@pytest.mark.thorough
def test_motions_for_joint_torques_without_the_payload_are_planned_and_the_plan_says_to_take_it_off(
    service: RealService, browser: Browser, person: Console
) -> None:
    with signed_in(service, browser) as at:
        page = at.page
        at.tap(page.locator(".more-settings summary"))
        settings = page.locator(".more-settings")
        expect(settings.get_by_role("checkbox", name="Rotate about each axis")).to_be_visible()
        settings.get_by_label("Identify from").select_option("Joint torques")
        expect(settings.get_by_role("checkbox", name="Rotate about each axis")).to_have_count(0)
        settings.get_by_role("checkbox", name="Without the payload").check(force=True)
        for axis in "yz":
            settings.get_by_role("checkbox", name=axis, exact=True).uncheck(force=True)
        check_looks(look(page, "settings for joint torques"))
        at.press("Take control and plan")
        expect(page.locator(".preview .poses")).to_be_visible(timeout=PLANNED_MS)
        expect(page.get_by_role("alert").filter(has_text="Take the payload off first")).to_be_visible()
        check_looks(look(page, "plan without the payload"))
        (ordered,) = [each["run"] for each in person.http.get("/api/orders").json()]
        order = ordered["order"]
        assert (order["identify_from"], order["empty"], order["axes"], order["rotations"], order["target"]) == (
            "joint_torques",
            True,
            "x",
            True,
            None,
        )
        at.press("STOP")
        at.wait(".ended")
        assert at.complaints == []


def test_a_run_for_joint_torques_is_compared_with_one_without_the_payload(service: RealService, browser: Browser, person: Console) -> None:
    store = Store(service.store_url)
    empty = finished_run(store, utc_now(), drawn_result(1), cell="lwr4_bench", payload="steel_block", empty=True)
    store.close()
    with signed_in(service, browser) as at:
        page = at.page
        at.tap(page.locator(".more-settings summary"))
        settings = page.locator(".more-settings")
        compared = settings.get_by_label("Compared with the run without it")
        expect(compared).to_have_count(0)
        settings.get_by_label("Identify from").select_option("Joint torques")
        compared.select_option(empty)
        settings.get_by_role("checkbox", name="Without the payload").check(force=True)
        expect(compared).to_have_count(0)
        settings.get_by_role("checkbox", name="Without the payload").uncheck(force=True)
        expect(compared).to_have_value(empty)
        check_looks(look(page, "a run that is compared"))
        with page.expect_request(lambda sent: sent.method == "POST" and sent.url.endswith("/api/runs")) as asked:
            at.press("Take control and plan")
        order = asked.value.post_data_json
        assert (order["identify_from"], order["empty"], order["without"]) == ("joint_torques", False, empty)
