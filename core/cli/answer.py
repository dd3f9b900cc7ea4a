"""The answer of an identification on a terminal or as JSON."""

import sys
from pathlib import Path

from core.cli.joints_table import joints_table
from core.cli.tables import (
    assumption_lines,
    parameters_table,
    reason_lines,
    tabulate_budget,
    verification_lines,
)
from core.cli.terminal import answers, find_wording
from core.cli.workpiece_table import workpiece_lines, workpiece_table
from core.estimation.result import Result
from core.files.whole_file import write_whole
from core.report.requirement_words import verdict_sign


def print_answer(result: Result, json: str | None) -> None:
    """The answer for a person, or as JSON."""
    if json is not None:
        write_json(result.model_dump_json(indent=2), json)
    if json == "-":
        return
    words = find_wording()
    answers.print(parameters_table(result))
    if result.workpiece is not None:
        answers.print(workpiece_table(result.workpiece))
        for line in workpiece_lines(result.workpiece):
            answers.print(line, highlight=False)
    if result.estimate is not None and result.estimate.budget is not None and result.estimate.determined[0]:
        answers.print(tabulate_budget(result.estimate.budget, result))
    if result.joints:
        answers.print(joints_table(result.joints))
    for line in reason_lines(result):
        answers.print(line, highlight=False)
    if result.accounted:
        answers.print(words.say("result-accounted", effects=result.accounted), highlight=False)
    for line in verification_lines(result):
        answers.print(line, highlight=False)
    for line in assumption_lines(result):
        answers.print(line, highlight=False)
    for warning in result.warnings:
        answers.print(words.say("result-warning", warning=words.quote(warning)), highlight=False)
    answers.print(words.quote(result.verdict), highlight=False)
    _print_verdicts(result)


def _print_verdicts(result: Result) -> None:
    """Whether it is good enough for the cell, and as exact as was asked for."""
    words = find_wording()
    if result.requirement is not None:
        answers.print(f"{verdict_sign(result.requirement)} {words.quote(result.requirement.message)}", highlight=False, markup=False)
        if result.requirement.assumed and result.requirement.adequacy is not None:
            answers.print(words.say("requirement-assumed"), highlight=False, markup=False)
    if result.target is not None:
        for said in (*(each.message for each in result.target.quantities), result.target.message):
            answers.print(words.quote(said), highlight=False, markup=False)


def write_json(text: str, target: str) -> None:
    """To standard output, or to a file that appears only when it is whole."""
    if target == "-":
        sys.stdout.write(text + "\n")
        return
    write_whole(Path(target), text + "\n")
