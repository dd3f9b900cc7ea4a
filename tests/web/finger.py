"""Fingers on the glass, as the browser gets them from the device: what scrolls or zooms a page does so."""

from __future__ import annotations

from playwright.sync_api import Locator, Page

Spot = tuple[float, float]


def middle_of(what: Locator) -> Spot:
    """Of what is to be seen of it, px."""
    box = what.bounding_box()
    assert box is not None, "nothing is to be seen of it"
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def drag(page: Page, begin: Spot, end: Spot, *, steps: int = 12) -> None:
    """Down, along a line, up."""
    move_fingers(page, [(begin, end)], steps)


def pinch(page: Page, middle: Spot, begin_px: float, end_px: float, *, steps: int = 12) -> None:
    """Two fingers beside each other, so far from the middle, come together or go apart."""
    x, y = middle
    move_fingers(page, [((x + side * begin_px, y), (x + side * end_px, y)) for side in (-1, 1)], steps)


def move_fingers(page: Page, ways: list[tuple[Spot, Spot]], steps: int) -> None:
    """All down at once, along their lines, up."""
    device = page.context.new_cdp_session(page)

    def touch(kind: str, share: float) -> None:
        at = [(x + (to_x - x) * share, y + (to_y - y) * share) for (x, y), (to_x, to_y) in ways]
        points = [{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(at)]
        device.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points if kind != "touchEnd" else []})

    touch("touchStart", 0.0)
    for k in range(1, steps + 1):
        touch("touchMove", k / steps)
        page.wait_for_timeout(16)
    touch("touchEnd", 1.0)
    device.detach()
