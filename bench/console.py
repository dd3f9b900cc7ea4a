"""How soon the console can be used on a slow tablet, how soon it shows again what is, and how large it is.

Loads the built console in Chromium on a processor slowed down four times, each time with an empty cache, until its first field can be
typed into; the same unslowed beside it, because this machine may be busy with other things. The same from loading the page of somebody
who is signed in until its picture of the cell shows a robot, drawn without a graphics card. Then a tablet that looks on is loaded
again, and cut off from the service while the run that it shows is cancelled: until it shows the run as it is, once it is asked for or
has its line back.
"""

from __future__ import annotations

import argparse
import gzip
import re
import tempfile
import time
from io import BytesIO
from pathlib import Path
from statistics import median

import numpy as np
from PIL import Image
from playwright.sync_api import Browser, Page

from core.words.catalogue import LANGUAGES
from tests.server.real_service import ROOT, Console, RealService, real_service
from tests.web.screens import show, signed_in
from tests.web.tablet import LANDSCAPE, Tablet, chromium

SLOWDOWNS = (1, 4)
SOLID_SHARE = 0.03
"""Of a picture with a robot and its table; one without has lines alone."""
FIRST_FIELD_S = "() => document.activeElement?.name === 'username' && performance.now() / 1000"
"""Seconds since the page was asked for, once the field for the name has the cursor."""
PLANNED_S = "() => document.querySelector('.preview table') && performance.now() / 1000"
"""Seconds since the page was asked for, once it shows a plan."""
STOPPED = "() => document.querySelector('.ended [data-state=Stopped]') && !document.querySelector('.line-lost')"


def main() -> None:
    """Prints both."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--times", type=int, default=5, help="loads at each speed")
    times = parser.parse_args().times
    for language in LANGUAGES:
        loaded = first_files(ROOT / "web" / "dist", language)
        print(
            f"bundle, {language}: {sum(len(gzip.compress(file.read_bytes())) for file in loaded) / 1e3:.1f} kB gzip in {len(loaded)} files"
        )
    with tempfile.TemporaryDirectory() as folder, real_service(Path(folder)) as service, chromium() as browser:
        for slowdown in SLOWDOWNS:
            found = [interactive_s(browser, service, slowdown) for _ in range(times)]
            print(f"interactive, processor slowed {slowdown}x: median {median(found):.2f} s, worst {max(found):.2f} s of {times}")
        for slowdown in SLOWDOWNS:
            drawn = [drawn_s(browser, service, slowdown) for _ in range(times)]
            print(
                f"three dimensions shown, processor slowed {slowdown}x: median {median(drawn):.2f} s, worst {max(drawn):.2f} s of {times}"
            )
        again, back = zip(*shown_again_s(browser, service, times), strict=True)
    for what, taken in (("loaded again", again), ("the line is back", back)):
        print(f"the run as it is, once {what}: median {median(taken):.2f} s, worst {max(taken):.2f} s of {times}")


def first_files(dist: Path, language: str) -> list[Path]:
    """What a console in a language loads before anybody opens a page whose code comes later: scripts with what they import, styles."""
    assets = {file.name: file for file in (dist / "assets").iterdir()}
    begins = re.findall(r"assets/([^\"]+)", (dist / "index.html").read_text())
    unseen = {*begins, *(name for name in assets if re.match(rf"start-|{language}-all-|lease-worker-", name))}
    found: set[str] = set()
    while unseen:
        name = unseen.pop()
        found.add(name)
        imported = re.findall(r"(?:from|import)\"\./([^\"]+)", assets[name].read_text()) if name.endswith(".js") else []
        styles = [other for other in assets if other.endswith(".css") and stem_of(other) == stem_of(name)]
        unseen |= {*imported, *styles} - found
    return [dist / "index.html", *(assets[name] for name in sorted(found))]


def stem_of(asset: str) -> str:
    """The name of an asset without what makes it that of this build."""
    return re.sub(r"-.{8}\.\w+$", "", asset)


def interactive_s(browser: Browser, service: RealService, slowdown: float) -> float:
    """Seconds from asking for the page until its first field can be typed into."""
    with browser.new_context(has_touch=True, viewport=LANDSCAPE) as context:
        page = context.new_page()
        context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": slowdown})
        page.goto(f"http://{service.address}/")
        return float(page.wait_for_function(FIRST_FIELD_S, polling=10).json_value())


def drawn_s(browser: Browser, service: RealService, slowdown: float) -> float:
    """Seconds from asking for the set-up page until the viewer's picture has more than its background and the lines of its grid."""
    with (
        signed_in(service, browser) as at,
        browser.new_context(storage_state=at.page.context.storage_state(), viewport=LANDSCAPE) as context,
    ):
        page = context.new_page()
        context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": slowdown})
        since = time.monotonic()
        page.goto(f"http://{service.address}/", wait_until="commit")
        page.frame_locator("iframe.viewer").locator("canvas[data-engine]").wait_for(timeout=60_000)
        while solid_share(page) < SOLID_SHARE:
            if time.monotonic() - since > 60.0:
                raise SystemExit("no picture of the cell within a minute")
        return time.monotonic() - since


def solid_share(page: Page) -> float:
    """How much of the viewer's picture is neither its most frequent colour nor close to it."""
    picture = np.asarray(Image.open(BytesIO(page.locator("iframe.viewer").screenshot())).convert("RGB"), dtype=int)
    background = np.median(picture.reshape(-1, 3), axis=0)
    return float((np.abs(picture - background).max(axis=2) > 40).mean())


def shown_again_s(browser: Browser, service: RealService, times: int) -> list[tuple[float, float]]:
    """Seconds until the run that a tablet looks on is on its screen: after it was loaded again, after its line is back."""
    person = Console(service)
    with signed_in(service, browser) as at:
        at.without_viewer()
        found = [(loaded_again_s(page), back_s(page, person, run)) for run, page in (planned(at, person) for _ in range(times))]
    person.leave()
    return found


def planned(at: Tablet, person: Console) -> tuple[str, Page]:
    """A run whose plan the tablet shows."""
    run = person.queue()
    person.wait(run, "Idle")
    page = show(at, "runs", run)
    page.wait_for_selector(".preview table")
    return run, page


def loaded_again_s(page: Page) -> float:
    page.reload(wait_until="commit")
    return float(page.wait_for_function(PLANNED_S, polling=10).json_value())


def back_s(page: Page, person: Console, run: str) -> float:
    """The run is cancelled while the tablet has no line."""
    page.context.set_offline(True)
    page.wait_for_selector(".line-lost")
    person.http.delete(f"/api/runs/{run}")
    person.wait(run, "Stopped")
    since = time.monotonic()
    page.context.set_offline(False)
    page.wait_for_function(STOPPED, polling=10)
    return time.monotonic() - since


if __name__ == "__main__":
    main()
