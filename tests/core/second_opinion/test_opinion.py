"""The second opinion against Pinocchio and Coal, against a look at every sample, and on plans that are wrong in one place."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import coal
import fcl
import numpy as np
import pytest
import trimesh
from scipy.spatial.transform import Rotation

from core.array import Array
from core.cell.cell import Box, Cell, Pose
from core.cell.folder import load_cell
from core.errors import BadRobot, PlanDisputed
from core.events import drive
from core.planning.commanded_path import PlanPart, compute_joint_paths
from core.planning.confirmation import confirm_plan
from core.planning.joint_torques import JointTorques, guess_load
from core.planning.plan import Plan, plan_summary
from core.planning.search import plan_stops
from core.planning.settings import Scope
from core.planning.stops import Stops
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.point_speed import point_speeds
from core.second_opinion import solids
from core.second_opinion.arm import Frames, build_solid_arm
from core.second_opinion.least import find_least
from core.second_opinion.left_out import describe_left_out
from core.second_opinion.opinion import Approach, JointPath, Opinion, PeakSpeed, _exact, _steps, second_opinion
from core.second_opinion.pairs import PairKind, Placed, classify_pairs, place_bodies, place_standing
from core.second_opinion.refusal import refuse_disputed
from tests.core.robot.mesh_bytes import dae, elbow

CELLS = Path(__file__).parents[3] / "cells"
NAMES = ("lwr4_bench", "ur5e_line")
PERIOD = 0.001


@dataclass(frozen=True)
class Bench:
    cell: Cell
    robot: RobotModel
    collision: CollisionModel

    @property
    def home(self) -> Array:
        return np.array(self.cell.robot.home_rad)


@cache
def bench(name: str) -> Bench:
    cell = load_cell(CELLS / name)
    robot = RobotModel.of_cell(cell)
    return Bench(cell, robot, CollisionModel(cell, robot, cell.payload_box))


@cache
def planned(name: str) -> Plan:
    at = bench(name)
    return drive(plan_stops(at.cell, at.robot, at.collision, at.cell.payload_box, Stops.of_procedure(Scope("x")).stops, start=at.home))


def postures(robot: RobotModel, count: int) -> Array:
    return np.random.default_rng(3).uniform(robot.lower, robot.upper, (count, robot.n))


def there_and_back(home: Array, away: Array, seconds: float) -> Array:
    """(N, n), from home by `away` (n,) and back, smoothly."""
    share = 0.5 - 0.5 * np.cos(np.linspace(0.0, 2.0 * np.pi, round(seconds / PERIOD)))
    return np.asarray(home + share[:, None] * away)


@pytest.mark.parametrize("name", NAMES)
def test_its_kinematics_are_pinocchios(name: str) -> None:
    at = bench(name)
    arm, q = build_solid_arm(at.cell, at.cell.payload_box), postures(at.robot, 50)
    own, theirs = arm.sensor_frames(q), at.robot.sensor_poses(q)
    np.testing.assert_allclose(own.rotation, theirs.rotation, atol=1e-12)
    np.testing.assert_allclose(own.position, theirs.position, atol=1e-12)


@pytest.mark.parametrize("name", NAMES)
def test_its_distances_are_coals_for_every_pair_that_the_planner_watches(name: str) -> None:
    at = bench(name)
    arm = build_solid_arm(at.cell, at.cell.payload_box)
    q = postures(at.robot, 200)
    bodies = [*place_bodies(arm, q), *place_standing(at.cell)]
    number = {body.name: i for i, body in enumerate(bodies)}
    watched = [pair for group in at.collision.pairs for pair in group]
    errors = []
    for k, row in enumerate(q):
        theirs = at.collision.margins(row)[at.collision.watched] + at.collision.required_m
        own = []
        for first, second in watched:
            a, b = bodies[number[first.name]], bodies[number[second.name]]
            own.append(solids.distance(a.at(k), b.at(k)))
        errors.append(np.array(own) - theirs)
    assert np.percentile(np.abs(errors), 99) < 1e-9
    assert np.max(errors) < 1e-7
    assert np.min(errors) > -1e-5  # libccd now and then ends its iteration early, on the near side


def test_round_solids_are_exact_where_python_fcl_by_itself_is_not() -> None:
    rng = np.random.default_rng(1)
    for own, theirs in (
        (solids.sphere(0.1), coal.Sphere(0.1)),
        (solids.capsule(0.06, 0.3), coal.Capsule(0.06, 0.3)),
        (solids.hull(Box(size_m=(0.1, 0.2, 0.3)).corners), coal.Box(0.1, 0.2, 0.3)),
    ):
        for _ in range(200):
            turns, places = Rotation.random(2, rng=rng).as_matrix(), rng.uniform(-0.4, 0.4, (2, 3))
            between = _distance_of(own, solids.box(np.array([0.1, 0.2, 0.15])), turns, places)
            there = [coal.Transform3s(turn, place) for turn, place in zip(turns, places, strict=True)]
            coals = coal.distance(theirs, there[0], coal.Box(0.1, 0.2, 0.15), there[1], coal.DistanceRequest(), coal.DistanceResult())
            assert between == pytest.approx(coals, abs=1e-6)


def test_a_cylinder_is_never_seen_farther_than_it_is() -> None:
    rng = np.random.default_rng(2)
    for _ in range(200):
        turns, places = Rotation.random(2, rng=rng).as_matrix(), rng.uniform(-0.4, 0.4, (2, 3))
        between = _distance_of(solids.cylinder(0.08, 0.3), solids.box(np.full(3, 0.1)), turns, places)
        there = [coal.Transform3s(turn, place) for turn, place in zip(turns, places, strict=True)]
        coals = coal.distance(
            coal.Cylinder(0.08, 0.3), there[0], coal.Box(0.1, 0.1, 0.1), there[1], coal.DistanceRequest(), coal.DistanceResult()
        )
        assert -0.0013 * 0.08 - 1e-6 < between - coals < 1e-6


def _distance_of(first: solids.Solid, second: solids.Solid, turns: Array, places: Array) -> float:
    return solids.distance(solids.place(first, turns[0], places[0]), solids.place(second, turns[1], places[1]))


def test_boxes_nearly_parallel_are_no_farther_than_they_are_where_python_fcl_puts_them_farther() -> None:
    rng = np.random.default_rng(4)
    size = np.array([0.13, 0.12, 0.2])
    farther = []
    for _ in range(3000):
        turns = Rotation.from_euler("xyz", rng.uniform(-3e-3, 3e-3, (2, 3)) * rng.integers(0, 2, (2, 3))).as_matrix()
        places = np.array([[0.0, 0.0, 0.0], [*rng.uniform(-0.1, 0.1, 2), rng.uniform(0.25, 0.6)]])
        there = [coal.Transform3s(turn, place) for turn, place in zip(turns, places, strict=True)]
        shapes = coal.Box(*size), coal.Box(*size)
        coals = coal.distance(shapes[0], there[0], shapes[1], there[1], coal.DistanceRequest(), coal.DistanceResult())
        by_itself = [fcl.CollisionObject(fcl.Box(*size), fcl.Transform(turn, place)) for turn, place in zip(turns, places, strict=True)]
        farther.append(fcl.distance(*by_itself, fcl.DistanceRequest(), fcl.DistanceResult()) - coals)
        assert _distance_of(solids.box(size), solids.box(size), turns, places) == pytest.approx(coals, abs=1e-6)
    assert max(farther) > 1e-5


def test_a_convex_mesh_is_its_hull_and_one_that_cannot_be_read_is_refused(tmp_path: Path) -> None:
    trimesh.creation.box(extents=(2.0, 4.0, 6.0)).export(tmp_path / "box.stl")
    (tmp_path / "box.txt").write_text("no mesh")
    scaled = ET.fromstring('<geometry><mesh filename="box.stl" scale="0.1 0.1 0.1"/></geometry>')
    (found,) = solids.solids_of_geometries([scaled], tmp_path)
    assert found.surface is None
    np.testing.assert_allclose(found.corners.max(axis=0), [0.1, 0.2, 0.3], atol=1e-9)
    with pytest.raises(BadRobot, match="an STL, OBJ or DAE file"):
        solids.solids_of_geometries([ET.fromstring('<geometry><mesh filename="box.txt"/></geometry>')], tmp_path)


def test_a_mesh_that_is_not_convex_is_as_far_as_its_triangles_and_no_nearer_from_inside(tmp_path: Path) -> None:
    elbow().export(tmp_path / "elbow.stl")
    (found,) = solids.solids_of_geometries([ET.fromstring('<geometry><mesh filename="elbow.stl"/></geometry>')], tmp_path)
    small, turn = solids.box(np.full(3, 0.02)), np.eye(3)
    bar = solids.box(np.array([0.02, 0.02, 0.4]))

    def from_elbow(other: solids.Solid, x: float, y: float, z: float = 0.025) -> float:
        return solids.distance(solids.place(found, turn, np.zeros(3)), solids.place(other, turn, np.array([x, y, z])))

    assert from_elbow(small, 0.12, 0.10) == pytest.approx(0.04, abs=1e-9)  # in the hull, beside both arms
    assert from_elbow(solids.sphere(0.01), 0.10, 0.12) == pytest.approx(0.04, abs=1e-9)
    assert from_elbow(solids.capsule(0.01, 0.2), 0.10, 0.12) == pytest.approx(0.04, abs=1e-9)
    assert from_elbow(bar, 0.2, 0.03) < 0.0  # through an arm
    assert from_elbow(solids.sphere(0.01), 0.3, 0.025) < 0.0  # within it, meeting no surface
    assert from_elbow(small, 0.5, 0.025) == pytest.approx(0.09, abs=1e-6)  # as far as the hulls
    inside = solids.distance(solids.place(small, turn, np.array([0.12, 0.10, 0.025])), solids.place(found, turn, np.zeros(3)))
    assert inside == pytest.approx(0.04, abs=1e-9)


def test_a_dae_is_read_with_its_nodes_and_its_unit(tmp_path: Path) -> None:
    nodes = '<node id="n"><translate>1 2 3</translate><instance_geometry url="#body"/></node>'
    (tmp_path / "a.dae").write_bytes(dae(nodes, unit="0.1"))
    (found,) = solids.solids_of_geometries([ET.fromstring('<geometry><mesh filename="a.dae"/></geometry>')], tmp_path)
    np.testing.assert_allclose([found.corners.min(axis=0), found.corners.max(axis=0)], [[0.1, 0.2, 0.3], [0.11, 0.21, 0.31]], atol=1e-9)


@pytest.mark.parametrize("name", NAMES)
def test_what_it_finds_is_what_a_look_at_every_sample_finds(name: str) -> None:
    at = bench(name)
    q = there_and_back(at.home, np.linspace(1.0, -0.6, at.robot.n), 0.6)
    opinion = second_opinion(at.cell, at.cell.payload_box, [JointPath("first", q[:250]), JointPath("second", q[250:])], PERIOD)
    bodies = [*place_bodies(build_solid_arm(at.cell, at.cell.payload_box), q), *place_standing(at.cell)]
    for found in opinion.approaches:
        pairs = [pair for pair in opinion.pairs if pair.kind == found.kind]
        margins = np.array(
            [
                [solids.distance(a.at(k), b.at(k)) - pair.required_m for k in range(len(q))]
                for pair in pairs
                for a, b in [[bodies[i] for i in pair.bodies]]
            ]
        )
        margin = found.distance_m - found.required_m
        assert margins.min() <= margin <= margins.min() + pairs[int(np.argmin(margins.min(axis=1)))].resolution_m
        sample = round(found.time_s / PERIOD) + (250 if found.part == "second" else 0)
        pair = next(i for i, each in enumerate(pairs) if (each.first, each.second) == (found.first, found.second))
        assert margins[pair, sample] == margin


def test_a_least_margin_just_below_zero_is_found_however_coarse_the_figures_may_be() -> None:
    margins = np.full((3, 1000), 0.0005)
    margins[1, 617] = -0.0001
    ways = [np.linspace(0.0, 1.0, 1000)] * 3
    found = find_least(ways, lambda pair, sample: float(margins[pair, sample]), resolutions=[0.01] * 3)
    assert (found.pair, found.sample) == (1, 617)


def test_a_margin_that_hardly_changes_costs_few_looks_and_one_that_must_be_exact_is() -> None:
    """A link that turns beside its round base moves far and keeps its distance."""
    rng = np.random.default_rng(5)
    margins = np.array([0.02 + 1e-5 * rng.random(20_000), 0.05 + 0.02 * np.cos(np.linspace(0.0, 6.0, 20_000))])
    ways, looks = [np.linspace(0.0, 4.0, 20_000)] * 2, np.zeros(2, dtype=int)

    def margin(pair: int, sample: int) -> float:
        looks[pair] += 1
        return float(margins[pair, sample])

    flat = find_least(ways[:1], margin, resolutions=[0.001])
    assert margins[0].min() <= flat.margin <= margins[0].min() + 0.001
    assert looks[0] < 20_000 / 4
    both = find_least(ways[::-1], lambda pair, sample: margin(1 - pair, sample), resolutions=[0.0, 0.001])
    assert both.margin == pytest.approx(0.02, abs=2e-5)
    wave = find_least(ways[1:], lambda _, sample: margin(1, sample), resolutions=[0.0])
    assert wave.margin == margins[1].min()


@pytest.mark.parametrize("name", NAMES)
def test_a_plan_of_a_shipped_cell_passes_with_its_rotation_and_says_no_other_distance_than_the_planner(name: str) -> None:
    at, plan = bench(name), planned(name)
    assert plan.opinion.passes
    assert plan.opinion.samples > plan.robot_s / PERIOD * 0.5
    around = [each for each in plan.opinion.approaches if each.kind == PairKind.ENVIRONMENT]
    assert around[0].distance_m <= min(leg.start.least_clearance_m for leg in plan.legs) + 1e-4
    assert around[0].distance_m >= at.cell.limits.clearance_m
    assert plan.opinion.fastest.speed_m_s == pytest.approx(0.96 * at.cell.limits.cartesian_speed_m_s, rel=0.01)


def approach(opinion: Opinion, kind: PairKind) -> Approach:
    return next(each for each in opinion.approaches if each.kind == kind)


@pytest.mark.parametrize("name", NAMES)
def test_a_path_bent_into_an_obstacle_by_5_mm_is_found_at_its_deepest_place(name: str) -> None:
    at = bench(name)
    down = np.zeros(at.robot.n)
    down[1], down[3] = 1.0, -0.6 if name == "lwr4_bench" else 0.0  # carries the arm down to what it stands on
    near = [angle for angle in np.arange(0.0, 2.4, 0.01) if at.collision.obstacle_distance(at.home + angle * down).distance_m < -0.005]
    low, high = near[0] - 0.01, near[0]  # Coal says how far
    while high - low > 1e-10:
        middle = 0.5 * (low + high)
        free = at.collision.obstacle_distance(at.home + middle * down).distance_m > -0.005
        low, high = (middle, high) if free else (low, middle)
    theirs = at.collision.obstacle_distance(at.home + low * down)
    q = there_and_back(at.home, low * down, 6.0)
    opinion = second_opinion(at.cell, at.cell.payload_box, [JointPath("transfer x+", q[:2000]), JointPath("home", q[2000:])], PERIOD)
    found = approach(opinion, PairKind.ENVIRONMENT)
    assert opinion.violations[0] == found
    assert (found.first, found.second, found.part) == (theirs.first, theirs.second, "home")
    assert found.distance_m == pytest.approx(-0.005, abs=2e-6)
    assert found.time_s == pytest.approx(1.0, abs=2.5 * PERIOD)
    with pytest.raises(
        PlanDisputed, match=rf"{theirs.first}\W* -0.0050 m from \w+ \"{theirs.second}\" \(limit 0.030 m\).*of home"
    ) as refused:
        refuse_disputed(at.cell, opinion)
    assert refused.value.in_the_way == theirs.second


def test_a_payload_box_that_turns_into_the_wrist_is_found() -> None:
    at = bench("lwr4_bench")
    beside = Box(size_m=(0.03, 0.03, 0.14), pose=Pose(xyz_m=(0.085, 0.0, -0.02)))  # 5 mm beside the cube of link6, which is 130 mm wide
    share = np.linspace(0.0, 1.0, 2001)
    q = at.home + 0.5 * np.pi * share[:, None] * np.eye(7)[6]
    opinion = second_opinion(at.cell, beside, [JointPath("rotation z", q)], PERIOD)
    found = approach(opinion, PairKind.PAYLOAD)
    assert found in opinion.violations
    assert (found.first, found.second) == ("payload", "link6")
    assert found.distance_m == pytest.approx(0.07 - 0.065 * np.sqrt(2.0), abs=1e-3)  # an edge of the cube, at 45 degrees
    assert found.time_s == pytest.approx(1.0, abs=0.1)


def test_a_payload_bent_back_into_the_forearm_is_found() -> None:
    at = bench("lwr4_bench")
    away = np.array([0.0, 0.0, 0.0, 0.0, 0.0, -2.09 - at.home[5], 0.0])
    opinion = second_opinion(at.cell, at.cell.payload_box, [JointPath("transfer y-", there_and_back(at.home, away, 10.0))], PERIOD)
    found = approach(opinion, PairKind.PAYLOAD)
    assert found in opinion.violations
    assert (found.first, found.second, found.part, found.required_m) == ("payload", "link5", "transfer y-", 0.01)
    assert found.time_s == pytest.approx(5.0, abs=0.1)


@pytest.mark.parametrize("name", NAMES)
def test_a_speed_3_percent_over_the_limit_is_found_with_its_body_and_time(name: str) -> None:
    at = bench(name)
    turn = np.eye(at.robot.n)[0]
    speeds = point_speeds(at.robot.chain, at.collision.points, at.home[None], turn[None])[0]
    rate = 1.03 * at.cell.limits.cartesian_speed_m_s / speeds.max()
    angle = 0.6  # rad, first half of there and back: fastest in its middle
    seconds = 0.5 * np.pi * angle / rate
    q = there_and_back(at.home, angle * turn, 2.0 * seconds)
    opinion = second_opinion(at.cell, at.cell.payload_box, [JointPath("home", q[: len(q) // 2])], PERIOD)
    (found,) = opinion.violations
    assert isinstance(found, PeakSpeed)
    assert found.speed_m_s == pytest.approx(1.03 * 0.25, rel=2e-3)
    assert found.body == at.collision.points.owner[int(np.argmax(speeds))]
    assert found.time_s == pytest.approx(0.5 * seconds, abs=2.5 * PERIOD)
    with pytest.raises(PlanDisputed, match=rf"{found.body}\W* at 0.257\d m/s \(limit 0.250 m/s\)"):
        refuse_disputed(at.cell, opinion)


def test_a_mesh_is_no_faster_than_its_own_points_though_the_box_round_it_is() -> None:
    octahedron = solids.hull(0.1 * np.vstack([np.eye(3), -np.eye(3)]))
    turned = Rotation.from_rotvec(np.linspace(0.0, 0.01, 11)[:, None] * [0.0, 0.0, 1.0]).as_matrix()
    body = Placed("link", 1, octahedron, Frames(turned, np.zeros((11, 3))))
    of_box = _steps(body.frames, octahedron.corners)
    np.testing.assert_allclose(of_box, 1e-4 * np.sqrt(2.0), rtol=1e-6)
    np.testing.assert_allclose(_exact(body, of_box, 1.2e-4), 1e-4, rtol=1e-6)
    assert _exact(body, of_box, 1.5e-4) is of_box


def test_a_step_between_two_parts_is_a_speed() -> None:
    at = bench("ur5e_line")
    apart = [JointPath("transfer x-", at.home[None]), JointPath("home", at.home[None] + 1e-3)]
    found = second_opinion(at.cell, at.cell.payload_box, apart, PERIOD).violations[-1]
    assert isinstance(found, PeakSpeed)
    assert (found.part, found.time_s) == ("home", 0.0)


def test_a_set_point_that_is_no_number_is_not_judged() -> None:
    at = bench("ur5e_line")
    with pytest.raises(ValueError, match="not finite"):
        second_opinion(at.cell, at.cell.payload_box, [JointPath("home", np.full((3, 6), np.nan))], PERIOD)


@pytest.mark.parametrize("name", NAMES)
def test_every_pair_is_accounted_for_once_and_each_that_the_planner_watches_is_judged(name: str) -> None:
    at = bench(name)
    pairs = classify_pairs(at.cell, build_solid_arm(at.cell, at.cell.payload_box))
    names = [frozenset((pair.first, pair.second)) for pair in pairs]
    assert len(set(names)) == len(names)
    judged = {name for name, pair in zip(names, pairs, strict=True) if pair.kind.is_judged}
    assert {frozenset((first.name, second.name)) for group in at.collision.pairs for first, second in group} <= judged
    assert all(pair.why for pair in pairs)


@pytest.mark.parametrize("name", NAMES)
def test_a_rotation_is_judged_as_the_controller_will_command_it(name: str) -> None:
    at, plan = bench(name), planned(name)
    leg = plan.legs[-1]
    assert leg.profile is not None
    (path,) = compute_joint_paths(at.cell, at.robot, at.collision, [PlanPart("rotation x", leg.profile, "x")], leg.start.q)
    poses = at.robot.sensor_poses(path.q)
    about = Rotation.from_matrix(poses.rotation[0].T @ poses.rotation).as_rotvec()
    assert np.abs(poses.position - poses.position[0]).max() < 1e-5
    assert np.abs(about[:, 1:]).max() < 1e-4
    assert np.abs(about[:, 0]).max() == pytest.approx(np.abs(leg.profile.angle).max(), rel=1e-3)


def test_what_it_says_stands_in_the_plans_summary_beside_the_planners_own_figures() -> None:
    plan = planned("ur5e_line")
    told = plan_summary(bench("ur5e_line").cell, plan).second_opinion
    assert told is not None and told.samples == plan.opinion.samples
    assert [(each.first, each.second) for each in told.closest] == [(each.first, each.second) for each in plan.opinion.approaches]
    assert [each.required_m for each in told.closest] == [each.required_m for each in plan.opinion.approaches]
    assert told.fastest.speed_m_s == plan.opinion.fastest.speed_m_s
    assert told.lost_load is not None and plan.opinion.lost_load is not None
    assert (told.lost_load.zone, told.lost_load.distance_m) == (plan.opinion.lost_load.zone, plan.opinion.lost_load.distance_m)


def test_the_largest_share_of_a_torque_stands_in_the_plans_summary() -> None:
    plan = planned("lwr4_bench")
    told = plan_summary(bench("lwr4_bench").cell, plan).torques
    assert told == plan.torques
    assert told is not None and told.largest is not None and not told.not_judged
    assert told.mass_kg == 1.0
    assert 0.0 < told.largest.ratio < 1.0


@pytest.mark.thorough
@pytest.mark.parametrize("name", NAMES)
def test_the_least_distance_of_a_plan_is_that_of_everything_that_moves_the_first_link_too(name: str, fcl_scene: Callable[..., Any]) -> None:
    at, plan = bench(name), planned(name)
    told = plan_summary(at.cell, plan)
    scene = fcl_scene(at.cell, at.cell.payload_box)
    base = {body.name for body in build_solid_arm(at.cell, at.cell.payload_box).bodies if body.joint == 0}
    rows = np.concatenate([*(leg.transfer.trajectory.q[::25] for leg in plan.legs), plan.home.trajectory.q[::25]])
    seen = {
        pair: min(found[pair] for found in map(scene.to_environment, rows)) for pair in scene.to_environment(rows[0]) if pair[0] not in base
    }
    assert told.least_distance_m is not None
    assert told.least_distance_m <= min(seen.values()) + 1e-3
    assert told.least_distance_m >= min(seen.values()) - 0.02  # how far anything gets in 25 periods, and the rotations
    assert told.least_margin_m <= told.least_distance_m - at.cell.limits.clearance_m + 1e-9
    assert told.least_margin_m > 0.0


def test_every_pair_of_which_nothing_is_asked_stands_in_the_summary_with_its_reason_and_in_as_many_lines_as_reasons() -> None:
    plan = planned("ur5e_line")
    told = plan_summary(bench("ur5e_line").cell, plan).left_out
    asked = {(pair.first, pair.second) for pair in plan.opinion.pairs if pair.required_m != 0.0}
    assert {(pair.first, pair.second) for pair in told} == {(pair.first, pair.second) for pair in plan.opinion.pairs} - asked
    lines = [line.text for line in describe_left_out(plan.opinion.left_out)]
    assert len(lines) == len({pair.why.code for pair in told})
    for pair in told:
        assert any(f"{pair.first} - {pair.second}" in line and line.endswith(f": {pair.why}") for line in lines)


def test_a_plan_that_is_not_confirmed_is_not_offered() -> None:
    at = bench("ur5e_line")
    slower = at.cell.model_copy(update={"limits": at.cell.limits.model_copy(update={"cartesian_speed_m_s": 0.2})})
    plan = planned("ur5e_line")
    torques = JointTorques(at.cell, at.robot, guess_load(at.cell, at.cell.payload_box, 1.0))
    with pytest.raises(PlanDisputed, match=r"limit 0\.200 m/s"):
        confirm_plan(slower, at.robot, at.collision, at.cell.payload_box, plan.legs, plan.home, torques)
