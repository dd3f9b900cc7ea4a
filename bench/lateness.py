"""How late the control loop of a run in real time comes while the server beside it is busy: watchers, requests, uploads.

`python -m bench.lateness`.
"""

from __future__ import annotations

import argparse
import re
import tempfile
import threading
from contextlib import suppress
from pathlib import Path

import httpx2
from websockets.exceptions import ConnectionClosed

from tests.server.real_service import Console, real_service, wait_for

WATCHERS = 10


def watch(console: Console, run: str) -> None:
    """Reads what is sent until the run is over."""
    with suppress(ConnectionClosed, OSError), console.socket(f"/api/runs/{run}/live") as live:
        for _ in live:
            pass


def ask(console: Console, run: str, over: threading.Event) -> None:
    """One request after the other."""
    with suppress(httpx2.HTTPError):
        while not over.is_set():
            for path in ("/api/runs", f"/api/runs/{run}/events", "/api/cells", "/metrics"):
                console.http.get(path)


def figure(text: str, name: str) -> float:
    """One of Prometheus's numbers."""
    found = re.search(rf"^{name} (\S+)$", text, re.MULTILINE)
    return float(found[1]) if found else 0.0


def main() -> None:
    """Prints the median, the latest and the share that is late by more than 5 ms."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quiet", action="store_true", help="nobody watches and nobody asks, to compare with")
    quiet = parser.parse_args().quiet
    with tempfile.TemporaryDirectory() as folder, real_service(Path(folder)) as service:
        console, over = Console(service), threading.Event()
        console.take_control()
        run = console.queue(pace="real_time")
        console.wait(run, "Idle")
        for _ in range(0 if quiet else WATCHERS):
            threading.Thread(target=watch, args=(console, run), daemon=True).start()
        if not quiet:
            threading.Thread(target=ask, args=(Console(service), run, over), daemon=True).start()
        assert console.release(run).status_code == 200
        state = console.wait(run, "Complete", "Aborted", seconds=180)["state"]
        over.set()
        wait_for(lambda: figure(console.http.get("/metrics").text, "heft_control_ticks_total"), "the figures")
        text = console.http.get("/metrics").text
        console.leave()
    ticks, late = figure(text, "heft_control_ticks_total"), figure(text, "heft_control_late_ticks_total")
    median, latest = figure(text, "heft_control_median_tick_seconds_sum"), figure(text, "heft_control_latest_tick_seconds_sum")
    print(f"{ticks:.0f} ticks, run {state}: late by {1e3 * median:.2f} ms in the median, {1e3 * latest:.1f} ms at most")
    print(f"later than 5 ms: {late / max(ticks, 1.0):.3%}")


if __name__ == "__main__":
    main()
