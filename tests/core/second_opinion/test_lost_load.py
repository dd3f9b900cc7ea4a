"""Loads that come off along motions: the planner's verdict and the second opinion's, each against flights calculated one by one."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.array import Array
from core.cell.cell import Box, Capsule, Cell, Pose, Shape, Sphere, Zone
from core.cell.folder import load_cell
from core.errors import NoPath, PlanDisputed
from core.planning.throw import PAD_M, ThrowCheck
from core.planning.transfer import plan_transfer
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel, SensorPose
from core.second_opinion.arm import Frames
from core.second_opinion.lost_load import FINE_M, RESOLUTION_M, distance_to, nearest_flight
from core.second_opinion.opinion import JointPath, second_opinion
from core.second_opinion.refusal import refuse_disputed

CELLS = Path(__file__).parents[3] / "cells"
PERIOD = 0.001
FAST = 1.2  # m/s of the sensor in these motions


@cache
def bench() -> tuple[Cell, RobotModel]:
    cell = load_cell(CELLS / "ur5e_line")
    return cell, RobotModel.of_cell(cell)


def with_zones(*shapes: Shape) -> Cell:
    return bench()[0].model_copy(update={"zones": tuple(Zone(name=f"zone{k}", shape=shape) for k, shape in enumerate(shapes))})


def swung(seconds: float, rate: float) -> Frames:
    """A sensor that swings about the z axis of the world and turns, 0.7 m beside it and 0.3 m above."""
    angle = 0.5 * (1.0 - np.cos(np.linspace(0.0, 2.0 * np.pi, round(seconds / PERIOD)))) * rate * seconds / np.pi
    turned = np.zeros((len(angle), 3, 3))
    turned[:, 0, 0], turned[:, 0, 1], turned[:, 1, 0], turned[:, 1, 1] = np.cos(angle), -np.sin(angle), np.sin(angle), np.cos(angle)
    turned[:, 2, 2] = 1.0
    return Frames(turned, turned @ np.array([0.7, 0.0, 0.3]))


def depth_of(shape: Shape, points: Array) -> Array:
    """(N,), below the surface, one point after the other."""
    return np.array([shape.depth(point) for point in points])


def one_by_one(cell: Cell, box: Box, sensor: Frames, every: int) -> float:
    """How deep the deepest of all flights gets into a zone, m; negative where none does."""
    centre, ball = box.pose.translation, 0.5 * float(np.linalg.norm(box.size_m))
    deepest = -np.inf
    for k in range(0, len(sensor.position) - 1, every):
        for number, point in enumerate([centre, *box.corners]):
            here, then = (sensor.rotation[i] @ point + sensor.position[i] for i in (k, k + 1))
            t = np.arange(0.0, 1.0, 0.004)[:, None]
            flight = here + (then - here) / PERIOD * t + 0.5 * cell.gravity * t**2
            flight = flight[flight[:, 2] >= cell.floor_z_m]
            for zone in cell.zones:
                deepest = max(deepest, float(depth_of(zone.shape, flight).max()) + (ball if number == 0 else 0.0))
    return deepest


BOX = Box(size_m=(0.06, 0.1, 0.08), pose=Pose(xyz_m=(0.02, 0.0, 0.05), rpy_rad=(0.2, 0.4, 0.0)))


@pytest.mark.thorough
@settings(max_examples=8, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_the_flight_nearest_to_a_round_zone_is_found_as_one_by_one(seed: int) -> None:
    rng = np.random.default_rng(seed)
    x, y, z = float(rng.uniform(0.2, 1.0)), float(rng.uniform(0.2, 1.0)), float(rng.uniform(-0.7, 0.0))
    shapes: list[Shape] = [
        Sphere(kind="sphere", radius_m=0.1, pose=Pose(xyz_m=(x, y, z))),
        Capsule(kind="capsule", radius_m=0.08, length_m=0.3, pose=Pose(xyz_m=(-x, -y, -z), rpy_rad=(0.5, 0.3, 0.0))),
    ]
    cell, sensor = with_zones(*shapes), swung(0.6, FAST / 0.7)
    found = nearest_flight(cell, BOX, sensor, PERIOD)
    assert found is not None
    deepest = one_by_one(cell, BOX, sensor, 12)
    assert -found.distance_m >= deepest - 1e-9
    assert -found.distance_m <= deepest + RESOLUTION_M + FINE_M + 0.03  # of what lies between every twelfth release
    thrown = ThrowCheck(cell).into_zone(BOX, SensorPose(sensor.rotation, sensor.position), PERIOD)
    if deepest > 0.0:
        assert thrown is not None
    if found.distance_m > PAD_M + 0.01:
        assert thrown is None


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_the_second_opinions_distances_reach_to_the_surface_and_no_farther(seed: int) -> None:
    """By membership alone: no point of the ball of that radius is across the surface, and some point of one a little larger is."""
    rng = np.random.default_rng(seed)
    pose = Pose(xyz_m=(0.1, -0.2, 0.3), rpy_rad=(0.4, -0.7, 1.2))
    rays = rng.normal(size=(4000, 3))
    rays /= np.linalg.norm(rays, axis=1, keepdims=True)
    shapes: list[Shape] = [
        Box(size_m=(0.3, 0.2, 0.4), pose=pose),
        Sphere(kind="sphere", radius_m=0.2, pose=pose),
        Capsule(kind="capsule", radius_m=0.1, length_m=0.3, pose=pose),
    ]
    for shape in shapes:
        for point in pose.translation + rng.uniform(-0.3, 0.3, (2, 3)):
            distance = float(distance_to(shape)(point))
            inside = shape.depth(point) > 0.0
            assert (distance < 0.0) == inside
            within, beyond = (depth_of(shape, point + each * rays) > 0.0 for each in (0.999 * abs(distance), 1.05 * abs(distance) + 0.005))
            assert (within == inside).all()
            assert (beyond != inside).any()


def test_a_motion_beside_a_zone_throws_a_load_into_it_only_when_it_is_fast() -> None:
    cell, box = bench()[0], Box(size_m=(0.06, 0.06, 0.06))
    for rate, expected in ((0.1, False), (FAST / 0.7, True)):
        sensor = swung(0.6 if expected else 2.0, rate)
        beside = sensor.position[int(np.argmax(sensor.position[:, 1]))] + [0.0, 0.25, -0.6]
        near = cell.model_copy(update={"zones": (Zone(name="near", shape=Box(size_m=(2.0, 0.1, 0.4), pose=Pose(xyz_m=tuple(beside)))),)})
        thrown = ThrowCheck(near).into_zone(box, SensorPose(sensor.rotation, sensor.position), PERIOD)
        found = nearest_flight(near, box, sensor, PERIOD)
        assert (thrown is not None) is expected
        assert found is not None and (found.distance_m < 0.0) is expected
        if thrown is not None:
            assert thrown.zone == found.zone == "near"


def over_a_zone() -> tuple[Cell, RobotModel, CollisionModel, Array, Array]:
    """A bare cell, a turn of the first joint, and a low zone under the middle of the way."""
    cell, robot = bench()
    box = Box(size_m=(0.08, 0.08, 0.08), pose=Pose(xyz_m=(0.0, 0.0, 0.04)))
    start, goal = np.array(cell.robot.home_rad), np.array(cell.robot.home_rad)
    start[0], goal[0] = -0.7, 0.7
    x, y, _ = robot.sensor_pose(0.5 * (start + goal)).position
    below = Box(size_m=(0.12, 0.12, 0.2), pose=Pose(xyz_m=(float(x), float(y), -0.65)))
    cell = cell.model_copy(update={"obstacles": (), "zones": (Zone(name="below", shape=below),)})
    return cell, robot, CollisionModel(cell, robot, box), start, goal


def test_a_transfer_goes_round_a_zone_into_which_a_load_would_fall_though_there_is_room_above_it() -> None:
    cell, robot, collision, start, goal = over_a_zone()
    free = cell.model_copy(update={"zones": ()})
    straight = plan_transfer(free, robot, CollisionModel(free, robot, collision.payload_box), start, goal, period=PERIOD, seed=1)
    assert collision.obstacle_distance(straight.trajectory.q[len(straight.trajectory) // 2]).distance_m > 0.3
    blind = second_opinion(cell, collision.payload_box, [JointPath("transfer x+", straight.trajectory.q)], PERIOD)
    lost = blind.lost_load
    assert lost is not None and lost in blind.violations
    assert lost.zone == "below" and lost.part == "transfer x+"
    middle = robot.sensor_pose(straight.trajectory.q[round(lost.time_s / PERIOD)]).position
    assert np.linalg.norm((middle - cell.zones[0].shape.pose.translation)[:2]) < 0.2
    with pytest.raises(
        PlanDisputed, match=r"a load that comes off at 0\.\d+ m/s, .* of transfer x\+, would fly 0\.\d+ m into zone \"below\""
    ):
        refuse_disputed(cell, blind)
    round_it = plan_transfer(cell, robot, collision, start, goal, period=PERIOD, seed=1)
    seen = second_opinion(cell, collision.payload_box, [JointPath("transfer x+", round_it.trajectory.q)], PERIOD)
    assert seen.passes
    poses = robot.sensor_poses(round_it.trajectory.q)
    assert one_by_one(cell, collision.payload_box, Frames(poses.rotation, poses.position), 40) < 0.0


def test_a_goal_above_a_zone_is_refused_in_words() -> None:
    cell, robot, collision, start, goal = over_a_zone()
    with pytest.raises(NoPath, match=r"at the goal of the path a load that comes off would fall 0\.\d{4} m into zone \"below\"") as caught:
        plan_transfer(cell, robot, collision, start, 0.5 * (start + goal), period=PERIOD)
    assert caught.value.in_the_way == "below"
    with pytest.raises(NoPath, match="at the start of the path a load"):
        plan_transfer(cell, robot, collision, 0.5 * (start + goal), 0.5 * (start + goal), period=PERIOD)


def test_where_a_load_would_be_thrown_into_a_zone_the_transfer_is_slower() -> None:
    """A wall beside the way, low and long: what falls from rest stays 3 cm beside it, what is thrown along the tangent does not."""
    cell, robot, collision, start, goal = over_a_zone()
    fast = cell.model_copy(update={"limits": cell.limits.model_copy(update={"cartesian_speed_m_s": 1.0}), "zones": ()})
    x, y, _ = robot.sensor_pose(0.5 * (start + goal)).position
    outward = np.array([x, y]) / np.hypot(x, y)
    ball = 0.04 * np.sqrt(3.0) + PAD_M
    place = np.array([x, y]) + (ball + 0.03 + 0.05) * outward
    turned = Pose(xyz_m=(float(place[0]), float(place[1]), -0.6), rpy_rad=(0.0, 0.0, float(np.arctan2(outward[1], outward[0]))))
    wall = Zone(name="wall", shape=Box(size_m=(0.1, 1.5, 0.4), pose=turned))
    speeds = []
    for zones in ((), (wall,)):
        here = fast.model_copy(update={"zones": zones})
        moved = plan_transfer(here, robot, CollisionModel(here, robot, collision.payload_box), start, goal, period=PERIOD, seed=1)
        speeds.append(np.linalg.norm(np.diff(robot.sensor_poses(moved.trajectory.q).position, axis=0), axis=1).max() / PERIOD)
        assert second_opinion(here, collision.payload_box, [JointPath("transfer x+", moved.trajectory.q)], PERIOD).passes
        poses = robot.sensor_poses(moved.trajectory.q)
        assert one_by_one(here, collision.payload_box, Frames(poses.rotation, poses.position), 40) < 0.0
    assert speeds[0] > 0.7
    assert speeds[1] < 0.6 * speeds[0]


def test_without_zones_there_is_nothing_to_fly_into() -> None:
    cell, sensor = with_zones(), swung(0.1, 1.0)
    assert nearest_flight(cell, BOX, sensor, PERIOD) is None
    assert ThrowCheck(cell).into_zone(BOX, SensorPose(sensor.rotation, sensor.position), PERIOD) is None
    assert ThrowCheck(cell).drop(BOX, SensorPose(sensor.rotation, sensor.position)) is None
