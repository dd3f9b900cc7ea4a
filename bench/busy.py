"""How many runs come through from a console that draws the cell in three dimensions, on a machine whose cores are kept busy beside it.

The whole way in Chromium, which draws without a graphics card, beside four processes that compute, all at normal priority:
`python -m bench.busy`. Nobody resumes: a run that was held because something was late has not come through.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image
from playwright.sync_api import Browser, Error, FloatRect, Page
from playwright.sync_api import TimeoutError as TooLate

from bench.stops import STANDING, recover
from tests.server.real_service import Console, RealService, real_service
from tests.web.tablet import Tablet, chromium, tablet

PROCESSES = 4
BUSY_MS = 240_000
"""Everything takes longer on a machine that is busy."""
TAP_MS = 30_000
RUN_S = 300.0
LOOK_S = 0.5
COLOURS = 200
"""At least in a picture of the cell; a viewer that draws nothing has a handful."""


@dataclass(frozen=True)
class Way:
    """One way from signing in to the result.

    Args:
        outcome: the run's last state, or what the browser could not do.
        seconds: from START on.
        stops: of the robot, with what was late.
        link: what the service says of the way to the console; None where it says nothing.
    """

    outcome: str
    seconds: float
    stops: tuple[str, ...]
    link: dict[str, Any] | None

    def __str__(self) -> str:
        told = f"{self.outcome} after {self.seconds:.0f} s, {'; '.join(self.stops) or 'never held'}"
        if self.link is None:
            return told
        return f"{told}; round trip p99 {1e3 * self.link['round_trip_p99_s']:.0f} ms, longest gap {self.link['longest_gap_s']:.2f} s"


def compute(parent: int) -> None:
    """Keeps a core busy as long as its parent lives."""
    table = np.random.default_rng(0).normal(size=(200, 200))
    while os.getppid() == parent:
        table = np.tanh(table @ table)
        sum(k * k for k in range(50_000))


@contextmanager
def busy(processes: int) -> Iterator[None]:
    """So many processes compute meanwhile."""
    context = multiprocessing.get_context("spawn")
    computing = [context.Process(target=compute, args=(os.getpid(),), daemon=True) for _ in range(processes)]
    try:
        for process in computing:
            process.start()
        yield
    finally:
        for process in computing:
            process.kill()
            process.join()


def walked(service: RealService, browser: Browser) -> Way:
    """The way of one run, which is ended where it is held, so that the cell is free for the next."""
    known = Console(service)
    before = {run["run"] for run in known.http.get("/api/runs").json()}
    with tablet(browser, service) as at:
        at.page.set_default_timeout(BUSY_MS)
        begun_s = time.monotonic()
        try:
            start(at)
            begun_s = time.monotonic()
            way = awaited(at, known, at.page.url.rsplit("/", 1)[1])
        except (AssertionError, Error) as error:
            way = Way(f"lost in the browser, {type(error).__name__}: {error}"[:300], time.monotonic() - begun_s, (), None)
    for run in {run["run"] for run in known.http.get("/api/runs").json()} - before:
        if known.run(run)["state"] not in STANDING:
            known.http.post(f"/api/runs/{run}/commands", json={"command": "stop"})
        recover(service, run)
    known.leave()
    return way


def start(at: Tablet) -> None:
    """From signing in to START, with the cell in three dimensions on the page."""
    at.open()
    at.sign_in()
    at.tap(at.page.get_by_text("Asymmetric steel block"))
    at.press("Take control and plan")
    at.page.wait_for_selector(".preview table")
    check_drawn(at.page)
    release(at)


def release(at: Tablet) -> None:
    """Release and START; a plan that was shown too long ago by then is shown again first."""
    until = time.monotonic() + BUSY_MS / 1e3
    while at.page.locator(".preview").is_visible():
        assert time.monotonic() < until, f"no START within {BUSY_MS / 1e3:.0f} s: {at.page.inner_text('body')}"
        for name in ("START", "Review the plan again", "Release"):
            button = at.page.get_by_role("button", name=name)
            if button.is_visible():
                with suppress(TooLate):  # it went away under the finger
                    button.tap(timeout=TAP_MS)
                break
        at.page.wait_for_timeout(1e3 * LOOK_S)


def check_drawn(page: Page) -> None:
    """The viewer draws the cell."""
    page.frame_locator("iframe.viewer").locator("canvas").first.wait_for()
    until = time.monotonic() + BUSY_MS / 1e3
    while (found := colours(page)) < COLOURS:
        assert time.monotonic() < until, f"the viewer shows {found} colours (expected {COLOURS} at least): it draws nothing"
        page.wait_for_timeout(1e3 * LOOK_S)


def colours(page: Page) -> int:
    """How many the viewer shows."""
    box = page.locator("iframe.viewer").bounding_box()
    assert box is not None
    clip: FloatRect = {"x": box["x"], "y": box["y"], "width": box["width"], "height": box["height"]}
    shown = Image.open(BytesIO(page.screenshot(clip=clip))).convert("RGB")
    return len(np.unique(np.asarray(shown).reshape(-1, 3), axis=0))


def awaited(at: Tablet, known: Console, run: str) -> Way:
    """Until the page shows the result, or the run has ended or is held."""
    begun_s = time.monotonic()
    link, state, drawn = None, "", False
    while state not in STANDING and time.monotonic() < begun_s + RUN_S:
        drawn |= at.page.locator(".running").is_visible() and at.page.locator("iframe.viewer").is_visible()
        at.page.wait_for_timeout(1e3 * LOOK_S)
        link = known.http.get(f"/api/control/{known.cell}").json().get("link") or link
        state = known.run(run)["state"]
    assert drawn, "the viewer was not on the page while the robot moved"
    if state == "Complete":
        at.page.wait_for_selector(".result table")
    events = [message["event"] for message in known.http.get(f"/api/runs/{run}/events?kind=event").json()]
    stops = tuple(told(event) for event in events if event["kind"] == "robot_stopped")
    return Way(state, time.monotonic() - begun_s, stops, link)


def told(stop: dict[str, Any]) -> str:
    """Why the robot was stopped."""
    late = stop.get("lateness")
    return f"{late['cause']} late by {late['late_s']:.3f} s (limit {late['limit_s']:.3f} s)" if late else str(stop["message"])


def main() -> None:
    """Prints one line for each run, then what became of them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--runs", type=int, default=20)
    parser.add_argument("--processes", type=int, default=PROCESSES, help="that compute meanwhile; 0 to compare with")
    given = parser.parse_args()
    ways = []
    with (
        tempfile.TemporaryDirectory() as folder, real_service(Path(folder)) as service, chromium() as browser, busy(given.processes),
    ):  # fmt: skip
        for k in range(given.runs):
            ways.append(walked(service, browser))
            print(f"{time.strftime('%H:%M:%S')}, load {os.getloadavg()[0]:.1f}: run {k + 1}: {ways[-1]}", flush=True)
    complete = sum(way.outcome == "Complete" and not way.stops for way in ways)
    print(f"\n{complete} of {len(ways)} complete and never held, beside {given.processes} processes on {os.cpu_count()} cores")
    print(f"stops: {dict(Counter(stop.partition(' late')[0] for way in ways for stop in way.stops)) or 'none'}")


if __name__ == "__main__":
    main()
