"""Cells on the tablet: their zones where they are, and new ones checked before they are taken in."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, FilePayload, expect

from tests.server.hostile_uploads import sound, zipped
from tests.server.real_service import Console, RealService
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import on_page
from tests.web.tablet import Tablet

REFUSED = "422 (Unprocessable"
"""What the browser says of a cell that cannot be used."""


@pytest.fixture
def at(service: RealService, browser: Browser) -> Iterator[Tablet]:
    """A tablet on the cells."""
    with on_page(service, browser, "Cells", ".zone-places .tile") as found:
        yield found
        assert [said for said in found.complaints if REFUSED not in said] == []


def uploaded(name: str, **changed: str) -> FilePayload:
    """A zip of the bench under another name, with words of its cell.toml changed."""
    files = sound()
    toml = files["cell.toml"].decode().replace('name = "lwr4_bench"', f'name = "{name}"', 1)
    for before, after in changed.items():
        toml = toml.replace(before, after)
    return {"name": f"{name}.zip", "mimeType": "application/zip", "buffer": zipped(files | {"cell.toml": toml.encode()})}


def choose(at: Tablet, file: FilePayload) -> None:
    with at.page.expect_file_chooser() as chooser:
        at.press("Choose a zip")
    chooser.value.set_files(file)


def test_a_zone_is_moved_by_typed_numbers_and_every_screen_says_by_whom(at: Tablet, service: RealService):
    check_looks(look(at.page, "cells"))
    at.page.get_by_role("textbox", name="x").fill("1,42")
    at.page.get_by_role("textbox", name="y").fill("-0.25")
    at.press("Move the zone")
    expect(at.page.locator(".zone-places .tile")).to_contain_text("centre at 1.420 | −0.250 | 0.625 m")
    expect(at.page.locator(".zone-places .tile")).to_contain_text("moved by operator")
    console = Console(service)
    place = console.http.get("/api/cells/lwr4_bench").json()
    assert place["cell"]["zones"][0]["shape"]["pose"]["xyz_m"] == [1.42, -0.25, 0.625]
    moved = {"pose": {"xyz_m": [1.35, 0.0, 0.625]}, "measured_at": place["read_at"]}
    assert console.http.put("/api/cells/lwr4_bench/zones/operator", json=moved).status_code == 200
    expect(at.page.locator(".zone-places .tile")).to_contain_text("centre at 1.350 | 0.000 | 0.625 m")
    console.leave()


def test_a_cell_that_cannot_be_used_is_refused_in_words_and_a_sound_one_taken_in_when_somebody_says_so(at: Tablet, service: RealService):
    choose(at, uploaded("second", noise_std="noise"))
    expect(at.page.get_by_role("alert").locator("li")).to_contain_text(["sensor.noise_std", "sensor.noise"])
    check_looks(look(at.page, "a cell that cannot be used"))
    choose(at, uploaded("second"))
    expect(at.page.locator(".cell-upload")).to_contain_text("Cell second can be used.")
    expect(at.page.get_by_role("radio", name="second")).to_have_count(0)
    at.press("Add the cell")
    expect(at.page.get_by_role("radio", name="second")).to_have_count(1)
    choose(at, uploaded("second"))
    at.press("Replace cell second")
    expect(at.page.locator(".cell-upload")).to_contain_text("Cell second was taken in.")
