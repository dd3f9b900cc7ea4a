from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog

from core.control.bounds import JointLimits, velocity_bounds
from core.control.sns import scale_and_critical_joint, sns_reference
from core.control.sns_kernel import sns, sns_step
from tests.core.control.kinematic_session import CELLS, PERIOD, bench

SHAPES = [(6, 6), (6, 7), (3, 6), (3, 7), (6, 9)]


def largest_scale(J, x, lower, upper):
    """The linear program's answer; None where it is infeasible."""
    m, n = J.shape
    result = linprog(
        np.r_[np.zeros(n), -1.0],
        A_eq=np.c_[J, -x],
        b_eq=np.zeros(m),
        bounds=[*zip(lower, upper, strict=True), (0.0, 1.0)],
    )
    return None if result.status == 2 else float(result.x[-1])


def problem(seed, shape, kind):
    """Random tasks: easy ones, ones that saturate, ones whose bounds lie round a velocity far from 0, and joints that must not move."""
    rng = np.random.default_rng(seed)
    m, n = shape
    J = rng.normal(size=(m, n))
    if kind == "moving":
        v = rng.normal(size=n)
        width = rng.uniform(0.02, 0.5, n)
        return J, J @ v * rng.uniform(0.6, 1.4) + 0.03 * rng.normal(size=m), v - width, v + width
    lower, upper = -rng.uniform(0.2, 2, n), rng.uniform(0.2, 2, n)
    if kind == "blocked":
        upper[rng.integers(n)] = 0.0
    return J, rng.normal(size=m) * (0.1 if kind == "easy" else rng.uniform(0.5, 5)), lower, upper


problems = st.builds(
    problem,
    st.integers(0, 2**32),
    st.sampled_from(SHAPES),
    st.sampled_from(["easy", "hard", "moving", "blocked"]),
)
implementations = pytest.mark.parametrize("solve", [sns_reference, sns])


@implementations
@settings(max_examples=300)
@given(drawn=problems)
def test_it_never_leaves_the_bounds_and_achieves_the_share_it_says(solve, drawn):
    J, x, lower, upper = drawn
    dq, s = solve(J, x, lower, upper)
    assert (dq >= lower).all() and (dq <= upper).all()
    assert 0.0 <= s <= 1.0
    if s > 0.0:
        np.testing.assert_allclose(J @ dq, s * x, atol=1e-6 * (1 + np.abs(x).max()))


@settings(max_examples=300)
@given(drawn=problems)
def test_the_compiled_one_gives_the_largest_scale_that_a_linear_program_finds(drawn):
    J, x, lower, upper = drawn
    s = sns(J, x, lower, upper).scale
    best = largest_scale(J, x, lower, upper)
    if best is None:
        assert s == 0.0
    else:
        assert s >= 0.97 * best - 1e-9  # what was promised
        assert s == pytest.approx(best, abs=1e-6)  # what it does


@settings(max_examples=300)
@given(drawn=problems)
def test_the_compiled_one_agrees_with_the_reference_and_never_scales_more(drawn):
    J, x, lower, upper = drawn
    paper, fast = sns_reference(J, x, lower, upper), sns(J, x, lower, upper)
    assert fast.scale >= paper.scale - 1e-7
    if paper.scale == 1.0:
        np.testing.assert_allclose(fast.dq, paper.dq, atol=1e-7)


@settings(max_examples=100)
@given(seed=st.integers(0, 2**32))
def test_without_redundancy_both_scale_alike(seed):
    J, x, lower, upper = problem(seed, (6, 6), "hard")
    assume(np.linalg.cond(J) < 1e3)
    paper, fast = sns_reference(J, x, lower, upper), sns(J, x, lower, upper)
    assert fast.scale == pytest.approx(paper.scale, abs=1e-9)
    np.testing.assert_allclose(fast.dq, paper.dq, atol=1e-7)


@implementations
def test_where_nothing_saturates_it_is_the_solution_of_least_norm(solve):
    J, x, lower, upper = problem(3, (6, 7), "easy")
    dq, s = solve(J, x, 10 * lower, 10 * upper)
    assert s == 1.0
    np.testing.assert_allclose(dq, np.linalg.lstsq(J, x)[0], atol=1e-10)


@implementations
def test_a_saturated_joint_is_made_up_for_by_the_others(solve):
    J = np.array([[1.0, 1.0, 1.0]])
    dq, s = solve(J, np.array([3.0]), -2.0 * np.ones(3), np.array([0.5, 2.0, 2.0]))
    assert s == 1.0
    np.testing.assert_allclose(dq, [0.5, 1.25, 1.25], atol=1e-12)


@implementations
def test_what_no_joint_can_make_up_for_scales_the_task(solve):
    J = np.array([[1.0, 1.0, 1.0]])
    dq, s = solve(J, np.array([6.0]), -np.ones(3), np.array([0.5, 1.0, 1.5]))
    assert s == pytest.approx(0.5)
    np.testing.assert_allclose(dq, [0.5, 1.0, 1.5], atol=1e-12)


@implementations
def test_a_singular_jacobian_brakes(solve):
    J = np.array([[1.0, 2.0, 0.0], [2.0, 4.0, 0.0], [0.0, 0.0, 1.0]])
    lower, upper = np.array([0.1, -1.0, -1.0]), np.array([0.3, 1.0, 1.0])
    dq, s = solve(J, np.array([1.0, 0.0, 0.0]), lower, upper)
    assert s == 0.0
    np.testing.assert_array_equal(dq, [0.1, 0.0, 0.0])


@implementations
def test_a_task_of_zero_is_done_by_standing_still(solve):
    J, x, lower, upper = problem(5, (6, 7), "hard")
    dq, s = solve(J, 0.0 * x, lower, upper)
    assert s == 1.0
    np.testing.assert_array_equal(dq, np.zeros(7))


def test_algorithm_8_ignores_a_joint_that_does_not_move_unless_it_is_outside():
    a, lower, upper = np.array([0.0, 2.0]), -np.ones(2), np.ones(2)
    assert scale_and_critical_joint(a, np.zeros(2), lower, upper) == (0.5, 1)
    assert scale_and_critical_joint(a, np.array([1.5, 0.0]), lower, upper) == (0.0, 0)


def test_algorithm_8_exchanges_the_ends_for_a_joint_that_moves_backwards():
    assert scale_and_critical_joint(np.array([-4.0]), np.zeros(1), np.array([-1.0]), np.array([3.0])) == (0.25, 0)


@pytest.mark.parametrize("name", CELLS)
@pytest.mark.parametrize("rows", [3, 6])
@settings(max_examples=25)
@given(seed=st.integers(0, 2**32))
def test_the_fused_step_is_jacobian_bounds_and_sns(name, rows, seed):
    robot, cell = bench(name).robot, bench(name).cell
    limits = JointLimits.of(cell, robot)
    rng = np.random.default_rng(seed)
    q, x = rng.uniform(robot.lower, robot.upper), rng.normal(size=rows)
    dq = 0.1 * rng.uniform(-1, 1, robot.n)
    J = robot.sensor_jacobian(q)[6 - rows :]
    assume(np.linalg.cond(J) < 100)
    step = sns_step(robot.chain, q, dq, x, limits, 0.05)
    paper = sns_reference(J, x, *velocity_bounds(q, dq, limits, 0.05))
    assert step.scale >= paper.scale - 1e-7
    if paper.scale == 1.0:
        np.testing.assert_allclose(step.dq, paper.dq, atol=1e-7)


@pytest.mark.parametrize("name", CELLS)
@pytest.mark.parametrize("rows", [3, 6])
@settings(max_examples=15)
@given(seed=st.integers(0, 2**32))
@example(seed=78311316)  # two joints left for three rows, and a small pivot that hid it
def test_tasks_integrated_for_long_never_leave_the_limits(name, rows, seed):
    """Wild tasks, whole seconds, into position limits and singularities."""
    robot, cell = bench(name).robot, bench(name).cell
    limits = JointLimits.of(cell, robot)
    rng = np.random.default_rng(seed)
    T = 4 * PERIOD
    q, dq = rng.uniform(robot.lower, robot.upper), np.zeros(robot.n)
    for k in range(1500):
        if k % 250 == 0:
            x = rng.normal(size=rows) * rng.uniform(0.2, 4)
        v, s = sns_step(robot.chain, q, dq, x, limits, T)
        if s > 0.0:
            J = robot.sensor_jacobian(q)[6 - rows :]
            np.testing.assert_allclose(J @ v, s * x, atol=1e-5 * (1 + np.abs(x).max()))
        q = q + T * v
        assert (q >= limits.lower).all() and (q <= limits.upper).all()
        assert (np.abs(v) <= limits.velocity).all()
        assert (np.abs(v - dq) <= limits.acceleration * T * (1 + 1e-9)).all()
        dq = v


def test_a_robot_that_cannot_follow_brakes_along_its_path():
    robot, cell = bench().robot, bench().cell
    limits = JointLimits.of(cell, robot)
    q, dq = bench().home, np.linspace(0.2, 0.5, robot.n)
    v, s = sns_step(robot.chain, q, dq, -robot.sensor_jacobian(q) @ dq, limits, PERIOD)
    assert s == 0.0
    ratio = v / dq
    np.testing.assert_allclose(ratio, ratio[0])
    assert 0.0 < ratio[0] < 1.0
    assert np.max((dq - v) / (limits.acceleration * PERIOD)) == pytest.approx(1.0)
