"""Paths as Franka's motion generator takes them, held against backward differences that are taken here anew."""

import numpy as np
import pytest

from core.sessions.franka_path import (
    ACCELERATION,
    BACK_PER_S,
    JERK,
    PANDA,
    RESEARCH_3,
    Difference,
    Envelope,
    Smoothness,
    Steps,
    braking_path,
)

T = 0.001


def derivatives(begin: Steps, q: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Speed, acceleration and jerk of positions that go on from `begin`."""
    dq = np.diff(np.vstack([begin.q, q]), axis=0) / T
    ddq = np.diff(np.vstack([begin.dq, dq]), axis=0) / T
    return dq, ddq, np.diff(np.vstack([begin.ddq, ddq]), axis=0) / T


@pytest.mark.parametrize("make", [PANDA, RESEARCH_3])
@pytest.mark.parametrize("seed", range(6))
def test_braking_from_any_motion_keeps_acceleration_and_jerk_and_ends_at_rest(make, seed):
    rng = np.random.default_rng(seed)
    acceleration, jerk = np.array(ACCELERATION[make]), np.array(JERK[make])
    begin = Steps(rng.uniform(-1, 1, 7), rng.uniform(-1.5, 1.5, 7), rng.uniform(-0.9, 0.9, 7) * acceleration)
    q = braking_path(begin, 0.9 * acceleration, 0.9 * jerk)
    dq, ddq, dddq = derivatives(begin, q)
    slack = 1.0 + 1e-6
    assert (np.abs(ddq) <= slack * acceleration).all() and (np.abs(dddq) <= slack * jerk).all()
    np.testing.assert_allclose(dq[-1], 0.0, atol=1e-9)
    np.testing.assert_allclose(ddq[-1], 0.0, atol=1e-6)
    shortest = float(np.max(np.abs(begin.dq) / acceleration))
    assert len(q) * T < 1.3 * shortest + 0.02


def test_braking_keeps_the_direction_of_the_motion():
    begin = Steps(np.zeros(7), np.linspace(-0.7, 0.9, 7))
    q = braking_path(begin, np.full(7, 5.0), np.full(7, 4000.0))
    way = q[-1] / begin.dq
    np.testing.assert_allclose(way, way[0], rtol=1e-9)
    assert way[0] == pytest.approx(0.5 * 0.9 / 5.0, rel=0.05), "half of the time that the fastest joint takes, at its speed"


def test_an_arm_at_rest_has_nothing_to_brake():
    q = braking_path(Steps(np.ones(7)), np.full(7, 5.0), np.full(7, 4000.0))
    np.testing.assert_array_equal(q, np.ones_like(q))


def test_what_the_controller_went_on_by_itself_goes_back_to_the_path_without_a_step():
    """Ten lost commands at 0.5 rad/s and 2 rad/s2: the arm is 5 mrad ahead."""
    path = Steps(np.full(7, 0.3), np.full(7, 0.5), np.full(7, 2.0))
    ahead, lost = 10, path
    for _ in range(ahead):
        lost = lost.next(lost.q + T * (lost.dq + T * lost.ddq))
    difference = Difference(7)
    difference.set(lost, path)
    sent, positions = path, []
    speed = path.dq
    for _ in range(1500):
        sent = sent.next(sent.q + T * speed)  # the path itself goes on at the same speed
        positions.append(sent.q + difference.next())
    _, ddq, dddq = derivatives(lost, np.array(positions))
    assert np.abs(ddq).max() < 7.0 and np.abs(dddq[1:]).max() < 500.0
    far = np.abs(np.array(positions)[:, 0] - np.cumsum(np.full(1500, T * 0.5)) - 0.3)
    assert far[0] == pytest.approx(5e-3, rel=0.1)
    assert far[round(1000 * 10 / BACK_PER_S)] < 1e-4 and far[-1] < 1e-9


@pytest.mark.parametrize(("q", "down", "up"), [(0.0, 2.0, 2.0), (2.9, 2.0, 0.0), (-2.0, np.sqrt(2 * 6 * 1.0) - 0.3, 2.0)])
def test_near_the_end_of_a_joint_it_may_go_only_so_fast_as_it_can_brake(q, down, up):
    limits = [np.full(7, each) for each in (-3.0, 2.9, 2.0, 0.3, 6.0)]
    found = Envelope(*limits).fastest(np.full(7, q))
    np.testing.assert_allclose(found[0], min(down, 2.0))
    np.testing.assert_allclose(found[1], min(up, 2.0))


def test_limits_are_those_of_the_arm():
    """A step of 8 rad/s2 at joint 2, which a Research 3 may and a Panda may not."""
    before, now = Steps(np.zeros(7), np.zeros(7), np.full(7, 5.0)), Steps(np.zeros(7), np.zeros(7), np.full(7, 8.0))
    Smoothness("abcdefg", RESEARCH_3, None).check(before, now)
    with pytest.raises(Exception, match=r"joint b: 8\.0 rad/s² commanded, and its controller allows 7\.5"):
        Smoothness("abcdefg", PANDA, None).check(before, now)
