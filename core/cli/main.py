"""The command line: `heft run`, `heft identify`, `heft diagnose`, `heft plan`, `heft cells`, and what other files add to it."""

from __future__ import annotations

import sys
import time
from contextlib import nullcontext
from datetime import UTC, datetime
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from core.cell.cell import Cell, Payload, find_cell, list_cell_folders, load_cell
from core.cli import cells as cell_commands
from core.cli import twins as twin_commands
from core.cli.experiments import check_experiment_file, plan_next, read_request
from core.cli.exports import export
from core.cli.tables import (
    broken_lines,
    cells_table,
    diagnosis_lines,
    diagnosis_table,
    not_excited_lines,
    opinion_lines,
    parameters_table,
    plan_table,
    reason_lines,
    torque_lines,
    verification_lines,
)
from core.cli.terminal import HELP, answers, enter, messages
from core.cli.trials import trial
from core.cli.workpiece_table import workpiece_lines, workpiece_table
from core.errors import BadInput, BadPayload
from core.estimation.identification import identify_recording
from core.estimation.result import Result, SecondsPart, result_of
from core.files.whole_file import write_whole
from core.gap.diagnosis import examine
from core.gap.twin_addition import addable_to
from core.planning.joint_torques import find_known_load
from core.planning.options import AxesOption, EffortOption, FromOption, HoldsOnlyOption, SpeedOption, scope_of
from core.planning.plan import plan_summary
from core.planning.sequence import PlanRequest, Procedure
from core.planning.set_points import check_set_points, set_points_of, write_set_points
from core.planning.settings import WHOLE, Timing
from core.planning.slow_run import limit_speed
from core.planning.starting_point import starting_point
from core.plant.mechanics import PERIOD
from core.procedure.experiment import measure_more
from core.procedure.identify import identify
from core.procedure.progress import watch
from core.recording.folder import read_recording
from core.recording.stated_friction import with_cell_friction
from core.report.diagnosis_page import write_diagnosis
from core.report.overlay import overlay_of
from core.report.page import write_report
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.sessions.pace import AsFastAsPossible, RealTime
from core.sessions.simulated import SimulatedSession
from core.twin.file import read_twin
from core.twin.twin import NOMINAL

app = typer.Typer(
    name="heft",
    help=HELP,
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)


class PlannerName(StrEnum):
    """The planners at hand."""

    rrt_connect = "rrt_connect"
    rrt_star = "rrt_star"


CellArgument = Annotated[str, typer.Argument(metavar="CELL", help="A cell's name (see `heft cells`) or the path of its folder.")]
JsonOption = Annotated[str | None, typer.Option("--json", metavar="FILE", help="Write the answer as JSON; `-` for standard output.")]
SeedOption = Annotated[int, typer.Option(min=0, help="Makes planning and the simulated noise repeatable.")]
PlannerOption = Annotated[PlannerName, typer.Option(help="How paths are searched.")]
PayloadOption = Annotated[str | None, typer.Option(metavar="NAME", help="A payload that the cell knows. [default: its first]")]


@app.command()
def run(
    cell: CellArgument,
    payload: PayloadOption = None,
    seed: SeedOption = 0,
    planner: PlannerOption = PlannerName.rrt_connect,
    start: FromOption = None,
    axes: AxesOption = "xyz",
    holds_only: HoldsOnlyOption = False,
    speed: SpeedOption = None,
    effort: EffortOption = 1,
    out: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Folder to make, or an empty one, for recording, result.json and report.")
    ] = None,
    json: JsonOption = None,
    real_time: Annotated[bool, typer.Option("--real-time", help="Move at the speed of a real robot, to watch it.")] = False,
    experiment: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Instead of the procedure, the motion that `heft diagnose --experiment` proposed.")
    ] = None,
    recording: Annotated[Path | None, typer.Option(metavar="DIR", help="The recording that the experiment continues, if moved.")] = None,
) -> None:
    """Plan and run the procedure on the simulated robot, identify the payload, write recording, answer and report."""
    loaded = limit_speed(load_cell(find_cell(cell)), speed, "--speed")
    scope = scope_of(axes, holds_only=holds_only)
    if experiment is not None and (start is not None or scope != WHOLE):
        raise BadInput(
            "--experiment", "--from, --axes or --holds-only beside it", "none of these: the experiment has its own motion, from home"
        )
    asked, before = (None, None) if experiment is None else read_request(experiment, recording, loaded)
    name, carried = _payload(loaded, payload or (asked.payload if asked else None))
    folder = out or Path("recordings") / f"{loaded.name}-{name}-{datetime.now(UTC):%Y%m%d-%H%M%S}"
    _check_new(folder, json)
    pace = RealTime() if real_time else AsFastAsPossible()
    twin = read_twin(loaded)
    stands = starting_point(start, loaded, RobotModel.of_cell(loaded))
    session = SimulatedSession(loaded, carried.parameters, seed=seed + (before is not None), pace=pace, twin=twin, start=stands)
    if asked is None or before is None:
        steps = identify(
            loaded,
            session,
            carried.box,
            payload=name,
            reference=carried,
            scope=scope,
            start=stands,
            planner=planner.value,
            seed=seed,
            effort=effort,
            out=folder,
            twin=twin,
        )
    else:
        steps = measure_more(
            before, asked.stops, loaded, session, carried.box, planner=planner.value, seed=seed, effort=effort, out=folder, twin=twin
        )
    outcome = watch(steps, messages)
    result = outcome.result(folder)
    _write_json(result.model_dump_json(indent=2), str(folder / "result.json"))
    _answer(result, json)
    page = folder / "report.html"
    write_report(page, recording=outcome.recording, identification=outcome.identification, run=outcome.summary)
    if json != "-":
        answers.print(f"Report: {page}", soft_wrap=True, highlight=False)


@app.command("identify")
def identify_command(
    recording: Annotated[Path, typer.Argument(metavar="RECORDING", help="Folder of a recording.")],
    json: JsonOption = None,
    report: Annotated[Path | None, typer.Option(metavar="FILE", help="Also write the HTML report.")] = None,
    cell: Annotated[str | None, typer.Option(metavar="CELL", help="The cell it was made in: its twin is accounted for.")] = None,
) -> None:
    """Identify the payload from a recording, of this program or from elsewhere. The recording is only read."""
    _check_new(report, json)
    twin = NOMINAL if cell is None else read_twin(load_cell(find_cell(cell)))
    loaded = read_recording(recording)
    began = time.perf_counter()
    with messages.status("estimating") if messages.is_terminal else nullcontext():
        identification = identify_recording(loaded, twin)
    seconds = SecondsPart(robot=float(loaded.t[-1] - loaded.t[0]), estimate=time.perf_counter() - began)
    if report is not None:
        write_report(report, recording=loaded, identification=identification)
    _answer(result_of(identification, loaded, seconds=seconds, folder=recording), json)


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
) -> None:
    """Where simulation and recording part, which unmodelled effect causes it, and how far adding it closes the gap."""
    _check_new(report, json)
    check_experiment_file(experiment, cell)
    made_in = None if cell is None else load_cell(find_cell(cell))
    twin = NOMINAL if made_in is None else read_twin(made_in)
    loaded = read_recording(recording)
    loaded = loaded if made_in is None else with_cell_friction(loaded, made_in)
    with messages.status("fitting effects") if messages.is_terminal else nullcontext():
        diagnosis, evidence = examine(loaded, twin=twin)
    if made_in is not None:
        diagnosis = addable_to(diagnosis, made_in, loaded, recording)
        diagnosis = plan_next(diagnosis, evidence, loaded, recording, made_in, experiment, messages)
    if report is not None:
        report.mkdir(parents=True, exist_ok=True)
        write_diagnosis(report / "diagnosis.html", diagnosis=diagnosis, overlay=None if evidence is None else overlay_of(evidence))
        _write_json(diagnosis.model_dump_json(indent=2), str(report / "diagnosis.json"))
    if json is not None:
        _write_json(diagnosis.model_dump_json(indent=2), json)
    if json != "-":
        answers.print(diagnosis_table(diagnosis))
        for line in diagnosis_lines(diagnosis):
            answers.print(line, highlight=False)
    if report is not None and json != "-":
        answers.print(f"Report: {report / 'diagnosis.html'}", soft_wrap=True, highlight=False)


app.command()(trial)
app.command()(export)
app.add_typer(twin_commands.app, name="twin")
app.add_typer(cell_commands.app, name="cell")


@app.command()
def plan(
    cell: CellArgument,
    payload: PayloadOption = None,
    seed: SeedOption = 0,
    planner: PlannerOption = PlannerName.rrt_connect,
    start: FromOption = None,
    axes: AxesOption = "xyz",
    holds_only: HoldsOnlyOption = False,
    speed: SpeedOption = None,
    effort: EffortOption = 1,
    json: JsonOption = None,
    trajectory: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Write every set point, for one's own controller: .csv or .json.")
    ] = None,
    period: Annotated[
        float | None, typer.Option(metavar="S", help="From one set point in that file to the next, s; whole milliseconds. [default: 0.001]")
    ] = None,
) -> None:
    """Plan the procedure and show start configurations, distances and times. Nothing moves."""
    loaded = limit_speed(load_cell(find_cell(cell)), speed, "--speed")
    scope = scope_of(axes, holds_only=holds_only)
    box = loaded.payload_box if payload is None else _payload(loaded, payload)[1].box
    _check_new(None, json)
    check_set_points(trajectory, period, PERIOD)
    robot = RobotModel.of_cell(loaded)
    collision = CollisionModel(loaded, robot, box)
    load = find_known_load(loaded, payload)
    asked = PlanRequest(loaded, box, starting_point(start, loaded, robot), 0, PERIOD, planner.value, seed, load, effort)
    found = watch(Procedure(Timing(), scope=scope).plan_legs(asked, robot, collision), messages)
    if trajectory is not None:
        write_set_points(trajectory, set_points_of(loaded, robot, collision, found, period_s=period))
    if json is not None:
        _write_json(plan_summary(loaded, found).model_dump_json(indent=2), json)
    if json != "-":
        answers.print(plan_table(found))
        answers.print(f"Robot time {found.robot_s:.0f} s, planned in {found.plan_s:.1f} s.", highlight=False)
        for line in (*not_excited_lines(scope), *torque_lines(found.torques), *opinion_lines(found.opinion)):
            answers.print(line, highlight=False)


@app.command()
def cells() -> None:
    """List the cells at hand, and what keeps any of them from being used."""
    loaded, broken = [], {}
    for folder in list_cell_folders():
        try:
            loaded.append(load_cell(folder))
        except BadInput as error:
            broken[folder.name] = error
    answers.print(cells_table(loaded))
    for line in broken_lines(broken):
        answers.print(line, highlight=False, markup=False, soft_wrap=True)


def _payload(cell: Cell, name: str | None) -> tuple[str, Payload]:
    """The payload that the simulated robot is to carry."""
    chosen = name or next(iter(cell.payloads), "none")
    if chosen not in cell.payloads:
        raise BadPayload(f"{cell.folder / 'cell.toml'}: payloads", repr(chosen), f"one of {', '.join(cell.payloads) or 'none'}")
    return chosen, cell.payloads[chosen]


def _check_new(target: Path | None, json: str | None) -> None:
    """Before anything long begins: what is to be written can be written, and overwrites nothing but a JSON file."""
    if target is not None and target.exists() and not (target.is_dir() and not any(target.iterdir())):
        raise BadInput(str(target), "something that exists already", "a new name, or an empty folder")
    if json is not None and json != "-" and not Path(json).absolute().parent.is_dir():
        raise BadInput(json, "a folder that does not exist", "a file in an existing folder")


def _answer(result: Result, json: str | None) -> None:
    if json is not None:
        _write_json(result.model_dump_json(indent=2), json)
    if json == "-":
        return
    answers.print(parameters_table(result))
    if result.workpiece is not None:
        answers.print(workpiece_table(result.workpiece))
        for line in workpiece_lines(result.workpiece):
            answers.print(line, highlight=False)
    for line in reason_lines(result):
        answers.print(line, highlight=False)
    if result.accounted:
        answers.print(f"Accounted for, as the cell's twin has it: {', '.join(result.accounted)}", highlight=False)
    for line in verification_lines(result):
        answers.print(line, highlight=False)
    for warning in result.warnings:
        answers.print(f"Warning: {warning.sentence}", highlight=False)
    answers.print(result.verdict, highlight=False)


def _write_json(text: str, target: str) -> None:
    """To standard output, or to a file that appears only when it is whole."""
    if target == "-":
        sys.stdout.write(text + "\n")
        return
    write_whole(Path(target), text + "\n")


def main() -> None:
    """Entry point of the engine alone."""
    enter(app)
