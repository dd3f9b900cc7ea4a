"""What a release is bound to: any change of what is going to happen, or of where, is another hash."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.events import drive
from core.payload.shapes import Pose
from core.planning.plan import Plan
from core.planning.search import plan_stops
from core.planning.settings import Scope
from core.planning.stops import Stops
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from server.runner.release_hash import release_sha256
from server.runner.shown_plan import build_run_plan, plan_digest

ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="module")
def cell() -> Cell:
    return load_cell(ROOT / "cells" / "lwr4_bench")


@pytest.fixture(scope="module")
def plan(cell) -> Plan:
    robot = RobotModel.of_cell(cell)
    home, collision = np.array(cell.robot.home_rad), CollisionModel(cell, robot, cell.payload_box)
    return drive(plan_stops(cell, robot, collision, cell.payload_box, Stops.of_procedure(Scope("x")).stops, start=home))


def test_one_set_point_that_differs_by_a_bit_is_another_plan(plan):
    leg = plan.legs[0]
    q = leg.transfer.trajectory.q.copy()
    q[len(q) // 2, 3] = np.nextafter(q[len(q) // 2, 3], np.inf)
    transfer = replace(leg.transfer, trajectory=replace(leg.transfer.trajectory, q=q))
    other = replace(plan, legs=(replace(leg, transfer=transfer), *plan.legs[1:]))
    assert plan_digest(other) != plan_digest(plan)
    longer = replace(plan, timing=replace(plan.timing, hold_s=plan.timing.hold_s + 1e-9))
    assert plan_digest(longer) != plan_digest(plan)


def test_a_zone_a_limit_or_the_box_that_differs_makes_the_release_void(cell):
    box = cell.payload_box
    sha256 = release_sha256("d", cell, box)
    assert release_sha256("d", load_cell(cell.folder), box) == sha256
    zone = cell.zones[0].name
    pose = cell.zones[0].shape.pose
    moved = cell.with_pose_of(zone, Pose(xyz_m=(pose.xyz_m[0] + 1e-6, *pose.xyz_m[1:]), rpy_rad=pose.rpy_rad))
    faster = cell.model_copy(update={"limits": cell.limits.model_copy(update={"cartesian_speed_m_s": 0.26})})
    wider = box.model_copy(update={"size_m": (box.size_m[0] + 1e-6, *box.size_m[1:])})
    others = {
        release_sha256("e", cell, box),
        release_sha256("d", moved, box),
        release_sha256("d", faster, box),
        release_sha256("d", cell, wider),
    }
    assert len(others | {sha256}) == 5


def test_what_is_shown_begins_and_ends_where_the_robot_does(cell, plan):
    answer = build_run_plan(cell, cell.payload_box, plan)
    transfers = [path for path in answer.paths if path.part.startswith(("transfer", "home"))]
    for path, transfer in zip(transfers, [*(leg.transfer for leg in plan.legs), plan.home], strict=True):
        np.testing.assert_allclose(path.q_rad[0], transfer.trajectory.q[0], atol=1e-4)  # as far as the rotation before it is off
        np.testing.assert_allclose(path.q_rad[-1], transfer.trajectory.q[-1], atol=1e-5)
    assert [path.part for path in answer.paths] == ["transfer x-", "transfer x+", "rotation x", "home"]
    for before, after in pairwise(answer.paths):
        np.testing.assert_allclose(before.q_rad[-1], after.q_rad[0], atol=1e-4)
    turned = answer.paths[2]
    assert turned.period_s * (len(turned.q_rad) - 1) == pytest.approx(plan.legs[1].moving_s, abs=turned.period_s)
    assert answer.safety_rated is False
    assert {throw.zone for throw in answer.throws} <= {zone.name for zone in cell.zones}


def test_the_load_flies_off_square_to_axis_and_arm_at_the_speed_that_planning_found(cell, plan):
    held, throw = build_run_plan(cell, cell.payload_box, plan).throws
    leg = plan.legs[1]
    sensor = RobotModel.of_cell(cell).sensor_pose(leg.start.q)
    arm, velocity, axis = np.array(throw.point_m) - sensor.position, np.array(throw.velocity_m_s), sensor.rotation[:, 0]
    assert (held.axis, held.speed_m_s, held.velocity_m_s) == ("x-", 0.0, [0.0, 0.0, 0.0])
    assert throw.axis == "x+"
    assert np.linalg.norm(velocity) == pytest.approx(leg.start.throw.speed_m_s, abs=1e-4)
    assert abs(velocity @ axis) < 1e-4
    assert abs(velocity @ arm) < 1e-4
    assert np.abs(np.linalg.norm(arm) - np.linalg.norm(cell.payload_box.corners, axis=1)).min() < 1e-3
