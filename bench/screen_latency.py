"""How late a sample of the robot is on the screen: one tablet draws a run in real time while nine other clients watch it.

`python -m bench.screen_latency --seconds 20`. The robot's clock is read off the watchers: it shows a sample's time no later than the
sample arrives anywhere, so what is counted begins with the fastest arrival of all, some milliseconds after the sample at most. It
ends with the frame in which a plot that reaches up to the sample was painted. The cell in three dimensions is left out: there is no
graphics card here.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from pathlib import Path

import numpy as np
from playwright.sync_api import Page

from bench.watchers import Reader
from core.array import Array
from tests.server.real_service import Console, RealService, real_service
from tests.web.screens import signed_in
from tests.web.tablet import chromium

OTHERS = 9
ALLOWED_S = 0.2
PERIOD_S = 0.002
"""Between samples."""
NOTES_FRAMES = """() => {
    window.painted = [];
    const after = newest => requestAnimationFrame(() => setTimeout(
        () => window.painted.push([performance.timeOrigin + performance.now(), newest]), 0));
    new MutationObserver(changes => after(Number(changes.at(-1).target.dataset.drawnUpTo)))
        .observe(document.querySelector('.plots .canvas'), {attributeFilter: ['data-drawn-up-to']}) }"""
"""Keeps, for each frame with a newly drawn plot of the force, when it had been painted (ms since 1970) and its newest sample (s)."""


def main() -> None:
    """Prints median and 95th percentile, and how they stand to the limit."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--seconds", type=float, default=20.0)
    seconds = parser.parse_args().seconds
    with (
        tempfile.TemporaryDirectory() as folder, real_service(Path(folder)) as service, chromium() as browser,
        signed_in(service, browser, drawn=True) as at,
    ):  # fmt: skip
        at.without_viewer()
        painted, readers = watched(service, at.page, seconds)
    late = latencies(painted, zero_of(readers))
    median, p95 = 1e3 * np.quantile(late, [0.5, 0.95])
    least = min(len(reader.seen) for reader in readers)
    print(f"{len(painted)} frames with new samples in {seconds:.0f} s; {OTHERS} others got {least} batches or more")
    print(f"sample to screen: median {median:.0f} ms, p95 {p95:.0f} ms (allowed {1e3 * ALLOWED_S:.0f} ms), worst {1e3 * late.max():.0f} ms")


def watched(service: RealService, page: Page, seconds: float) -> tuple[Array, list[Reader]]:
    """A run that the page and others watch: (K, 2) time of the frame (s since 1970) and of the newest sample in it (s, robot's clock)."""
    console = Console(service)
    console.take_control()
    run = console.queue(pace="real_time", hold_s=5.0)
    console.wait(run, "Idle")
    page.goto(f"http://{service.address}/#/runs/{run}")
    readers = [Reader(console, run) for _ in range(OTHERS)]
    assert console.release(run).status_code == 200
    page.wait_for_selector(".plots .canvas")
    page.evaluate(NOTES_FRAMES)
    page.wait_for_timeout(1e3 * seconds)
    painted = np.array(page.evaluate("() => window.painted")) * [1e-3, 1.0]
    console.command(run, "stop")
    console.leave()
    return painted, readers


def zero_of(readers: list[Reader]) -> float:
    """When the robot's clock showed zero, s since 1970."""
    since_1970 = time.time() - time.monotonic()
    return since_1970 + min(float((np.array(reader.seen) @ [1.0, -1.0]).min()) for reader in readers)


def latencies(painted: Array, zero_s: float) -> Array:
    """(N,), s, of every sample between the first and the last frame, until the first frame that shows it or a later one."""
    samples = np.arange(painted[0, 1] + PERIOD_S, painted[-1, 1], PERIOD_S)
    frame = np.searchsorted(painted[:, 1], samples - 1e-9)
    return np.asarray(painted[frame, 0] - (zero_s + samples))


if __name__ == "__main__":
    main()
