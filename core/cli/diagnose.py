"""`heft diagnose`: the gap between simulation and a recording."""

from contextlib import nullcontext
from pathlib import Path
from typing import Annotated

import typer

from core.cell.folder import find_cell, load_cell
from core.cli.answer import write_json
from core.cli.experiments import check_experiment_file, plan_next
from core.cli.options import JsonOption, LanguageOption, check_new
from core.cli.tables import (
    diagnosis_lines,
    diagnosis_table,
)
from core.cli.terminal import answers, find_wording, messages
from core.gap.diagnosis import examine
from core.gap.twin_addition import addable_to
from core.recording.folder import read_recording
from core.recording.stated_friction import with_cell_friction
from core.report.diagnosis_page import write_diagnosis
from core.report.overlay import overlay_of
from core.twin.file import read_twin
from core.twin.twin import NOMINAL

app = typer.Typer()


@app.command("diagnose")
def diagnose_command(
    recording: Annotated[Path, typer.Argument(metavar="RECORDING", help="Folder of a recording.")],
    json: JsonOption = None,
    report: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder to make for the report, as a page and as JSON.")] = None,
    cell: Annotated[
        str | None, typer.Option(metavar="CELL", help="The cell it was made in: its twin is the start, the next motion is planned there.")
    ] = None,
    experiment: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Write the next motion for `heft run --experiment`; needs --cell.")
    ] = None,
    *,
    language: LanguageOption,
) -> None:
    """Where simulation and recording part, which unmodelled effect causes it, and how far adding it closes the gap."""
    check_new(report, json)
    check_experiment_file(experiment, cell)
    made_in = None if cell is None else load_cell(find_cell(cell))
    twin = NOMINAL if made_in is None else read_twin(made_in)
    loaded = read_recording(recording)
    loaded = loaded if made_in is None else with_cell_friction(loaded, made_in)
    with messages.status(find_wording().say("cli-fitting")) if messages.is_terminal else nullcontext():
        diagnosis, evidence = examine(loaded, twin=twin, folder=recording)
    if made_in is not None:
        diagnosis = addable_to(diagnosis, made_in)
        diagnosis = plan_next(diagnosis, evidence, loaded, recording, made_in, experiment, messages)
    if report is not None:
        report.mkdir(parents=True, exist_ok=True)
        write_diagnosis(
            report / "diagnosis.html", diagnosis=diagnosis, overlay=None if evidence is None else overlay_of(evidence), language=language
        )
        write_json(diagnosis.model_dump_json(indent=2), str(report / "diagnosis.json"))
    if json is not None:
        write_json(diagnosis.model_dump_json(indent=2), json)
    if json != "-":
        answers.print(diagnosis_table(diagnosis))
        for line in diagnosis_lines(diagnosis):
            answers.print(line, highlight=False)
    if report is not None and json != "-":
        answers.print(find_wording().say("cli-report", file=str(report / "diagnosis.html")), soft_wrap=True, highlight=False)
