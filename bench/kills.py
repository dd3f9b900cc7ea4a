"""kill -9 of the server at random moments: nothing that was acknowledged is lost, no state is illegal, and it is soon back.

`python -m bench.kills --count 200`.
"""

from __future__ import annotations

import argparse
import os
import tempfile
import threading
import time
from contextlib import suppress
from pathlib import Path
from typing import Any

import httpx2
import numpy as np
from websockets.exceptions import WebSocketException

from server.runs.packml import State
from tests.server.real_service import Console, real_service

SOON_S = 2.0
SETTLED = {State.RESETTING, State.IDLE, State.STOPPED, State.COMPLETE, State.ABORTED}


class Worker:
    """Queues, releases, commands and clears until the server is gone; keeps what was acknowledged."""

    def __init__(self, console: Console, known: dict[str, dict[str, Any]], seed: int) -> None:
        self._console, self._known, self._seed = console, known, seed
        self.thread = threading.Thread(target=self._work, daemon=True)
        self.thread.start()

    def _work(self) -> None:
        with suppress(httpx2.HTTPError, OSError, WebSocketException):
            console = self._console
            console.take_control()
            for old in console.http.get("/api/runs?limit=500").json():
                if old["state"] == State.ABORTED:
                    self._keep(console.command(old["run"], "clear"))
            for k in range(100):
                order = {"cell": console.cell, "payload": "steel_block", "seed": self._seed + k, "pace": "as_fast_as_possible"}
                self._keep(console.http.post("/api/runs", json=order, headers={"Idempotency-Key": f"{self._seed}-{k}"}))
                for run, found in list(self._known.items()):
                    if found["state"] in (State.RESETTING, State.IDLE):
                        self._move(run)

    def _move(self, run: str) -> None:
        now = self._console.run(run)
        if now["state"] == State.IDLE:
            self._keep(self._console.release(run))
        elif now["state"] == State.EXECUTE:
            self._keep(self._console.command(run, "stop"))

    def _keep(self, answer: httpx2.Response) -> None:
        if answer.is_success:
            self._known[answer.json()["run"]] = answer.json()


def lost_of(console: Console, run: str, before: dict[str, Any]) -> list[str]:
    """What an acknowledged run has lost."""
    lost = []
    now = console.run(run)
    if now.get("run") != run:
        return [f"{run} is gone"]
    if now["sequence"] < before["sequence"] or before["released"] > now["released"]:
        lost.append(f"{run} went back from {before['sequence']} to {now['sequence']}")
    if now["state"] not in SETTLED:
        lost.append(f"{run} is in {now['state']} after a crash")
    events = console.http.get(f"/api/runs/{run}/events?kind=event").json()
    if [event["sequence"] for event in events] != list(range(1, now["sequence"] + 1)):
        lost.append(f"{run} has gaps in its events")
    return lost


def main() -> None:
    """Prints each kill as it comes, then what was lost and how long the service needed to answer again."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0, help="of the moments")
    asked = parser.parse_args()
    rng = np.random.default_rng(asked.seed)
    known: dict[str, dict[str, Any]] = {}
    lost: list[str] = []
    back: list[float] = []
    with tempfile.TemporaryDirectory() as folder, real_service(Path(folder)) as service:
        for k in range(asked.count):
            console = Console(service)
            seen = dict(known)
            worker = Worker(console, known, 1000 * k)
            time.sleep(float(rng.exponential(4.0)))
            service.kill()
            worker.thread.join()
            console.leave()
            began = time.monotonic()
            service.start()
            back.append(time.monotonic() - began)
            console = Console(service)
            last = k == asked.count - 1
            touched = [run for run in known if last or known[run] is not seen.get(run) or known[run]["state"] not in SETTLED]
            for run in touched:
                lost += lost_of(console, run, known[run])
            console.leave()
            machine = f"{time.strftime('%H:%M:%S')}, load {os.getloadavg()[0]:.1f}"
            told = f"{len(touched)} runs looked at, back after {back[-1]:.1f} s, lost so far: {len(lost)}"
            print(f"{machine}: kill {k + 1}: {told}", flush=True)
    print(f"{asked.count} kills, {len(known)} acknowledged runs, lost: {len(lost)} {lost[:5]}")
    soon = sum(seconds <= SOON_S for seconds in back)
    print(f"back after {np.median(back):.1f} s in the median, {max(back):.1f} s at most, {soon} of {asked.count} times within {SOON_S:g} s")


if __name__ == "__main__":
    main()
