"""Stops planned in both cells: every motion keeps limits, distances and zones, by an independent look at the samples."""

from __future__ import annotations

import numpy as np
import pytest

from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.cell.tools import widest_box
from core.errors import NoPath, PlanDisputed
from core.events import Event, Planned, drive
from core.gap.planned_path import path_of
from core.planning.confirmation import Confirmation, confirm_plan
from core.planning.plan import Leg, Plan
from core.planning.search import ANOTHER_SEED, plan_stops
from core.planning.settings import Timing
from core.planning.stop import Stop, Swings, Wave
from core.planning.torque_wave import list_waves
from core.planning.wave import fit_wave
from core.recording.recording import Recording
from core.robot.collision import CollisionModel
from core.robot.decoupling import decoupling_profile
from core.robot.model import RobotModel
from core.second_opinion.part_name import name_part

STOPS = (
    Stop(down=(0.0, 0.0, 1.0), swings=Swings(about="x", repetitions=2)),
    Stop(down=(0.6, 0.0, 0.8), wave=Wave(lowest_hz=2.0, highest_hz=10.0, seconds=4.0)),
)


@pytest.fixture(scope="module", params=["lwr4_bench", "ur5e_line"])
def planned(request: pytest.FixtureRequest) -> tuple[Cell, RobotModel, CollisionModel, Plan, list[Event]]:
    """A rotation about a horizontal axis, then a wide-band motion."""
    cell = load_cell(find_cell(request.param))
    robot = RobotModel.of_cell(cell)
    box = cell.payloads["cylinder"].box
    collision = CollisionModel(cell, robot, box)
    events: list[Event] = []
    plan = drive(plan_stops(cell, robot, collision, box, STOPS, start=np.array(cell.robot.home_rad)), events.append)
    return cell, robot, collision, plan, events


def path(planned: tuple[Cell, RobotModel, CollisionModel, Plan, list[Event]]) -> Recording:
    """All of it at 1 kHz."""
    cell, robot, _, plan, _ = planned
    like = Recording(t=np.array([0.0, 0.001]), gravity=cell.gravity, robot=robot.description)
    return path_of(plan, robot, like)


def test_it_goes_from_home_through_the_stops_to_home(planned):
    cell, robot, _, plan, events = planned
    whole = path(planned)
    np.testing.assert_allclose(whole.q[[0, -1]], [cell.robot.home_rad] * 2, atol=1e-9)
    assert [leg.axis for leg in plan.legs] == ["z+", "free"]
    assert {"transfer", "hold:z+", "rotate:x", "hold:free"} == set(whole.phase)
    assert plan.robot_s == pytest.approx(whole.t[-1], abs=0.05)
    assert isinstance(events[-1], Planned)
    down = cell.gravity / np.linalg.norm(cell.gravity)
    for leg, stop in zip(plan.legs, STOPS, strict=True):
        np.testing.assert_allclose(down @ robot.sensor_pose(leg.start.q).rotation, stop.down, atol=1e-5)


def test_no_point_and_no_joint_is_too_fast_at_any_tick(planned):
    cell, robot, collision, _, _ = planned
    q = path(planned).q
    velocity = robot.velocity if cell.robot.velocity_rad_s is None else np.array(cell.robot.velocity_rad_s)
    assert (np.abs(np.diff(q, axis=0)) / 0.001 <= velocity).all()
    corners = collision.payload_box.corners
    poses = robot.sensor_poses(q)
    there = poses.position[:, None] + corners @ np.swapaxes(poses.rotation, 1, 2)
    assert np.linalg.norm(np.diff(there, axis=0), axis=2).max() / 0.001 <= cell.limits.cartesian_speed_m_s


def test_every_required_distance_is_kept(planned):
    _, _, collision, _, _ = planned
    assert min(collision.margin(row) for row in path(planned).q[::20]) >= 0.0


def test_a_wave_keeps_the_acceleration_limits_and_comes_back_to_where_it_began(planned):
    cell, _, _, plan, _ = planned
    wave = plan.legs[1].wave
    acceleration = np.abs(np.diff(wave.q, 2, axis=0)) / wave.period**2
    assert (acceleration <= np.array(cell.robot.acceleration_rad_s2)).all()
    assert acceleration.max() > 1.0  # and it is not a motion in name only
    np.testing.assert_allclose(wave.q[[0, -1]], [plan.legs[1].start.q] * 2, atol=1e-9)


def test_an_open_wave_is_chosen_while_planning_and_the_whole_is_confirmed(planned):
    """Whoever carries the plan out reads in its stops which one it is."""
    cell, robot, collision, _, _ = planned
    stops = (Stop(down=(0.6, 0.0, 0.8), wave=Wave(lowest_hz=0.2, highest_hz=3.0, seconds=5.0, wrist=None)),)
    plan = drive(plan_stops(cell, robot, collision, collision.payload_box, stops, start=np.array(cell.robot.home_rad)))
    (leg,) = plan.legs
    assert leg.stop.wave in list_waves(stops[0].wave)
    assert leg.wave.duration == pytest.approx(5.0)
    assert [path.name for path in plan.commanded] == ["transfer free", "wave free", "home"]
    assert plan.opinion.samples >= len(leg.wave.q)
    assert plan.torques.largest.ratio <= 1.0


def test_a_wave_without_room_is_refused_in_words(planned):
    _, robot, collision, plan, _ = planned
    cell = planned[0]
    q = plan.legs[1].start.q.copy()
    q[1] = robot.upper[1]
    shape = plan.legs[1].wave.q - plan.legs[1].start.q
    with pytest.raises(NoPath, match="no room for a wide-band motion"):
        fit_wave(cell, robot, collision, q, shape, 0.001)


def test_rotations_without_a_number_share_the_robot_time_that_the_rest_leaves(planned):
    """One with a number keeps it; one without is repeated until the time is used up, where the accuracy asks for more than there is."""
    cell, robot, collision, _, _ = planned
    timing = Timing(inertia_std=1e-6, robot_s=60.0)
    stops = (
        Stop(down=(0.0, 0.0, 1.0), swings=Swings(about="x", repetitions=2)),
        Stop(down=(0.0, 0.0, 1.0), swings=Swings(about="z", repetitions=None)),
    )
    plan = drive(plan_stops(cell, robot, collision, collision.payload_box, stops, start=np.array(cell.robot.home_rad), timing=timing))
    counted, free = (leg.profile for leg in plan.legs)
    once = decoupling_profile(
        widest_box(cell, collision.payload_box), cartesian_speed=cell.limits.cartesian_speed_m_s, period=0.001, excursion=0.25
    )
    assert counted.duration == pytest.approx(2 * once.duration)
    assert free.duration > 3 * once.duration
    assert timing.robot_s - once.duration <= plan.robot_s <= timing.robot_s


def test_a_plan_that_the_second_opinion_disputes_is_made_again_from_another_seed(planned, monkeypatch):
    """The first opinion is overheard and the plan disputed; the second stands."""
    cell, robot, collision, _, _ = planned
    made: list[tuple[Leg, ...]] = []

    def dispute_first(*what: object) -> Confirmation:
        made.append(tuple(what[4]))
        if len(made) <= disputed:
            raise PlanDisputed("planning-not-feasible", part=name_part("home"))
        return confirm_plan(*what)

    monkeypatch.setattr("core.planning.search.confirm_plan", dispute_first)
    stops, home = (Stop(down=(0.0, 0.0, 1.0)),), np.array(cell.robot.home_rad)
    disputed = 1
    plan = drive(plan_stops(cell, robot, collision, collision.payload_box, stops, start=home))
    assert len(made) == 2
    assert np.abs(made[0][0].start.q - made[1][0].start.q).max() > 1e-3
    assert plan.legs == made[1]
    disputed = 100
    made.clear()
    with pytest.raises(PlanDisputed):
        drive(plan_stops(cell, robot, collision, collision.payload_box, stops, start=home))
    assert len(made) == ANOTHER_SEED
