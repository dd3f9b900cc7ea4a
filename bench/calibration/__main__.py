"""Probabilities of the diagnosis, learnt from simulated trials.

python -m bench.calibration FOLDER [--count N] [--workers N | --dask tcp://HOST:8786] [--write]

Runs trials and appends each one's evidence to FOLDER/trials.jsonl; started again it goes on where it ended. Then the map from evidence to
probabilities is fitted, and judged by leaving out variants and unknown causes in turn. `--write` puts it where the diagnosis reads it;
the doubts that strangers have taught stay there, and are to be learnt again.
"""

from __future__ import annotations

import argparse
import sys
from datetime import UTC, datetime
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from bench.calibration.intervals import find_held_left_out, find_widened
from bench.calibration.learning import can_teach, learn, predict_left_out, stack
from bench.calibration.mattering import learn_mattering
from bench.calibration.scores import HEADER, find_coverage, find_outside, score
from bench.calibration.trial import Trial, run_trial
from bench.json_lines import append_results, read_results
from core.gap.weighing import FILE, Figures, Provenance, read_figures
from core.trial.batch import on_cluster, on_cores

FEWEST = 2
"""Trials that have to teach something: each is tried on what was learnt from the others."""

DOUBTS_ARE_OLDER = (
    "kept the doubts under `elsewhere`, learnt beside the figures before: learn them again by `python -m bench.calibration.strangers`"
)


def run_trials(path: Path, seeds: list[int], workers: int, dask: str | None) -> None:
    """Appends a line for each trial as it ends."""
    with on_cores(workers) if dask is None else on_cluster(dask) as executor:
        for trial in append_results(path, {executor.submit(run_trial, seed): seed for seed in seeds}):
            print(f"{trial.seed}: {trial.truth} {' '.join(trial.variants)}, gap {trial.gap:.2f}, {trial.seconds:.0f} s", flush=True)


def learn_figures(trials: list[Trial]) -> Figures:
    """Learns from all trials; prints how well figures do that were learnt without the variant or cause that they are tried on."""
    teaching = [trial for trial in trials if can_teach(trial)]
    there, left_out = predict_left_out(trials)
    learnt = score(trials, left_out)
    covered, size = find_coverage(trials, left_out)
    widened, payload_held = find_widened(trials, there), find_held_left_out(trials, there)
    print(HEADER, learnt.say("variants left out"), sep="\n")
    print(f"sets that are to hold the truth in 90 %: {100 * covered:.1f} %, {size:.1f} answers each")
    held = {} if payload_held is None else {"payload_held": round(payload_held, 3)}
    if payload_held is not None:
        print(f"95 % intervals of the payload, learnt from other trials, that hold the truth: {100 * payload_held:.1f} %")
    seeds = [trial.seed for trial in trials]
    return Figures(
        figures={name: round(value, 4) for name, value in learn(stack(teaching)).items()},
        outside=round(find_outside(trials, left_out), 4),
        matters={name: (round(at, 2), round(by, 2)) for name, (at, by) in learn_mattering(trials).items()},
        widened=round(widened, 2),
        provenance=Provenance(
            date=f"{datetime.now(UTC):%Y-%m-%d}",
            trials=len(trials),
            learnt_from=len(teaching),
            seeds=(min(seeds), max(seeds)),
            versions=tuple(sorted({trial.version for trial in trials})),
            scores={**learnt.as_numbers(), "covered": round(covered, 3), "set_size": round(size, 2), **held},
        ),
    )


def main() -> None:
    """Runs what lacks, then learns."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--count", type=int, default=250)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--dask", help="address of a scheduler that runs")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    path = arguments.folder / "trials.jsonl"
    done = {trial.seed for trial in read_results(path, Trial)}
    wanted = [seed for seed in range(arguments.first, arguments.first + arguments.count) if seed not in done]
    run_trials(path, wanted, arguments.workers, arguments.dask)
    trials = read_results(path, Trial)
    if sum(can_teach(trial) for trial in trials) < FEWEST:
        sys.exit(f"{len(trials)} trials, of which {sum(can_teach(trial) for trial in trials)} teach anything: at least {FEWEST} have to")
    elsewhere = read_figures().elsewhere
    figures = learn_figures(trials).model_copy(update={"elsewhere": elsewhere})
    print(figures.model_dump_json(indent=2))
    if arguments.write:
        FILE.write_text(figures.model_dump_json(indent=2) + "\n", encoding="utf-8")
        if elsewhere is not None:
            print(DOUBTS_ARE_OLDER, file=sys.stderr)


if __name__ == "__main__":
    main()
