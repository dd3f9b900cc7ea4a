"""Whether runs of one payload with different plans are called different: `python -m bench.eight_plans --count 10`.

Each cell has its own arm, payload and zeros of the joints, wrong by 0.05 deg; eight recordings are made in it along paths of their own, by
a generator without the engine's code (`tests.foreign_recordings`), identified, and compared in pairs as `heft compare` does.
"""

from __future__ import annotations

import argparse
import os
import sys
from concurrent.futures import ProcessPoolExecutor
from itertools import repeat
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from core.estimation.identification import identify_recording
from core.estimation.result import SecondsPart, result_of
from core.estimation.series import measure_result
from core.payload.comparison import SIGNIFICANT
from core.payload.random_effects import Measured
from core.payload.series import compare_series
from tests.foreign_recordings import Condition, make

ZEROS = Condition(zero_std_rad=0.05 * np.pi / 180.0)


def run_plan(seed: int, plan: int) -> Measured:
    """One recording in the cell of a seed, identified."""
    recording = make(ZEROS, seed, plan).recording
    return measure_result(result_of(identify_recording(recording), recording, seconds=SecondsPart(estimate=0.0)))


def main() -> None:
    """Prints a line for each cell, and the share of pairs that are called different."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=10, help="cells")
    parser.add_argument("--first", type=int, default=0, help="seed of the first cell")
    parser.add_argument("--plans", type=int, default=8)
    parser.add_argument("--processes", type=int, default=2)
    arguments = parser.parse_args()
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    names = [f"plan {k + 1}" for k in range(arguments.plans)]
    apart = pairs = called = 0
    with ProcessPoolExecutor(arguments.processes) as pool:
        for seed in range(arguments.first, arguments.first + arguments.count):
            series = compare_series(names, list(pool.map(run_plan, repeat(seed), range(arguments.plans))))
            chances = [pair.chance for pair in series.pairs if pair.chance is not None]
            here = sum(chance < SIGNIFICANT for chance in chances)
            apart, pairs, called = apart + here, pairs + len(chances), called + series.differ
            print(
                f"cell {seed}: {here} of {len(chances)} pairs below 1 %, the eight together: chance {series.chance or 0.0:.3f}", flush=True
            )
    share = 100.0 * apart / max(pairs, 1)
    print(f"{apart} of {pairs} pairs ({share:.1f} %) differ at p < 1 %; {called} of {arguments.count} series are called so")


if __name__ == "__main__":
    main()
