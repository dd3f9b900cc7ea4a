"""`bench.fourth_stranger.causes`: what new pieces do, by what is known of them without their code."""

from __future__ import annotations

import numpy as np
import pytest

from bench.fourth_stranger.causes.characteristic import sat_recovery
from bench.fourth_stranger.causes.joints import joff_rod
from bench.fourth_stranger.causes.payload import loose_tray, mass_drain
from bench.fourth_stranger.causes.timing import kin_oneeuro, lp_chebyshev
from bench.fourth_stranger.causes.unlisted_tool import u_freewheel, u_turret
from bench.fourth_stranger.causes.zero import step_connector
from bench.fourth_stranger.forms import Form
from bench.fourth_stranger.machines import DESK, HUNG, UPRIGHT
from bench.fourth_stranger.scene import Wish, draw_scene
from bench.second_stranger.fault import Planted
from bench.second_stranger.rig import Rig
from bench.second_stranger.rigid_body import find_body_wrench
from bench.second_stranger.sensing import sense


@pytest.fixture(scope="module")
def rig() -> Rig:
    return draw_scene(np.random.default_rng(3), Wish(HUNG, Form(), "sines", 24, False, False)).rig


def test_a_drained_tank_weighs_less_by_what_it_lost(rig: Rig) -> None:
    fault = mass_drain(np.random.default_rng(0), rig)
    gone_kg = -fault.size(2.0).value / 1e3
    missing = (rig.load - sense(rig, [Planted(fault, 2.0)])) / (1 + rig.background.gain)
    np.testing.assert_allclose(missing[: int(0.29 * rig.seconds * 1000)], 0, atol=1e-9)
    at_rest = missing[-500:, :3]
    np.testing.assert_allclose(np.linalg.norm(at_rest, axis=1), gone_kg * float(np.linalg.norm(rig.gravity)), rtol=1e-4)


def test_a_part_on_a_tray_moves_within_its_rim_and_a_turret_comes_round(rig: Rig) -> None:
    for make in (loose_tray, u_turret):
        fault = make(np.random.default_rng(0), rig)
        weigh = fault.change_payload
        assert weigh is not None
        changed = weigh(np.zeros((len(rig.t), 6)), rig.nominal, 1.0)[-200:]
        lever = np.linalg.norm(changed[:, 3:], axis=1) / (fault.size(1.0).value * np.linalg.norm(rig.gravity))
        assert np.abs(changed[:, :3]).max() < 1e-3
        assert np.all(lever < 2.1 * np.linalg.norm(rig.body.com))


def test_a_roller_that_slips_gives_its_torque_back_about_its_own_axis_and_no_force(rig: Rig) -> None:
    fault = u_freewheel(np.random.default_rng(0), rig)
    spare = fault.change_payload
    assert spare is not None
    changed = spare(find_body_wrench(rig.nominal, rig.body), rig.nominal, 1.0) - find_body_wrench(rig.nominal, rig.body)
    np.testing.assert_array_equal(changed[:, :3], 0)
    np.testing.assert_allclose(changed[:1000], 0, atol=1e-12)
    assert np.abs(changed[:, 3:]).max() > 0


def test_filters_keep_what_is_constant_and_come_late(rig: Rig) -> None:
    distort = lp_chebyshev(np.random.default_rng(0), rig).distort
    report = kin_oneeuro(np.random.default_rng(0), rig).report_joints
    assert distort is not None
    assert report is not None
    ramp = np.clip(rig.t[:, None] - 2, 0, 3) * np.ones(6)
    for filtered in (distort(ramp, 1.0), report(ramp, 1.0)):
        np.testing.assert_allclose(filtered[-1], 3, atol=1e-3)
        np.testing.assert_allclose(filtered[:1900], 0, atol=1e-12)
        late_s = 2.5 - filtered[4500, 0]
        assert 0.005 < late_s < 0.2


def test_a_channel_at_its_rail_stays_there_and_a_step_does_not_go_back() -> None:
    rig = draw_scene(np.random.default_rng(3), Wish(DESK, Form(), "stairs", 24, False, False)).rig
    clip = sat_recovery(np.random.default_rng(0), rig).distort
    assert clip is not None
    off = np.ptp(clip(rig.load, 1.0) - rig.load, axis=0)
    assert np.sum(off > 0) == 1
    jump = step_connector(np.random.default_rng(0), rig).distort
    assert jump is not None
    by = jump(rig.load, 1.0) - rig.load
    np.testing.assert_allclose(np.linalg.norm(by[-1, :3]), 1)
    np.testing.assert_allclose(by[0], 0)


def test_a_rod_that_is_too_long_tips_the_tool() -> None:
    rig = draw_scene(np.random.default_rng(3), Wish(UPRIGHT, Form(), "pick", 20, False, False)).rig
    fault = joff_rod(np.random.default_rng(0), rig)
    turn = fault.turn_joints
    assert turn is not None
    by = np.degrees(turn(rig.links, 1.0) - rig.links)
    np.testing.assert_allclose(by[:, 3], fault.size(1.0).value, rtol=0.07)
    np.testing.assert_array_equal(by[:, [0, 1, 2, 4]], 0)
