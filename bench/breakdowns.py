"""How long the robot goes on moving when its sensor freezes or says nothing, its state stands still or the disk is full, in each phase.

A whole service, the simulated robot as fast as it can be computed, times on the robot's clock: `python -m bench.breakdowns --times 20`.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

import numpy as np

from bench.stops import LIMIT_S, PHASES, say
from core.cell import load_cell
from core.recording import Recording
from core.recording_folder import read_recording
from tests.server.breaking_robot import DISK_FULL, FROZEN, NAN, STALE, Told, seed_of, told
from tests.server.real_service import ROOT, Console, RealService, real_service, wait_for

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


def moments(recording: Recording, phase: str, rng: np.random.Generator, count: int) -> list[float]:
    """When to break: at random in the phase, s."""
    assert recording.phase is not None
    kinds = np.array([each.partition(":")[0] for each in recording.phase])
    fits = (kinds == phase) & (recording.t < recording.t[-1] - LATEST_S)
    return [float(t) for t in rng.choice(recording.t[fits], count, replace=False)]


def measured(service: RealService, console: Console, kind: int, at_s: float) -> tuple[float, float]:
    """Time from the breakdown until the commanded speed is zero for good, and how much of it the braking takes, s."""
    acceleration = np.array(load_cell(ROOT / "cells" / console.cell).robot.acceleration_rad_s2)
    while (found := broken(service, console, seed_of(kind, at_s))) is None:
        print("control was lost before anything broke; once more", flush=True)
        console.take_control()
    return found.stop_s, float((found.dq / acceleration).max())


def broken(service: RealService, console: Console, seed: int) -> Told | None:
    """What the arm was told after its breakdown."""
    run = console.queue(seed=seed)
    console.wait(run, "Idle")
    assert console.release(run).status_code == 200
    lost = console.wait(run, "Aborted")
    assert console.release(run).status_code == 409, "nothing moves again"
    wait_for(lambda: console.command(run, "clear").status_code == 200, f"{lost['reason']} to be cleared")
    return told(service.data / "recordings" / run)


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
                when = moments(expected, phase, rng, given.times)
                say(name, phase, np.array([measured(service, console, KINDS[name], at_s) for at_s in when]))
        console.leave()


if __name__ == "__main__":
    main()
