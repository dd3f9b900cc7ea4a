from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import cumulative_simpson

from core.cell.cell import Box, Pose
from core.robot.decoupling import (
    ACCELERATION,
    count_accelerating_samples,
    decoupling_profile,
    predict_inertia,
    rate_limit,
    repetitions_for,
)

CUBE = Box(size_m=(0.16, 0.16, 0.16), pose=Pose(xyz_m=(0.0, 0.0, 0.08)))

size = st.floats(0.03, 0.5)
boxes = st.builds(
    lambda size, xyz, rpy: Box(size_m=size, pose=Pose(xyz_m=xyz, rpy_rad=rpy)),
    st.tuples(size, size, size),
    st.tuples(*[st.floats(-0.1, 0.2)] * 3),
    st.tuples(*[st.floats(-3, 3)] * 3),
)
profiles = st.builds(
    lambda box, speed, period, repetitions, plateau: (
        box,
        speed,
        decoupling_profile(box, cartesian_speed=speed, period=period, repetitions=repetitions, plateau=plateau),
    ),
    boxes,
    st.floats(0.1, 1.0),
    st.sampled_from([0.001, 0.002, 0.004]),
    st.integers(1, 4),
    st.floats(0.0, 0.2),
)


@given(profiles)
def test_the_angle_is_the_integral_of_the_rate(drawn):
    _, _, profile = drawn
    # Simpson on a grid twice as fine is exact for a piecewise linear rate with its corners on the coarse grid
    fine = np.interp(np.arange(2 * len(profile.rate) - 1) / 2, np.arange(len(profile.rate)), profile.rate)
    angle = cumulative_simpson(fine, dx=profile.period / 2, initial=0.0)[::2]
    np.testing.assert_allclose(profile.angle, angle, atol=1e-12)


@given(profiles)
def test_it_starts_and_ends_at_rest_where_it_started(drawn):
    _, _, profile = drawn
    assert profile.angle[0] == 0.0 and profile.rate[0] == 0.0
    assert abs(profile.angle[-1]) < 1e-12 and abs(profile.rate[-1]) < 1e-12


@given(profiles)
def test_the_acceleration_is_the_papers_or_zero(drawn):
    _, _, profile = drawn
    acceleration = np.abs(np.diff(profile.rate)) / profile.period
    assert acceleration.max() <= ACCELERATION * (1 + 1e-9)
    assert np.isclose(acceleration[:, None], [0.0, ACCELERATION], atol=1e-8).any(axis=1).all()


@given(profiles)
def test_no_corner_of_the_box_is_faster_than_the_limit(drawn):
    box, speed, profile = drawn
    w = np.abs(profile.rate).max()
    for axis in np.eye(3):
        corners = np.linalg.norm(np.cross(w * axis, box.corners), axis=1)
        assert corners.max() <= speed


@given(profiles)
def test_the_two_trapezoids_are_opposed_and_one_sided(drawn):
    _, _, profile = drawn
    assert profile.rate.max() == pytest.approx(-profile.rate.min())
    assert profile.angle.min() >= -1e-12
    assert profile.angle.max() <= 0.6 + 1e-9


def test_repetitions_repeat():
    once = decoupling_profile(CUBE, cartesian_speed=0.25, period=0.001)
    thrice = decoupling_profile(CUBE, cartesian_speed=0.25, period=0.001, repetitions=3)
    assert thrice.duration == pytest.approx(3 * once.duration)
    np.testing.assert_allclose(thrice.angle[: len(once.angle)], once.angle, atol=1e-12)
    np.testing.assert_allclose(thrice.rate[-len(once.rate) :], once.rate, atol=1e-12)


def test_the_rate_is_the_ratio_of_the_limit_to_the_farthest_corner():
    assert rate_limit(CUBE, 0.25) == pytest.approx(0.95 * 0.25 / np.sqrt(0.08**2 + 0.08**2 + 0.16**2))


def test_a_box_that_is_too_large_for_any_motion_is_refused():
    with pytest.raises(ValueError, match="less than one period"):
        decoupling_profile(Box(size_m=(200.0, 200.0, 200.0)), cartesian_speed=0.25, period=0.001)


def test_the_wanted_uncertainty_is_reached_in_a_simulation_and_not_by_much_less():
    once = decoupling_profile(CUBE, cartesian_speed=0.25, period=0.001)
    torque_std, inertia_std = 0.003, 8e-6
    repetitions = repetitions_for(once, torque_std=torque_std, inertia_std=inertia_std, budget=1e3)
    assert repetitions > 3
    profile = decoupling_profile(CUBE, cartesian_speed=0.25, period=0.001, repetitions=repetitions)
    acceleration = np.diff(profile.rate) / profile.period
    regressor = np.stack([acceleration, np.ones_like(acceleration)])  # the offset is unknown as well
    rng = np.random.default_rng(1)
    tau = 0.005 * acceleration + 0.1 + rng.normal(0.0, torque_std, (2000, len(acceleration)))
    found = np.linalg.lstsq(regressor.T, tau.T)[0][0]
    assert np.std(found) < 1.05 * inertia_std
    fewer = (repetitions - 1) * count_accelerating_samples(once)
    assert torque_std / (ACCELERATION * np.sqrt(fewer)) > inertia_std


def test_the_time_budget_clips_the_repetitions_but_one_is_always_done():
    once = decoupling_profile(CUBE, cartesian_speed=0.25, period=0.001)
    assert repetitions_for(once, torque_std=0.003, inertia_std=1e-9, budget=3.5 * once.duration) == 3
    assert repetitions_for(once, torque_std=0.003, inertia_std=1e-9, budget=0.1 * once.duration) == 1
    assert repetitions_for(once, torque_std=0.003, inertia_std=1.0, budget=1e3) == 1


@given(boxes, st.integers(0, 2))
def test_the_expected_inertia_is_that_of_a_box_full_of_points(box, axis):
    # Gauss-Legendre with two points per edge is exact for a quadratic
    gauss = np.array([-0.5, 0.5]) / np.sqrt(3.0)
    grid = np.stack(np.meshgrid(gauss, gauss, gauss), axis=-1).reshape(-1, 3) * np.array(box.size_m)
    points = grid @ box.pose.rotation.T + box.pose.translation
    off_axis = np.delete(points, axis, axis=1)
    assert predict_inertia(box, 2.0, axis) == pytest.approx(2.0 * np.mean(np.sum(off_axis**2, axis=1)))


@given(profiles)
def test_a_profile_rests_where_it_began_after_each_repetition_and_nowhere_else(drawn):
    box, speed, _ = drawn
    one, three = (decoupling_profile(box, cartesian_speed=speed, period=0.002, repetitions=count) for count in (1, 3))
    samples = len(one.angle) - 1
    assert three.rests.tolist() == [samples, 2 * samples, 3 * samples]


@given(profiles)
def test_a_profile_that_is_cut_is_the_one_with_fewer_repetitions(drawn):
    box, speed, _ = drawn
    few, many = (decoupling_profile(box, cartesian_speed=speed, period=0.002, repetitions=count) for count in (2, 5))
    cut = many.cut(int(many.rests[1]))
    np.testing.assert_allclose(cut.angle, few.angle, atol=1e-12)
    np.testing.assert_allclose(cut.rate, few.rate, atol=1e-12)
    assert cut.duration == few.duration


def test_a_rotation_that_is_repeated_is_the_one_that_is_made_as_often():
    once, thrice = (decoupling_profile(CUBE, cartesian_speed=0.25, period=0.002, repetitions=count) for count in (1, 3))
    again = once.repeat(3)
    np.testing.assert_allclose(again.angle, thrice.angle, atol=1e-12)
    np.testing.assert_allclose(again.rate, thrice.rate, atol=1e-12)
    assert len(again.rests) == 3
