"""`bench.third_stranger.tours`: the arm stays within its limits, comes to rest, and is never jerked."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from bench.second_stranger.arms import Arm
from bench.second_stranger.motions import follow_motion
from bench.second_stranger.signals import STEP_S, derive
from bench.third_stranger.arms import ARMS
from bench.third_stranger.tours import PACES, Tour, draw_poses, draw_tour

UP = np.array([0, 0, 1.0])


@pytest.mark.parametrize("arm", ARMS, ids=lambda arm: arm.name)
@pytest.mark.parametrize("kind", [kind for kind in PACES if kind != "poses"])
def test_a_tour_is_smooth_and_within_the_joints_limits(arm: Arm, kind: Tour) -> None:
    stretches = draw_tour(np.random.default_rng(7), arm, UP, kind, 45, 1, True)
    assert all(a.end_s == b.begin_s for a, b in pairwise(stretches))
    t = np.arange(0, stretches[-1].end_s, STEP_S)
    q = follow_motion(stretches, t)
    speed = derive(q)
    assert np.all(np.abs(q) < arm.angle_limits)
    assert np.max(np.abs(speed)) < 5
    assert np.max(np.abs(derive(speed))) < 40
    for stretch in stretches:
        if stretch.label.startswith("hold"):
            assert np.ptp(stretch.follow(np.linspace(stretch.begin_s, stretch.end_s, 5)), axis=0).max() == 0


def test_poses_have_as_many_stops_as_are_asked_for() -> None:
    stretches = draw_poses(np.random.default_rng(8), ARMS[0], UP, 14)
    assert sum(stretch.label.startswith("hold") for stretch in stretches) == 14
