"""`heft requirement`: how exactly the controller has to know its payload, and whether an answer is good enough."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from core.cell.folder import find_cell, load_cell
from core.cli.answer import write_json
from core.cli.answer_file import read_result_file
from core.cli.options import CellArgument, JsonOption, PayloadOption, check_new, choose_payload
from core.cli.terminal import answers, find_wording
from core.errors import BadInput
from core.estimation.result import Result
from core.payload.inertia import InertialParameters
from core.requirement.answer import RequirementPart, requirement_part
from core.requirement.motions import make_brisk_motion, read_program
from core.requirement.requirement import require
from core.robot.model import RobotModel

app = typer.Typer()


@app.command()
def requirement(
    cell: CellArgument,
    payload: PayloadOption = None,
    program: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="A program's path: CSV, time (s) and joints (rad). [default: as brisk as the cell allows]"),
    ] = None,
    result: Annotated[
        Path | None, typer.Option(metavar="FILE", help="An answer of `heft run` or `heft identify`: is it good enough?")
    ] = None,
    json: JsonOption = None,
) -> None:
    """Say how exactly the controller has to know its payload, and whether an answer is good enough for it."""
    check_new(None, json)
    loaded = load_cell(find_cell(cell))
    robot = RobotModel.of_cell(loaded)
    answer = None if result is None else read_result_file(result)
    carried = choose_payload(loaded, payload)[1].parameters if answer is None or result is None else _payload_of(answer, result)
    motion = make_brisk_motion(loaded, robot) if program is None else read_program(program, robot)
    found = requirement_part(require(loaded, robot, carried, motion), motion, None if answer is None else answer.estimate)
    if json is not None:
        write_json(found.model_dump_json(indent=2), json)
    if json != "-":
        _print(found)


def _payload_of(answer: Result, file: Path) -> InertialParameters:
    """What the answer says that the robot carries."""
    values = [] if answer.estimate is None else answer.estimate.phi
    known = [value for value in values if value is not None]
    if len(known) < 10 or known[0] <= 0.0:
        raise BadInput(str(file), "requirement-no-payload")
    return InertialParameters(np.array(known))


def _print(found: RequirementPart) -> None:
    words = find_wording()
    for line in (*found.details, found.message):
        answers.print(words.quote(line), highlight=False, markup=False)
