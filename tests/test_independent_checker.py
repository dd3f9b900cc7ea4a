"""The tests' own checker is checked: against formulas, against other libraries, and with flaws planted."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from scipy.optimize import minimize
from scipy.spatial.transform import Rotation

from core.cell.cell import Box, Cell, Obstacle, Pose, Zone
from core.cell.folder import load_cell
from tests.convex_distance import Convex, ball, bounds, box, capsule, cylinder, distance, packed
from tests.independent_arm import Arm, Inertia, pose
from tests.independent_checker import IndependentChecker
from tests.real_robots import ROBOTS, SENSOR, robot_folder

ROOT = Path(__file__).parents[1]
LWR = load_cell(ROOT / "cells" / "lwr4_bench")
GRAVITY = np.array([0.0, 0.0, -9.81])


def placed(rng: np.random.Generator, far_m: float = 0.6) -> np.ndarray:
    T = np.eye(4)
    T[:3, :3] = Rotation.random(random_state=int(rng.integers(2**31))).as_matrix()
    T[:3, 3] = rng.uniform(-far_m, far_m, 3)
    return T


def by_quadratic_program(first: Convex, second: Convex) -> float:
    """The least distance of two hulls of points, by weights of the points."""
    P = np.concatenate((first.points, -second.points))
    n = len(first.points)
    sums = [{"type": "eq", "fun": lambda w: w[:n].sum() - 1.0}, {"type": "eq", "fun": lambda w: w[n:].sum() - 1.0}]
    start = np.concatenate((np.full(n, 1.0 / n), np.full(len(P) - n, 1.0 / (len(P) - n))))
    found = minimize(
        lambda w: (w @ P) @ (w @ P), start, jac=lambda w: 2.0 * P @ (P.T @ w), bounds=[(0, 1)] * len(P), constraints=sums, tol=1e-14
    )
    return float(np.sqrt(found.fun))


def test_the_distance_of_boxes_is_that_of_a_quadratic_program() -> None:
    rng = np.random.default_rng(3)
    for _ in range(40):
        first, second = (box(rng.uniform(0.05, 0.5, 3)).moved(placed(rng)) for _ in range(2))
        if (apart := distance(first, second)) > 0.0:
            assert apart == pytest.approx(by_quadratic_program(first, second), abs=1e-5)


def test_both_bounds_meet_for_every_kind_of_body_even_nearly_parallel_ones() -> None:
    rng = np.random.default_rng(4)
    makers = (lambda: box(rng.uniform(0.05, 0.5, 3)), lambda: ball(0.1), lambda: capsule(0.1, 0.3), lambda: cylinder(0.1, 0.2))
    apart = 0
    for k in range(1000):
        bodies = packed([makers[k % 4](), makers[k // 4 % 4]()])
        first, second = placed(rng), placed(rng)
        if k % 3 == 0:
            second[:3, :3] = first[:3, :3] @ Rotation.from_rotvec(rng.normal(size=3) * 10.0 ** rng.uniform(-9, -3)).as_matrix()
        low, high = bounds(bodies, 0, 1, first, second)
        apart += low > 0.0
        assert low - 1e-15 <= high <= low + 1e-7
    assert apart > 700


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        (box(np.array([0.2, 0.2, 0.2])), ball(0.1), 0.3),
        (cylinder(0.1, 0.2), box(np.array([0.2, 0.2, 0.2])), 0.3),
        (capsule(0.1, 0.2), cylinder(0.05, 0.1), 0.35),
    ],
)
def test_simple_distances_are_what_they_are(first: Convex, second: Convex, expected: float) -> None:
    assert distance(first, second.moved(pose([0.5, 0.0, 0.0], np.zeros(3)))) == pytest.approx(expected, abs=1e-7)
    assert distance(first, second.moved(pose([0.05, 0.0, 0.0], np.zeros(3)))) < 0.0


@pytest.mark.parametrize("name", ["panda", "ur5", "talos"])
def test_torques_are_those_of_pinocchio(name: str, tmp_path: Path) -> None:
    folder = robot_folder(name, tmp_path / name)
    base = pose([0.1, 0.2, 0.3], [0.3, -0.5, 1.0])
    arm = Arm((folder / "robot.urdf").read_text(), folder, ROBOTS[name].base, SENSOR, base)
    model = pin.buildModelFromUrdf(str(folder / "robot.urdf"))
    data = model.createData()
    pin.framesForwardKinematics(model, data, pin.neutral(model))
    root = base @ np.linalg.inv(data.oMf[model.getFrameId(ROBOTS[name].base)].homogeneous)
    model.gravity.linear = root[:3, :3].T @ GRAVITY
    com = np.array([0.05, 0.02, 0.1])
    load = Inertia(2.0, 2.0 * com, np.diag([0.1, 0.11, 0.12]))
    frame = model.frames[model.getFrameId(SENSOR)]
    about_com = load.second - 2.0 * (com @ com * np.eye(3) - np.outer(com, com))
    model.appendBodyToJoint(frame.parentJoint, pin.Inertia(2.0, com, about_com), frame.placement)
    data = model.createData()
    q, dq, ddq = np.random.default_rng(0).normal(size=(3, 10, arm.n))
    expected = [pin.rnea(model, data, *row) for row in zip(q, dq, ddq, strict=True)]
    assert arm.torques(q, dq, ddq, GRAVITY, load) == pytest.approx(np.array(expected), abs=1e-9)


def swung(cell: Cell, joint: int, by_rad: float) -> np.ndarray:
    """A slow motion of one joint from home, every 10 ms."""
    q = np.tile(np.array(cell.robot.home_rad), (600, 1))
    q[:, joint] += by_rad * np.sin(np.linspace(0.0, 0.5 * np.pi, 600)) ** 2
    return q


def test_a_payload_that_reaches_back_into_the_wrist_is_seen() -> None:
    beside = Box(size_m=(0.04, 0.04, 0.3), pose=Pose(xyz_m=(0.12, 0.0, -0.1)))
    violations = IndependentChecker(LWR, beside).check(swung(LWR, 5, -1.0), 0.01).violations
    assert any("payload" in violation and "(payload)" in violation for violation in violations)
    assert not IndependentChecker(LWR, LWR.payload_box).check(swung(LWR, 6, 0.3), 0.01).too_close_m


def test_the_floor_is_solid() -> None:
    raised = LWR.model_copy(update={"floor_z_m": 0.5, "obstacles": (), "zones": ()})
    assert any("floor" in violation for violation in IndependentChecker(raised, LWR.payload_box).check(swung(LWR, 1, 1.5), 0.01).violations)


def test_a_load_that_comes_off_over_a_zone_falls_into_it() -> None:
    sensor = IndependentChecker(LWR, LWR.payload_box).arm.sensor_poses(np.array([LWR.robot.home_rad]))[0, :3, 3]
    for aside, hit in ((0.0, True), (0.6, False)):
        below = Box(size_m=(0.3, 0.3, 0.3), pose=Pose(xyz_m=(float(sensor[0]), float(sensor[1]) + aside, -0.5)))
        cell = LWR.model_copy(update={"obstacles": (), "zones": (Zone(name="below", shape=below),)})
        findings = IndependentChecker(cell, LWR.payload_box).check(np.tile(LWR.robot.home_rad, (5, 1)), 0.001)
        assert any("comes off" in violation for violation in findings.violations) == hit
        assert not findings.too_close_m


def test_a_fast_swing_throws_the_load_where_it_would_not_fall() -> None:
    """1 m/s for 0.3 s of fall is 0.3 m."""
    sensor = IndependentChecker(LWR, LWR.payload_box).arm.sensor_poses(np.array([LWR.robot.home_rad]))[0, :3, 3]
    turn = np.array([sensor[1], -sensor[0]]) / np.linalg.norm(sensor[:2])  # where a negative rate of the first joint moves the load
    at = sensor[:2] + 0.45 * turn
    zone = Zone(name="beside", shape=Box(size_m=(0.2, 0.2, 0.2), pose=Pose(xyz_m=(float(at[0]), float(at[1]), float(sensor[2]) - 0.6))))
    cell = LWR.model_copy(update={"obstacles": (), "zones": (zone,)})
    checker = IndependentChecker(cell, LWR.payload_box)
    q = np.tile(LWR.robot.home_rad, (5, 1))
    assert checker.flights(q, 0.001)[0] > 0.0
    q[:, 0] -= np.arange(5) * 0.001 * 1.5 / np.linalg.norm(sensor[:2])
    assert checker.flights(q, 0.001)[0] < 0.0


def test_too_heavy_a_payload_is_seen_and_named() -> None:
    change = {"mass_kg": 60.0, "first_moment_kg_m": (0.0, 0.0, 6.0), "inertia_kg_m2": (1.0, 0.0, 0.0, 1.0, 0.0, 1.0)}
    heavy = LWR.payloads["cylinder"].model_copy(update=change)
    findings = IndependentChecker(LWR, LWR.payload_box, heavy).check(swung(LWR, 1, 0.5), 0.01)
    assert findings.torque > 1.0
    assert any("times its effort limit" in violation and findings.torque_joint in violation for violation in findings.violations)


def test_a_capsule_and_a_mesh_are_obstacles_for_links_as_exact_as_boxes(tmp_path: Path) -> None:
    """The hand of a Panda is a mesh: a thin wall is put beside it, nearer than the clearance and then farther."""
    folder = robot_folder("panda", tmp_path / "panda")
    robot = LWR.robot.model_copy(
        update={
            "base_frame": "panda_link0",
            "sensor_frame": SENSOR,
            "home_rad": (0.0, -0.5, 0.0, -2.0, 0.0, 1.6, 0.0),
            "acceleration_rad_s2": (10.0,) * 7,
            "friction": None,
        }
    )
    bare = LWR.model_copy(update={"robot": robot, "folder": folder, "obstacles": (), "zones": (), "floor_z_m": -1.0})
    small = Box(size_m=(0.02, 0.02, 0.02), pose=Pose(xyz_m=(0.0, 0.0, 0.01)))
    checker = IndependentChecker(bare, small)
    q = np.array(robot.home_rad)
    frames = checker.arm.frames(q[None])[0]
    links = np.concatenate([b.convex.points @ frames[b.group][:3, :3].T + frames[b.group][:3, 3] for b in checker.arm.bodies])
    for gap, ok in ((0.02, False), (0.04, True)):
        x = float(links[:, 0].max()) + gap + 0.05
        wall = Obstacle(name="wall", shape=Box(size_m=(0.1, 3.0, 3.0), pose=Pose(xyz_m=(x, 0.0, 0.5))))
        margin = IndependentChecker(bare.model_copy(update={"obstacles": (wall,)}), small).margins(q)["obstacle"][0]
        assert margin == pytest.approx(gap - bare.limits.clearance_m, abs=1e-6)
        assert (margin > 0.0) == ok
