"""How long the robot goes on moving when the console falls silent, the server is killed or frozen, or its database locked, in each phase.

Whole services over real sockets, the simulated robot in real time: `python -m bench.stops --times 20`.
"""

from __future__ import annotations

import argparse
import json
import signal
import sqlite3
import tempfile
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from websockets.exceptions import ConnectionClosed

from core.cell import load_cell
from core.recording import Recording
from core.recording_folder import read_recording
from tests.server.real_service import ROOT, Console, RealService, real_service, wait_for

LIMIT_S = 0.3
PHASES = ("transfer", "hold", "rotate")


def silent(_: RealService, console: Console) -> None:
    """The console no longer answers stamps."""
    console.answering.clear()


def closed(_: RealService, console: Console) -> None:
    """Its window is closed."""
    assert console.lease is not None
    console.lease.close()


def killed(service: RealService, _: Console) -> None:
    """kill -9 of the server."""
    service.kill()


def frozen(service: RealService, _: Console) -> None:
    """The server stands still."""
    service.send(signal.SIGSTOP)


def locked(service: RealService, _: Console) -> None:
    """Somebody else has locked the database, for as long as the test looks."""
    other = sqlite3.connect(service.data / "heft.sqlite", isolation_level=None, check_same_thread=False)
    other.execute("BEGIN EXCLUSIVE")
    threading.Timer(2.0, other.close).start()


Blow = Callable[[RealService, Console], None]
BLOWS: tuple[Blow, ...] = (silent, closed, killed, frozen, locked)


class Watcher:
    """Follows a run, and knows what the robot's clock shows at which moment of ours."""

    def __init__(self, console: Console, run: str) -> None:
        self.phase = ""
        self.aborted = False
        self.offset_s = np.inf
        self._live = console.socket(f"/api/runs/{run}/live")
        threading.Thread(target=self._watch, daemon=True).start()

    def _watch(self) -> None:
        with suppress(ConnectionClosed, OSError):
            for text in self._live:
                message = json.loads(text)
                self.aborted |= message.get("event", {}).get("state") == "Aborted"
                if message["kind"] == "samples":
                    self.offset_s = min(self.offset_s, time.monotonic() - message["t_s"][-1])
                    self.phase = message["phase"].partition(":")[0]


def series(blows: list[Blow], folder: Path, seeds: list[int]) -> dict[tuple[str, str], list[tuple[float, float]]]:
    """Blows in every phase, once for each seed, to one service: see `measured`."""
    with real_service(folder) as service:
        return {(blow.__name__, phase): [measured(service, blow, phase, seed) for seed in seeds] for blow in blows for phase in PHASES}


def measured(service: RealService, blow: Blow, phase: str, seed: int) -> tuple[float, float]:
    """Time from the blow until the commanded speed is zero for good, and how much of it the braking takes, s."""
    while (found := struck(service, blow, phase, seed)) is None:
        print("control was lost before the blow; once more", flush=True)
    print(f"{blow.__name__:13} {phase:9} {1e3 * found[0]:5.0f} ms, braking up to {1e3 * found[1]:4.0f} ms", flush=True)
    return found


def struck(service: RealService, blow: Blow, phase: str, seed: int) -> tuple[float, float] | None:
    """The same; None where the console lost control before the blow, on a machine that is too busy for it."""
    console = Console(service)
    console.take_control()
    run = console.queue(seed=seed, pace="real_time")
    console.wait(run, "Idle")
    watcher = Watcher(console, run)
    assert console.release(run).status_code == 200
    wait_for(lambda: watcher.phase == phase or watcher.aborted, f"the phase {phase}", lambda: watcher.phase)
    if watcher.aborted:
        console.leave()
        recover(service, run)
        return None
    time.sleep(float(np.random.default_rng(seed).uniform(0.05, 0.25)))
    struck_s = time.monotonic() - watcher.offset_s
    blow(service, console)
    recording = service.data / "recordings" / run / "recording"
    wait_for(recording.is_dir, "the recording")
    console.leave()
    recover(service, run)
    return stopped(read_recording(recording), struck_s)


def recover(service: RealService, run: str) -> None:
    """Makes the service answer again, and clears the run that was aborted."""
    service.send(signal.SIGCONT)
    if service.process is None or service.process.poll() is not None:
        service.start()
    console = Console(service)
    console.take_control()
    console.wait(run, "Aborted")
    wait_for(lambda: console.command(run, "clear").status_code == 200, f"{run} to be cleared")
    console.leave()


def stopped(recording: Recording, struck_s: float) -> tuple[float, float]:
    """When its commanded speed was zero for good after it was struck, and how much of that its braking takes, s."""
    acceleration = np.array(load_cell(ROOT / "cells" / "lwr4_bench").robot.acceleration_rad_s2)
    assert recording.q_cmd is not None
    speed = np.abs(np.diff(recording.q_cmd, axis=0)) / np.diff(recording.t)[:, None]
    moving = np.flatnonzero((speed > 1e-6).any(axis=1))
    after = speed[recording.t[1:] >= struck_s]
    braking_s = float((after / acceleration).max()) if len(after) else 0.0
    return max(0.0, float(recording.t[moving[-1] + 1]) - struck_s), braking_s


def say(what: str, phase: str, found: NDArray[np.float64]) -> None:
    """One line.

    Args:
        found: (n, 2), times until the robot stood and what braking takes of them, s.
    """
    late = int((found[:, 0] > LIMIT_S + found[:, 1]).sum())
    worst = 1e3 * found.max(axis=0)
    print(f"{what:13} {phase:9} worst {worst[0]:5.0f} ms, braking up to {worst[1]:4.0f} ms, too late {late} of {len(found)}", flush=True)


def main() -> None:
    """Prints one line for each way to lose control and each phase."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("blows", nargs="*", help=f"all, or some of {' '.join(blow.__name__ for blow in BLOWS)}")
    parser.add_argument("--times", type=int, default=3, help="of each way in each phase")
    parser.add_argument("--at-once", type=int, default=1, help="services at the same time; more than there are cores make each other late")
    given = parser.parse_args()
    blows = [blow for blow in BLOWS if blow.__name__ in (given.blows or {each.__name__ for each in BLOWS})]
    print(f"time from the blow to zero commanded speed; allowed {1e3 * LIMIT_S:.0f} ms plus braking")
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(given.at_once) as pool:
        seeds = [list(range(100, 100 + given.times))[k :: given.at_once] for k in range(given.at_once)]
        found = list(pool.map(partial(series, blows), [Path(folder) / str(k) for k in range(given.at_once)], seeds))
    print()
    for blow in blows:
        for phase in PHASES:
            say(blow.__name__, phase, np.concatenate([part[blow.__name__, phase] for part in found]))


if __name__ == "__main__":
    main()
