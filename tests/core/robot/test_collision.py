from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.cell.cell import Box, Cell, Limits, Obstacle, Pose, Sphere, Zone
from core.cell.folder import load_cell
from core.errors import BadCell
from core.robot.bodies import link_bodies
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.point_speed import point_positions

ROOT = Path(__file__).parents[3]


def model_of(cell: Cell, box: Box | None = None) -> CollisionModel:
    return CollisionModel(cell, RobotModel.of_cell(cell), box or cell.payload_box)


def random_q(collision: CollisionModel, count: int, seed: int = 0) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return rng.uniform(collision.robot.lower, collision.robot.upper, (count, collision.robot.n))


LWR = model_of(load_cell(ROOT / "cells" / "lwr4_bench"))
UR = model_of(load_cell(ROOT / "cells" / "ur5e_line"))
configurations = st.tuples(st.sampled_from([LWR, UR]), st.integers(0, 2**32 - 1)).map(
    lambda drawn: (drawn[0], random_q(drawn[0], 2, drawn[1]))
)


def watched(collision: CollisionModel, distances: dict[tuple[str, str], float]) -> dict[tuple[str, str], float]:
    pairs = {(body.name, thing.name) for body, thing in collision.pairs[0]}
    return {pair: distance for pair, distance in distances.items() if pair in pairs}


def test_distances_to_obstacles_and_zones_are_those_of_another_library(cell, fcl_scene):
    collision, scene = model_of(cell), fcl_scene(cell, cell.payload_box)
    free = 0
    for q in random_q(collision, 150):
        oracle = watched(collision, scene.to_environment(q))
        nearest = collision.obstacle_distance(q)
        least = min(oracle.values())
        assert (least > 1e-6) == (nearest.distance_m > 1e-6)
        if least > 1e-6:
            free += 1
            assert nearest.distance_m == pytest.approx(least, abs=2e-6)
            assert oracle[nearest.first, nearest.second] == pytest.approx(least, abs=2e-6)
            assert np.linalg.norm(nearest.point_first - nearest.point_second) == pytest.approx(least, abs=2e-6)
    assert free > 20


def test_distances_between_links_are_those_of_another_library(cell, fcl_scene):
    collision, scene = model_of(cell), fcl_scene(cell, cell.payload_box)
    links = [(first.name, second.name) for first, second in collision.pairs[1]]
    for q in random_q(collision, 60, seed=1):
        least = min(scene.between(q, *pair) for pair in links)
        margin = collision.self_margin(q)
        assert (least > 1e-6) == (margin > 1e-6 - cell.limits.self_clearance_m)
        if least > 1e-6:
            assert margin == pytest.approx(least - cell.limits.self_clearance_m, abs=2e-6)


def test_the_margin_is_the_smallest_of_both_kinds(cell):
    collision = model_of(cell)
    for q in random_q(collision, 100, seed=2):
        obstacles = collision.obstacle_distance(q).distance_m - cell.limits.clearance_m
        assert collision.margin(q) == pytest.approx(min(obstacles, collision.self_margin(q)), abs=1e-9)
        assert collision.nearest(q).margin_m == pytest.approx(collision.margin(q), abs=1e-9)


@given(configurations, st.floats(0.0, 0.1))
def test_free_means_a_margin_above_what_is_asked_for(drawn, extra):
    collision, (q, _) = drawn
    margin = collision.margin(q)
    if abs(margin - extra) > 1e-6:
        assert collision.is_free(q, extra) is (margin > extra)


@given(configurations, st.floats(1e-4, 1.0))
def test_no_point_moves_and_no_margin_changes_by_more_than_the_motion_bound(drawn, share):
    collision, (q, other) = drawn
    there = q + share * (other - q)
    bound = collision.motion_bound(q, there)
    before, after = point_positions(collision.robot.chain, collision.points, np.array([q, there]))
    assert np.linalg.norm(after - before, axis=1).max() <= bound + 1e-12
    margins = collision.margin(q), collision.margin(there)
    if min(margins) > -collision.cell.limits.self_clearance_m:  # free: distances are no penetration depths
        assert abs(margins[1] - margins[0]) <= bound + 1e-6


@given(configurations)
def test_the_motion_bound_of_a_stretched_arm_is_nearly_reached(drawn):
    collision, (q, _) = drawn
    assert collision.reach[-1] < 0.4 * collision.reach[0]
    step = np.zeros(len(q))
    step[-1] = 1e-4
    points = point_positions(collision.robot.chain, collision.points, np.array([q, q + step]))
    moved = np.linalg.norm(points[1] - points[0], axis=1).max()
    assert moved == pytest.approx(collision.motion_bound(q, q + step), rel=1e-3)


def test_speed_points_hold_the_payload_box_in_the_sensor_frame(cell):
    collision = model_of(cell)
    q = random_q(collision, 1)[0]
    mine = [k for k, owner in enumerate(collision.points.owner) if owner == "payload"]
    placed = point_positions(collision.robot.chain, collision.points, q[None])[0, mine]
    pose = collision.robot.sensor_pose(q)
    expected = pose.position + cell.payload_box.corners @ pose.rotation.T
    assert len(mine) == 8
    distances = np.linalg.norm(placed[:, None] - expected[None], axis=2)
    assert distances.min(axis=0).max() < 1e-12


def test_a_base_somewhere_else_moves_everything_with_it(cell, fcl_scene):
    base = Pose(xyz_m=(0.05, -0.1, 0.02), rpy_rad=(0.02, -0.03, 2.0))
    moved = cell.model_copy(update={"robot": cell.robot.model_copy(update={"base": base}), "obstacles": (), "zones": ()})
    wall = Obstacle(name="wall", shape=Box(size_m=(0.1, 4.0, 4.0), pose=Pose(xyz_m=(-1.5, 0.0, 0.0))))
    moved = moved.model_copy(update={"obstacles": (wall,)})
    collision, scene = model_of(moved), fcl_scene(moved, moved.payload_box)
    for q in random_q(collision, 20):
        least = min(watched(collision, scene.to_environment(q)).values())
        assert collision.obstacle_distance(q).distance_m == pytest.approx(least, abs=2e-6)
    base_pairs = [(a.name, b.name) for a, b in collision.pairs[1] if b.joint == 0]
    q = np.array(moved.robot.home_rad)
    assert collision.self_margin(q) + cell.limits.self_clearance_m <= min(scene.between(q, *pair) for pair in base_pairs) + 2e-6


def test_a_link_that_only_the_first_joint_moves_is_left_out_where_it_is_always_clear(cell, fcl_scene):
    collision, scene = model_of(cell), fcl_scene(cell, cell.payload_box)
    pairs = {(body.name, thing.name) for body, thing in collision.pairs[0]}
    first = [body.name for body in link_bodies(cell, collision.robot) if body.joint == 1]
    left_out = {pair for q in [np.zeros(collision.robot.n)] for pair in scene.to_environment(q) if pair[0] in first} - pairs
    assert left_out
    q = np.array(cell.robot.home_rad)
    for q[0] in np.linspace(collision.robot.lower[0], collision.robot.upper[0], 100):
        distances = scene.to_environment(q)
        least = min(left_out, key=lambda pair: distances[pair])
        assert distances[least] >= cell.limits.clearance_m - 1e-6
        told = collision.find_nearest_left_out(q)
        assert told.distance_m == pytest.approx(distances[least], abs=2e-6)
        assert distances[told.first, told.second] == pytest.approx(distances[least], abs=2e-6)


def test_where_nothing_stands_the_first_link_is_as_far_from_the_floor_as_it_is(cell, fcl_scene):
    empty = cell.model_copy(update={"obstacles": (), "zones": ()})
    nearest = model_of(empty).find_nearest_left_out(np.array(cell.robot.home_rad))
    heights = fcl_scene(empty, cell.payload_box).to_environment(np.array(cell.robot.home_rad))
    assert nearest.second == "floor"
    assert nearest.distance_m == pytest.approx(heights[nearest.first, "floor"], abs=1e-6)


def test_links_that_are_left_out_never_touch_or_are_neighbours(cell, fcl_scene):
    collision, scene = model_of(cell), fcl_scene(cell, cell.payload_box)
    bodies = {body.name: body.joint for pair in (*collision.pairs[0], *collision.pairs[1]) for body in pair if body.joint > 0}
    watched_links = {frozenset((a.name, b.name)) for a, b in collision.pairs[1]}
    two_apart = [(a, b) for a in bodies for b in bodies if bodies[a] - bodies[b] == 2 and frozenset((a, b)) not in watched_links]
    home = np.array(cell.robot.home_rad)
    proven = [pair for pair in two_apart if scene.between(home, *pair) >= cell.limits.self_clearance_m]
    for q in random_q(collision, 150, seed=3):
        assert all(scene.between(q, *pair) > 0.0 for pair in proven)
    farther = [(a, b) for a in bodies for b in bodies if bodies[a] - bodies[b] > 2]
    assert all(frozenset(pair) in watched_links for pair in farther)
    neighbours = [(a, b) for a, b in collision.pairs[1] if a.joint - b.joint < 2]
    assert not neighbours


def test_a_moved_obstacle_is_where_it_was_moved(cell):
    collision = model_of(cell)
    name = cell.obstacles[-1].name
    pose = Pose(xyz_m=(0.1, 0.9, 0.4), rpy_rad=(0.3, 0.2, 0.1))
    collision.move(name, pose)
    shape = cell.obstacles[-1].shape.model_copy(update={"pose": pose})
    there = model_of(cell.model_copy(update={"obstacles": (*cell.obstacles[:-1], Obstacle(name=name, shape=shape))}))
    for q in random_q(collision, 50):
        assert collision.margin(q) == pytest.approx(there.margin(q), abs=1e-9)


def test_an_obstacle_that_comes_near_the_first_link_is_watched_from_then_on():
    collision = model_of(load_cell(ROOT / "cells" / "lwr4_bench"))
    home = np.array(collision.cell.robot.home_rad)
    assert ("link1", "fixture") not in {(body.name, thing.name) for body, thing in collision.pairs[0]}
    collision.move("fixture", Pose(xyz_m=(-0.22, 0.0, 0.2)))
    assert ("link1", "fixture") in {(body.name, thing.name) for body, thing in collision.pairs[0]}
    assert collision.nearest(home).second == "fixture"
    collision.move("fixture", Pose(xyz_m=(0.45, -0.6, 0.1)))
    assert ("link1", "fixture") not in {(body.name, thing.name) for body, thing in collision.pairs[0]}


def test_a_zone_that_comes_grows_moves_and_goes_is_kept_clear_of_as_if_it_had_always_been_so(cell):
    """The oracle is a model that is made of such a cell from the beginning."""
    collision = model_of(cell)
    far = Box(size_m=(0.3, 0.4, 0.5), pose=Pose(xyz_m=(0.6, 1.4, 1.0), rpy_rad=(0.0, 0.0, 0.4)))
    ball = Sphere(kind="sphere", radius_m=0.3, pose=Pose(xyz_m=(-1.4, 0.3, 1.2)))
    first = cell.zones[0].name
    changes = [("trolley", far), ("trolley", ball), ("trolley", ball.model_copy(update={"pose": Pose(xyz_m=(-1.5, 0.2, 0.9))})),
               (first, None), ("trolley", None), (first, cell.zones[0].shape)]  # fmt: skip
    now = cell
    for name, shape in changes:
        collision.change_zone(name, shape)
        now = now.with_zone(name, shape)
        there = model_of(now)
        assert {zone.name for zone in collision.cell.zones} == {zone.name for zone in now.zones}
        assert sorted((a.name, b.name) for a, b in collision.pairs[0]) == sorted((a.name, b.name) for a, b in there.pairs[0])
        for q in random_q(collision, 20):
            assert collision.margin(q) == pytest.approx(there.margin(q), abs=1e-9)
            assert collision.is_free(q) is there.is_free(q)
            assert collision.obstacle_distance(q).second == there.obstacle_distance(q).second


def test_a_zone_cannot_take_the_name_of_an_obstacle():
    collision = model_of(load_cell(ROOT / "cells" / "lwr4_bench"))
    with pytest.raises(BadCell, match="bench"):
        collision.change_zone("bench", Box(size_m=(0.1, 0.1, 0.1), pose=Pose(xyz_m=(2.0, 0.0, 0.0))))


def test_an_unknown_obstacle_cannot_be_moved():
    with pytest.raises(BadCell, match=r"'forklift', expected one of .*operator"):
        LWR.move("forklift", Pose())


def test_a_configuration_that_is_not_finite_is_not_free(cell):
    collision = model_of(cell)
    q = np.array(cell.robot.home_rad)
    q[2] = np.nan
    assert collision.margin(q) < 0.0
    assert collision.is_free(q) is False


def test_a_cell_with_nothing_in_it_has_only_the_robot_itself_and_the_floor(cell):
    collision = model_of(cell.model_copy(update={"obstacles": (), "zones": ()}))
    home = np.array(cell.robot.home_rad)
    assert {thing.name for _, thing in collision.pairs[0]} == {"floor"}
    assert collision.obstacle_distance(home).second == "floor"
    assert collision.margin(home) > 0.0
    assert collision.is_free(home)


def test_a_home_too_close_to_something_is_refused_with_names_and_distances(cell):
    pose = RobotModel.of_cell(cell).sensor_pose(np.array(cell.robot.home_rad))
    zone = Zone(name="visitor", shape=Box(size_m=(0.1, 0.1, 0.1), pose=Pose(xyz_m=tuple(pose.position.tolist()))))
    with pytest.raises(BadCell, match=r"home_rad: found '.*' -0\.\d+ m from 'visitor', expected at least 0\.030 m"):
        model_of(cell.model_copy(update={"zones": (*cell.zones, zone)}))


def test_an_obstacle_round_the_base_is_refused_with_its_name(cell):
    lump = Obstacle(name="lump", shape=Box(size_m=(0.6, 0.6, 0.3)))
    with pytest.raises(BadCell, match=r"lump: found 'base' of the robot 0\.\d+ m inside it"):
        model_of(cell.model_copy(update={"obstacles": (*cell.obstacles, lump)}))


def test_a_larger_clearance_is_required_of_obstacles_but_not_of_links(cell):
    wider = model_of(cell.model_copy(update={"limits": Limits(clearance_m=0.035, self_clearance_m=0.01)}))
    narrow = model_of(cell)
    for q in random_q(narrow, 20):
        assert wider.obstacle_margin(q) == pytest.approx(narrow.obstacle_margin(q) - 0.005, abs=1e-9)
        assert wider.self_margin(q) == pytest.approx(narrow.self_margin(q), abs=1e-9)


def test_a_mesh_counts_as_its_convex_hull(tmp_path):
    source = ROOT / "cells" / "lwr4_bench"
    corners = np.array(np.meshgrid([-0.065, 0.065], [-0.065, 0.065], [-0.065, 0.065])).reshape(3, -1).T
    triangles = [
        (0, 1, 2),
        (1, 3, 2),
        (4, 6, 5),
        (5, 6, 7),
        (0, 4, 1),
        (1, 4, 5),
        (2, 3, 6),
        (3, 7, 6),
        (0, 2, 4),
        (2, 6, 4),
        (1, 5, 3),
        (3, 5, 7),
    ]
    facets = "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join("vertex {} {} {}\n".format(*corners[i]) for i in t) + "endloop\nendfacet\n"
        for t in triangles
    )
    (tmp_path / "link6.stl").write_text(f"solid link6\n{facets}endsolid link6\n")
    (tmp_path / "cell.toml").write_text((source / "cell.toml").read_text())
    box = '<geometry><box size="0.13 0.13 0.13"/></geometry>'
    urdf = (source / "robot.urdf").read_text()
    assert urdf.count(box) == 1
    (tmp_path / "robot.urdf").write_text(urdf.replace(box, '<geometry><mesh filename="link6.stl"/></geometry>'))
    meshed = model_of(load_cell(tmp_path))
    for q in random_q(LWR, 50):
        if LWR.margin(q) > 0.0:
            assert meshed.margin(q) == pytest.approx(LWR.margin(q), abs=1e-6)
    assert meshed.reach == pytest.approx(LWR.reach, abs=1e-6)
