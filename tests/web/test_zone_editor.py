"""Protected zones in the picture of a cell: dragged by finger and by mouse, resized, turned, drawn, deleted and brought back."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Browser, Locator, Page, expect

from tests.server.real_service import Console, RealService
from tests.web.finger import drag, middle_of
from tests.web.judgement import check_looks
from tests.web.looks import look
from tests.web.patient_cells import console_service
from tests.web.screens import on_page
from tests.web.tablet import Tablet

CELL = "/api/cells/lwr4_bench"
IN_FILE = {"kind": "box", "size_m": [1.0, 3.0, 2.75], "pose": {"xyz_m": [1.35, 0.0, 0.625], "rpy_rad": [0.0, 0.0, 0.0]}}


@pytest.fixture(scope="module")
def service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RealService]:
    """One whose zones nobody else looks at."""
    with console_service(tmp_path_factory.mktemp("zones")) as running:
        yield running


@pytest.fixture
def at(service: RealService, browser: Browser) -> Iterator[Tablet]:
    """A tablet on the zones of a cell, which are as the file has them, before and afterwards."""
    with on_page(service, browser, "Cells", ".zone-places .tile") as found:
        found.page.locator(".zone-editor").evaluate("each => each.scrollIntoView()")
        yield found
        complaints = [said for said in found.complaints if "409 (Conflict" not in said]
        person = Console(service)
        for place in person.http.get(CELL).json()["moved"]:
            person.http.post(f"{CELL}/zones/{place['zone']}/undo", json={"to": "file"})
        assert zones_of(person) == {"operator": IN_FILE}
        person.leave()
        assert complaints == []


def zones_of(person: Console) -> dict[str, Any]:
    return {zone["name"]: zone["shape"] for zone in person.http.get(CELL).json()["cell"]["zones"]}


def stored(service: RealService) -> dict[str, Any]:
    person = Console(service)
    found = zones_of(person)
    person.leave()
    return found


def picture(page: Page, view: str = "From above") -> Locator:
    return page.get_by_role("group", name=view)


def metres(page: Page, view: str = "From above") -> float:
    """How many px of the picture are a metre."""
    size = float((picture(page, view).get_attribute("viewBox") or "").split()[2])
    box = picture(page, view).bounding_box()
    assert box is not None
    return min(box["width"], box["height"]) / size


def value(page: Page, label: str, group: str = "Centre") -> float:
    return float(page.get_by_role("group", name=group).get_by_role("textbox", name=label, exact=True).input_value().replace("−", "-"))


def test_a_finger_drags_a_zone_by_centimetres_and_the_page_stays_where_it_is(at: Tablet, service: RealService):
    page, zone = at.page, picture(at.page).locator("[data-zone=operator]")
    scrolled = page.locator("main").evaluate("each => each.scrollTop")
    x, y = middle_of(zone)
    scale = metres(page)
    drag(page, (x, y), (x + 0.4 * scale, y + 0.25 * scale))
    assert page.locator("main").evaluate("each => each.scrollTop") == scrolled
    there = value(page, "x"), value(page, "y")
    assert there == pytest.approx((1.75, -0.25), abs=0.03)
    assert [round(1000 * each) % 10 for each in there] == [0, 0]
    expect(page.locator(".zone-numbers")).to_contain_text(f"{there[0]:.3f}")
    expect(page.locator(".zone-changing")).to_contain_text("The robot’s base and its arm at home stay clear of it.")
    assert stored(service) == {"operator": IN_FILE}
    check_looks(look(page, "a zone that was dragged"))
    at.press("Move the zone")
    expect(page.locator(".zone-places .tile")).to_contain_text("changed by operator")
    assert stored(service)["operator"]["pose"]["xyz_m"] == [*there, 0.625]


def test_a_mouse_resizes_and_turns_a_zone_and_each_step_can_be_taken_back(at: Tablet):
    page = at.page
    at.press("Change")
    for begin, right, up in ((grip(page, "edge", x=1, y=0), 0.5, 0.0), (grip(page, "edge", x=-1, y=1), 0.2, -0.5)):
        move_mouse(page, begin, right, up)
    assert [value(page, side, "Size") for side in ("x", "y")] == pytest.approx([1.3, 2.5], abs=0.02)
    assert value(page, "x") == pytest.approx(1.35 + 0.35, abs=0.02)
    move_mouse(page, grip(page, "turn"), 0.0, 0.6)
    turned = page.get_by_role("textbox", name="Turned")
    assert float(turned.input_value()) > 5.0
    move_mouse(page, grip(page, "height", view="From the side", z=1), 0.0, -0.5, view="From the side")
    assert value(page, "Height", "Size") == pytest.approx(2.25, abs=0.02)
    assert value(page, "z") == pytest.approx(0.625 - 0.25, abs=0.02)
    for _ in range(4):
        at.press("Undo step")
    assert [value(page, side, "Size") for side in ("x", "y", "Height")] == [1.0, 3.0, 2.75]
    expect(turned).to_have_value("0.0")
    expect(page.get_by_role("button", name="Undo step")).to_be_disabled()


def grip(page: Page, at: str, view: str = "From above", **which: int) -> Locator:
    """A handle of the zone that is being changed."""
    found = [f'"at":"{at}"', *(f'"{name}":{sign}' for name, sign in which.items())]
    return picture(page, view).locator(f"[data-grip='{{{','.join(found)}}}'] .grip-dot")


def move_mouse(page: Page, what: Locator, right_m: float, up_m: float, view: str = "From above") -> None:
    (x, y), scale = middle_of(what), metres(page, view)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + right_m * scale, y - up_m * scale, steps=5)
    page.mouse.up()


@pytest.mark.parametrize("kind", ["Box", *(pytest.param(kind, marks=pytest.mark.thorough) for kind in ("Cylinder", "Sphere"))])
def test_a_zone_is_drawn_with_a_finger_saved_deleted_and_brought_back(kind: str, at: Tablet, service: RealService):
    page = at.page
    at.tap(page.get_by_role("group", name="New zone").get_by_role("button", name=kind))
    frame = picture(page).bounding_box()
    assert frame is not None
    begin = (frame["x"] + 0.15 * frame["width"], frame["y"] + 0.85 * frame["height"])
    drag(page, begin, (begin[0] + 50, begin[1] + 30))
    page.get_by_role("textbox", name="Name").fill("bench")
    expect(page.locator(".zone-changing")).to_contain_text("This name is taken in the cell")
    page.get_by_role("textbox", name="Name").fill("trolley")
    expect(page.locator(".zone-changing")).to_contain_text("stay clear of it")
    at.press("Save zone")
    tile = page.locator(".zone-places .tile", has_text="trolley")
    expect(tile).to_contain_text("changed by operator")
    assert stored(service)["trolley"]["kind"] == kind.lower()
    at.tap(tile.get_by_role("button", name="Delete zone"))
    expect(tile).to_contain_text("Delete trolley?")
    assert "trolley" in stored(service)
    at.tap(tile.get_by_role("button", name="Delete zone", exact=True))
    expect(page.locator(".zone-places")).to_contain_text("deleted by operator")
    assert "trolley" not in stored(service)
    at.press("Bring trolley back")
    expect(tile.get_by_role("heading", name="trolley")).to_be_visible()
    assert "trolley" in stored(service)


def test_a_zone_drawn_over_the_robot_is_refused_before_it_is_saved(at: Tablet, service: RealService):
    page = at.page
    at.tap(page.get_by_role("group", name="New zone").get_by_role("button", name="Box"))
    base = picture(page).locator(".base")
    x, y = middle_of(base)
    drag(page, (x - 40, y - 40), (x + 40, y + 40))
    refused = page.locator(".zone-changing [role=alert]")
    expect(refused).to_contain_text("It cannot be saved like this")
    expect(page.get_by_role("button", name="Save zone")).to_be_disabled()
    check_looks(look(page, "a zone that was drawn over the robot"))
    at.press("Discard")
    expect(page.locator(".zone-changing")).to_have_count(0)
    assert stored(service) == {"operator": IN_FILE}


def test_the_picture_follows_what_is_typed_and_the_arrow_keys_move_what_is_seen(at: Tablet):
    page = at.page
    at.press("Change")
    outline = picture(page).locator(".zone-new")
    page.get_by_role("group", name="Size").get_by_role("textbox", name="x", exact=True).fill("0,5")
    points = outline.get_attribute("points") or ""
    xs = [float(point.split(",")[0]) for point in points.split()]
    assert max(xs) - min(xs) == pytest.approx(0.5)
    outline.press("ArrowRight")
    outline.press("Shift+ArrowUp")
    centre = page.get_by_role("group", name="Centre")
    expect(centre.get_by_role("textbox", name="x", exact=True)).to_have_value("1.360")
    expect(centre.get_by_role("textbox", name="y", exact=True)).to_have_value("0.100")
    page.get_by_role("group", name="Size").get_by_role("textbox", name="x", exact=True).fill("0")
    expect(page.locator(".zone-changing")).to_contain_text("Enter at least 0.02 m")


def test_a_zone_that_was_dragged_far_away_is_within_reach_again(at: Tablet):
    page = at.page
    at.press("Change")
    page.get_by_role("group", name="Centre").get_by_role("textbox", name="x", exact=True).fill("15")
    frame = picture(page).bounding_box()
    assert frame is not None
    x, y = middle_of(picture(page).locator(".zone-new"))
    assert frame["x"] < x < frame["x"] + frame["width"]
    assert frame["y"] < y < frame["y"] + frame["height"]
    at.press("Zoom to zone")
    box = picture(page).locator(".zone-new").bounding_box()
    assert box is not None and box["height"] > frame["height"] / 2


def test_on_a_phone_the_picture_stays_in_sight_beside_the_fields(at: Tablet):
    page = at.page
    page.set_viewport_size({"width": 390, "height": 844})
    at.press("Change")
    turned = page.get_by_role("textbox", name="Turned")
    turned.evaluate("each => each.scrollIntoView({block: 'end'})")
    field, shown = turned.bounding_box(), picture(page).bounding_box()
    assert field is not None and shown is not None
    main = page.locator("main").bounding_box()
    assert main is not None and main["y"] - 2 <= shown["y"] < main["y"] + 40
    assert shown["y"] + shown["height"] <= field["y"]
    page.locator("main").evaluate("each => each.scrollTo(0, each.scrollHeight)")
    facts, shown = page.locator(".cell-facts").bounding_box(), picture(page).bounding_box()
    assert facts is not None and shown is not None
    assert shown["y"] + shown["height"] <= facts["y"], "the picture lies over the facts of the cell"
