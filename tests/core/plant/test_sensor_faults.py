"""Faults in what the sensor makes of a load, fed with signals whose answer is known in closed form."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.special import erfc

from core.plant.faults.sensor_memory import BoucWen, Creep, LogarithmicCreep, Microslip, PlayHysteresis, SlowRecovery, StickAndSnap
from core.plant.faults.sensor_offset import (
    Clicks,
    ExponentialDrift,
    HeatFront,
    LinearDrift,
    OffsetKnock,
    OffsetRamp,
    OffsetStep,
    RandomWalk,
    Thermostat,
    TwoTimeConstantDrift,
)
from core.plant.faults.sensor_response import (
    Bow,
    Crosstalk,
    FadingCrosstalk,
    Gain,
    Knee,
    LostGauge,
    ProductCrosstalk,
    Quadratic,
    RectifiedCrosstalk,
    Shunt,
    TwoSidedGain,
    WanderingSupply,
    WarmingSupply,
)
from core.plant.faults.sensor_saturation import Clipping, Compression, GaugeClipping
from tests.core.plant.fault_oracle import PERIOD, SETTING, SIGNAL, SIX, clean, constant, run, through, triangle

ALL = (1.0,) * 6


@pytest.mark.parametrize(
    ("fault", "expected"),
    [
        (ExponentialDrift(tuple(SIX), 2.0), lambda t: 1 - np.exp(-t / 2)),
        (LinearDrift(tuple(SIX), 8.0), lambda t: t / 8),
        (TwoTimeConstantDrift(tuple(SIX), 0.5, tuple(-0.5 * SIX), 4.0), lambda t: 1 - np.exp(-t / 0.5) - 0.5 * (1 - np.exp(-t / 4))),
        (OffsetStep(tuple(SIX), 1.0), lambda t: np.where(t >= 1.0 - 1e-9, 1.0, 0.0)),
        (OffsetRamp(tuple(SIX), 1.0, 0.4), lambda t: np.interp(t, [1.0, 1.4], [0, 1])),
        (OffsetKnock(tuple(SIX), 1.0, 0.6, 0.3), lambda t: np.where(t < 1.0 - 1e-9, 0, 0.6 + 0.4 * np.exp((1.0 - t) / 0.3))),
        (HeatFront(tuple(SIX), 1.5), lambda t: erfc(np.sqrt(1.5 / np.maximum(t, 1e-9)))),
        (
            Clicks(tuple(SIX), (0.4995, 1.0995, 2.4995), (0.5, 0.2, 0.3)),
            lambda t: 0.5 * (t > 0.4995) + 0.2 * (t > 1.0995) + 0.3 * (t > 2.4995),
        ),
    ],
    ids=lambda value: getattr(value, "variant", ""),
)
def test_offsets_move_as_their_formula_says(fault, expected):
    t = PERIOD * np.arange(3000)
    load = np.linspace(-5, 5, 3000)[:, None] * np.ones(6)
    np.testing.assert_allclose(through(fault.sense(SIGNAL), load) - load, np.outer(expected(t), SIX), atol=1e-9)


def test_a_random_walk_spreads_with_the_root_of_time():
    ends = []
    for seed in range(60):
        walk = through(RandomWalk(ALL, 4.0, seed).sense(SIGNAL), np.zeros((1000, 6)))
        ends.append(walk[[249, 999]])
    np.testing.assert_allclose(np.std(ends, axis=(0, 2)), [0.25, 0.5], rtol=0.15)


@given(st.lists(st.floats(-100, 100), min_size=6, max_size=6))
def test_static_errors_are_functions_of_the_load(load):
    W = np.array(load)
    e, f = np.linspace(-0.05, 0.05, 6), np.linspace(0.02, -0.02, 6)
    C = 0.01 * np.arange(36).reshape(6, 6)
    rows = tuple(map(tuple, C))
    full = np.array(SETTING.full_scale)
    knee = np.full(6, 20.0)
    beyond = np.sign(W) * np.maximum(np.abs(W) - 20.0, 0)
    for fault, expected in (
        (Gain(tuple(e)), W * (1 + e)),
        (TwoSidedGain(tuple(e), tuple(f)), W + np.where(W > 0, e, f) * W),
        (Crosstalk(rows), W + C @ W),
        (RectifiedCrosstalk(rows), W + C @ np.abs(W)),
        (Quadratic(tuple(e)), W + e * W * np.abs(W) / full),
        (Knee(tuple(knee), tuple(e)), W + e * beyond),
    ):
        np.testing.assert_allclose(fault.sense(SIGNAL)(0.0, W), expected, atol=1e-9)


def test_play_opens_a_loop_of_its_width():
    load = triangle(10.0, 0.5, 9)
    W = np.outer(load, np.ones(6))
    half = np.full(6, 0.3)
    error = through(PlayHysteresis(tuple(half)).sense(SIGNAL), W)[:, 0] - load
    assert np.abs(error).max() <= 0.3 + 1e-12
    rising, falling = error[2250], error[2750]  # at zero load, going up and down
    np.testing.assert_allclose([rising, falling], [-0.3, 0.3], atol=1e-9)


def test_bouc_wen_opens_a_smooth_loop_that_does_not_depend_on_speed():
    fault = BoucWen((0.4,) * 6, (2.0,) * 6, 0.7, 1.5)
    loops = []
    for quarter in (0.25, 1.0):
        load = triangle(10.0, quarter, 9)
        error = through(fault.sense(SIGNAL), np.outer(load, np.ones(6)))[:, 0] - load
        loops.append([error[round(k * quarter / PERIOD)] for k in (5, 5.5, 6, 7, 8)])
        assert np.abs(error).max() <= 0.4 + 1e-12
        assert np.abs(np.diff(error)).max() < 0.02
    np.testing.assert_allclose(loops[0], loops[1], atol=0.01)
    up_through_zero, down_through_zero = loops[0][4], loops[0][2]
    assert up_through_zero > 0.3
    assert down_through_zero < -0.3


@pytest.mark.parametrize("creep", [Creep(0.01, (0.5,)), LogarithmicCreep(0.01, (0.1, 1.0, 10.0))])
def test_creep_begins_loaded_and_follows_a_step(creep):
    W = np.vstack((constant(0.5), 2 * constant(2.0)))
    error = through(creep.sense(SIGNAL), W)[:, 0] / SIX[0]
    np.testing.assert_allclose(error[:500], 1.01, atol=1e-12)
    t = PERIOD * np.arange(1, 2001)
    expected = 2 + 0.01 * (1 + np.mean([1 - np.exp(-t / tau) for tau in creep.time_constant_s], axis=0))
    np.testing.assert_allclose(error[500:], expected, atol=2e-5)


@given(st.floats(-50, 50))
def test_a_saturated_channel_keeps_below_its_level_and_the_others_stay(load):
    W = np.full(6, load)
    level = (5.0, *[1e4] * 5)
    clipped, pressed = Clipping(level).amplify(SIGNAL)(0, W), Compression(level, 0.7).amplify(SIGNAL)(0, W)
    assert clipped[0] == min(max(load, -5.0), 5.0)
    assert abs(pressed[0]) <= min(5.0, abs(load)) + 1e-12
    if abs(load) < 3.5:
        assert pressed[0] == pytest.approx(load)
    np.testing.assert_allclose(clipped[1:], load)
    np.testing.assert_allclose(pressed[1:], load)


def test_a_wandering_supply_swings_about_its_gain_and_takes_part_of_the_offset():
    amplified = WanderingSupply((0.02,) * 6, 0.5, 8.0, 0.0).amplify(SIGNAL)
    for t, gain in ((0.0, 0.02), (2.0, 0.03), (4.0, 0.02), (6.0, 0.01)):
        np.testing.assert_allclose(amplified(t, SIX) / SIX, 1 + gain, atol=1e-12)


def test_a_warming_supply_takes_its_share_of_all_channels():
    found = WarmingSupply(0.04, 2.0).amplify(SIGNAL)(2.0, SIX)
    np.testing.assert_allclose(found / SIX, 1 - 0.04 * (1 - np.exp(-1)))


def test_products_of_two_channels_show_in_a_third():
    fault = ProductCrosstalk((3, 5), (0, 1), (2, 0), (0.001, -0.002))
    error = fault.sense(SIGNAL)(0.0, SIX) - SIX
    np.testing.assert_allclose(error, [0, 0, 0, 0.001 * 10 * 20, 0, -0.002 * -5 * 10], atol=1e-12)
    np.testing.assert_allclose(fault.sense(SIGNAL)(0.0, -SIX) + SIX, error, atol=1e-12)


def test_a_bow_is_right_without_load_and_at_its_weight_and_off_by_its_share_half_way():
    error = [Bow((0.01,) * 6, (30.0,) * 6).sense(SIGNAL)(0.0, np.full(6, x))[2] - x for x in (0.0, 15.0, 30.0, 45.0, -15.0)]
    np.testing.assert_allclose(error, [0.0, 0.3, 0.0, -0.3, -0.3], atol=1e-12)


def test_what_sticks_holds_back_to_its_width_and_snaps():
    load = np.linspace(0.0, 10.0, 5001)
    error = through(StickAndSnap((0.3,) * 6, 0.2).sense(SIGNAL), np.outer(load, np.ones(6)))[:, 0] - load
    assert -0.3 - 1e-9 <= error.min() < -0.298
    assert error.max() <= 0
    assert np.count_nonzero(np.diff(error) > 0.2) == 6  # every 0.3 / 0.2 of the way
    slopes = np.diff(error)
    np.testing.assert_allclose(slopes[slopes < 0], -0.2 * 0.002, atol=1e-9)
    back = through(StickAndSnap((0.3,) * 6, 0.2).sense(SIGNAL), np.outer(load[::-1], np.ones(6)))[:, 0] - load[::-1]
    assert back.max() > 0.298


def test_a_heat_front_comes_as_heat_goes_behind_a_thick_wall():
    """The heat equation by finite differences, one side hot from the start on, felt at depth 1."""
    dx, dt = 0.05, 0.001
    heat, felt = np.zeros(400), []
    heat[0] = 1.0
    for _ in range(4000):
        felt.append(heat[20])
        heat[1:-1] += dt / dx**2 * np.diff(heat, 2)
    found = through(HeatFront(ALL, 0.25).sense(SIGNAL), np.zeros((4000, 6)))[:, 0]
    np.testing.assert_allclose(found, felt, atol=2e-3)
    assert found[20] < 1e-4
    assert found[2000] > 0.5


def test_a_lost_gauge_is_a_gain_from_its_moment_on():
    found = through(LostGauge((-0.04, 0, 0, -0.02, 0, 0), 0.5).sense(SIGNAL), constant(1.0)) / SIX
    np.testing.assert_allclose(found[:500], 1.0, atol=1e-12)
    np.testing.assert_allclose(found[500:], np.tile([0.96, 1, 1, 0.98, 1, 1], (500, 1)), atol=1e-12)


def test_a_shunt_takes_a_share_of_small_loads_and_no_more_than_so_much_of_large_ones():
    fault = Shunt((0.2,) * 6, (2.0,) * 6)
    error = [fault.sense(SIGNAL)(0.0, np.full(6, x))[1] - x for x in (0.0, 0.01, -0.01, 20.0, -40.0)]
    np.testing.assert_allclose(error, [0.0, -0.001, 0.001, -0.2, 0.2], atol=1e-6)


def test_fading_crosstalk_shows_a_change_and_forgets_it():
    C = np.zeros((6, 6))
    C[3, 2] = 0.02
    fault = FadingCrosstalk(tuple(map(tuple, C)), 0.4)
    W = np.vstack((constant(0.2), 3 * constant(1.0)))
    error = through(fault.sense(SIGNAL), W) - W
    np.testing.assert_allclose(error[:200], 0.0, atol=1e-12)
    t = PERIOD * np.arange(1, 1001)
    np.testing.assert_allclose(error[200:, 3], 0.02 * 2 * SIX[2] * np.exp(-t / 0.4), atol=1e-9)
    np.testing.assert_allclose(np.delete(error, 3, axis=1), 0.0, atol=1e-12)


def test_microslip_opens_a_loop_that_grows_with_the_square_of_the_load():
    """Masing's rules on the first branch `h (2 x / w - (x / w)^2)`, which turns back as twice that of half the way."""
    h, w = 0.4, 10.0
    fault = Microslip((h,) * 6, (w,) * 6)
    widths = []
    for top in (3.0, 6.0):
        load = triangle(top, 0.5, 9)
        error = through(fault.sense(SIGNAL), np.outer(load, np.ones(6)))[:, 0] - load
        np.testing.assert_allclose(error[:500], -h * (2 * load[:500] / w - (load[:500] / w) ** 2), atol=0.004)
        rising, falling = error[2000], error[3000]  # at zero load, going up and down
        assert rising == pytest.approx(-falling, abs=1e-3)
        widths.append(falling - rising)
    np.testing.assert_allclose(widths, [h * (top / w) ** 2 for top in (3.0, 6.0)], rtol=0.05)


def test_a_slow_recovery_takes_longer_than_the_creep_before():
    W = np.vstack((np.zeros((10, 6)), constant(1.0), np.zeros((1000, 6))))
    crept = (through(SlowRecovery(0.01, 0.3, 1.2).sense(SIGNAL), W) - W)[10:] / (0.01 * SIX)
    t = PERIOD * np.arange(1, 1001)
    np.testing.assert_allclose(crept[:1000], np.outer(1 - np.exp(-t / 0.3), np.ones(6)), atol=1e-9)
    np.testing.assert_allclose(crept[1000:], crept[999] * np.exp(-t / 1.2)[:, None], atol=1e-9)


def test_a_gauge_at_its_end_spoils_the_channels_in_which_its_beam_counts():
    fault = GaugeClipping((15.0, 1e4, 1e4, 1e4, 1e4, 20.0), 0.03)
    clip = fault.amplify(SIGNAL)
    within = np.array([5.0, -4.0, 30.0, 0.1, 0.05, 0.2])
    np.testing.assert_allclose(clip(0.0, within), within, atol=1e-12)
    # 60 N along the axis: 20 N on each beam, of which the first one, 3 cm along x, shows 15
    np.testing.assert_allclose(clip(0.0, np.array([0, 0, 60.0, 0, 0, 0])), [0, 0, 55.0, 0, 0.03 * 5.0, 0], atol=1e-9)
    # 2.7 N m about the axis: 30 N round it on each beam, of which the third one, at 240 degrees, shows 20
    s, c = np.sin(4 * np.pi / 3), np.cos(4 * np.pi / 3)
    np.testing.assert_allclose(clip(0.0, np.array([0, 0, 0, 0, 0, 2.7])), [10 * s, -10 * c, 0, 0, 0, 2.4], atol=1e-9)


def test_a_thermostat_warms_and_cools_in_turn():
    drift = through(Thermostat(tuple(SIX), 2.0, 1.5, 0.5).sense(SIGNAL), np.zeros((4000, 6))) / SIX
    warm = 1 - np.exp(-1.5 / 2.0)
    cool = warm * np.exp(-1.5 / 2.0)
    expected = [0.0, 1 - np.exp(-0.25), warm, cool, 1 - (1 - cool) * np.exp(-0.2)]
    np.testing.assert_allclose(drift[[499, 999, 1999, 3499, 3899]], np.outer(expected, np.ones(6)), atol=1e-3)


def test_a_saturated_sensor_reads_no_more_than_its_level_whatever_its_offset():
    level = (145.0, 145.0, 20.0, 5.0, 5.0, 5.0)
    found = run(Clipping(level))
    assert np.abs(found.wrench[:, 2]).max() <= 20.0 + 0.0625
    assert np.abs(clean().wrench[:, 2]).max() > 22.0
    np.testing.assert_array_equal(found.wrench[:, [0, 1, 3, 4, 5]], clean().wrench[:, [0, 1, 3, 4, 5]])
