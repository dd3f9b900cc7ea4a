"""`heft run`: the procedure on the simulated robot."""

from datetime import UTC, datetime
from pathlib import Path
from typing import Annotated

import typer

from core.cell.folder import find_cell, load_cell
from core.cli.answer import print_answer, write_json
from core.cli.experiments import read_request
from core.cli.options import (
    CellArgument,
    JsonOption,
    LanguageOption,
    PayloadOption,
    PlannerName,
    PlannerOption,
    SeedOption,
    TargetOption,
    check_new,
    choose_payload,
)
from core.cli.terminal import answers, find_wording, messages
from core.errors import BadInput
from core.planning.joint_torques import find_known_load
from core.planning.options import (
    AxesOption,
    EffortOption,
    FromOption,
    HoldsOnlyOption,
    Purpose,
    PurposeOption,
    SpeedOption,
    scope_of,
    stops_for,
)
from core.planning.settings import WHOLE
from core.planning.slow_run import limit_speed
from core.planning.starting_point import starting_point
from core.planning.stops import Stops
from core.procedure.identify import identify
from core.procedure.progress import watch
from core.recording.folder import read_recording
from core.report.page import write_report
from core.requirement.target import parse_target
from core.robot.model import RobotModel
from core.sessions.opening import Simulation, is_simulated, open_robot_session
from core.sessions.pace import AsFastAsPossible, RealTime
from core.twin.file import read_twin

app = typer.Typer()


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
    target: TargetOption = None,
    purpose: PurposeOption = Purpose.wrist_sensor,
    empty: Annotated[
        bool,
        typer.Option(
            "--empty", help="The motions that the payload is identified with, without it: for heft identify LOADED --without EMPTY."
        ),
    ] = False,
    without: Annotated[
        Path | None,
        typer.Option(metavar="EMPTY", help="A recording of --empty: the answer is then from the joints' torques in both."),
    ] = None,
    out: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Folder to make, or an empty one, for recording, result.json and report.")
    ] = None,
    json: JsonOption = None,
    real_time: Annotated[bool, typer.Option("--real-time", help="Move at the speed of a real robot, to watch it.")] = False,
    experiment: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Instead of the procedure, the motion that `heft diagnose --experiment` proposed.")
    ] = None,
    recording: Annotated[Path | None, typer.Option(metavar="DIR", help="The recording that the experiment continues, if moved.")] = None,
    *,
    language: LanguageOption,
) -> None:
    """Plan and run the procedure on the cell's robot, identify the payload, write recording, answer and report.

    The robot is simulated unless cell.toml names a real one.
    """
    loaded = limit_speed(load_cell(find_cell(cell)), speed, "--speed")
    scope = scope_of(axes, holds_only=holds_only)
    if experiment is not None and (start is not None or scope != WHOLE or purpose != Purpose.wrist_sensor or empty or without):
        raise BadInput("--experiment", "cli-experiment-beside-others")
    wanted = None if target is None else parse_target(target)
    if experiment is not None and wanted is not None:
        raise BadInput("--target", "target-beside-experiment")
    if without is not None and (empty or wanted is not None):
        raise BadInput("--without", "torques-without-beside", option="--empty" if empty else "--target")
    stops = stops_for(purpose, scope, wanted)
    alone = None if without is None else read_recording(without)
    asked, before = (None, None) if experiment is None else read_request(experiment, recording, loaded)
    simulated = is_simulated(loaded)
    if start is not None and not simulated:
        raise BadInput("--from", "cli-from-beside-robot", driver=loaded.session.driver)
    named = payload or (asked.payload if asked else None)
    # nobody knows what a real robot carries, unless somebody says so
    name, carried = choose_payload(loaded, named) if simulated or named else (None, None)
    mounted = None if empty else name
    folder = out or Path("recordings") / f"{loaded.name}-{'empty' if empty else name or 'unknown'}-{datetime.now(UTC):%Y%m%d-%H%M%S}"
    check_new(folder, json)
    pace = RealTime() if real_time else AsFastAsPossible()
    twin = read_twin(loaded)
    stands = starting_point(start, loaded, RobotModel.of_cell(loaded))
    load = None if carried is None or empty else carried.parameters
    simulation = Simulation(load, seed=seed + (before is not None) + empty, pace=pace, twin=twin, start=stands)
    session = open_robot_session(loaded, simulation)
    stands = session.find_start()
    steps = identify(
        loaded,
        session,
        loaded.payload_box if carried is None else carried.box,
        stops=stops if asked is None else Stops(asked.stops),
        before=before,
        payload=mounted if asked is None else None,
        reference=carried if asked is None and not empty else None,
        load=find_known_load(loaded, name),
        start=stands,
        planner=planner.value,
        seed=seed,
        effort=effort,
        out=folder,
        twin=twin,
        target=wanted,
        clock_waits=simulated and not real_time,
        without=alone,
    )
    outcome = watch(steps, messages)
    for remark in session.remarks():
        messages.print(find_wording().quote(remark), markup=False, highlight=False, soft_wrap=True)
    at = datetime.now(UTC)
    result = outcome.result(folder, at=at)
    write_json(result.model_dump_json(indent=2), str(folder / "result.json"))
    print_answer(result, json)
    page = folder / "report.html"
    write_report(
        page,
        recording=outcome.recording,
        identification=outcome.identification,
        run=outcome.summary,
        requirement=outcome.requirement,
        target=outcome.target,
        at=at,
        language=language,
    )
    if json != "-":
        answers.print(find_wording().say("cli-report", file=str(page)), soft_wrap=True, highlight=False)
