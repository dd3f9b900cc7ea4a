"""The page of a result: its certificate to be taken along, and whether it is good enough, with what decides and by how much."""

from __future__ import annotations

import io
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pypdf
import pytest
from playwright.sync_api import Browser, expect

from core.certificate.certificate import Certificate
from core.estimation.result import Result
from tests.server.real_service import RealService
from tests.web.finished_runs import drawn_result, finished_runs
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import show, signed_in
from tests.web.tablet import Tablet


@pytest.fixture(scope="module")
def good() -> Result:
    """One that is exact enough for its cell."""
    return drawn_result(1, judged=True)


@pytest.fixture(scope="module")
def poor() -> Result:
    """One that is not."""
    return drawn_result(2, worse=800.0, judged=True)


@pytest.fixture(scope="module")
def runs(service: RealService, good: Result, poor: Result) -> list[str]:
    """A run with each."""
    return finished_runs(service, [good, poor])


@pytest.fixture
def at(service: RealService, browser: Browser) -> Iterator[Tablet]:
    """A tablet of the first account."""
    with signed_in(service, browser) as found:
        yield found
        assert found.complaints == []


def test_the_certificate_is_saved_as_a_page_and_as_data_that_belong_together(at: Tablet, runs: list[str]) -> None:
    page = show(at, "runs", runs[0])
    expect(page.get_by_text("Until somebody accepts the result")).to_be_visible()
    name = rf"run-{runs[0]}-gripper-\d{{4}}-\d\d-\d\d-certificate"
    data, text = saved(at, "Certificate (JSON)", rf"{name}\.json"), saved(at, "Certificate (PDF)", rf"{name}\.pdf")
    certificate = Certificate.model_validate_json(data)
    assert certificate.run == runs[0]
    printed = pypdf.PdfReader(io.BytesIO(text)).pages[0].extract_text()
    assert runs[0] in printed


def test_a_result_that_is_good_enough_names_what_decides_and_the_margin(at: Tablet, runs: list[str], good: Result) -> None:
    adequacy = adequacy_of(good)
    assert adequacy["good_enough"]
    page = show(at, "runs", runs[0])
    verdict = page.locator(".good-enough")
    expect(verdict).to_contain_text("✓ Good enough for this cell")
    expect(verdict).to_contain_text(f"{DECIDING[adequacy['decides']]} decides")
    shown = re.search(r"([\d.,\u202f ]+) times more exact", verdict.inner_text())
    assert shown is not None
    assert float(re.sub(r"[^\d.]", "", shown[1])) == pytest.approx(adequacy["margin"], rel=0.06)
    at.tap(page.locator("summary", has_text="Why, and against what"))
    details = page.locator("details", has=page.locator("summary", has_text="Why, and against what"))
    assert good.requirement is not None
    expect(details.get_by_role("listitem")).to_have_count(len(good.requirement.details))
    check_looks(look(page, "result with its verdict open"))


def test_a_result_that_is_not_good_enough_says_so_with_the_parameter(at: Tablet, runs: list[str], poor: Result) -> None:
    adequacy = adequacy_of(poor)
    assert not adequacy["good_enough"]
    page = show(at, "runs", runs[1])
    verdict = page.locator(".not-good-enough")
    expect(verdict).to_contain_text("▲ Not good enough for this cell")
    assert poor.requirement is not None
    expect(verdict).to_contain_text(poor.requirement.message.text)
    check_looks(look(page, "result that is not good enough"))


def saved(at: Tablet, link: str, name: str) -> bytes:
    """What a tap on a link saves."""
    with at.page.expect_download() as found:
        at.tap(at.page.get_by_role("link", name=link))
    assert re.fullmatch(name, found.value.suggested_filename), found.value.suggested_filename
    return Path(found.value.path()).read_bytes()


DECIDING = {"mass": "mass", "centre_of_mass": "centre of mass", "inertia": "inertia"}


def adequacy_of(result: Result) -> dict[str, Any]:
    """As the answer has it."""
    assert result.requirement is not None and result.requirement.adequacy is not None
    return dict(json.loads(result.requirement.adequacy.model_dump_json()))
