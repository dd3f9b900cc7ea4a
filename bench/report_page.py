"""How soon a browser shows the report of a run whose robot is described by meshes, and how large it is.

The robots are public ones with the meshes that they come with; each carries a block in the cell that the tests make for it, on the
simulated robot. The page is read from the disk with an empty cache until its last picture is laid out and painted, at full speed and with
the processor slowed four times.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path
from statistics import median

import numpy as np
from playwright.sync_api import Browser

from core.events import drive
from core.payload.inertia import InertialParameters
from core.procedure.identify import identify
from core.report.page import write_report
from core.sessions.simulated import SimulatedSession
from tests.real_robots import ROBOTS, real_cell
from tests.web.tablet import LANDSCAPE, chromium

SLOWDOWNS = (1, 4)
BLOCK = InertialParameters.from_com(1.0, (0.0, 0.0, 0.05), 0.002 * np.eye(3))
SHOWN_S = """() => new Promise(done => requestAnimationFrame(() => setTimeout(() => done(performance.now() / 1000))))"""
"""Seconds since the page was asked for, once a frame has been painted."""


def main() -> None:
    """Prints size and times for each robot."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--times", type=int, default=5, help="loads at each speed")
    parser.add_argument("robots", nargs="*", default=["ur5", "ur10"], help=f"of {', '.join(ROBOTS)}")
    arguments = parser.parse_args()
    if unknown := set(arguments.robots) - set(ROBOTS):
        parser.error(f"no such robot: {', '.join(sorted(unknown))}")
    with tempfile.TemporaryDirectory() as folder, chromium() as browser:
        for name in arguments.robots:
            page = make_report(name, Path(folder))
            print(f"{name}: {page.stat().st_size / 1e6:.2f} MB", flush=True)
            for slowdown in SLOWDOWNS:
                found = [shown_s(browser, page, slowdown) for _ in range(arguments.times)]
                print(f"  shown, processor slowed {slowdown}x: median {median(found):.2f} s, worst {max(found):.2f} s of {len(found)}")


def make_report(name: str, folder: Path) -> Path:
    """The report of a whole run of one robot."""
    cell = real_cell(name, folder / name)
    session = SimulatedSession(cell, BLOCK, seed=0)
    outcome = drive(identify(cell, session, cell.payload_box))
    page = folder / f"{name}.html"
    write_report(
        page,
        recording=outcome.recording,
        identification=outcome.identification,
        run=outcome.summary,
        requirement=outcome.requirement,
    )
    return page


def shown_s(browser: Browser, file: Path, slowdown: float) -> float:
    """Seconds from asking for the page until it is painted."""
    with browser.new_context(viewport=LANDSCAPE) as context:
        page = context.new_page()
        context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": slowdown})
        page.goto(file.as_uri(), wait_until="load")
        return float(page.evaluate(SHOWN_S))


if __name__ == "__main__":
    main()
