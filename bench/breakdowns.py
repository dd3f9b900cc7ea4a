"""How long the robot goes on moving when its sensor freezes or says nothing, its state stands still or the disk is full, in each phase.

A whole service, the simulated robot as fast as it can be computed, times on the robot's clock: `python -m bench.breakdowns --times 20`.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from bench.stops import LIMIT_S, PHASES, STANDING, Found, recover, say
from core.cell.folder import load_cell
from core.recording.folder import read_recording
from core.recording.recording import Recording
from tests.server.breaking_robot import DISK_FULL, FROZEN, NAN, STALE, Told, seed_of, told
from tests.server.real_service import ROOT, Console, RealService, real_service

KINDS = {"frozen sensor": FROZEN, "not a number": NAN, "stale state": STALE, "disk full": DISK_FULL}
LATEST_S = 3.0
"""Before the end of a run, nothing is broken: a run of another seed may be over by then."""


def undisturbed(service: RealService, console: Console) -> Recording:
    """A whole run, which tells when which phase is to be expected."""
    run = console.queue(seed=0)
    console.wait(run, "Idle")
    assert console.release(run).status_code == 200
    console.wait(run, "Complete")
    return read_recording(service.data / "recordings" / run / "recording")


def moments(recording: Recording, phase: str, rng: np.random.Generator) -> Iterator[float]:
    """When to break: at random in the phase, s."""
    assert recording.phase is not None
    kinds = np.array([each.partition(":")[0] for each in recording.phase])
    fits = recording.t[(kinds == phase) & (recording.t < recording.t[-1] - LATEST_S)]
    while True:
        yield float(rng.choice(fits))


def measured(service: RealService, console: Console, kind: int, when: Iterator[float]) -> Found:
    """One breakdown."""
    acceleration = np.array(load_cell(ROOT / "cells" / console.cell).robot.acceleration_rad_s2)
    while (found := broken(service, console, seed_of(kind, next(when)))) is None:
        print("the run was over, or on hold, before anything broke; once more", flush=True)
    return found.stop_s, float((found.dq / acceleration).max()), LIMIT_S


def broken(service: RealService, console: Console, seed: int) -> Told | None:
    """What the arm was told after its breakdown; None where there was none."""
    console.take_control()
    run = console.queue(seed=seed)
    console.wait(run, "Idle")
    assert console.release(run).status_code == 200
    state = console.wait(run, *STANDING)["state"]
    assert console.release(run).status_code == 409, "nothing moves again"
    recover(service, run)
    found = told(service.data / "recordings" / run)
    assert found is None or state != "Complete", f"{run} broke and went on"
    return found


def main() -> None:
    """Prints one line for each breakdown and each phase."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("kinds", nargs="*", help=f"all, or some of {', '.join(map(repr, KINDS))}")
    parser.add_argument("--times", type=int, default=3, help="of each breakdown in each phase")
    given = parser.parse_args()
    rng = np.random.default_rng(0)
    print(f"time from the breakdown to zero commanded speed; allowed {1e3 * LIMIT_S:.0f} ms plus braking")
    with tempfile.TemporaryDirectory() as folder, real_service(Path(folder), "tests.server.breaking_service") as service:
        console = Console(service)
        console.take_control()
        expected = undisturbed(service, console)
        for name in given.kinds or KINDS:
            for phase in PHASES:
                when = moments(expected, phase, rng)
                say(name, phase, np.array([measured(service, console, KINDS[name], when) for _ in range(given.times)]))
        console.leave()


if __name__ == "__main__":
    main()
