"""What a diagnosis makes of the recordings that intervals are counted on: python -m bench.diagnosis_of_conditions [--count N].

The recordings are those of `bench.conditions`: another generator's arms and payloads, and what real sensors, encoders and recorders do to
them. Most are sound, and any cause that is named there is a false alarm; of the others it is said what was planted. The payload that
the diagnosis has with the best set is held against that of `heft identify`, which is another fit of the same equations.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import NamedTuple

import numpy as np
from threadpoolctl import threadpool_limits

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from bench.conditions import CONDITIONS, INTERVAL
from core.array import Array
from core.estimation.identification import identify_recording
from core.gap.diagnosis import examine
from core.gap.fit_all import one_by_one
from tests.foreign_recordings import make

PLANTED = {
    "random walk 0.04 N/sqrt(s)": ("sensor_drift",),
    "tilt 0.5 deg, 4 ms, drift": ("base_tilt", "sensor_drift", "time_delay"),
    "gain 1 %": ("sensor_gain",),
    "mounting 0.5 deg": ("sensor_rotation",),
    "zeros 0.1 deg": ("joint_offset",),
}
"""What may be named, by condition; each recording draws its size, and small ones do not matter."""


class Answer(NamedTuple):
    """Of one recording: the verdict, the effects of the best set, the gap before and after.

    Args:
        apart: (10,), the payload with the effects less that of the identification, in the standard uncertainty of both together; NaN where
            either leaves it undetermined.
    """

    verdict: str
    named: tuple[str, ...]
    before: float
    after: float
    apart: Array


def diagnose_one(job: tuple[str, int]) -> Answer:
    """Makes the recording of one condition and seed, and diagnoses it."""
    name, seed = job
    recording = make(CONDITIONS[name], seed).recording
    with threadpool_limits(1):
        told, evidence = examine(recording, fit_all=one_by_one)
        identified = identify_recording(recording).estimate
    if told.gap is None or told.payload is None or evidence is None:
        return Answer(told.verdict, (), np.nan, np.nan, np.full(10, np.nan))
    best = tuple(sorted(effect.id for effect in evidence.best.effects))
    apart, after = np.full(10, np.nan), told.payload.after
    if identified is not None:
        both = np.where(identified.determined & after.determined, np.hypot(identified.std, after.std), np.nan)
        apart = (np.array(after.phi) - identified.phi) / both
    return Answer(told.verdict, best, told.gap.before, told.gap.after, apart)


def say(name: str, answers: list[Answer]) -> str:
    """The line of one condition."""
    verdicts = ", ".join(f"{verdict} {count}" for verdict, count in Counter(answer.verdict for answer in answers).most_common())
    named = Counter("+".join(answer.named) for answer in answers if answer.verdict in ("explained", "ambiguous"))
    gaps = np.array([(answer.before, answer.after) for answer in answers])
    before, after = f"{np.nanmin(gaps[:, 0]):.2f}-{np.nanmax(gaps[:, 0]):.2f}", f"{np.nanmax(gaps[:, 1]):.2f}"
    return f"{name:28}{len(answers):4}  gap {before:12} after at most {after:7}{verdicts:32}{_say_apart(answers)}  {dict(named) or ''}"


def _say_apart(answers: list[Answer]) -> str:
    """How many of the payload's parameters are further apart than a 95 % interval of the difference."""
    apart = np.abs(np.concatenate([answer.apart for answer in answers]))
    apart = apart[np.isfinite(apart)]
    return f"{(apart > INTERVAL).sum()} of {len(apart)} contradict heft identify"


def is_false(name: str, answer: Answer) -> bool:
    """Whether something is named, or called unknown, that nobody planted."""
    if answer.verdict in ("no_gap", "not_enough"):
        return False
    return answer.verdict == "unknown" or not set(answer.named) <= set(PLANTED.get(name, ()))


def main() -> None:
    """Prints a line for each condition, and how many answers are false."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=4, help="recordings of each condition")
    parser.add_argument("--first", type=int, default=0, help="seed of the first recording")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--only", default="", help="conditions whose names contain this")
    arguments = parser.parse_args()
    false, every = 0, list[Answer]()
    with ProcessPoolExecutor(arguments.processes) as pool:
        for name in (name for name in CONDITIONS if arguments.only in name):
            seeds = range(arguments.first, arguments.first + arguments.count)
            answers = list(pool.map(diagnose_one, [(name, seed) for seed in seeds]))
            print(say(name, answers), flush=True)
            false += sum(is_false(name, answer) for answer in answers)
            every += answers
    print(f"named or called unknown though nobody planted it: {false} of {len(every)}; payload {_say_apart(every)}")


if __name__ == "__main__":
    main()
