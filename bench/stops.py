"""How long the robot goes on moving when the console falls silent, or the server is killed or frozen, in each phase of a run.

Whole services over real sockets, the simulated robot in real time: `python -m bench.stops --repetitions 20`.
"""

from __future__ import annotations

import argparse
import json
import signal
import tempfile
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import numpy as np
from websockets.exceptions import ConnectionClosed

from core.cell import load_cell
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
    service.send(signal.SIGKILL)


def frozen(service: RealService, _: Console) -> None:
    """The server stands still."""
    service.send(signal.SIGSTOP)


BLOWS: tuple[Callable[[RealService, Console], None], ...] = (silent, closed, killed, frozen)


class Watcher:
    """Follows a run, and knows what the robot's clock shows at which moment of ours."""

    def __init__(self, console: Console, run: str) -> None:
        self.phase = ""
        self.offset_s = np.inf
        self._live = console.socket(f"/api/runs/{run}/live")
        threading.Thread(target=self._watch, daemon=True).start()

    def _watch(self) -> None:
        with suppress(ConnectionClosed, OSError):
            for text in self._live:
                message = json.loads(text)
                if message["kind"] == "samples":
                    self.offset_s = min(self.offset_s, time.monotonic() - message["t_s"][-1])
                    self.phase = message["phase"].partition(":")[0]


def measured(folder: Path, blow: Callable[[RealService, Console], None], phase: str, seed: int) -> tuple[float, float]:
    """Time from the blow until the commanded speed is zero for good, and how much of it the braking takes, s."""
    with real_service(folder) as service:
        console = Console(service)
        console.take_control()
        run = console.queue(seed=seed, pace="real_time")
        console.wait(run, "Idle")
        watcher = Watcher(console, run)
        assert console.release(run).status_code == 200
        wait_for(lambda: watcher.phase == phase, f"the phase {phase}", lambda: watcher.phase)
        time.sleep(float(np.random.default_rng(seed).uniform(0.05, 0.25)))
        blow(service, console)
        struck_s = time.monotonic() - watcher.offset_s
        recording = service.data / "recordings" / run / "recording"
        wait_for(recording.is_dir, "the recording")
        console.leave()
        samples = read_recording(recording)
        acceleration = np.array(load_cell(ROOT / "cells" / "lwr4_bench").robot.acceleration_rad_s2)
        assert samples.q_cmd is not None
        speed = np.abs(np.diff(samples.q_cmd, axis=0)) / np.diff(samples.t)[:, None]
        moving = np.flatnonzero((speed > 1e-6).any(axis=1))
        after = speed[samples.t[1:] >= struck_s]
        braking_s = float((after / acceleration).max()) if len(after) else 0.0
        return max(0.0, float(samples.t[moving[-1] + 1]) - struck_s), braking_s


def main() -> None:
    """Prints one line for each way to lose control and each phase."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repetitions", type=int, default=3)
    count = parser.parse_args().repetitions
    print(f"time from the blow to zero commanded speed; allowed {1e3 * LIMIT_S:.0f} ms plus braking")
    for blow in BLOWS:
        for phase in PHASES:
            with tempfile.TemporaryDirectory() as folder:
                found = np.array([measured(Path(folder) / str(k), blow, phase, 100 + k) for k in range(count)])
            late = int((found[:, 0] > LIMIT_S + found[:, 1]).sum())
            worst = 1e3 * found.max(axis=0)
            print(
                f"{blow.__name__:8} {phase:9} worst {worst[0]:5.0f} ms, braking up to {worst[1]:4.0f} ms, too late {late} of {count}",
                flush=True,
            )


if __name__ == "__main__":
    main()
