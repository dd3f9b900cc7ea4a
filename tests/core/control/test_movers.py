from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation as Orientation

from core.control.bounds import JointLimits
from core.control.movers import Mover, Playback, StandStill
from core.control.rotation import Rotation
from core.errors import BadState, OutOfLimits
from core.robot.decoupling import decoupling_profile
from core.robot.trajectory import AngularProfile, JointTrajectory
from core.sessions.session import RobotState
from tests.core.control.kinematic_session import CELLS, PERIOD, bench, fastest_at


def standing(q: np.ndarray) -> RobotState:
    return RobotState(0.0, q, np.zeros_like(q), q, np.zeros(6))


def drain(mover: Mover, q: np.ndarray) -> np.ndarray:
    """All commanded positions, the start first."""
    rows = [q]
    while (target := mover.next(standing(q))) is not None:
        rows.append(target)
    return np.array(rows)


def rotation_of(name: str, axis: int, profile: AngularProfile, speed: float = 0.25) -> Rotation:
    it = bench(name)
    limits = JointLimits.of(it.cell, it.robot)
    return Rotation(it.robot, it.collision.points, limits, cartesian_speed=speed, profile=profile, axis=axis)


def profile_of(name: str, **options: float) -> AngularProfile:
    return decoupling_profile(bench(name).cell.payload_box, **{"cartesian_speed": 0.2, "period": PERIOD, **options})


def turned(name: str, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rotation vectors in the sensor frame and displacements of the sensor origin, both from the first row on."""
    poses = bench(name).robot.sensor_poses(q)
    R = poses.rotation
    return Orientation.from_matrix(R[0].T @ R).as_rotvec(), poses.position - poses.position[0]


def assert_within_limits(name: str, q: np.ndarray) -> None:
    limits = JointLimits.of(bench(name).cell, bench(name).robot)
    dq = np.diff(q, axis=0, prepend=q[:1]) / PERIOD
    assert (q >= limits.lower).all() and (q <= limits.upper).all()
    assert (np.abs(dq) <= limits.velocity * (1 + 1e-9)).all()
    assert (np.abs(np.diff(dq, axis=0)) / PERIOD <= limits.acceleration * (1 + 1e-6)).all()


@pytest.mark.parametrize("name", CELLS)
@pytest.mark.parametrize("axis", [0, 1, 2])
def test_the_rotation_follows_the_profile_and_the_sensor_origin_stays(name, axis):
    profile = profile_of(name, repetitions=3, cartesian_speed=0.12)
    mover = rotation_of(name, axis, profile)
    q = drain(mover, bench(name).home)
    angle, displacement = turned(name, q)
    assert mover.scaled == 0 and mover.progress == 1.0
    assert len(profile.angle) <= len(q) <= len(profile.angle) + 10
    np.testing.assert_allclose(angle[: len(profile.angle), axis], profile.angle, atol=2e-6)
    np.testing.assert_allclose(np.delete(angle, axis, axis=1), 0.0, atol=1e-5)
    assert np.abs(displacement).max() < 2e-6
    assert_within_limits(name, q)


@pytest.mark.parametrize("name", CELLS)
def test_it_ends_at_rest(name):
    q = drain(rotation_of(name, 0, profile_of(name)), bench(name).home)
    assert np.abs(q[-1] - q[-2]).max() / PERIOD < 1e-3


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_an_arm_with_a_joint_to_spare_comes_back_to_where_it_began_however_often_it_turns(axis):
    q = drain(rotation_of("lwr4_bench", axis, profile_of("lwr4_bench", repetitions=10)), bench("lwr4_bench").home)
    assert np.abs(q - q[0]).max() > 0.2
    assert np.abs(q[-1] - q[0]).max() < 1e-6
    assert np.abs(turned("lwr4_bench", q)[1]).max() < 1e-7


@pytest.mark.parametrize("name", CELLS)
@pytest.mark.parametrize("axis", [0, 1])
def test_where_a_link_would_be_too_fast_time_passes_more_slowly(name, axis):
    profile = profile_of(name)
    mover = rotation_of(name, axis, profile, speed=0.1)
    q = drain(mover, bench(name).home)
    angle, displacement = turned(name, q)
    it = bench(name)
    dq = np.diff(q, axis=0) / PERIOD
    speeds = [fastest_at(it, *row)[0] for row in zip(q[:-1], dq, strict=True)]
    assert mover.scaled > 0 and mover.progress == 1.0
    assert 0.095 < max(speeds) <= 0.0975
    assert angle[:, axis].max() == pytest.approx(profile.angle.max(), abs=1e-3)
    assert np.abs(angle[-1]).max() < 1e-5 and np.abs(displacement).max() < 5e-6
    assert_within_limits(name, q)


def test_a_rotation_that_meets_a_joint_limit_is_given_up_inside_the_limits():
    it = bench("ur5e_line")
    t = np.arange(0, 8, PERIOD)
    rate = np.minimum(1.0, np.minimum(4.8 * t, 4.8 * (t[-1] - t)))
    profile = AngularProfile(PERIOD, np.concatenate(([0.0], np.cumsum(PERIOD * 0.5 * (rate[1:] + rate[:-1])))), rate)
    start = it.home.copy()
    start[5] = it.robot.upper[5] - 0.3
    mover = rotation_of("ur5e_line", 2, profile)
    rows = [start]
    with pytest.raises(OutOfLimits, match=r"rotation about sensor axis z stands still at \d+ % .* joint wrist_3 is 0\.000 rad"):
        while (target := mover.next(standing(start))) is not None:
            rows.append(target)
    assert_within_limits("ur5e_line", np.array(rows))
    np.testing.assert_allclose(rows[-1], rows[-2], atol=1e-9)


def test_playback_gives_the_trajectory_sample_by_sample():
    q = bench().home + np.linspace(0, 0.1, 20)[:, None] ** 2
    np.testing.assert_array_equal(drain(Playback(JointTrajectory(PERIOD, q)), q[0]), q)


def test_what_is_left_of_a_rotation_is_faded_out_and_never_jumps():
    home = bench("lwr4_bench").home
    s = np.linspace(0.0, 1.0, 2001)[:, None]
    trajectory = JointTrajectory(PERIOD, home + 0.3 * s**3 * (10 - 15 * s + 6 * s**2))
    away = np.array([6e-5, -3e-5, 2e-5, 0, 0, 1e-5, -6e-5])
    q = drain(Playback(trajectory), home + away)
    np.testing.assert_allclose(q[0], home + away)
    np.testing.assert_array_equal(q[-1], trajectory.q[-1])
    planned = np.abs(np.diff(trajectory.q, 2, axis=0)).max() / PERIOD**2
    assert np.abs(np.diff(q, 2, axis=0)).max() / PERIOD**2 < planned + 1e-3


def test_playback_refuses_to_start_elsewhere():
    q = np.tile(bench().home, (5, 1))
    away = q[0] + np.array([0, 0.02, 0, 0, 0, 0, 0])
    with pytest.raises(BadState, match=r"joint 2 stands 0\.0200 rad from where the trajectory starts"):
        Playback(JointTrajectory(PERIOD, q)).next(standing(away))


def test_standstill_holds_the_command_for_its_time():
    q = drain(StandStill(0.25, PERIOD), bench().home)
    assert len(q) == 1 + 250
    np.testing.assert_array_equal(q, np.tile(bench().home, (251, 1)))


@pytest.mark.parametrize("name", CELLS)
def test_a_rotation_that_is_ended_early_is_the_one_that_was_planned_with_fewer_repetitions(name):
    many, few = (rotation_of(name, 2, profile_of(name, repetitions=count)) for count in (5, 2))
    planned = drain(few, bench(name).home)
    rows = [bench(name).home]
    left_out = 0
    while (target := many.next(standing(rows[-1]))) is not None:
        rows.append(target)
        if many.repetitions_done == 1 and not left_out:
            left_out = many.end_early()
    assert left_out == 3
    assert many.end_early() == 0
    np.testing.assert_allclose(rows, planned, atol=1e-12)


def test_a_rotation_in_its_last_repetition_has_nothing_to_leave_out():
    mover = rotation_of(CELLS[0], 0, profile_of(CELLS[0], repetitions=2))
    rows = 0
    while (mover.next(standing(bench(CELLS[0]).home))) is not None:
        rows += 1
        if mover.repetitions_done == 1:
            assert mover.end_early() == 0
    assert mover.repetitions_done == 2
