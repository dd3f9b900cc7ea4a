from __future__ import annotations

import warnings
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.array import Array
from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.errors import NoPath
from core.planning.blending import corners, round_corners
from core.planning.phase_plane import fastest_profile
from core.planning.timing import SMOOTHING_S, MotionLimits, least_seconds, time_curve
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.trajectory import JointTrajectory
from tests.independent_checker import IndependentChecker

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # toppra's sources have invalid escape sequences
    import toppra
    from toppra.algorithm import TOPPRA
    from toppra.constraint import JointAccelerationConstraint, JointVelocityConstraint


CELLS = Path(__file__).parents[3] / "cells"
PERIOD = 0.001


@cache
def arm(name: str) -> tuple[Cell, RobotModel, CollisionModel, MotionLimits]:
    cell = load_cell(CELLS / name)
    robot = RobotModel.of_cell(cell)
    collision = CollisionModel(cell, robot, cell.payload_box)
    return cell, robot, collision, MotionLimits.of_cell(cell, robot, collision)


def timed(name: str, q: Array) -> JointTrajectory:
    _, robot, _, limits = arm(name)
    return time_curve(round_corners(q), robot, limits, period=PERIOD)


def polyline(name: str, seed: int, vertices: int) -> Array:
    cell, robot, _, _ = arm(name)
    rng = np.random.default_rng(seed)
    steps = rng.normal(0.0, 0.4, (vertices - 1, robot.n))
    return np.concatenate(([cell.robot.home_rad], cell.robot.home_rad + np.cumsum(steps, axis=0)))


@cache
def speeds_of(name: str) -> IndependentChecker:
    """Judges speeds alone: where nothing stands around there are no distances and no flights to look at."""
    cell, *_ = arm(name)
    return IndependentChecker(cell.model_copy(update={"zones": (), "obstacles": ()}), cell.payload_box)


@settings(max_examples=12, deadline=None)
@given(name=st.sampled_from(["lwr4_bench", "ur5e_line"]), seed=st.integers(0, 10_000), vertices=st.integers(2, 6))
def test_every_limit_holds_for_finite_differences_of_the_samples(name: str, seed: int, vertices: int) -> None:
    cell, _, _, _ = arm(name)
    trajectory = timed(name, polyline(name, seed, vertices))
    findings = speeds_of(name).check(trajectory.q, PERIOD)
    assert findings.speed_m_s <= cell.limits.cartesian_speed_m_s * (1 + 1e-9)
    assert findings.velocity <= 1 + 1e-9
    assert findings.acceleration <= 1 + 1e-9


@pytest.mark.parametrize("name", ["lwr4_bench", "ur5e_line"])
@pytest.mark.parametrize("seed", range(3))
def test_the_time_is_close_to_what_the_speed_limits_leave(name: str, seed: int) -> None:
    """The lower bound has infinite accelerations; speeding up, slowing down and tight corners may cost some."""
    _, robot, _, limits = arm(name)
    q = polyline(name, seed, 3)
    bound = least_seconds(np.asarray(round_corners(q)(np.linspace(0, round_corners(q).x[-1], 400))), robot, limits)
    assert 0.999 * bound <= timed(name, q).duration <= 1.1 * bound + 2.5 * SMOOTHING_S


def test_a_trajectory_runs_along_its_path_from_rest_to_rest_without_jumps() -> None:
    q = polyline("lwr4_bench", 5, 4)
    trajectory = timed("lwr4_bench", q)
    np.testing.assert_allclose(trajectory.q[[0, -1]], q[[0, -1]], atol=1e-12)
    velocity = np.diff(trajectory.q, axis=0) / PERIOD
    assert np.abs(velocity[[0, -1]]).max() < 1e-3
    jerk = np.diff(np.pad(velocity, ((3, 3), (0, 0))), n=2, axis=0) / PERIOD**2
    assert np.abs(jerk).max() < 1500.0  # rad/s3; a step to the acceleration limit would be 15 000
    curve = round_corners(q)
    samples = np.asarray(curve(np.linspace(0.0, curve.x[-1], 4000)))
    off = [np.linalg.norm(samples - row, axis=1).min() for row in trajectory.q[::50]]
    assert max(off) < 1e-3


def test_limits_far_below_anything_are_refused_or_kept() -> None:
    _, robot, _, limits = arm("ur5e_line")
    slow = MotionLimits(limits.velocity, limits.acceleration, 0.01, limits.points)
    trajectory = time_curve(round_corners(polyline("ur5e_line", 1, 3)), robot, slow, period=PERIOD)
    fast = timed("ur5e_line", polyline("ur5e_line", 1, 3))
    assert trajectory.duration == pytest.approx(25.0 * fast.duration, rel=0.1)


@pytest.mark.parametrize("seed", range(4))
def test_the_phase_plane_agrees_with_toppra(seed: int) -> None:
    """The same problem without Cartesian limit: joint velocities and accelerations along a smooth curve."""
    rng = np.random.default_rng(seed)
    n = 6
    velocity, acceleration = rng.uniform(0.5, 2.0, n), rng.uniform(1.0, 5.0, n)
    curve = round_corners(np.cumsum(rng.normal(0.0, 0.7, (4, n)), axis=0))
    s = np.linspace(0.0, curve.x[-1], 1500)
    tangent, curvature = np.asarray(curve(s, 1)), np.asarray(curve(s, 2))
    ceiling = 1.0 / (np.abs(tangent) / velocity).max(axis=1) ** 2
    x = fastest_profile(s, tangent, curvature, acceleration, ceiling)
    sdot = np.sqrt(x)
    mine = float((2.0 * np.diff(s) / (sdot[1:] + sdot[:-1])).sum())

    class Curve(toppra.interpolator.AbstractGeometricPath):
        dof, path_interval = n, np.array([0.0, s[-1]])

        def __call__(self, at: Array, order: int = 0) -> Array:
            return np.asarray(curve(at, order))

    limits = [
        JointVelocityConstraint(np.stack((-velocity, velocity), axis=1)),
        JointAccelerationConstraint(np.stack((-acceleration, acceleration), axis=1)),
    ]
    solver = TOPPRA(limits, Curve(), gridpoints=s, solver_wrapper="seidel")
    theirs = solver.compute_parameterization(0.0, 0.0)[1]
    assert mine == pytest.approx(float((2.0 * np.diff(s) / (theirs[1:] + theirs[:-1])).sum()), rel=0.01)
    u = np.diff(x) / (2.0 * np.diff(s))
    torque = np.abs(tangent[:-1] * u[:, None] + curvature[:-1] * x[:-1, None]) / acceleration
    assert np.quantile(torque.max(axis=1), 0.99) <= 1.0 + 1e-6


def test_corners_are_found_again_in_a_dense_polyline() -> None:
    vertices = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [0.0, 2.5]])
    dense = np.concatenate([np.linspace(a, b, 11) for a, b in pairwise(vertices)])
    np.testing.assert_allclose(corners(dense), vertices)


@given(seed=st.integers(0, 10_000))
@settings(max_examples=30, deadline=None)
def test_a_rounded_curve_is_smooth_and_stays_in_the_triangles_that_it_cuts_off(seed: int) -> None:
    rng = np.random.default_rng(seed)
    q = np.cumsum(rng.normal(0.0, 1.0, (4, 3)), axis=0)
    curve = round_corners(q)
    inner = curve.x[1:-1]
    for order in range(3):
        np.testing.assert_allclose(curve(inner - 1e-9, order), curve(inner + 1e-9, order), atol=1e-5 * 10**order)
    assert (np.asarray(curve(np.linspace(0, curve.x[-1], 300))) <= q.max(axis=0) + 1e-9).all()
    np.testing.assert_allclose(curve(curve.x[[0, -1]]), q[[0, -1]], atol=1e-12)


def test_a_corner_is_rounded_only_as_far_as_there_is_room() -> None:
    q = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])

    def is_clear(samples: Array) -> bool:
        return bool(np.linalg.norm(samples - q[1], axis=1).min() < 0.02)

    wide, tight = round_corners(q), round_corners(q, is_clear)
    from_corner = [np.linalg.norm(np.asarray(curve(np.linspace(0, curve.x[-1], 999))) - q[1], axis=1).min() for curve in (wide, tight)]
    assert from_corner[0] > 0.1
    assert from_corner[1] < 0.02


def test_a_corner_without_any_room_is_refused() -> None:
    with pytest.raises(NoPath, match="cannot be rounded"):
        round_corners(np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]), lambda _: False)
