"""How soon the console can be used on a slow tablet, and how large it is.

Loads the built console in Chromium on a processor slowed down four times, each time with an empty cache, until its first field can be typed
into; the same unslowed beside it, because this machine may be busy with other things.
"""

from __future__ import annotations

import argparse
import gzip
import tempfile
from pathlib import Path
from statistics import median

from playwright.sync_api import Browser

from tests.server.real_service import ROOT, RealService, real_service
from tests.web.tablet import LANDSCAPE, chromium

SLOWDOWNS = (1, 4)
FIRST_FIELD_S = "() => document.activeElement?.name === 'username' && performance.now() / 1000"
"""Seconds since the page was asked for, once the field for the name has the cursor."""


def main() -> None:
    """Prints both."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--times", type=int, default=5, help="loads at each speed")
    times = parser.parse_args().times
    files = [file for file in (ROOT / "web" / "dist").rglob("*") if file.is_file()]
    print(f"bundle: {sum(len(gzip.compress(file.read_bytes())) for file in files) / 1e3:.1f} kB gzip in {len(files)} files")
    with tempfile.TemporaryDirectory() as folder, real_service(Path(folder)) as service, chromium() as browser:
        for slowdown in SLOWDOWNS:
            found = [interactive_s(browser, service, slowdown) for _ in range(times)]
            print(f"interactive, processor slowed {slowdown}x: median {median(found):.2f} s, worst {max(found):.2f} s of {times}")


def interactive_s(browser: Browser, service: RealService, slowdown: float) -> float:
    """Seconds from asking for the page until its first field can be typed into."""
    with browser.new_context(has_touch=True, viewport=LANDSCAPE) as context:
        page = context.new_page()
        context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": slowdown})
        page.goto(f"http://{service.address}/")
        return float(page.wait_for_function(FIRST_FIELD_S, polling=10).json_value())


if __name__ == "__main__":
    main()
