"""`heft plan`: what the procedure would do."""

from pathlib import Path
from typing import Annotated

import typer

from core.cell.folder import find_cell, load_cell
from core.cli.answer import write_json
from core.cli.options import (
    CellArgument,
    JsonOption,
    PayloadOption,
    PlannerName,
    PlannerOption,
    SeedOption,
    TargetOption,
    check_new,
    choose_payload,
)
from core.cli.plan_tables import not_excited_lines, opinion_lines, plan_table, torque_lines, wave_lines
from core.cli.terminal import answers, find_wording, messages
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
from core.planning.plan import plan_summary
from core.planning.set_points import check_set_points, set_points_of, write_set_points
from core.planning.slow_run import limit_speed
from core.planning.starting_point import starting_point
from core.planning.stops import PlanRequest
from core.plant.mechanics import PERIOD
from core.procedure.progress import watch
from core.requirement.target import parse_target
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel

app = typer.Typer()


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
    target: TargetOption = None,
    purpose: PurposeOption = Purpose.wrist_sensor,
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
    stops = stops_for(purpose, scope, None if target is None else parse_target(target))
    box = loaded.payload_box if payload is None else choose_payload(loaded, payload)[1].box
    check_new(None, json)
    check_set_points(trajectory, period, PERIOD)
    robot = RobotModel.of_cell(loaded)
    collision = CollisionModel(loaded, robot, box)
    load = find_known_load(loaded, payload)
    asked = PlanRequest(loaded, box, starting_point(start, loaded, robot), 0, PERIOD, planner.value, seed, load, effort)
    found = watch(stops.plan(asked, robot, collision), messages)
    if trajectory is not None:
        write_set_points(trajectory, set_points_of(loaded, robot, collision, found, period_s=period))
    if json is not None:
        write_json(plan_summary(loaded, found).model_dump_json(indent=2), json)
    if json != "-":
        answers.print(plan_table(found))
        answers.print(find_wording().say("result-plan-times", robot_s=found.robot_s, plan_s=found.plan_s), highlight=False)
        for line in (
            *wave_lines(found),
            *(not_excited_lines(scope) if purpose == Purpose.wrist_sensor else ()),
            *torque_lines(found.torques),
            *opinion_lines(found.opinion),
        ):
            answers.print(line, highlight=False)
