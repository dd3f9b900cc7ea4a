"""`bench.fifth_stranger.causes`: what pieces do, by what is known of them without their code."""

from __future__ import annotations

import numpy as np
import pytest

from bench.fifth_stranger.causes import (
    characteristic,
    joints,
    memory,
    mounting,
    payload,
    surroundings,
    timing,
    unlisted,
    unlisted_tool,
    zero,
)
from bench.fifth_stranger.machines import WEDGE
from bench.fifth_stranger.plan import PAIRS, SINGLES, UNLISTED
from bench.fourth_stranger.forms import Form
from bench.fourth_stranger.scene import Wish, draw_scene
from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Maker, Planted
from bench.second_stranger.rig import Rig
from bench.second_stranger.sensing import sense

MAKERS = sorted(
    {cause.maker for causes, _ in (*SINGLES, *PAIRS) for cause in causes} | {each[0] for each in UNLISTED}, key=lambda maker: maker.__name__
)
"""All that is planted."""


@pytest.fixture(scope="module")
def rig() -> Rig:
    return draw_scene(np.random.default_rng(3), Wish(WEDGE, Form(), "stairs", 32, False, False)).rig


def draw(maker: Maker, rig: Rig) -> Fault:
    return maker(np.random.default_rng(0), rig)


def find_added(maker: Maker, rig: Rig, scale: float = 1.0) -> Array:
    """(N, 6), N and N m: what a cause adds to what is read without it."""
    return np.asarray(sense(rig, [Planted(draw(maker, rig), scale)]) - rig.load)


def distort(maker: Maker, rig: Rig, W: Array, scale: float = 1.0) -> Array:
    change = draw(maker, rig).distort
    assert change is not None
    return change(W, scale)


def turn(maker: Maker, rig: Rig) -> Array:
    change = draw(maker, rig).turn_joints
    assert change is not None
    return np.degrees(change(rig.links, 1.0) - rig.links)


@pytest.mark.parametrize("maker", MAKERS, ids=lambda maker: maker.__name__)
def test_each_is_told_in_words_and_is_the_more_the_larger_it_is(maker: Maker, rig: Rig) -> None:
    fault = draw(maker, rig)
    assert fault.size(1.0).what
    assert fault.size(1.0).value != fault.size(2.0).value
    if fault.delay is not None or fault.report_joints is not None:
        return
    small, large = (float(np.linalg.norm(find_added(maker, rig, scale))) for scale in (0.5, 1.0))
    assert 0 < small < large


def test_a_zero_that_jumps_was_none_before_and_stays(rig: Rig) -> None:
    for maker in (zero.step_bond, zero.step_knock):
        by = find_added(maker, rig)[:, :3]
        np.testing.assert_allclose(by[:5000], 0, atol=1e-9)
        np.testing.assert_allclose(np.linalg.norm(by[-1]), draw(maker, rig).size(1.0).value, rtol=0.11)  # which creeps on by a tenth


def test_a_drift_begins_at_nothing_and_has_no_steps(rig: Rig) -> None:
    for maker in (zero.drift_sun, zero.drift_morning):
        by = find_added(maker, rig)
        np.testing.assert_allclose(by[0], 0, atol=1e-9)
        assert np.abs(np.diff(by, axis=0)).max() < 0.01 * np.ptp(by)


def test_gains_scale_their_own_channel_and_crosstalk_others(rig: Rig) -> None:
    one = np.eye(6) * 10
    for maker in (characteristic.gain_bridge, characteristic.gain_aged):
        by = distort(maker, rig, np.tile(10.0, (len(rig.t), 6)) * 1.0) - 10
        np.testing.assert_allclose(by, by[0] * np.ones_like(by), atol=0.05 * np.abs(by).max() + 1e-9, rtol=0.2)
    for maker in (characteristic.cross_leak, characteristic.cross_bolts):
        by = distort(maker, rig, one) - one
        np.testing.assert_allclose(np.diag(by), 0, atol=1e-12)
        assert np.count_nonzero(by) in (4, 5)


def test_a_stop_carries_nothing_of_small_loads_and_a_weak_supply_ends(rig: Rig) -> None:
    most = np.abs(rig.load).max(0)
    by = distort(characteristic.nonlin_stop, rig, np.array([0.1, -0.1, 1.0])[:, None] * most) / most
    assert np.abs(by - [[0.1], [-0.1], [1.0]])[:2].max() < 1e-5
    assert np.all(by[2] < 0.995)
    read = distort(characteristic.sat_supply, rig, rig.load)
    clipped = np.flatnonzero(np.ptp(rig.load - read, axis=0) > 1e-9)
    assert len(clipped) == 2
    assert np.all(np.ptp(read[:, clipped], axis=0) < np.ptp(rig.load[:, clipped], axis=0))


def test_a_memory_forgets_nothing_at_rest_but_what_flows(rig: Rig) -> None:
    n = len(rig.t)
    up = np.minimum(np.arange(n) / 4000, 1)[:, None] * np.ptp(rig.load, axis=0)
    rubbed = distort(memory.hyst_clamp, rig, up) - up
    np.testing.assert_allclose(rubbed[8000:], np.broadcast_to(rubbed[8000], rubbed[8000:].shape), atol=1e-9)
    flowed = np.abs(distort(memory.creep_glue, rig, up) - up)[:, 0]
    assert flowed[4000] > 1.5 * flowed[12000]


def test_averages_come_late_by_half_of_their_windows(rig: Rig) -> None:
    ramp = np.clip(rig.t - 3, 0, 6)[:, None] * np.ones(6)
    read = distort(timing.lp_average, rig, ramp)
    np.testing.assert_allclose(ramp[6000, 0] - read[6000, 0], (0.06 + 0.03) / 2, atol=0.002)
    np.testing.assert_allclose(read[:2900], 0, atol=1e-12)


def test_tilts_and_turns_keep_lengths(rig: Rig) -> None:
    for maker in (mounting.tilt_shims, mounting.tilt_sinking):
        tilt = draw(maker, rig).turn_gravity
        assert tilt is not None
        g = rig.spread_gravity(len(rig.t))
        tilted = tilt(g, 1.0)
        np.testing.assert_allclose(np.linalg.norm(tilted, axis=1), np.linalg.norm(g, axis=1), rtol=1e-9)
        assert np.degrees(np.abs(tilted - g).max() / 9.81) <= draw(maker, rig).size(1.0).value * 1.01


def test_joints_are_off_by_what_is_told(rig: Rig) -> None:
    np.testing.assert_allclose(np.abs(turn(joints.joff_belt, rig)).max(), 0.5, rtol=0.09)
    np.testing.assert_allclose(np.abs(turn(joints.joff_swap, rig)[:, [1, 3]]), [[0.4, 0.6]] * len(rig.t), rtol=1e-6)
    assert np.all(turn(joints.elast_reducer, rig)[:, 1] * rig.torques[:, 1] <= 0)
    assert np.all(turn(joints.backlash_worm, rig)[:, 3] * rig.torques[:, 3] <= 0)
    np.testing.assert_allclose(np.abs(turn(joints.ripple_cyclo, rig)).max(), 1.3 * 0.5 / 60, rtol=0.1)


def test_masses_weigh_what_they_are_told_to(rig: Rig) -> None:
    g = float(np.linalg.norm(rig.gravity))
    for maker in (payload.mass_sprue, payload.mass_bucket):
        by = find_added(maker, rig)[:, :3]
        np.testing.assert_allclose(np.linalg.norm(by[-500:], axis=1), abs(draw(maker, rig).size(1.0).value) / 1e3 * g, rtol=5e-3)
        np.testing.assert_allclose(by[:4000], 0, atol=1e-9)
    by = find_added(unlisted_tool.u_cycle, rig)[:, :3]
    held = np.linalg.norm(by, axis=1) > 0.5 * draw(unlisted_tool.u_cycle, rig).size(1.0).value / 1e3 * g
    assert np.sum(np.diff(held.astype(int)) == 1) >= 3


def test_what_moves_in_the_payload_weighs_the_same_at_rest(rig: Rig) -> None:
    for maker in (payload.shift_slide, payload.shift_snap, payload.loose_bag, payload.loose_flap):
        by = find_added(maker, rig)[-200:]
        assert np.abs(by[:, :3]).max() < 0.02 * rig.body.mass
        assert np.abs(by[:, 3:]).max() > 1e-4


def test_hands_touch_three_times_and_a_rail_twice(rig: Rig) -> None:
    for maker, times in ((surroundings.contact_hands, 3), (surroundings.contact_rail, 2)):
        touched = np.linalg.norm(find_added(maker, rig)[:, :3], axis=1) > 1e-6
        assert np.sum(np.diff(touched.astype(int)) == 1) == times


def test_a_hose_pulls_the_more_the_farther_it_is(rig: Rig) -> None:
    by = -find_added(surroundings.cable_hose, rig)[:, :3]
    pull = np.einsum("nij,nj->ni", rig.nominal.R, by / (1 + rig.background.gain[:3]))
    way = rig.nominal.p - rig.nominal.p.mean(0)
    slope = -np.sum((pull - pull.mean(0)) * way) / np.sum(way**2)
    stiffness = draw(surroundings.cable_hose, rig).size(1.0).value
    assert 0.6 * stiffness < slope < 1.1 * stiffness


def test_what_is_unlisted_is_what_it_says(rig: Rig) -> None:
    read = distort(unlisted.u_stuck_bit, rig, rig.load) - rig.load
    assert len(np.unique(np.round(read, 9))) == 2
    slow = distort(unlisted.u_slew, rig, rig.load)
    assert np.abs(np.diff(slow[:, 0])).max() <= draw(unlisted.u_slew, rig).size(1.0).value * 1e-3 * (1 + 1e-9)
    level = draw(unlisted.u_deadband, rig).size(1.0).value
    small = np.zeros((2, 6))
    small[:, 3] = [0.5 * level, 3 * level]
    np.testing.assert_allclose(distort(unlisted.u_deadband, rig, small)[:, 3], [0, 3 * level], atol=0.01 * level)
    held = np.tile(rig.load[0] + 1, (len(rig.t), 1))
    held[0] = rig.load[0]
    left = distort(unlisted.u_charge, rig, held)[25_000, 0] - rig.load[0, 0]
    np.testing.assert_allclose(left, np.exp(-1), rtol=0.02)


def test_a_rotor_gives_no_force_and_a_bath_only_bears(rig: Rig) -> None:
    by = find_added(unlisted_tool.u_runup, rig) / (1 + rig.background.gain)
    np.testing.assert_allclose(by[:, :3], 0, atol=1e-9)
    still = np.linalg.norm(rig.nominal.v, axis=1) < 1e-9
    up = -np.asarray(rig.gravity) / np.linalg.norm(rig.gravity)
    borne = -np.einsum("nij,nj->ni", rig.nominal.R, find_added(unlisted_tool.u_bath, rig)[:, :3])[still] @ up
    assert borne.min() > -0.01 * borne.max()
    np.testing.assert_allclose(borne.max(), draw(unlisted_tool.u_bath, rig).size(1.0).value, rtol=0.05)
