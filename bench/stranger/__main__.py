"""Diagnoses of recordings by somebody who had read the specification and not a line of core.

python -m bench.stranger FOLDER [--only NAMES] [--processes P]

Makes 80 recordings into FOLDER/recordings and FOLDER/truth.json where they are missing, and diagnoses each; started again it goes on where
it ended. The answers are lines of FOLDER/diagnoses.jsonl. Names are numbers of recordings, or causes as they are called in
`bench/stranger/causes`, separated by commas.
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
from bench.stranger.making import Truth, make_case
from bench.stranger.plan import Case, list_cases
from bench.stranger.score import Planted, print_score
from core.trial.batch import on_cores


def choose_cases(only: str | None) -> list[Case]:
    """All, or those of numbers or names."""
    cases = list_cases()
    if only is None:
        return cases
    wanted = set(only.split(","))
    known = {name for case in cases for name in _list_names(case)}
    if not wanted <= known:
        sys.exit(f"unknown: {', '.join(sorted(wanted - known))}; known are 001 to {len(cases):03d} and {', '.join(sorted(known))}")
    return [case for case in cases if wanted.intersection(_list_names(case))]


def _list_names(case: Case) -> set[str]:
    return {case.number, case.order.name, *case.order.name.split("+")}


def read_truths(folder: Path) -> dict[str, Truth]:
    """Of the recordings that are there whole."""
    path = folder / "truth.json"
    return json.loads(path.read_text()) if path.exists() else {}


def make_missing(folder: Path, cases: Iterable[Case], pool: Executor) -> None:
    """Writes recordings, and the truth about each after it."""
    truths = read_truths(folder)
    missing = [case for case in cases if case.number not in truths or not _find_recording(folder, case).exists()]
    made = {pool.submit(make_case, case, _find_recording(folder, case)): case for case in missing}
    for future in as_completed(made):
        case = made[future]
        truths[case.number] = future.result()
        partly = folder / "truth.json.new"
        partly.write_text(json.dumps(dict(sorted(truths.items())), indent=1))
        partly.replace(folder / "truth.json")
        print(f"{case.number} made", flush=True)


def _find_recording(folder: Path, case: Case) -> Path:
    return folder / "recordings" / case.number


def diagnose_missing(folder: Path, cases: Iterable[Case], pool: Executor) -> None:
    """Appends a line for each as it ends."""
    path = folder / "diagnoses.jsonl"
    done = {answer.case for answer in read_results(path, Answer)}
    asked = {pool.submit(diagnose, _find_recording(folder, case)): case.number for case in cases if case.number not in done}
    for answer in append_results(path, asked):
        print(f"{answer.case} {answer.named}, {answer.cpu:.0f} s", flush=True)


def main() -> None:
    """Makes what lacks, diagnoses what is not diagnosed, and prints the score."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", help="numbers or names, separated by commas")
    parser.add_argument("--processes", type=int, default=2)
    arguments = parser.parse_args()
    folder: Path = arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    cases = choose_cases(arguments.only)
    with on_cores(arguments.processes) as pool:
        make_missing(folder, cases, pool)
        diagnose_missing(folder, cases, pool)
    numbers = {case.number for case in cases}
    truths = {number: Planted.model_validate(truth) for number, truth in read_truths(folder).items()}
    answers = {answer.case: answer for answer in read_results(folder / "diagnoses.jsonl", Answer) if answer.case in numbers}
    print_score(truths, answers)


if __name__ == "__main__":
    main()
