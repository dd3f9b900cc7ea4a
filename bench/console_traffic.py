"""What the console asks of the service, and how much it is sent, while a run moves.

A tablet in control follows a run with the default parameters, its plots shown, for a minute in which the robot moves. Counted are
the requests to the service's API and the bytes on the wire as Chromium reports them: bodies and headers of answers, frames of
websockets in both directions. The viewer is another program's page: it is drawn on a second run only.
"""

from __future__ import annotations

import argparse
import tempfile
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Page

from tests.server.real_service import Console, RealService
from tests.web.patient_cells import console_service
from tests.web.tablet import Tablet, chromium, tablet

HOLD_S = 20.0
"""Long enough for a run that lasts longer than is watched."""


def main() -> None:
    """Prints requests and kilobytes a second, without and with three dimensions."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--seconds", type=float, default=60.0, help="how long is watched")
    seconds = parser.parse_args().seconds
    with tempfile.TemporaryDirectory() as folder, console_service(Path(folder)) as service, chromium() as browser:
        for drawn in (False, True):
            with moving(service, browser, drawn=drawn) as (at, traffic):
                at.page.wait_for_timeout(1e3 * seconds)
                if not at.page.get_by_role("button", name="Hold").is_visible():
                    raise SystemExit("the run did not move all the time; is the machine busy?")
                print(f"{'with' if drawn else 'without'} three dimensions, {seconds:.0f} s of a moving robot: {traffic.told(seconds)}")


@contextmanager
def moving(service: RealService, browser: Browser, *, drawn: bool) -> Iterator[tuple[Tablet, Traffic]]:
    """A tablet in control of a robot that has begun to move, and what it is sent since then; the run is ended afterwards."""
    person = Console(service)
    with tablet(browser, service) as at:
        if not drawn:
            at.without_viewer()
        at.hurry(hold_s=HOLD_S)
        traffic = Traffic(at.page)
        at.open()
        at.sign_in()
        at.press("Take control and plan")
        at.wait(".preview table")
        at.press("Release")
        at.press("START")
        at.page.get_by_role("button", name="Hold").wait_for()
        at.page.wait_for_timeout(2000)
        traffic.begin_again()
        yield at, traffic
        at.press("STOP")
        person.wait(at.page.url.rsplit("/", 1)[1], "Stopped", "Aborted")
    person.leave()


class Traffic:
    """What a page asks and is sent; sockets count that are opened later.

    Args:
        page: of the console.
    """

    def __init__(self, page: Page) -> None:
        self.asked: list[str] = []
        self.bytes: Counter[str] = Counter()
        network = page.context.new_cdp_session(page)
        network.on("Network.requestWillBeSent", self._ask)
        network.on("Network.loadingFinished", lambda done: self.bytes.update({"answers": int(done["encodedDataLength"])}))
        network.on("Network.webSocketFrameReceived", lambda frame: self._count("sockets, received", frame))
        network.on("Network.webSocketFrameSent", lambda frame: self._count("sockets, sent", frame))
        network.send("Network.enable")

    def begin_again(self) -> None:
        """Forgets what there was so far."""
        self.asked.clear()
        self.bytes.clear()

    def _ask(self, request: dict[str, Any]) -> None:
        if "/api/" in request["request"]["url"]:
            self.asked.append(request["request"]["url"])

    def _count(self, what: str, frame: dict[str, Any]) -> None:
        payload = frame["response"]["payloadData"]
        binary = frame["response"]["opcode"] == 2
        self.bytes[what] += len(payload) * 3 // 4 if binary else len(payload.encode())

    def told(self, seconds: float) -> str:
        """Requests, and kB/s by kind."""
        kinds = ", ".join(f"{what} {count / 1e3 / seconds:.1f} kB/s" for what, count in sorted(self.bytes.items()))
        return f"{len(self.asked)} requests to the API; {sum(self.bytes.values()) / 1e3 / seconds:.1f} kB/s ({kinds})"


if __name__ == "__main__":
    main()
