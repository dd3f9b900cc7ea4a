"""Whether slips of the set-up are found, and nothing else is taken for one: `python -m bench.setup_slips --each 5 --sound 200`.

The recordings come from `tests.independent_logs`, which shares no code with the engine: fourteen kinds of slip, and sound recordings of ten
kinds with imperfect sensors, clocks, bases and encoders. `--harmless` counts what is said of sound recordings by an identification, and
`--real FOLDER` checks the recordings in the folders below it, all of which count as sound.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from core.estimation.identification import identify_recording
from core.estimation.setup.check import SetUp, check_setup
from core.recording.folder import read_recording
from core.recording.recording import Recording
from core.words.message import Message
from tests.independent_logs import SLIPS, SOUND, Log, Setting, draw_plate, draw_rod, make_log, slipped_log, sound_log

NAMED = {
    "sign": ("setup-wrench-sign",),
    "frame": ("setup-wrench-in-base",),
    "inverse": ("setup-rotation-inverted",),
    "quaternion": ("setup-quaternions-wxyz",),
    "force unit": ("setup-force-in",),
    "torque unit": ("setup-torque-in",),
    "time unit": ("setup-time-in",),
    "angle unit": ("setup-joints-in-degrees",),
    "gravity": ("setup-gravity-along", "setup-gravity-opposite"),
    "joints": ("setup-joints-exchanged", "setup-joint-negative"),
    "millimetres": ("setup-positions-in-millimetres",),
    "axes": ("setup-axes-of-both", "setup-force-and-torque-exchanged"),
    "torque point": ("setup-torque-about-another-point",),
    "rate": ("setup-clock-slow", "setup-clock-fast"),
}
"""Codes of the messages that name each slip."""


def read_log(log: Log) -> Recording:
    """What our reader makes of it."""
    with tempfile.TemporaryDirectory() as folder:
        return read_recording(log.write(Path(folder) / "log"))


def check_slip(name: str, seed: int) -> tuple[str, float]:
    """`named`, `named first`, `refused` or `missed`, and the time that it took, s."""
    recording = read_log(slipped_log(name, seed))
    began = time.perf_counter()
    found = check_setup(recording).contradiction
    taken = time.perf_counter() - began
    if found is None:
        return "missed", taken
    codes = [code for code in codes_of(found) if code not in ("setup-either", "setup-both")]
    named = [code in NAMED[name] for code in codes]
    return ("named first" if named[1:2] == [True] else "named" if any(named) else "refused"), taken


def codes_of(message: Message) -> list[str]:
    """Of a message and those that it names, from the outside in."""
    inner = [code for value in message.parameters.values() if isinstance(value, Message) for code in codes_of(value)]
    return [message.code, *inner]


def check_sound(seed: int) -> SetUp:
    """What is said of a sound recording."""
    return check_setup(read_log(sound_log(seed)))


def identify_harmless(kind: str, seed: int) -> list[str]:
    """Codes of all warnings of a sound recording with white noise and nothing else: any payload, a true plate, or a true rod."""
    rng = np.random.default_rng([seed, 5])
    setting = Setting(rate_hz=float(rng.choice([250.0, 500.0])), stated=bool(seed % 2))
    load = draw_plate(rng) if kind == "plate" else draw_rod(rng) if kind == "rod" else None
    found = identify_recording(read_log(make_log(("motion", "poses")[seed // 2 % 2], rng, setting, load)))
    return [warning.code for warning in found.warnings] + ([] if found.estimate is not None else ["none"])


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--each", type=int, default=5)
    parser.add_argument("--sound", type=int, default=200)
    parser.add_argument("--harmless", type=int, default=0)
    parser.add_argument("--real", type=Path, default=None)
    parser.add_argument("--processes", type=int, default=2)
    arguments = parser.parse_args()
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    with ProcessPoolExecutor(arguments.processes) as pool:
        missed = 0
        for name in SLIPS:
            answers = list(pool.map(partial(check_slip, name), range(arguments.each)))
            counts = Counter(answer for answer, _ in answers)
            missed += counts["missed"]
            print(f"{name:14s} {dict(counts)}, {max(taken for _, taken in answers):.2f} s at most", flush=True)
        print(f"missed: {missed} of {arguments.each * len(SLIPS)}")
        alarms = list(zip(range(arguments.sound), pool.map(check_sound, range(arguments.sound)), strict=True))
        for seed, found in alarms:
            for said in ([found.contradiction] if found.contradiction else []) + list(found.remarks):
                print(f"sound {seed} ({SOUND[seed % len(SOUND)]}): {said}")
        print(f"false alarms: {sum(found.contradiction is not None for _, found in alarms)} of {arguments.sound} sound recordings")
        for kind in ("any", "plate", "rod") if arguments.harmless else ():
            codes = Counter(code for each in pool.map(partial(identify_harmless, kind), range(arguments.harmless)) for code in each)
            print(f"warnings of {arguments.harmless} harmless recordings, {kind}: {dict(codes)}", flush=True)
    for manifest in sorted(arguments.real.rglob("recording.json")) if arguments.real else ():
        found = check_setup(read_recording(manifest.parent))
        print(f"real, {manifest.parent.name}: {found.contradiction or 'sound'}{''.join(f'; {each}' for each in found.remarks)}")


if __name__ == "__main__":
    main()
