"""A cell made of a robot's description on the console, a question after the other, from the file to the imported cell."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from core.cell.folder import load_cell
from tests.core.new_cell.small_arm import arm, joint, link
from tests.server.real_service import RealService, wait_for
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.screens import on_page
from tests.web.tablet import PATIENCE_MS, Tablet

HAND = link("hand") + joint("grip", "flange", "hand", kind="fixed", rest="")
TEXT = arm(HAND, joints={3: joint("joint3", "link2", "link3", axis="0 0 1", rest="<limit/>")})
TEXT = TEXT.replace(link("link4"), link("link4", inertial=""))
REFUSED = "422 (Unprocessable"
"""What the browser says of a cell that cannot be made."""


@pytest.fixture
def at(service: RealService, browser: Browser) -> Iterator[Tablet]:
    with on_page(service, browser, "Cells", ".zone-places .tile") as found:
        yield found
        assert [said for said in found.complaints if REFUSED not in said] == []


def go_on(page: Page, step: str) -> None:
    page.get_by_role("button", name="Next", exact=True).tap()
    expect(page.locator(".new-cell h2").first).to_have_text(step, timeout=PATIENCE_MS)


def begin(at: Tablet, file: Path, text: str) -> Page:
    """Somebody makes a cell of a file with this text."""
    file.write_text(text)
    at.tap(at.page.get_by_role("link", name="Make a cell"))
    at.wait(".new-cell .steps")
    at.page.locator("input[type=file]").set_input_files(file)
    return at.page


def test_from_a_description_that_lacks_much_to_the_imported_cell(at: Tablet, service: RealService, tmp_path: Path) -> None:
    page = begin(at, tmp_path / "arm.urdf", TEXT)
    expect(page.get_by_role("radio", name="arm.urdf")).to_be_checked()
    check_looks(look(page, "the description of a new cell"))
    go_on(page, "Arm")
    name = page.get_by_label("Name of the cell")
    name.fill("lwr4_bench")
    expect(page.locator(".new-cell")).to_contain_text("There is a cell of that name already")
    name.fill("made_here")
    expect(page.get_by_role("button", name="Next", exact=True)).to_be_disabled()
    page.get_by_role("radio", name="The sensor carries them").check(force=True)
    check_looks(look(page, "the arm of a new cell"))
    go_on(page, "Joints")
    third = page.locator(".joint", has_text="joint3")
    expect(third).to_contain_text("has no limits of position")
    third.get_by_label("Speed, rad/s").fill("1,5")
    expect(page.locator(".new-cell")).to_contain_text("Link 'link4' has no mass")
    page.get_by_label("link4, kg").fill("3.5")
    check_looks(look(page, "the joints of a new cell"))
    go_on(page, "Home")
    expect(page.get_by_role("img", name="The robot at home")).to_be_visible()
    expect(page.locator(".new-cell")).not_to_contain_text("velocity")
    bent = page.get_by_label("joint2", exact=True)
    before = bent.input_value()
    for each in ("joint2", "joint4", "joint6"):
        page.get_by_label(each, exact=True).fill("2.7")
    at.press("Draw it")
    expect(page.locator(".new-cell [role=alert]")).to_contain_text("robot.home_rad", timeout=PATIENCE_MS)
    for each in ("joint2", "joint4", "joint6"):
        page.get_by_label(each, exact=True).fill("")
    at.press("Draw it")
    expect(page.locator(".new-cell [role=alert]")).to_have_count(0, timeout=PATIENCE_MS)
    assert before != "2.7"
    go_on(page, "Sensor")
    page.get_by_label("Range, force x, y, z, N: x").fill("150")
    expect(page.get_by_role("button", name="Next", exact=True)).to_be_disabled()
    page.get_by_label("Make and model").fill("ACME 150")
    go_on(page, "Room")
    page.get_by_label("Height of the floor").fill("-0.4")
    leave_a_pair_out_and_watch_it_again(page)
    go_on(page, "Check")
    expect(page.locator(".new-cell")).to_contain_text("The cell can be used.")
    expect(page.locator(".findings").last).to_contain_text("zones")
    check_looks(look(page, "what is doubtful in a new cell"))
    at.press("Import cell")
    expect(page.get_by_role("radio", name="made_here")).to_be_checked(timeout=PATIENCE_MS)
    made = load_cell(service.data / "cells" / "made_here")
    assert (made.sensor.name, made.sensor.range[0], made.floor_z_m, list(made.tools)) == ("ACME 150", 150.0, -0.4, ["hand_tool"])
    assert 'velocity="1.5"' in made.urdf


def leave_a_pair_out_and_watch_it_again(page: Page) -> None:
    """The reason stands beside it, and the findings follow."""
    pairs = page.get_by_role("group", name="Pairs of links that are left out")
    expect(pairs).to_contain_text("None: all pairs of links are watched.")
    leave_out = pairs.get_by_role("button", name="Leave this pair out")
    pairs.get_by_role("combobox").first.select_option("link5")
    expect(leave_out).to_be_disabled()
    pairs.get_by_role("combobox").last.select_option("link2")
    leave_out.tap()
    pair = pairs.get_by_role("checkbox", name="link5 and link2")
    expect(pair).to_be_checked()
    expect(pairs).to_contain_text("nothing shows that they always overlap", timeout=PATIENCE_MS)
    finding = page.locator(".findings li", has_text="'link5' and 'link2' left out")
    expect(finding).to_be_visible()
    check_looks(look(page, "the room of a new cell"))
    pair.uncheck(force=True)
    expect(finding).to_have_count(0, timeout=PATIENCE_MS)
    expect(pair).to_have_count(0)


def test_a_new_cell_that_is_discarded_is_gone(at: Tablet, service: RealService, tmp_path: Path) -> None:
    others = drafts(service)
    page = begin(at, tmp_path / "arm.urdf", arm())
    go_on(page, "Arm")
    assert len(drafts(service) - others) == 1
    at.press("Discard")
    page.get_by_role("button", name="Discard it").tap()
    expect(page.locator(".new-cell h2").first).to_have_text("Description")
    expect(page.get_by_role("radio")).to_have_count(0)
    wait_for(lambda: drafts(service) <= others, "the draft to be gone")


def drafts(service: RealService) -> set[Path]:
    """Of all tests that share the service."""
    return set((service.data / "cells").glob(".new-*"))
