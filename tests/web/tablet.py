"""A tablet in front of the operator: Debian's Chromium, driven by touch."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from typing import Any

from playwright.sync_api import Browser, ConsoleMessage, Locator, Page, Route, ViewportSize, sync_playwright

from tests.server.real_service import QUICK, RealService

SHORT = QUICK | {"pace": "real_time"}
"""A robot that moves as fast as it can be computed takes a processor of its own from the browser."""

CHROMIUM = "/usr/bin/chromium"
ARGUMENTS = [
    "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
]  # fmt: skip
LANDSCAPE: ViewportSize = {"width": 1280, "height": 800}
PORTRAIT: ViewportSize = {"width": 800, "height": 1280}
PHONE: ViewportSize = {"width": 390, "height": 844}
DESKTOP: ViewportSize = {"width": 1920, "height": 1080}
PATIENCE_MS = 60_000
STUB = "<!doctype html><title>viewer</title><body style='background:#888'>"
NOT_SIGNED_IN = "401 (Unauthorized)"
"""What the browser says of the console's first question, who is signed in."""
VISER_WARNS = ("THREE.Clock", "GL Driver Message")
"""An old name that viser's page uses, and what a browser without a graphics card says of reading pictures back."""


@contextmanager
def chromium() -> Iterator[Browser]:
    """The browser that Debian has."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        yield browser
        browser.close()


@dataclass
class Tablet:
    """One page of the console; counts what is tapped and keeps what the browser complains of.

    Args:
        page: signed in nowhere yet.
    """

    page: Page
    service: RealService
    taps: int = 0
    complaints: list[str] = field(default_factory=list)

    def open(self, where: str = "") -> None:
        """Loads the console."""
        self.page.goto(f"http://{self.service.address}/{where}")
        self.page.wait_for_selector("h1")

    def listen(self, page: Page) -> None:
        """Keeps what the browser complains of on a page."""
        page.on("pageerror", lambda error: self.complaints.append(error.stack or str(error)))
        page.on("console", lambda said: self.complaints.append(f"{said.text} at {said.location['url']}") if is_complaint(said) else None)

    def tap(self, what: Locator) -> None:
        """One tap of a finger."""
        what.tap()
        self.taps += 1

    def press(self, name: str) -> None:
        """Taps the button of that name."""
        self.tap(self.page.get_by_role("button", name=name))

    def sign_in(self) -> None:
        """As the first operator; typing is no tap."""
        self.page.keyboard.type("operator")
        self.page.keyboard.press("Tab")
        self.page.keyboard.type(self.service.password)
        self.press("Sign in")
        self.page.wait_for_selector(".setup .cell-facts")

    def wait(self, selector: str) -> None:
        """Until it is to be seen."""
        self.page.wait_for_selector(selector, timeout=PATIENCE_MS)

    def hurry(self, **order: float) -> None:
        """From now on runs are short: the robot moves for half a minute, or as it is ordered."""
        self.page.context.route("**/api/runs", partial(_shortened, SHORT | order))

    def until_drawn(self) -> None:
        """The viewer is there."""
        self.page.frame_locator("iframe.viewer").locator("canvas[data-engine]").wait_for(timeout=2 * PATIENCE_MS)

    def without_viewer(self) -> None:
        """Three dimensions drawn without a graphics card take the processor from everything else."""
        self.page.context.route("**/viewer/**", lambda route: route.fulfill(body=STUB, content_type="text/html"))


def _shortened(short: dict[str, Any], route: Route) -> None:
    if route.request.method != "POST":
        route.continue_()
        return
    order: dict[str, Any] = json.loads(route.request.post_data or "{}")
    route.continue_(post_data=json.dumps(order | short))


@contextmanager
def tablet(browser: Browser, service: RealService, **options: Any) -> Iterator[Tablet]:
    """A tablet that nobody has used before, in landscape."""
    with browser.new_context(has_touch=True, viewport=LANDSCAPE, locale="en-GB", **options) as context:
        page = context.new_page()
        page.set_default_timeout(PATIENCE_MS)
        found = Tablet(page, service)
        found.listen(page)
        yield found


def is_complaint(said: ConsoleMessage) -> bool:
    """Errors and warnings, but for the answer to who is signed in: nobody; and for what viser's own page warns of."""
    of_viser = said.type == "warning" and any(each in said.text for each in VISER_WARNS)
    return said.type in ("error", "warning") and NOT_SIGNED_IN not in said.text and not of_viser
