"""What works in the background is cancelled on the tablet by who may begin it, and leaves nothing behind. Trials: test_blind_trials.py."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.server.real_service import RealService
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import show, signed_in
from tests.web.tablet import Tablet
from tests.web.tilted import tilted_recording


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tilted_recording(tmp_path_factory.mktemp("tilted"))


@pytest.fixture
def engineer(service: RealService, browser: Browser) -> Iterator[Tablet]:
    """A tablet of the first account."""
    with signed_in(service, browser) as at:
        yield at


def test_a_diagnosis_is_cancelled_and_another_one_can_be_begun(engineer: Tablet, recording: Path) -> None:
    page = show(engineer, "gap")
    page.get_by_label("Recording (zip)").set_input_files(recording)
    engineer.tap(page.locator(".recording-upload button"))
    expect(page.get_by_role("progressbar")).to_be_visible()
    engineer.wait(".where-so-far")  # a busy computer takes its time
    expect(page.locator(".where-so-far")).to_contain_text(
        re.compile(r"The gap is largest in .+ of the whole gap\. The cause is being sought\.")
    )
    engineer.press("Cancel")
    expect(page.locator(".job-progress")).to_contain_text("cancelled by operator")
    expect(page.get_by_role("button", name="Cancel")).to_have_count(0)
    check_looks(look(page, "diagnosis cancelled"))
    engineer.press("All diagnoses")
    expect(page.locator(".rows li", has_text="Cancelled").first).to_be_visible()
    assert engineer.complaints == []
