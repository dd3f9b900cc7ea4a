"""`bench.fourth_stranger.motion`: a machine stays within its limits, comes to rest, and is never jerked; and so is what its log keeps."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from bench.fourth_stranger.forms import Form
from bench.fourth_stranger.machines import DESK, LARGE, MACHINES, UPRIGHT, Machine
from bench.fourth_stranger.motion import PACES, Kind, draw_motion
from bench.fourth_stranger.scene import Scene, Wish, draw_scene, find_g
from bench.second_stranger.motions import follow_motion
from bench.second_stranger.signals import STEP_S, derive


@pytest.mark.parametrize("machine", MACHINES, ids=lambda machine: machine.name)
@pytest.mark.parametrize("kind", list(PACES))
def test_a_motion_is_smooth_and_within_the_joints_limits(machine: Machine, kind: Kind) -> None:
    down = np.array(machine.downs[0], float)
    stretches = draw_motion(np.random.default_rng(7), machine, -down, kind, 30)
    assert all(a.end_s == b.begin_s for a, b in pairwise(stretches))
    q = follow_motion(stretches, np.arange(0, stretches[-1].end_s, STEP_S))
    speed = derive(q)
    assert np.all(np.abs(q) < machine.angle_limits)
    np.testing.assert_allclose(machine.link(q), q, atol=1e-12)
    assert np.max(np.abs(speed)) < 6
    assert np.max(np.abs(derive(speed))) < 60
    for stretch in stretches:
        if stretch.label.startswith("hold"):
            assert np.ptp(stretch.follow(np.linspace(stretch.begin_s, stretch.end_s, 5)), axis=0).max() == 0


def test_one_excitation_is_all_that_a_short_log_has() -> None:
    stretches = draw_motion(np.random.default_rng(8), DESK, np.array([0, 0, 1.0]), "once", 9)
    assert [each.label.split(":")[0] for each in stretches] == ["hold", "transfer", "hold"]
    assert 8 < stretches[-1].end_s < 10


@pytest.mark.parametrize("form", [Form(rate=100), Form(rate=100, uneven=0.3), Form(rate=100, is_halved=True)], ids=lambda form: form.name)
def test_stamps_rise_and_are_as_uneven_as_the_form_has_it(form: Form) -> None:
    steps = np.diff(draw(LARGE, form).rig.times)
    assert np.all(steps > 0.002)
    assert np.std(steps) / np.mean(steps) == pytest.approx({True: 0.34, False: 0.225 if form.uneven else 0.0}[form.is_halved], abs=0.03)


def test_gravity_stays_along_one_axis_of_a_tool_that_is_kept_upright() -> None:
    rig = draw(UPRIGHT, Form()).rig
    k = rig.move(rig.q, rig.spread_gravity(len(rig.t)))
    tool = np.array(k.turn_into_sensor(rig.spread_gravity(len(rig.t))))
    axis = tool.mean(0) / np.linalg.norm(tool.mean(0))
    assert np.std(tool @ np.linalg.svd(np.eye(3) - np.outer(axis, axis))[2][0]) < 2.5
    np.testing.assert_allclose(np.linalg.norm(tool, axis=1), np.linalg.norm(rig.gravity), rtol=1e-9)


def test_gravity_is_that_of_the_place() -> None:
    assert find_g(45.0, 0.0) == pytest.approx(9.80619, abs=1e-4)
    assert find_g(90.0, 0.0) == pytest.approx(9.83218, abs=1e-4)
    assert find_g(45.0, 1000.0) == pytest.approx(9.80619 - 0.003086, abs=1e-4)


def draw(machine: Machine, form: Form) -> Scene:
    return draw_scene(np.random.default_rng(5), Wish(machine, form, "stairs", 25, False, False))
