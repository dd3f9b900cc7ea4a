"""Blind trials on the tablet: the seal first, then what the diagnosis says, then what was planted."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect

from core.trial.draw import draw
from tests.server.finished_trial import SEED, finished_trial
from tests.server.real_service import RealService
from tests.web.judgement import check_looks
from tests.web.looks import glimpse, look
from tests.web.screens import show, signed_in
from tests.web.tablet import Tablet


@pytest.fixture
def engineer(service: RealService, browser: Browser) -> Iterator[Tablet]:
    """A tablet of the first account."""
    with signed_in(service, browser) as at:
        yield at


def test_a_blind_trial_shows_its_seal_before_anything_else_and_can_be_cancelled(engineer: Tablet):
    page = show(engineer, "trials")
    check_looks(look(page, "trials"))
    engineer.press("Start a blind trial")
    engineer.wait(".seals code")
    expect(page.locator(".opened-trials")).to_have_count(0)
    check_looks(glimpse(page, "trial under way"))  # looking for longer, the trial would be over
    [seal] = page.request.get(f"http://{engineer.service.address}/api/trials/{page.url.rsplit('/', 1)[1]}").json()["seals"]
    expect(page.locator(".seals code")).to_have_text(seal["sha256"])
    engineer.press("Cancel")
    expect(page.locator(".job-progress")).to_contain_text("Cancelled")
    check_looks(look(page, "trial cancelled"))
    assert engineer.complaints == []


@pytest.mark.thorough
def test_what_was_planted_is_hidden_until_the_seal_is_opened_and_is_then_checked(engineer: Tablet, service: RealService):
    planted = draw(SEED).sealed
    page = show(engineer, "trials", finished_trial(service))
    says = page.locator(".opened-trials")
    expect(says).to_contain_text("Base not level")
    expect(says).to_contain_text("Still sealed.")
    assert planted.in_words.text not in page.content()
    engineer.press("Open the seal")
    expect(says).to_contain_text(planted.in_words.text)
    expect(says).to_contain_text("The SHA-256 of this text is the seal that was shown first.")
    expect(page.get_by_role("link", name="Score sheet")).to_have_attribute("download", re.compile(r"trials-.*\.md"))
    check_looks(look(page, "trial opened"))
    assert engineer.complaints == []


def test_a_text_that_is_not_what_was_sealed_is_said_to_be_wrong(engineer: Tablet, service: RealService):
    page = show(engineer, "trials", finished_trial(service, sha256="0" * 64))
    engineer.press("Open the seal")
    expect(page.locator(".opened-trials .flaw")).to_contain_text("is NOT the seal")
