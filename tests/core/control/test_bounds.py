from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.cell.folder import load_cell
from core.control.bounds import JointLimits, velocity_bounds
from core.robot.model import RobotModel
from tests.core.control.kinematic_session import ROOT

periods = st.sampled_from([0.0005, 0.001, 0.004, 0.01, 0.05])


def limits_of(rng: np.random.Generator, n: int) -> JointLimits:
    middle, half = rng.uniform(-1, 1, n), rng.uniform(0.05, 3, n)
    return JointLimits(middle - half, middle + half, rng.uniform(0.2, 4, n), rng.uniform(1, 30, n))


@given(st.integers(0, 2**32), periods, st.sampled_from(["up", "down", "random", "bang", "sine"]))
def test_no_wish_ever_leaves_position_velocity_or_acceleration_limits(seed, T, wish):
    rng = np.random.default_rng(seed)
    n = 5
    limits = limits_of(rng, n)
    q, dq = rng.uniform(limits.lower, limits.upper), np.zeros(n)
    for k in range(400):
        lo, hi = velocity_bounds(q, dq, limits, T)
        assert (lo <= hi).all()
        wanted = {
            "up": 9.0, "down": -9.0, "random": rng.uniform(-9, 9, n), "bang": 9.0 * (-1) ** (k // 37), "sine": 5 * np.sin(k * T * 3),
        }[wish]  # fmt: skip
        v = np.clip(wanted, lo, hi)
        q = q + T * v
        assert (q >= limits.lower).all() and (q <= limits.upper).all()
        assert (np.abs(v) <= limits.velocity).all()
        assert (np.abs(v - dq) <= limits.acceleration * T * (1 + 1e-9)).all()
        dq = v


@given(st.integers(0, 2**32), st.sampled_from([0.004, 0.01, 0.05]))
@settings(max_examples=40)
def test_the_bound_is_the_largest_velocity_from_which_braking_keeps_the_limit(seed, T):
    rng = np.random.default_rng(seed)
    limits = limits_of(rng, 1)
    q = rng.uniform(limits.lower, limits.upper)
    A, V = limits.acceleration[0], limits.velocity[0]
    free = JointLimits(limits.lower - 1e6, limits.upper, np.array([1e3]), limits.acceleration)

    def distance(v: float) -> float:
        """Travelled by braking from v, simulated period by period."""
        total = 0.0
        while v > 0:
            total += T * v
            v -= A * T
        return total

    # acceleration out of the way: the velocity now is the bound itself, found by bisection with the simulation
    room = float(limits.upper[0] - q[0])
    low, high = 0.0, np.sqrt(2 * A * room) + A * T
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if distance(middle) <= room else (low, middle)
    _, hi = velocity_bounds(q, np.array([low]), free, T)
    assert hi[0] == pytest.approx(low, abs=1e-6 + 3e-9 / T)
    _, hi = velocity_bounds(q, np.array([min(low, V)]), limits, T)
    assert hi[0] == pytest.approx(min(low, V), abs=1e-6 + 3e-9 / T)


def test_it_tends_to_equation_7_for_a_short_period():
    limits = JointLimits(np.array([-2.0]), np.array([2.0]), np.array([50.0]), np.array([10.0]))
    for room in (0.01, 0.2, 1.0):
        q = limits.upper - room
        paper = np.sqrt(2 * 10.0 * room)
        _, hi = velocity_bounds(q, np.array([paper]), limits, 1e-6)
        assert hi[0] == pytest.approx(paper, rel=1e-3)
        assert hi[0] <= paper


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_a_joint_past_its_limit_brakes_as_hard_as_it_may(side):
    limits = JointLimits(np.array([-1.0]), np.array([1.0]), np.array([2.0]), np.array([10.0]))
    lo, hi = velocity_bounds(side * np.array([1.2]), side * np.array([1.5]), limits, 0.001)
    assert lo == hi == pytest.approx(side * (1.5 - 0.01))


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_a_joint_that_stands_past_its_limit_may_come_back_but_not_go_on(side):
    limits = JointLimits(np.array([-1.0]), np.array([1.0]), np.array([2.0]), np.array([10.0]))
    lo, hi = velocity_bounds(side * np.array([1.2]), np.zeros(1), limits, 0.001)
    inward, outward = (lo, hi) if side > 0 else (-hi, -lo)
    assert inward[0] == pytest.approx(-0.01) and outward[0] == 0.0


def test_a_joint_above_its_speed_limit_brakes():
    limits = JointLimits(np.array([-9.0]), np.array([9.0]), np.array([2.0]), np.array([10.0]))
    lo, hi = velocity_bounds(np.zeros(1), np.array([3.0]), limits, 0.001)
    assert lo == hi == pytest.approx(2.99)


def test_limits_of_a_cell_take_the_slower_of_cell_and_urdf():
    cell = load_cell(ROOT / "cells" / "lwr4_bench")
    robot = RobotModel.of_cell(cell)
    assert (JointLimits.of(cell, robot).velocity == robot.velocity).all()
    given_velocity = (0.5, 99.0, *robot.velocity[2:])
    slower = cell.model_copy(update={"robot": cell.robot.model_copy(update={"velocity_rad_s": given_velocity})})
    expected = np.array([0.5, *robot.velocity[1:]])
    np.testing.assert_array_equal(JointLimits.of(slower, robot).velocity, expected)
