"""The stops of a run: those of the procedure, a part of them, and what a refusal offers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import core.planning.search
from core.cell.folder import load_cell
from core.errors import BadInput, NoPath, NoStartConfiguration
from core.events import drive
from core.planning.candidate_checks import Attitude
from core.planning.settings import Scope, Timing
from core.planning.start_configuration import UNREACHABLE, StartConfiguration, find_start_configuration
from core.planning.stop import Stop
from core.planning.stops import PROCEDURE, PlanRequest, Stops
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel

CELL = load_cell(Path(__file__).parents[3] / "cells" / "ur5e_line")
ROBOT = RobotModel.of_cell(CELL)
COLLISION = CollisionModel(CELL, ROBOT, CELL.payload_box)
HOME = np.array(CELL.robot.home_rad)


def request(done: int = 0) -> PlanRequest:
    return PlanRequest(CELL, CELL.payload_box, HOME, done, 0.001, "rrt_connect", 0)


@pytest.fixture
def no_room(monkeypatch: pytest.MonkeyPatch) -> tuple[set[str], list[str]]:
    """Axes without room, to be filled; and every attitude that is asked for. What has room is searched for with half the candidates."""
    without: set[str] = set()
    asked: list[str] = []

    def found(cell: object, robot: object, collision: object, attitude: Attitude, **options: object) -> StartConfiguration:
        asked.append(attitude.name)
        if attitude.name[0] in without:
            raise NoStartConfiguration(attitude.name, {UNREACHABLE: 10})
        return find_start_configuration(cell, robot, collision, attitude, **options)  # type: ignore[arg-type]  # as it was called

    monkeypatch.setattr(core.planning.search, "find_start_configuration", found)
    return without, asked


def test_the_procedure_holds_each_axis_against_and_along_gravity_and_turns_about_it_where_it_points_down() -> None:
    """Fig. 2 of the paper; gravity's direction from the stops themselves."""
    assert PROCEDURE.labels == ("x-", "x+", "y-", "y+", "z-", "z+")
    for stop, label in zip(PROCEDURE.stops, PROCEDURE.labels, strict=True):
        unit = np.eye(3)["xyz".index(label[0])]
        np.testing.assert_array_equal(stop.down, unit if label[1] == "+" else -unit)
        assert (stop.swings.about if stop.swings else None) == (label[0] if label[1] == "+" else None)
        assert stop.repeats_as_needed == (label[1] == "+")


def test_a_part_keeps_the_order_and_the_angle_that_is_asked_for() -> None:
    part = Stops.of_procedure(Scope("xz"), Timing(swing_rad=0.4))
    assert part.labels == ("x-", "x+", "z-", "z+")
    assert {stop.swings.excursion_rad for stop in part.stops if stop.swings} == {0.4}
    assert all(stop.swings is None for stop in Stops.of_procedure(Scope("xz", rotations=False)).stops)


def test_no_stops_at_all_are_refused() -> None:
    with pytest.raises(BadInput, match="no stops"):
        Stops(())


def test_a_refusal_for_one_axis_offers_the_others_which_then_are_planned(no_room: tuple[set[str], list[str]]) -> None:
    no_room[0].add("z")
    with pytest.raises(NoStartConfiguration, match=r"--axes y\.$"):
        drive(Stops.of_procedure(Scope("yz")).plan(request(), ROBOT, COLLISION))
    offered = Stops.of_procedure(Scope("y"))
    assert [leg.axis for leg in drive(offered.plan(request(), ROBOT, COLLISION)).legs] == ["y-", "y+"]


def test_two_axes_without_room_leave_the_third(no_room: tuple[set[str], list[str]]) -> None:
    no_room[0].update("xz")
    with pytest.raises(NoStartConfiguration, match=r"--axes y\.$"):
        drive(Stops.of_procedure(Scope(rotations=False)).plan(request(), ROBOT, COLLISION))


@pytest.mark.parametrize("stops", [PROCEDURE, Stops((Stop(down=(0.0, 0.0, 1.0)), Stop(down=(0.6, 0.8, 0.0))))])
def test_nothing_is_offered_where_nothing_is_left_or_the_stops_are_not_of_the_procedure(
    no_room: tuple[set[str], list[str]], stops: Stops
) -> None:
    no_room[0].update("xyz")
    with pytest.raises(NoStartConfiguration) as refused:
        drive(stops.plan(request(), ROBOT, COLLISION))
    assert "--axes" not in str(refused.value)


def test_who_is_refused_for_something_else_than_an_axis_is_offered_none(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []

    def blocked(*given: object, **_: object) -> object:
        asked.append(len(given[4]))  # type: ignore[arg-type]  # the stops
        raise NoPath("text", text="the way home is blocked.")
        yield

    monkeypatch.setattr("core.planning.stops.plan_stops", blocked)
    with pytest.raises(NoPath) as refused:
        drive(PROCEDURE.plan(request(), ROBOT, COLLISION))
    assert "--axes" not in str(refused.value)
    assert asked == [6]


def test_in_the_middle_of_a_run_no_other_axes_are_offered(no_room: tuple[set[str], list[str]]) -> None:
    no_room[0].add("z")
    with pytest.raises(NoStartConfiguration) as refused:
        drive(Stops.of_procedure(Scope("yz")).plan(request(done=2), ROBOT, COLLISION))
    assert "--axes" not in str(refused.value)
    assert set(no_room[1]) <= {"z+", "z-"}


def test_without_rotations_there_are_holds_alone() -> None:
    plan = drive(Stops.of_procedure(Scope("x", rotations=False)).plan(request(), ROBOT, COLLISION))
    assert [(leg.axis, leg.profile, leg.wave) for leg in plan.legs] == [("x-", None, None), ("x+", None, None)]
