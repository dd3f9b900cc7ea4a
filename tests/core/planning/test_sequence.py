"""The procedure as what a robot goes through: a part of it, and what a refusal offers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import core.planning.search
from core.cell.folder import load_cell
from core.errors import NoStartConfiguration
from core.events import drive
from core.planning.sequence import PlanRequest, Procedure
from core.planning.settings import Scope, Timing
from core.planning.start_configuration import UNREACHABLE, StartConfiguration, find_start_configuration
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel

CELL = load_cell(Path(__file__).parents[3] / "cells" / "ur5e_line")
ROBOT = RobotModel.of_cell(CELL)
COLLISION = CollisionModel(CELL, ROBOT, CELL.payload_box)
HOME = np.array(CELL.robot.home_rad)


def request(done: int = 0) -> PlanRequest:
    return PlanRequest(CELL, CELL.payload_box, HOME, done, 0.001, "rrt_connect", 0)


@pytest.fixture
def no_room_for_z(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Every pose that is asked for."""
    asked: list[str] = []

    def found(cell: object, robot: object, collision: object, axis: str, rotation: object, **options: object) -> StartConfiguration:
        asked.append(axis)
        if axis[0] == "z":
            raise NoStartConfiguration(axis, {UNREACHABLE: 10})
        return find_start_configuration(cell, robot, collision, axis, rotation, **options)  # type: ignore[arg-type]  # as it was called

    monkeypatch.setattr(core.planning.search, "find_start_configuration", found)
    return asked


def test_a_refusal_for_one_axis_offers_the_others_which_then_are_planned(no_room_for_z: list[str]) -> None:
    with pytest.raises(NoStartConfiguration, match=r"--axes y\.$"):
        drive(Procedure(Timing(), scope=Scope("yz")).plan_legs(request(), ROBOT, COLLISION))
    offered = Procedure(Timing(), scope=Scope("y"))
    assert offered.steps == 2
    assert [leg.axis for leg in drive(offered.plan_legs(request(), ROBOT, COLLISION)).legs] == ["y-", "y+"]


def test_in_the_middle_of_a_run_no_other_axes_are_offered(no_room_for_z: list[str]) -> None:
    with pytest.raises(NoStartConfiguration) as refused:
        drive(Procedure(Timing(), scope=Scope("yz")).plan_legs(request(done=2), ROBOT, COLLISION))
    assert "--axes" not in str(refused.value)
    assert set(no_room_for_z) <= {"z+", "z-"}


def test_without_rotations_there_are_holds_alone() -> None:
    plan = drive(Procedure(Timing(), scope=Scope("x", rotations=False)).plan_legs(request(), ROBOT, COLLISION))
    assert [(leg.axis, leg.profile, leg.wave) for leg in plan.legs] == [("x-", None, None), ("x+", None, None)]
