"""In the page of a tablet that looks on, the robot moves and stands as the real one does; drawn without a graphics card."""

from __future__ import annotations

from io import BytesIO

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from playwright.sync_api import Browser, Page

from tests.server.real_service import Console, RealService, is_late
from tests.web.screens import show, signed_in

CHANGED = 30
"""By how much of 255 a pixel differs that shows something else."""
MOVED_PIXELS = 200
BETWEEN_MS = 1500
PICTURES = 8
"""In which the robot, which stands between its motions, is seen to move."""


def test_the_robot_in_the_page_moves_and_stands_as_the_robot_does(service: RealService, browser: Browser, person: Console) -> None:
    person.take_control()
    run = person.queue(pace="real_time", hold_s=10.0)
    person.wait(run, "Idle")
    with signed_in(service, browser, drawn=True) as at:
        assert person.release(run).status_code == 200
        page = show(at, "runs", run)
        at.until_drawn()
        with person.keep_moving(run):
            assert any(pixels_that_change(page) > MOVED_PIXELS for _ in range(PICTURES))
        held = person.command(run, "hold")
        assert held.status_code == 200 or is_late(person.run(run)), held.text  # a busy machine may have held it before
        at.wait("[data-state=Held]")
        page.wait_for_timeout(BETWEEN_MS)
        assert pixels_that_change(page) < MOVED_PIXELS


def pixels_that_change(page: Page) -> int:
    """From one picture of the scene to the next."""
    before = scene(page)
    page.wait_for_timeout(BETWEEN_MS)
    return int((np.abs(scene(page) - before).max(axis=2) > CHANGED).sum())


def scene(page: Page) -> NDArray[np.float64]:
    """(height, width, 3), what the viewer shows."""
    picture = page.locator("iframe.viewer").screenshot()
    return np.asarray(Image.open(BytesIO(picture)).convert("RGB"), dtype=float)
