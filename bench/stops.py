"""How long the robot goes on moving after its link was lost, it was commanded to stand, or a process was killed or frozen, in each phase.

Whole services over real sockets, the simulated robot in real time: `python -m bench.stops --times 20`. A link counts as lost when the
cell's lease has run out. A control process that is killed or frozen commands nothing any more, and a real robot's own watchdog stops it;
the simulated one lives in that process, and its clock stands while it is frozen. What is measured then is how long the loop still commands
motion once it goes on, on the robot's clock.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import tempfile
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from websockets.exceptions import ConnectionClosed

from core.cell.folder import load_cell
from core.recording.folder import read_recording
from core.recording.recording import Recording
from core.robot.model import RobotModel
from core.sessions.sample_log import SampleLog
from server.runner.run_folder import LOCK, RECORDING
from server.runner.sample_stream import recover_recording as samples_so_far
from tests.server.real_service import ROOT, Console, RealService, real_service, wait_for

LIMIT_S = 0.3
LINK_S = 0.05
"""Beyond the lease, for a link that is lost."""
LOOK_S = 2.0
"""Beyond the lease, in which nobody helps."""
PHASES = ("transfer", "hold", "rotate")
STANDING = ("Held", "Stopped", "Aborted", "Complete")


def silent(_: RealService, console: Console, _run: str) -> None:
    """The console no longer answers stamps."""
    console.answering.clear()


def closed(_: RealService, console: Console, _run: str) -> None:
    """Its window is closed."""
    assert console.lease is not None
    console.lease.close()


def killed(service: RealService, _: Console, _run: str) -> None:
    """kill -9 of the server."""
    service.kill()


def frozen(service: RealService, _: Console, _run: str) -> None:
    """The server stands still."""
    service.send(signal.SIGSTOP)


def control_killed(service: RealService, _: Console, run: str) -> None:
    """kill -9 of the control process."""
    os.kill(control_process(service, run), signal.SIGKILL)


def control_frozen(service: RealService, console: Console, run: str) -> None:
    """The control process stands still, until the lease has long run out."""
    process = control_process(service, run)
    os.kill(process, signal.SIGSTOP)
    time.sleep(lease_s(console) + 0.5 * LOOK_S)
    os.kill(process, signal.SIGCONT)


def held(_: RealService, console: Console, run: str) -> None:
    """Somebody commands a hold."""
    console.command(run, "hold")


def stopped(_: RealService, console: Console, run: str) -> None:
    """Somebody commands a stop."""
    console.command(run, "stop")


def aborted(_: RealService, console: Console, run: str) -> None:
    """Somebody commands an abort."""
    console.command(run, "abort")


Blow = Callable[[RealService, Console, str], None]
LOST_LINK: tuple[Blow, ...] = (silent, closed)
BLOWS: tuple[Blow, ...] = (*LOST_LINK, held, stopped, aborted, killed, frozen, control_killed, control_frozen)


def control_process(service: RealService, run: str) -> int:
    """Identifier of the process that moves the run's robot: it has the run's folder locked."""
    lock = service.data / "recordings" / run / LOCK
    for process in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):  # it has ended meanwhile
            if any(file.samefile(lock) for file in (process / "fd").iterdir() if file.exists()):
                return int(process.name)
    raise AssertionError(f"no process moves the robot of {run}")


def lease_s(console: Console) -> float:
    """How long the robot of the console's cell moves on without an answer, s."""
    return float(console.http.get(f"/api/control/{console.cell}").json()["lease_s"])


class Watcher:
    """Follows a run, and knows what the robot's clock shows at which moment of ours."""

    def __init__(self, console: Console, run: str) -> None:
        self.phase, self.state = "", ""
        self.progress = 0.0
        self.offset_s = np.inf
        self.told: list[dict[str, Any]] = []
        """Every event with its sequence number, in the order in which they came."""
        self._live = console.socket(f"/api/runs/{run}/live")
        self.thread = threading.Thread(target=self._watch, daemon=True)
        """Ends when the service has told the end of the run."""
        self.thread.start()

    def _watch(self) -> None:
        with suppress(ConnectionClosed, OSError):
            for text in self._live:
                message = json.loads(text)
                if message["kind"] == "event":
                    self.told.append(message)
                    self.state = message["event"].get("state", self.state)
                else:
                    self.offset_s = min(self.offset_s, time.monotonic() - message["t_s"][-1])
                    self.phase, self.progress = message["phase"].partition(":")[0], message["progress"]


Found = tuple[float, float, float]
"""Time from the blow until the commanded speed is zero for good, how much of it the braking takes, and what is allowed beside that, s."""


def series(blows: list[Blow], folder: Path, seeds: list[int]) -> dict[tuple[str, str], list[Found]]:
    """Blows in every phase, once for each seed, to one service: see `measured`."""
    with real_service(folder) as service:
        return {(blow.__name__, phase): [measured(service, blow, phase, seed) for seed in seeds] for blow in blows for phase in PHASES}


def measured(service: RealService, blow: Blow, phase: str, seed: int) -> Found:
    """One blow."""
    while (found := struck(service, blow, phase, seed)) is None:
        print("the robot was held before the blow; once more", flush=True)
    print(f"{blow.__name__:14} {phase:9} {1e3 * found[0]:5.0f} ms, braking up to {1e3 * found[1]:4.0f} ms", flush=True)
    return found


def struck(service: RealService, blow: Blow, phase: str, seed: int) -> Found | None:
    """The same; None where the robot was held before the blow, on a machine that is too busy for it."""
    console = Console(service)
    console.take_control()
    run = console.queue(seed=seed, pace="real_time")
    console.wait(run, "Idle")
    watcher = Watcher(console, run)
    assert console.release(run).status_code == 200
    wait_for(lambda: watcher.phase == phase or watcher.state in STANDING, f"the phase {phase}", lambda: watcher.phase)
    if watcher.state in STANDING:
        console.leave()
        recover(service, run)
        return None
    time.sleep(float(np.random.default_rng(seed).uniform(0.05, 0.25)))
    lease = lease_s(console)
    struck_s = time.monotonic() - watcher.offset_s
    blow(service, console, run)
    time.sleep(lease + LOOK_S)
    console.leave()
    recover(service, run)
    return (*standstill(recorded(service, run), struck_s), lease + LINK_S if blow in LOST_LINK else LIMIT_S)


def recover(service: RealService, run: str) -> None:
    """Makes the service answer again; ends the run if it is on hold, clears it if it was aborted."""
    service.send(signal.SIGCONT)
    if service.process is None or service.process.poll() is not None:
        service.start()
    console = Console(service)
    if console.wait(run, *STANDING)["state"] == "Held":
        assert console.http.post(f"/api/runs/{run}/commands", json={"command": "stop"}).status_code == 200
        console.wait(run, "Stopped", "Aborted")
    if console.run(run)["state"] == "Aborted":
        console.take_control()
        wait_for(lambda: console.command(run, "clear").status_code == 200, f"{run} to be cleared")
    console.leave()


def recorded(service: RealService, run: str) -> Recording:
    """What was recorded; where the control process was killed before it wrote it, the samples that it left."""
    folder = service.data / "recordings" / run
    if not (folder / RECORDING).is_dir():
        cell = load_cell(ROOT / "cells" / "lwr4_bench")
        samples_so_far(folder, SampleLog(cell, RobotModel.of_cell(cell), payload=None, reference=None), folder / RECORDING)
    return read_recording(folder / RECORDING)


def standstill(recording: Recording, struck_s: float) -> tuple[float, float]:
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
        found: (n, 3), each a `Found`.
    """
    took, braking, allowed = found.T
    late = int((took > allowed + braking).sum())
    print(f"{what:14} {phase:9} worst {1e3 * took.max():5.0f} ms, braking up to {1e3 * braking.max():4.0f} ms, ", end="")
    print(f"allowed {1e3 * allowed.max():4.0f} ms plus braking, too late {late} of {len(found)}", flush=True)


def main() -> None:
    """Prints one line for each blow and each phase."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("blows", nargs="*", help=f"all, or some of {' '.join(blow.__name__ for blow in BLOWS)}")
    parser.add_argument("--times", type=int, default=3, help="of each blow in each phase")
    parser.add_argument("--at-once", type=int, default=1, help="services at the same time; more than there are cores make each other late")
    given = parser.parse_args()
    blows = [blow for blow in BLOWS if blow.__name__ in (given.blows or {each.__name__ for each in BLOWS})]
    print(f"time from the blow to zero commanded speed; allowed {1e3 * LIMIT_S:.0f} ms plus braking, ", end="")
    print(f"for a lost link the lease and {1e3 * LINK_S:.0f} ms plus braking")
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(given.at_once) as pool:
        seeds = [list(range(100, 100 + given.times))[k :: given.at_once] for k in range(given.at_once)]
        found = list(pool.map(partial(series, blows), [Path(folder) / str(k) for k in range(given.at_once)], seeds))
    print()
    for blow in blows:
        for phase in PHASES:
            say(blow.__name__, phase, np.concatenate([part[blow.__name__, phase] for part in found]))


if __name__ == "__main__":
    main()
