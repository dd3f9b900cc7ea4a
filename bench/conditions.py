"""Whether 95 % intervals hold the truth under the conditions of real recordings: `python -m bench.conditions --count 200`.

The recordings come from a generator that shares no code with the engine (`tests.foreign_recordings`); what is wrong with each is drawn from
the standard uncertainty that it states. With `--keep FOLDER` every recording's outcome is appended to a file of its condition, so that a
count can be stopped and continued; `--show` prints what such a folder has so far.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import sys
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from core.array import Array

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from core.estimation.identification import identify_recording
from core.payload.inertia import PHI_NAMES
from tests.foreign_bound import least_std
from tests.foreign_recordings import Body, Condition, Noise, make

INTERVAL = 1.96
DEGREE = np.pi / 180.0
NOISES: tuple[Noise, ...] = ("white", "white", "ar1", "pink")
BODIES: tuple[Body, ...] = ("compact", "plate", "rod", "far")
CONDITIONS = {
    "white, 1000 Hz": Condition(rate_hz=1000.0),
    "white, 500 Hz": Condition(),
    "white, 250 Hz": Condition(rate_hz=250.0),
    "white, 100 Hz": Condition(rate_hz=100.0),
    "AR(1) 0.9": Condition(noise="ar1"),
    "pink": Condition(noise="pink"),
    "random walk 0.04 N/sqrt(s)": Condition(walk_n=0.04),
    "jitter 1 ms, 250 Hz": Condition(rate_hz=250.0, jitter_s=1e-3),
    "5 % of the rows lost": Condition(lost=0.05),
    "20 % of the rows lost": Condition(lost=0.2),
    "quantised": Condition(quantised=True),
    "zeros 0.05 deg": Condition(zero_std_rad=0.05 * DEGREE),
    "zeros 0.1 deg": Condition(zero_std_rad=0.1 * DEGREE),
    "tilt 0.5 deg, 4 ms, drift": Condition(tilt_rad=0.5 * DEGREE, delay_s=4e-3, drift_n=0.3),
    "gain 0.2 %": Condition(gain_std=0.002),
    "gain 1 %": Condition(gain_std=0.01),
    "mounting 0.5 deg": Condition(mount_std_rad=0.5 * DEGREE),
    "orientation only": Condition(poses=True),
    "averaged static poses": Condition(averaged=True),
    "turns about one axis": Condition(one_axis=True),
    "plate": Condition(body="plate"),
    "rod": Condition(body="rod"),
    "payload 0.3 m away": Condition(body="far"),
}

AT_ONCE = "several at once"
"""A condition drawn anew for each recording, of everything that the generator can do: what none of the others was made for."""


def condition_of(name: str, seed: int) -> Condition:
    """Of one recording."""
    if name != AT_ONCE:
        return CONDITIONS[name]
    rng = np.random.default_rng([seed, 777])
    rate_hz = float(rng.choice([10, 20, 30, 50, 62.5, 100, 125, 200, 250, 333, 500, 800, 1000, 2000]))
    return Condition(
        rate_hz=rate_hz,
        noise=NOISES[int(rng.integers(len(NOISES)))],
        walk_n=float(rng.choice([0.0, 0.0, 0.0, 0.04])),
        jitter_s=float(rng.choice([0.0, 0.0, 2e-4, 1e-3])) if rate_hz < 400.0 else 0.0,
        lost=float(rng.choice([0.0, 0.0, 0.05, 0.2])),
        quantised=bool(rng.random() < 0.3),
        zero_std_rad=float(rng.choice([0.0, 0.02, 0.05, 0.1])) * DEGREE,
        gain_std=float(rng.choice([0.0, 0.0, 0.002, 0.01])),
        mount_std_rad=float(rng.choice([0.0, 0.0, 0.2, 0.5])) * DEGREE,
        tilt_rad=float(rng.choice([0.0, 0.0, 0.2, 0.5, 1.5])) * DEGREE,
        delay_s=float(rng.choice([0.0, 0.0, 2e-3, 4e-3, 0.02, 0.08, 0.3])),
        drift_n=float(rng.choice([0.0, 0.0, 0.3, 1.0])),
        poses=bool(rng.random() < 0.15),
        one_axis=bool(rng.random() < 0.1),
        body=BODIES[int(rng.integers(len(BODIES)))],
    )


@dataclass(frozen=True)
class Outcome:
    """Of one recording: errors and standard uncertainties (10,), combined and by repeatability alone, NaN where not known; warnings.

    Args:
        least: (10,), bound of Cramér and Rao on the combined one; NaN where it is not worked out.
    """

    error: Array
    std: Array
    repeatability: Array
    least: Array
    warnings: tuple[str, ...]


def outcome_of(job: tuple[str, int]) -> Outcome:
    """Makes the recording of one condition and seed, and identifies it."""
    name, seed = job
    condition = condition_of(name, seed)
    made = make(condition, seed)
    found = identify_recording(made.recording)
    codes = tuple(warning.code for warning in found.warnings)
    if found.estimate is None:
        nothing = np.full(10, np.nan)
        return Outcome(nothing, nothing, nothing, nothing, codes)
    estimate, least = found.estimate, None if name == AT_ONCE else least_std(condition, made)
    least = np.full(10, np.nan) if least is None else least
    return Outcome(estimate.phi - made.phi, estimate.std, estimate.repeatability.std, least, codes)


def coverage(outcomes: list[Outcome]) -> Array:
    """(10,), share of the 95 % intervals that hold the truth, of those that are given."""
    z = np.abs([each.error / each.std for each in outcomes])
    given = np.isfinite(z).sum(axis=0)
    return np.asarray(np.where(given > 0, (z <= INTERVAL).sum(axis=0) / np.maximum(given, 1), np.nan))


def widths_over_bound(outcomes: list[Outcome]) -> Array:
    """(10,), mean standard uncertainty over its bound; NaN where either is not known."""
    ratio = np.array([each.std / each.least for each in outcomes])
    known = np.isfinite(ratio)
    return np.asarray(np.where(known.any(axis=0), np.where(known, ratio, 0.0).sum(axis=0) / np.maximum(known.sum(axis=0), 1), np.nan))


def _say_widths(outcomes: list[Outcome]) -> str:
    ratio = widths_over_bound(outcomes)
    if np.isnan(ratio).all():
        return "width over the bound -"
    return f"width over the bound {np.nanmin(ratio):.2f} to {np.nanmax(ratio):.2f} ({PHI_NAMES[int(np.nanargmax(ratio))]})"


class Kept:
    """Outcomes of one condition by seed, in a file of lines; in memory alone where there is no folder."""

    def __init__(self, folder: Path | None, name: str) -> None:
        self._file = None if folder is None else folder / f"{re.sub('[^a-z0-9]+', '-', name.lower()).strip('-')}.jsonl"
        self.outcomes: dict[int, Outcome] = {}
        if self._file is not None and self._file.exists():
            for line in map(json.loads, self._file.read_text().splitlines()):
                arrays = {key: np.array(line[key]) for key in ("error", "std", "repeatability", "least")}
                self.outcomes[line["seed"]] = Outcome(**arrays, warnings=tuple(line["warnings"]))

    def add(self, seed: int, outcome: Outcome) -> None:
        """Keeps one more."""
        self.outcomes[seed] = outcome
        if self._file is not None:
            line = {key: value.tolist() if isinstance(value, np.ndarray) else value for key, value in asdict(outcome).items()}
            with self._file.open("a") as file:
                file.write(json.dumps({"seed": seed, **line}) + "\n")


def say(name: str, outcomes: list[Outcome]) -> str:
    """The line of one condition."""
    said = Counter(code.removeprefix("estimation-") for each in outcomes for code in each.warnings)
    half = INTERVAL * np.nanmedian([[each.std[0], each.repeatability[0]] for each in outcomes], axis=0)
    cells = "".join(f"{'-' if np.isnan(share) else f'{100 * share:.0f}':>6}" for share in coverage(outcomes))
    widths = _say_widths(outcomes)
    return f"{name:28}{len(outcomes):5}{cells}   {half[0]:.5f} ({half[1]:.5f}) kg  {dict(said) or ''}  {widths}"


def count(pool: ProcessPoolExecutor, name: str, kept: Kept, seeds: range) -> None:
    """The recordings of one condition that are not there yet."""
    missing = [seed for seed in seeds if seed not in kept.outcomes]
    for seed, outcome in zip(missing, pool.map(outcome_of, [(name, seed) for seed in missing]), strict=True):
        kept.add(seed, outcome)


def _names(asked: str) -> Iterator[str]:
    """Conditions in the order in which they are asked for, parts of names that are separated by bars."""
    for part in asked.split("|"):
        yield from (name for name in (*CONDITIONS, AT_ONCE) if part in name)


def main() -> None:
    """Prints a line for each condition, and the worst figure of all."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=200, help="recordings of each condition")
    parser.add_argument("--first", type=int, default=0, help="seed of the first recording")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--only", default="", help="conditions whose names contain this, in this order where it is several: 'pink|rod'")
    parser.add_argument("--keep", type=Path, default=None, help="folder of what has been done, to be continued")
    parser.add_argument("--show", action="store_true", help="what is kept, and nothing new")
    arguments = parser.parse_args()
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    if arguments.keep is not None:
        arguments.keep.mkdir(parents=True, exist_ok=True)
    columns = "   median half-width of m, all in (repeatability alone); warnings; mean width over the Cramér-Rao bound"
    print(f"{'':28}{'n':>5}" + "".join(f"{name:>6}" for name in PHI_NAMES) + columns)
    worst = ("", 1.0)
    with ProcessPoolExecutor(arguments.processes) as pool:
        for name in _names(arguments.only):
            kept = Kept(arguments.keep, name)
            if not arguments.show:
                count(pool, name, kept, range(arguments.first, arguments.first + arguments.count))
            if not kept.outcomes:
                continue
            outcomes = list(kept.outcomes.values())
            shares = coverage(outcomes)
            print(say(name, outcomes), flush=True)
            if not np.isnan(shares).all() and np.nanmin(shares) < worst[1]:
                worst = (name, float(np.nanmin(shares)))
    print(f"worst: {100 * worst[1]:.0f} % ({worst[0]})")


if __name__ == "__main__":
    main()
