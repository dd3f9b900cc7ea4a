from __future__ import annotations

from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from scipy.optimize import brentq

from core.cell.body_name import name_body
from core.cell.cell import Box, Cell, Obstacle, Pose, Zone
from core.cell.folder import load_cell
from core.control.bounds import JointLimits
from core.control.rotation import Rotation
from core.errors import BadCell, NoRoomAtHome, NoStartConfiguration
from core.planning.candidate_checks import Attitude, Checks
from core.planning.candidates import CandidateSearch, Weights
from core.planning.link_room import LinkRoom
from core.planning.rotation_room import Turn, rotation_path
from core.planning.start_configuration import (
    LIMIT_MARGIN_RAD,
    TIGHT_ROOM_M,
    UNREACHABLE,
    Grid,
    StartConfiguration,
    find_start_configuration,
)
from core.robot.collision import CollisionModel
from core.robot.decoupling import decoupling_profile
from core.robot.model import RobotModel
from core.robot.point_speed import point_positions
from core.robot.trajectory import AngularProfile
from core.robot.watched_pairs import ROOM_M
from core.sessions.session import RobotState
from core.words.message import Message

SIDES = [("back", 0, -1), ("front", 0, 1), ("right", 1, -1), ("left", 1, 1), ("floor", 2, -1), ("ceiling", 2, 1)]
AXES = ("x+", "x-", "y+", "y-", "z+", "z-")
ROOT = Path(__file__).parents[3]


def profile_of(box: Box, excursion: float = 0.25) -> AngularProfile:
    return decoupling_profile(box, cartesian_speed=0.25, period=0.001, excursion=excursion)


def search(
    cell: Cell, axis: str, box: Box | None = None, *, rotate: bool | None = None, near: np.ndarray | None = None, **options: object
) -> StartConfiguration:
    box = box or cell.payload_box
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, box)
    profile = profile_of(box) if (axis[1] == "+" if rotate is None else rotate) else None
    return find_start_configuration(cell, robot, collision, Attitude.of_axis(axis, profile), near=near, **{"seed": 0, **options})


def boxes_of(cell: Cell) -> dict[str, Box]:
    return {"default": cell.payload_box, **{name: payload.box for name, payload in cell.payloads.items() if name != "gripper"}}


@pytest.mark.parametrize("axis", AXES)
@pytest.mark.parametrize("payload", ["default", "cylinder", pytest.param("steel_block", marks=pytest.mark.thorough)])
def test_every_pose_of_both_cells_is_found_and_another_library_finds_it_clear(cell, fcl_scene, axis, payload):
    box = boxes_of(cell)[payload]
    found = search(cell, axis, box, near=np.array(cell.robot.home_rad))
    robot = RobotModel.of_cell(cell)
    pin.framesForwardKinematics(robot.model, robot.data, found.q)
    direction = robot.data.oMf[robot.sensor_frame_id].rotation[:, "xyz".index(axis[0])]
    down = cell.gravity / np.linalg.norm(cell.gravity)
    assert direction @ down == pytest.approx(1.0 if axis[1] == "+" else -1.0, abs=1e-9)
    assert (found.q >= robot.lower + LIMIT_MARGIN_RAD).all() and (found.q <= robot.upper - LIMIT_MARGIN_RAD).all()
    distances = fcl_scene(cell, box).to_environment(found.q)
    moving = {pair: distance for pair, distance in distances.items() if pair[0] not in ("base", "link1", "shoulder")}
    assert found.clearance_m == pytest.approx(min(moving.values()), abs=2e-6)
    assert found.clearance_m >= found.least_clearance_m >= cell.limits.clearance_m + ROOM_M
    assert found.manipulability == pytest.approx(1.0 / np.linalg.cond(robot.sensor_jacobian(found.q)), rel=1e-9)
    assert found.throw is not None and found.throw.distance_m > 0.0
    assert found.nearest in {item.name for item in (*cell.obstacles, *cell.zones)}


@pytest.mark.parametrize("axis", ["x+", "y+", "z+"])
def test_the_rotation_that_the_controller_makes_of_it_is_unscaled_slow_enough_and_clear(cell, fcl_scene, axis):
    box = cell.payload_box
    found = search(cell, axis, near=np.array(cell.robot.home_rad))
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, box)
    profile = profile_of(box)
    mover = Rotation(robot, collision.points, JointLimits.of(cell, robot), cartesian_speed=0.25, profile=profile, axis="xyz".index(axis[0]))
    rows = [found.q]
    while (q := mover.next(RobotState(0.0, rows[-1], np.zeros(robot.n), rows[-1], np.zeros(6)))) is not None:
        rows.append(q)
        assert len(rows) < 2 * len(profile.angle)
    assert mover.scaled == 0
    path = np.array(rows)
    velocity = np.diff(path, axis=0) / profile.period
    assert (np.abs(velocity) <= robot.velocity).all()
    assert (np.abs(np.diff(velocity, axis=0)) / profile.period <= np.array(cell.robot.acceleration_rad_s2) * 1.001).all()
    scene, step = fcl_scene(cell, box), 25
    for row in path[::step]:
        moving = [d for pair, d in scene.to_environment(row).items() if pair[0] not in ("base", "link1", "shoulder")]
        assert min(moving) >= found.least_clearance_m - 0.005
    poses = [robot.sensor_pose(row) for row in path[::step]]
    assert max(np.linalg.norm(pose.position - poses[0].position) for pose in poses) < 1e-5
    corners = np.array([pose.position + box.corners @ pose.rotation.T for pose in (robot.sensor_pose(row) for row in path[::5])])
    assert np.linalg.norm(np.diff(corners, axis=0), axis=2).max() / (5 * profile.period) <= 0.95 * 0.25 + 1e-3


def test_the_same_seed_gives_the_same_configuration_and_near_keeps_the_way_short(cell):
    home = np.array(cell.robot.home_rad)
    first, again = search(cell, "x+", near=home), search(cell, "x+", near=home)
    assert (first.q == again.q).all()
    anywhere = search(cell, "x+")
    assert anywhere.objective >= first.objective - 0.02  # what is given up for the short way
    turned = search(cell, "x-", near=first.q)
    elsewhere = search(cell, "x-")
    assert np.abs(turned.q - first.q).max() < np.abs(elsewhere.q - first.q).max() + 0.5
    assert np.linalg.norm(turned.q - first.q) < 4.0


def narrow_cell(seed: int) -> tuple[Cell, RobotModel, CollisionModel]:
    """The bench without zones, with random boxes about that leave the home configuration free."""
    rng = np.random.default_rng(seed)
    cell = load_cell(ROOT / "cells" / "lwr4_bench")
    robot = RobotModel.of_cell(cell)
    while True:
        boxes = tuple(
            Obstacle(
                name=f"box{k}",
                shape=Box(
                    size_m=tuple(rng.uniform(0.1, 0.5, 3).tolist()),
                    pose=Pose(
                        xyz_m=tuple(rng.uniform((-0.5, -0.8, 0.1), (0.8, 0.8, 1.2)).tolist()),
                        rpy_rad=tuple(rng.uniform(-1.0, 1.0, 3).tolist()),
                    ),
                ),
            )
            for k in range(6)
        )
        narrow = cell.model_copy(update={"obstacles": (*cell.obstacles, *boxes), "zones": ()})
        try:
            return narrow, robot, CollisionModel(narrow, robot, cell.payloads["cylinder"].box)
        except (BadCell, NoRoomAtHome):
            continue


def brute_force(robot: RobotModel, collision: CollisionModel, axis: int, count: int) -> float | None:
    """Largest least of D of Eq. (6) among random configurations whose sensor axis has been turned along gravity by Newton's method.

    Nothing of the search is used: random joint positions, numpy, Pinocchio's Jacobian."""
    rng = np.random.default_rng(99)
    room = LinkRoom(robot, collision, (robot.lower + LIMIT_MARGIN_RAD, robot.upper - LIMIT_MARGIN_RAD), 2.0 * float(collision.reach[0]))
    down, best = np.array([0.0, 0.0, -1.0]), None
    for _ in range(count):
        q = rng.uniform(robot.lower, robot.upper)
        for _ in range(15):
            pin.framesForwardKinematics(robot.model, robot.data, q)
            a = robot.data.oMf[robot.sensor_frame_id].rotation[:, axis]
            error = np.cross(a, down)
            if np.linalg.norm(error) < 1e-8:
                break
            J = pin.computeFrameJacobian(robot.model, robot.data, q, robot.sensor_frame_id, pin.LOCAL_WORLD_ALIGNED)[3:]
            q = q + np.linalg.pinv(J) @ error
        inside = (q > robot.lower + LIMIT_MARGIN_RAD).all() and (q < robot.upper - LIMIT_MARGIN_RAD).all()
        if inside and np.linalg.norm(error) < 1e-8 and a @ down > 0 and collision.margin(q) > ROOM_M:
            least = float(room.normalise(room.distances(q[None])).min())
            best = least if best is None else max(best, least)
    return best


@pytest.mark.parametrize("seed", range(10))
def test_in_narrow_cells_it_is_as_good_as_brute_force(seed):
    cell, robot, collision = narrow_cell(seed)
    best = brute_force(robot, collision, 0, 300)
    try:
        found = find_start_configuration(cell, robot, collision, Attitude.of_axis("x+"), seed=0, weights=Weights(manipulability=0.0))
    except NoStartConfiguration as refusal:
        assert best is None, refusal
    else:
        assert collision.margin(found.q) >= ROOM_M
        assert best is None or found.objective > best - 0.01


@pytest.mark.parametrize(
    ("joint", "least", "most", "pair", "required_m"),
    [(0, 0.9, 1.3, ("payload", "pillar"), 0.03), (5, 1.05, 1.9, ("link7", "link5"), 0.01)],
    ids=["to what stands", "within the arm"],
)
def test_a_start_keeps_a_hundredth_of_a_metre_beyond_every_required_distance_and_two_millimetres_where_no_other_is_found(
    fcl_scene, joint, least, most, pair, required_m
):
    """Home with one joint turned until another library finds the required distance, and so much more, between two that come near."""
    cell = load_cell(ROOT / "cells" / "lwr4_bench")
    pillar = Obstacle(name="pillar", shape=Box(size_m=(0.1, 0.1, 3.0), pose=Pose(xyz_m=(0.0, 0.6, 0.75))))
    cell = cell.model_copy(update={"obstacles": (pillar,), "zones": ()})
    robot = RobotModel.of_cell(cell)
    collision, scene = CollisionModel(cell, robot, cell.payload_box), fcl_scene(cell, cell.payload_box)
    limits = (robot.lower, robot.upper)
    search = CandidateSearch(cell, robot, collision, limits=limits, near=None, diameter=2.0 * float(collision.reach[0]), weights=Weights())

    def turned(angle: float) -> np.ndarray:
        return np.where(np.arange(robot.n) == joint, angle, cell.robot.home_rad)

    def distance(angle: float) -> float:
        return scene.between(turned(angle), *pair) if pair[1] != "pillar" else scene.to_environment(turned(angle))[pair]

    def kept(beyond_m: float, room_m: float) -> bool:
        angle = brentq(lambda at: distance(at) - required_m - beyond_m, least, most)
        checks = Checks(cell, robot, collision, Attitude.of_axis("z+"), limits, room_m=room_m)
        accepted = checks.check_candidate(search.of(turned(angle)[None]), 0) is not None
        assert accepted or any(f"too close to {name_body(cell, name)}" in str(reason) for reason in checks.rejected for name in pair)
        return accepted

    assert [kept(beyond, ROOM_M) for beyond in (-0.005, 0.002, 0.009, 0.011, 0.015)] == [False, False, False, True, True]
    assert [kept(beyond, TIGHT_ROOM_M) for beyond in (-0.005, 0.001, 0.003, 0.009)] == [False, False, True, True]


def rejected(refusal: NoStartConfiguration) -> dict[Message, int]:
    """How many candidates each check rejected."""
    return {each.parameters["reason"]: each.parameters["count"] for each in refusal.message.parameters["rejected"]}


def test_a_rotation_that_the_arm_cannot_make_fast_enough_is_refused_with_that_reason():
    cell = load_cell(ROOT / "cells" / "lwr4_bench")
    box = cell.payloads["steel_block"].box
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, box)
    with pytest.raises(NoStartConfiguration) as refusal:
        find_start_configuration(
            cell, robot, collision, Attitude.of_axis("x+", profile_of(box, 0.6)), seed=0, grid=Grid(vertices=150, rounds=1)
        )
    reasons = rejected(refusal.value)
    assert reasons[Message.of("planning-rejected-cartesian-speed")] > 50
    assert UNREACHABLE in reasons
    assert refusal.value.axis == "x+"
    assert refusal.value.best_clearance_m > 0.1


def test_where_the_arm_cannot_make_the_whole_rotation_a_smaller_one_that_keeps_its_limits_is_taken():
    """The same rotation, and half and a quarter of it: the corners are followed by another library's kinematics."""
    cell = load_cell(ROOT / "cells" / "lwr4_bench")
    box = cell.payloads["steel_block"].box
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, box)
    wide, small, smaller = (profile_of(box, excursion) for excursion in (0.6, 0.3, 0.15))
    grid = Grid(vertices=150, rounds=1)

    def found(*smaller: AngularProfile) -> StartConfiguration:
        attitude = Attitude("x+", np.eye(3)[0], np.eye(3)[0], wide, smaller)
        return find_start_configuration(cell, robot, collision, attitude, seed=0, grid=grid)

    one = found(small, smaller)
    assert one.rotation in (small, smaller)
    assert found(smaller).rotation is smaller
    if one.rotation is smaller:
        with pytest.raises(NoStartConfiguration):
            found(small)
    path, _ = rotation_path(robot.chain, one.q, Turn.of(one.rotation, np.eye(3)[0]))
    wrench = robot.sensor_poses(path)
    np.testing.assert_allclose(wrench.position, wrench.position[:1].repeat(len(path), axis=0), atol=1e-4)
    q = np.array([np.interp(one.rotation.angle, Turn.of(one.rotation, np.eye(3)[0]).angle, column) for column in path.T]).T
    points = point_positions(robot.chain, collision.points, q)
    fastest = np.linalg.norm(np.diff(points, axis=0), axis=2).max() / one.rotation.period
    assert fastest <= cell.limits.cartesian_speed_m_s * 1.02  # between the grid's angles the path is taken to be straight


def test_a_zone_under_everything_is_refused_because_of_the_load_that_would_fall_into_it(cell):
    under = Zone(name="cellar", shape=Box(size_m=(8.0, 8.0, 0.05), pose=Pose(xyz_m=(0.0, 0.0, -0.7))))
    with pytest.raises(NoStartConfiguration, match='a released load would fly into zone "cellar"') as refusal:
        search(cell.model_copy(update={"zones": (under,)}), "z+", grid=Grid(vertices=100, rounds=1))
    assert refusal.value.in_the_way == "cellar"


def test_a_room_just_large_enough_for_home_is_refused_with_what_is_in_the_way():
    """Walls and a ceiling 5 cm from the robot at home: the sensor cannot be turned upside down inside."""
    cell = load_cell(ROOT / "cells" / "lwr4_bench")
    robot = RobotModel.of_cell(cell)
    home = np.array(cell.robot.home_rad)
    corners = point_positions(robot.chain, CollisionModel(cell, robot, cell.payload_box).points, home[None])[0]
    low, high = np.minimum(corners.min(axis=0), -0.2) - 0.05, np.maximum(corners.max(axis=0), 0.2) + 0.05
    low[2] = 0.0
    middle, size = (low + high) / 2, 3.0
    walls = []
    for name, axis, side in SIDES:
        at = middle.copy()
        at[axis] = (high if side > 0 else low)[axis] + side * size / 2
        walls.append(Obstacle(name=name, shape=Box(size_m=(size,) * 3, pose=Pose(xyz_m=tuple(at.tolist())))))
    room = cell.model_copy(update={"obstacles": tuple(walls), "zones": ()})
    with pytest.raises(NoStartConfiguration) as refusal:
        search(room, "z-", grid=Grid(vertices=200, rounds=1))
    reasons = rejected(refusal.value)
    assert reasons[Message.of("planning-rejected-obstacle", body=Message.of("body-obstacle", name="ceiling"))] > 0
    assert refusal.value.best_clearance_m < 0.05
    assert refusal.value.in_the_way in {item.name for item in room.obstacles}
    assert "z-" in str(refusal.value) and f'obstacle "{refusal.value.in_the_way}"' in str(refusal.value)
