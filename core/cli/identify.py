"""`heft identify`: the payload from a recording."""

import time
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from core.cell.folder import find_cell, load_cell
from core.cli.answer import print_answer
from core.cli.log_argument import LogKnowledge, MapOption, SetOption, UrdfOption, are_log, take_log, take_recording
from core.cli.options import JsonOption, LanguageOption, TargetOption, check_new
from core.cli.terminal import find_wording, messages
from core.errors import BadInput
from core.estimation.identification import identify_recording
from core.estimation.result import SecondsPart, result_of
from core.recording.long_recording import read_condensed
from core.requirement.target import CellRequirement, TargetCheck, parse_target
from core.requirement.target_answer import hold_against_target
from core.requirement.verdict import judge_estimate
from core.robot.model import RobotModel
from core.twin.file import read_twin
from core.twin.twin import NOMINAL

app = typer.Typer()


@app.command("identify")
def identify_command(
    recording: Annotated[
        list[Path],
        typer.Argument(metavar="RECORDING", help="Folder of a recording; or another program's log, whose files are given together."),
    ],
    json: JsonOption = None,
    report: Annotated[Path | None, typer.Option(metavar="FILE", help="Also write the HTML report.")] = None,
    cell: Annotated[
        str | None, typer.Option(metavar="CELL", help="The cell it was made in: its twin counts, its thresholds judge.")
    ] = None,
    target: TargetOption = None,
    without: Annotated[
        Path | None,
        typer.Option(metavar="EMPTY", help="A recording of the same arm without the payload: joint torques alone then tell the payload."),
    ] = None,
    mapping: MapOption = None,
    urdf: UrdfOption = None,
    changes: SetOption = None,
    *,
    language: LanguageOption,
) -> None:
    """Identify the payload from a recording, or from another program's log. Either is only read."""
    check_new(report, json)
    made_in = None if cell is None else load_cell(find_cell(cell))
    wanted = None if target is None else parse_target(target)
    if wanted is not None and wanted.requirement and made_in is None:
        raise BadInput("--target", "target-without-cell")
    twin = NOMINAL if made_in is None else read_twin(made_in)
    known = LogKnowledge(mapping, urdf, tuple(changes or ()), made_in)
    is_log = are_log(recording)
    if len(recording) > 1 and not is_log:
        raise BadInput(str(recording[1]), "cli-one-recording")
    with take_log(recording, known) if is_log else take_recording(recording[0], known) as folder:
        loaded, remarks = read_condensed(folder)
    empty, of_empty = (None, ()) if without is None else read_condensed(without)
    began = time.perf_counter()
    with messages.status(find_wording().say("cli-estimating")) if messages.is_terminal else nullcontext():
        identification = identify_recording(loaded, twin, empty)
    identification = replace(identification, warnings=(*identification.warnings, *remarks, *of_empty))
    seconds = SecondsPart(robot=float(loaded.t[-1] - loaded.t[0]), estimate=time.perf_counter() - began)
    robot = None if made_in is None else RobotModel.of_cell(made_in)
    enough = None if made_in is None or robot is None else judge_estimate(made_in, robot, identification.estimate)
    required = None if made_in is None or robot is None else CellRequirement(made_in, robot)
    met = None if wanted is None else hold_against_target(TargetCheck(wanted, required), identification.estimate)
    if report is not None:
        from core.report.page import write_report  # noqa: PLC0415 - only who wants a page waits for what draws it

        write_report(report, recording=loaded, identification=identification, requirement=enough, target=met, language=language)
    print_answer(result_of(identification, loaded, seconds=seconds, requirement=enough, target=met, folder=recording[0]), json)
