"""An address that names nothing is told as that, with a way on."""

from __future__ import annotations

import pytest
from playwright.sync_api import Browser, expect

from tests.server.real_service import RealService
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import show, signed_in

NOT_FOUND = "404 (Not Found)"
"""What the browser says of the one question that shows it."""
PLACES = {
    "nonsense": "Page not found", "runs/nonsense": "Run not found", "runs": "Page not found",
    "gap/nonsense": "Page not found", "trials/nonsense": "Page not found", "cells/nonsense": "Page not found",
    "constructor": "Page not found", "%": "Page not found",
}  # fmt: skip
SHORT = ("nonsense", "runs/nonsense", "constructor", "%")
"""Of which the rest are the same in other folders."""


@pytest.mark.parametrize("place", [each if each in SHORT else pytest.param(each, marks=pytest.mark.thorough) for each in PLACES])
def test_what_is_not_there_is_told_with_a_way_on(service: RealService, browser: Browser, place: str) -> None:
    with signed_in(service, browser) as at:
        show(at, place)
        expect(at.page.get_by_role("heading", level=1)).to_have_text(PLACES[place])
        expect(at.page.locator("main")).to_contain_text("There is nothing at #/")
        check_looks(look(at.page, place))
        at.press("Start page")
        at.wait(".setup .cell-facts")
        assert len([said for said in at.complaints if NOT_FOUND in said]) <= 1
        assert [said for said in at.complaints if NOT_FOUND not in said] == []
