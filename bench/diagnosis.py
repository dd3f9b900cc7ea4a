"""How long a diagnosis takes: where the gap lies, the full answer, and how both grow with the recording and the number of effects; of a
stiff arm, and of one whose joints swing on their springs.

python -m bench.diagnosis [--long SECONDS]

With `--long` a recording of so many seconds at 500 Hz, of another generator's arm, its wrench 40 ms late: time and memory.
"""

from __future__ import annotations

import argparse
import resource
import sys
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np
import psutil

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from core.effects.effect import Effect
from core.effects.library import library
from core.events import drive
from core.gap.basis import basis_of
from core.gap.diagnosis import diagnose
from core.gap.effect_fit import fit_nominal
from core.gap.evidence import gather
from core.gap.residual import Residual
from core.gap.windows import Windows
from core.plant.faults import Setting
from core.plant.faults.arm_imperfections import draw_arm_imperfections
from core.plant.imperfections import Imperfections
from core.procedure.identify import carry_out
from core.recording.recording import Recording
from core.sessions.simulated import SimulatedSession
from core.trial import plan_each_payload
from tests.foreign_recordings import make_long


def record_late(*, swinging: bool) -> Recording:
    """A run with 10 ms of delay, every second sample: 500 Hz."""
    cell, plans = plan_each_payload("lwr4_bench")
    carried = cell.payloads["cylinder"]
    late = Imperfections(wrench_delay_s=0.01)
    faults = draw_arm_imperfections(Setting(cell, carried.parameters, plans["cylinder"].robot_s)) if swinging else ()
    session = SimulatedSession(cell, carried.parameters, seed=1, imperfections=late, faults=faults)
    return thinned(drive(carry_out(cell, session, carried.box, plans["cylinder"])).recording, slice(None, None, 2))


def thinned(recording: Recording, rows: slice) -> Recording:
    """Some of the samples."""
    columns = ("t", "wrench", "q", "dq", "q_cmd", "tau", "phase")
    return replace(recording, **{name: values[rows] for name in columns if (values := getattr(recording, name)) is not None})


def diagnose_long(seconds: float, rate_hz: float = 500.0, late_s: float = 0.04) -> None:
    """Prints what a long recording takes."""
    pieces = list(make_long(seconds, rate_hz, 0).pieces)
    t, wrench, q = (np.concatenate([np.asarray(getattr(piece, name)) for piece in pieces]) for name in ("t", "wrench", "q"))
    late = round(late_s * rate_hz)
    wrench[late:] = wrench[:-late].copy()
    began = time.perf_counter()
    with watched_memory() as bytes_seen:
        told = diagnose(replace(pieces[0], t=t, wrench=wrench, q=q))
    took, inside = time.perf_counter() - began, resource.getrusage(resource.RUSAGE_CHILDREN)
    fits_s = inside.ru_utime + inside.ru_stime
    print(f"{seconds:.0f} s: {told.verdict}, {took:.0f} s by the clock, {fits_s:.0f} s of processor time in fits")
    print(f"memory of all processes together, what they share counted once: {max(bytes_seen) / 1e9:.2f} GB")


@contextmanager
def watched_memory() -> Iterator[list[int]]:
    """Bytes that this process and those it starts take together (proportional set size), ten times a second until it is left."""
    seen, left = [_find_memory()], threading.Event()

    def watch() -> None:
        while not left.wait(0.1):
            seen.append(_find_memory())

    watcher = threading.Thread(target=watch)
    watcher.start()
    try:
        yield seen
    finally:
        left.set()
        watcher.join()


def _find_memory() -> int:
    own = psutil.Process()
    total = 0
    for process in (own, *own.children(recursive=True)):
        try:
            total += int(process.memory_full_info().pss)
        except psutil.NoSuchProcess:  # ended meanwhile
            continue
    return total


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--long", type=float, default=None, metavar="SECONDS")
    seconds = parser.parse_args().long
    if seconds is not None:
        diagnose_long(seconds)
        return
    print(f"{'arm':>10}{'recording, s':>14}{'effects':>9}{'where, s':>10}{'full answer, s':>16}")
    stiff, swinging = (record_late(swinging=each) for each in (False, True))
    for share in (0.5, 1.0):
        for effects in (library()[::3], library()):
            print_times("stiff", thinned(stiff, slice(0, round(share * len(stiff)))), effects)
    print_times("swinging", swinging, library())


def print_times(arm: str, recording: Recording, effects: Sequence[Effect]) -> None:
    """One row of the table."""
    began = time.perf_counter()
    windows = Windows(basis_of(recording))
    Residual(windows, fit_nominal(windows)).describe()
    where = time.perf_counter() - began
    gather(windows, effects)
    print(f"{arm:>10}{np.ptp(recording.t):14.1f}{len(effects):9d}{where:10.2f}{time.perf_counter() - began:16.1f}", flush=True)


if __name__ == "__main__":
    main()
