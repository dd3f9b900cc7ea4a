"""The whole way from signing in to the accepted result, walked once, each screen looked at."""

from __future__ import annotations

from dataclasses import dataclass, field

from playwright.sync_api import Browser

from tests.server.real_service import RealService
from tests.web.looks import Look, glimpse, look
from tests.web.tablet import Tablet, tablet


@dataclass
class Way:
    """What was seen on the whole way from signing in to the accepted result.

    Args:
        taps: that it took.
        looks: at every screen.
        complaints: of the browser.
        told: words on the screens where they matter.
    """

    taps: int = 0
    looks: list[Look] = field(default_factory=list)
    complaints: list[str] = field(default_factory=list)
    told: dict[str, str] = field(default_factory=dict)

    def see(self, screen: str, at: Tablet) -> None:
        self.looks += look(at.page, screen)
        self.told[screen] = at.page.inner_text("body")


def walked(service: RealService, browser: Browser) -> Way:
    """The whole way, by touch; a hold stretches it so that the running screen can be looked at."""
    seen = Way()
    with tablet(browser, service) as at:
        at.hurry()
        at.without_viewer()
        at.open()
        seen.see("sign in", at)
        at.sign_in()
        seen.see("cell and tool", at)
        at.tap(at.page.get_by_text("Asymmetric steel block"))
        at.press("Take control and plan")
        at.wait(".planning .found, .preview table")
        at.wait(".preview table")
        seen.see("plan", at)
        _release(seen, at)
        _hold(seen, at, browser)
        at.wait(".result table")
        seen.see("result", at)
        at.press("Accept")
        at.wait("text=Accepted by operator")
        seen.see("accepted", at)
        at.page.emulate_media(media="print")
        seen.told["printed"] = at.page.inner_text("body")
    seen.complaints, seen.taps = at.complaints, at.taps
    return seen


def _release(seen: Way, at: Tablet) -> None:
    """A plan that has been looked at for too long is shown again first."""
    again = at.page.get_by_role("button", name="Review the plan again")
    if again.is_visible():
        again.tap()
    at.press("Release")
    seen.see("about to start", at)
    at.press("START")


def _hold(seen: Way, at: Tablet, browser: Browser) -> None:
    """Beside the way, so it counts no tap; another tablet looks on meanwhile."""
    at.wait(".running .estimate-so-far dl")
    at.page.get_by_role("button", name="Hold").tap()
    at.wait("[data-state=Held]")
    seen.looks += glimpse(at.page, "on hold")
    seen.told["on hold"] = at.page.inner_text("body")
    with tablet(browser, at.service) as watching:
        watching.without_viewer()
        watching.open()
        watching.sign_in()
        watching.press("Open the run")
        watching.wait("[data-state=Held]")
        seen.see("watched on hold", watching)
    at.page.get_by_role("link", name="History").tap()
    at.wait(".run-list")
    seen.see("history on hold", at)
    at.page.get_by_role("button", name="Resume").tap()
    at.page.get_by_role("button", name="Hold").wait_for()
    at.page.go_back()
