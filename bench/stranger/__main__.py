"""Diagnoses of recordings by somebody who had read the specification and not a line of core; or by later ones, who had not.

python -m bench.stranger FOLDER [--of {first,second,third,fourth,fifth}] [--only NAMES] [--processes P]

Makes 80 recordings (72 of the second, 60 of the third, 48 of the fourth, 100 of the fifth) into FOLDER/recordings and FOLDER/truth.json
where they are missing, and diagnoses each; started again it goes on where it ended. Each stranger needs a folder of its own. The answers
are lines of FOLDER/diagnoses.jsonl. Names are numbers of recordings, or causes as they are called in `bench/stranger/causes`
(`bench/second_stranger/causes`, and so on to `bench/fifth_stranger/causes`), separated by commas.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterable
from concurrent.futures import Executor, as_completed
from pathlib import Path

from bench.json_lines import append_results, read_results
from bench.stranger.answer import Answer
from bench.stranger.diagnosing import diagnose
from bench.stranger.score import TRUTHS, print_held, print_score, read_planted, read_truths
from bench.stranger.sets import SETS, Recording
from core.trial.batch import on_cores


def choose(recordings: list[Recording], only: str | None) -> list[Recording]:
    """All, or those of numbers or names."""
    if only is None:
        return recordings
    wanted = set(only.split(","))
    known = {name for each in recordings for name in _list_names(each)}
    if not wanted <= known:
        sys.exit(f"unknown: {', '.join(sorted(wanted - known))}; known are 001 to {len(recordings):03d} and {', '.join(sorted(known))}")
    return [each for each in recordings if wanted.intersection(_list_names(each))]


def _list_names(recording: Recording) -> set[str]:
    return {recording.number, recording.name, *recording.name.split("+")}


def make_missing(folder: Path, recordings: Iterable[Recording], pool: Executor) -> None:
    """Writes recordings, and the truth about each after it."""
    truths = read_truths(folder)
    missing = [each for each in recordings if each.number not in truths or not _find_recording(folder, each).exists()]
    made = {pool.submit(each.make, _find_recording(folder, each)): each.number for each in missing}
    for future in as_completed(made):
        number = made[future]
        truths[number] = future.result()
        partly = folder / "truth.json.new"
        partly.write_text(json.dumps(dict(sorted(truths.items())), indent=1))
        partly.replace(folder / TRUTHS)
        print(f"{number} made", flush=True)


def _find_recording(folder: Path, recording: Recording) -> Path:
    return folder / "recordings" / recording.number


def diagnose_missing(folder: Path, recordings: Iterable[Recording], pool: Executor) -> None:
    """Appends a line for each as it ends."""
    path = folder / "diagnoses.jsonl"
    done = {answer.case for answer in read_results(path, Answer)}
    missing = [each for each in recordings if each.number not in done]
    asked = {pool.submit(diagnose, _find_recording(folder, each)): each.number for each in missing}
    for answer in append_results(path, asked):
        print(f"{answer.case} {answer.named}, {answer.cpu:.0f} s", flush=True)


def main() -> None:
    """Makes what lacks, diagnoses what is not diagnosed, and prints the score."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--of", choices=SETS, default="first", help="which stranger's recordings")
    parser.add_argument("--only", help="numbers or names, separated by commas")
    parser.add_argument("--processes", type=int, default=2)
    arguments = parser.parse_args()
    folder: Path = arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    recordings = choose(SETS[arguments.of](), arguments.only)
    with on_cores(arguments.processes) as pool:
        make_missing(folder, recordings, pool)
        diagnose_missing(folder, recordings, pool)
    numbers = {each.number for each in recordings}
    truths = read_planted(folder)
    answers = {answer.case: answer for answer in read_results(folder / "diagnoses.jsonl", Answer) if answer.case in numbers}
    print_score(truths, answers)
    if arguments.of != "first":  # whose references are off by 0.1 %, as those of drawings are
        print_held(truths, answers)


if __name__ == "__main__":
    main()
