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


def type_centre(at: Tablet, **metres: str) -> None:
    """Numbers for the centre of the cell's zone."""
    at.press("Change")
    for axis, number in metres.items():
        at.page.get_by_role("group", name="Centre").get_by_role("textbox", name=axis, exact=True).fill(number)


def test_a_zone_is_moved_by_typed_numbers_and_every_screen_says_by_whom(at: Tablet, service: RealService):
    check_looks(look(at.page, "cells"))
    type_centre(at, x="1,42", y="-0.25")
    changing = at.page.locator(".zone-changing")
    expect(changing).to_contain_text("The robot’s base and its arm at home stay clear of it.")
    assert outlines(at) == [(0.92, 1.92), (-1.75, 1.25)]
    check_looks(look(at.page, "a place that nothing speaks against"))
    at.press("Move the zone")
    tile = at.page.locator(".zone-places .tile")
    expect(tile).to_contain_text("centre at 1.420 | −0.250 | 0.625 m")
    expect(tile).to_contain_text("changed by operator")
    console = Console(service)
    place = console.http.get("/api/cells/lwr4_bench").json()
    assert place["cell"]["zones"][0]["shape"]["pose"]["xyz_m"] == [1.42, -0.25, 0.625]
    moved = {"pose": {"xyz_m": [1.35, 0.0, 0.625]}, "measured_at": place["read_at"]}
    assert console.http.put("/api/cells/lwr4_bench/zones/operator", json=moved).status_code == 200
    expect(tile).to_contain_text("centre at 1.350 | 0.000 | 0.625 m")
    console.leave()


def outlines(at: Tablet) -> list[tuple[float, float]]:
    """From where to where a zone would be, along x and y of the drawing from above, m."""
    points = at.page.get_by_role("group", name="From above").locator(".zone-new").get_attribute("points") or ""
    corners = [[float(number) for number in point.split(",")] for point in points.split()]
    xs, ys = [x for x, _ in corners], [-y for _, y in corners]
    return [(min(xs), max(xs)), (min(ys), max(ys))]


def test_a_zone_on_the_robot_is_seen_before_it_moves_and_the_cell_says_what_is_wrong_and_leads_back(at: Tablet, service: RealService):
    console = Console(service)
    page = at.page
    type_centre(at, x="0", y="0", z="0.6")
    warned = page.locator(".zone-changing [role=alert]")
    expect(warned).to_contain_text("No run can be planned while the zone is there")
    expect(warned).to_contain_text("the robot's base 0.500 m inside it")
    check_looks(look(page, "a place that makes planning impossible"))
    assert console.http.get("/api/cells/lwr4_bench").json()["flaws"] == []
    at.press("Move the zone")
    flawed = page.locator(".cells > section > [role=alert]")
    expect(flawed).to_contain_text("zones.operator.shape")
    expect(page.locator("iframe.viewer")).to_be_visible()
    expect(page.get_by_role("radio", name="lwr4_bench")).to_be_enabled()
    expect(page.locator(".option", has_text="lwr4_bench")).to_contain_text("no run can be planned there now")
    check_looks(look(page, "a cell in which nothing can be planned"))
    at.tap(page.get_by_role("link", name="Run", exact=True))
    expect(page.locator(".setup [role=alert]")).to_contain_text("No run can be planned in this cell")
    expect(page.get_by_role("button", name="Take control and plan")).to_have_count(0)
    expect(page.get_by_role("link", name="Show the cell")).to_have_attribute("href", "#/cells/lwr4_bench")
    check_looks(look(page, "a cell that takes no run"))
    at.press("Put operator back as it was")
    expect(page.locator(".setup [role=alert]")).to_have_count(0)
    expect(page.get_by_role("button", name="plan")).to_be_enabled()
    assert console.http.get("/api/cells/lwr4_bench").json()["cell"]["zones"][0]["shape"]["pose"]["xyz_m"] == [1.35, 0.0, 0.625]
    console.leave()


def test_an_arm_that_could_not_stand_at_home_is_told_before_the_zone_moves(at: Tablet):
    type_centre(at, x="0.95")
    expect(at.page.locator(".zone-changing [role=alert]")).to_contain_text("robot.home_rad")
    at.press("Discard")
    expect(at.page.locator(".zone-changing")).to_have_count(0)
    expect(at.page.locator(".zone-places .tile")).to_contain_text("centre at 1.350 | 0.000 | 0.625 m")


@pytest.mark.parametrize(
    ("file", "before", "after", "says", "sketches"),
    [
        ("cell.toml", "clearance_m = 0.03", "clearance_m = -1.0", "limits.clearance_m", 0),
        ("cell.toml", "floor_z_m = -0.75", "floor_z_m = 0.4", "floor_z_m", 0),
        ("robot.urdf", "</robot>", "", "XML that does not parse", 2),
    ],
    ids=["a value that is impossible", "values that contradict", "a robot that cannot be read"],
)  # fmt: skip
def test_a_cell_broken_on_disk_is_shown_with_its_flaw_until_it_is_mended(
    file: str, before: str, after: str, says: str, sketches: int, at: Tablet, service: RealService
):
    path = service.data / "cells" / "lwr4_bench" / file
    sound_text = path.read_text()
    flawed = at.page.locator(".cells > section > [role=alert]")
    try:
        path.write_text(sound_text.replace(before, after, 1))
        expect(flawed).to_contain_text(says)
        expect(flawed).to_contain_text("import a zip of the corrected cell")
        expect(at.page.locator(".undrawn svg")).to_have_count(sketches)
        check_looks(look(at.page, says))
    finally:
        path.write_text(sound_text)
    expect(flawed).to_have_count(0)
    expect(at.page.locator("iframe.viewer")).to_be_visible()
    expect(at.page.locator(".zone-places .tile")).to_have_count(1)


def test_a_cell_that_cannot_be_used_is_refused_in_words_and_a_sound_one_taken_in_when_somebody_says_so(at: Tablet, service: RealService):
    choose(at, uploaded("second", noise_std="noise"))
    expect(at.page.get_by_role("alert").locator("li")).to_contain_text(["sensor.noise_std", "sensor.noise"])
    check_looks(look(at.page, "a cell that cannot be used"))
    choose(at, uploaded("second"))
    expect(at.page.locator(".cell-upload")).to_contain_text("Cell second can be used.")
    expect(at.page.get_by_role("radio", name="second")).to_have_count(0)
    at.press("Import cell")
    expect(at.page.get_by_role("radio", name="second")).to_have_count(1)
    choose(at, uploaded("second"))
    at.press("Replace cell second")
    expect(at.page.locator(".cell-upload")).to_contain_text("Cell second was imported.")
