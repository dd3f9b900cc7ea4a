"""One finger on the glass, as the browser gets it from the device: what scrolls a page scrolls it."""

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
    device = page.context.new_cdp_session(page)

    def touch(kind: str, *at: Spot) -> None:
        device.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y} for x, y in at]})

    touch("touchStart", begin)
    for k in range(1, steps + 1):
        touch("touchMove", (begin[0] + (end[0] - begin[0]) * k / steps, begin[1] + (end[1] - begin[1]) * k / steps))
        page.wait_for_timeout(16)
    touch("touchEnd")
    device.detach()
