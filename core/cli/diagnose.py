"""`heft diagnose`: the gap between simulation and a recording."""

from collections.abc import Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import Annotated

import typer
from pydantic import BaseModel
from rich.table import Table

from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.cli.answer import write_json
from core.cli.answer_file import read_diagnosis_file
from core.cli.experiments import check_experiment_file, plan_next
from core.cli.log_argument import LogKnowledge, MapOption, SetOption, UrdfOption, are_log, check_no_log, take_log, take_recording
from core.cli.options import JsonOption, LanguageOption, check_new
from core.cli.series_runs import shorten_names
from core.cli.tables import diagnosis_lines, diagnosis_table
from core.cli.terminal import answers, find_wording, messages
from core.cli.timeline_table import timeline_lines, timeline_table
from core.errors import BadInput
from core.gap.answer import Diagnosis
from core.gap.diagnosis import examine
from core.gap.evidence import Evidence
from core.gap.timeline import check_comparable, trace_effects
from core.gap.twin_addition import addable_to
from core.recording.folder import read_recording
from core.recording.recording import Recording
from core.recording.stated_friction import with_cell_friction
from core.report.diagnosis_page import write_diagnosis
from core.report.overlay import overlay_of
from core.twin.file import read_twin
from core.twin.twin import NOMINAL, Twin
from core.words.catalogue import Language

app = typer.Typer()

PAGE = "diagnosis.html"
TIMELINE = "timeline.json"


@app.command("diagnose")
def diagnose_command(
    recordings: Annotated[
        list[Path],
        typer.Argument(
            metavar="RECORDING...",
            help="Folder of a recording. Several of one cell, in the order in which they were made, tell which effect came when; in the "
            "place of a recording the file that --json wrote of it. Or another program's log, whose files are given together.",
        ),
    ],
    json: JsonOption = None,
    report: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder to make for the report, as a page and as JSON.")] = None,
    cell: Annotated[
        str | None, typer.Option(metavar="CELL", help="The cell it was made in: its twin is the start, the next motion is planned there.")
    ] = None,
    experiment: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Write the next motion for `heft run --experiment`; needs --cell and a single recording."),
    ] = None,
    mapping: MapOption = None,
    urdf: UrdfOption = None,
    changes: SetOption = None,
    *,
    language: LanguageOption,
) -> None:
    """Where simulation and recording part, which unmodelled effect causes it, and how far adding it closes the gap."""
    check_new(report, json)
    check_experiment_file(experiment, cell)
    is_log = are_log(recordings)
    if experiment is not None and is_log:
        raise BadInput("--experiment", "cli-experiment-of-log")
    if len(recordings) > 1 and experiment is not None:
        raise BadInput("--experiment", "cli-experiment-of-several")
    made_in = None if cell is None else load_cell(find_cell(cell))
    twin = NOMINAL if made_in is None else read_twin(made_in)
    known = LogKnowledge(mapping, urdf, tuple(changes or ()), made_in)
    if len(recordings) > 1 and not is_log:
        check_no_log(recordings[0], known)
        _follow(recordings, made_in, twin, json, report, language)
        return
    with take_log(recordings, known) if is_log else take_recording(recordings[0], known) as folder:
        diagnosis, evidence, loaded = _diagnose(folder, made_in, twin, kept=not is_log)
    if made_in is not None and not is_log:
        diagnosis = plan_next(diagnosis, evidence, loaded, recordings[0], made_in, experiment, messages)
    if report is not None:
        _write_report(report, diagnosis, evidence, language)
    _print(diagnosis, [diagnosis_table(diagnosis), *diagnosis_lines(diagnosis)], json, None if report is None else report / PAGE)


def _follow(recordings: list[Path], made_in: Cell | None, twin: Twin, json: str | None, report: Path | None, language: Language) -> None:
    """Several recordings of one cell: each diagnosed for itself, then held against each other."""
    names, diagnoses = shorten_names(recordings), []
    for k, (name, recording) in enumerate(zip(names, recordings, strict=True)):
        if recording.is_file():
            diagnoses.append(read_diagnosis_file(recording))
        else:
            messages.print(find_wording().say("cli-diagnosing", name=name, number=k + 1, count=len(recordings)), highlight=False)
            diagnosis, evidence, _ = _diagnose(recording, made_in, twin)
            diagnoses.append(diagnosis)
            if report is not None:
                _write_report(report / f"{k + 1}", diagnosis, evidence, language)
        check_comparable(names, diagnoses)  # before the minutes that the next one takes
    timeline = trace_effects(names, diagnoses)
    if report is not None:
        write_json(timeline.model_dump_json(indent=2), str(report / TIMELINE))
    _print(timeline, [timeline_table(timeline), *timeline_lines(timeline)], json, None if report is None else report / TIMELINE)


def _print(answer: BaseModel, shown: Sequence[Table | str], json: str | None, report: Path | None) -> None:
    """As JSON and for a person, or only as JSON where that goes to standard output; then where the report is."""
    if json is not None:
        write_json(answer.model_dump_json(indent=2), json)
    if json == "-":
        return
    for part in shown:
        answers.print(part, highlight=False)
    if report is not None:
        answers.print(find_wording().say("cli-report", file=str(report)), soft_wrap=True, highlight=False)


def _diagnose(folder: Path, made_in: Cell | None, twin: Twin, *, kept: bool = True) -> tuple[Diagnosis, Evidence | None, Recording]:
    """One recording, from the twin of the cell that it was made in; of one that is not kept nothing goes into a twin."""
    loaded = read_recording(folder)
    loaded = loaded if made_in is None else with_cell_friction(loaded, made_in)
    with messages.status(find_wording().say("cli-fitting")) if messages.is_terminal else nullcontext():
        diagnosis, evidence = examine(loaded, twin=twin, folder=folder if kept else None)
    return diagnosis if made_in is None else addable_to(diagnosis, made_in), evidence, loaded


def _write_report(folder: Path, diagnosis: Diagnosis, evidence: Evidence | None, language: Language) -> None:
    """The page for people, and the JSON that takes the recording's place another time."""
    folder.mkdir(parents=True, exist_ok=True)
    write_diagnosis(folder / PAGE, diagnosis=diagnosis, overlay=None if evidence is None else overlay_of(evidence), language=language)
    write_json(diagnosis.model_dump_json(indent=2), str(folder / "diagnosis.json"))
