"""Faults of the sensor and of timing, fed with signals whose answer is known in closed form."""

import numpy as np
import pytest
from fault_oracle import PERIOD, SETTING, SIGNAL, clean, run
from hypothesis import given, settings
from hypothesis import strategies as st

from core.plant.faults.sensor_noise import (
    CoarseSteps,
    ColouredNoise,
    Hum,
    LoudNoise,
    MissingCodes,
    SendOnDelta,
    Spikes,
    WanderingHum,
)
from core.plant.faults.sensor_offset import (
    ExponentialDrift,
    LinearDrift,
    OffsetKnock,
    OffsetRamp,
    OffsetStep,
    RandomWalk,
    TwoTimeConstantDrift,
)
from core.plant.faults.sensor_response import (
    BoucWen,
    Clipping,
    Compression,
    Creep,
    Crosstalk,
    Gain,
    Knee,
    LogarithmicCreep,
    PlayHysteresis,
    Quadratic,
    RectifiedCrosstalk,
    TwoSidedGain,
)
from core.plant.faults.timing import (
    LONGEST_BURST_S,
    Butterworth,
    Delay,
    FirstOrderFilter,
    HeldWrench,
    JitteryDelay,
    LostBursts,
    MotionLag,
    MotionLagThirdOrder,
    MovingAverage,
    SlowSensor,
)
from core.plant.faults.unknown import DriftingClock, RubbingSeal, Telegraph, WarmingGain

SIX = np.array([10.0, -5.0, 20.0, 0.5, -0.3, 0.2])
ALL = (1.0,) * 6


def through(hook, signal, start=0.0):
    """What a hook makes of a signal (N, 6)."""
    return np.array([hook(start + PERIOD * k, row) for k, row in enumerate(np.asarray(signal))])


def constant(seconds):
    return np.tile(SIX, (round(seconds / PERIOD), 1))


def sine(hz, seconds):
    return np.outer(np.sin(2 * np.pi * hz * PERIOD * np.arange(round(seconds / PERIOD))), SIX)


def triangle(height, quarter_s, quarters):
    turning = height * np.array([(0, 1, 0, -1)[k % 4] for k in range(quarters + 1)])
    return np.interp(np.arange(0, quarters * quarter_s, PERIOD), quarter_s * np.arange(quarters + 1), turning)


# offsets


@pytest.mark.parametrize(
    ("fault", "expected"),
    [
        (ExponentialDrift(tuple(SIX), 2.0), lambda t: 1 - np.exp(-t / 2)),
        (LinearDrift(tuple(SIX), 8.0), lambda t: t / 8),
        (TwoTimeConstantDrift(tuple(SIX), 0.5, tuple(-0.5 * SIX), 4.0), lambda t: 1 - np.exp(-t / 0.5) - 0.5 * (1 - np.exp(-t / 4))),
        (OffsetStep(tuple(SIX), 1.0), lambda t: np.where(t >= 1.0 - 1e-9, 1.0, 0.0)),
        (OffsetRamp(tuple(SIX), 1.0, 0.4), lambda t: np.interp(t, [1.0, 1.4], [0, 1])),
        (OffsetKnock(tuple(SIX), 1.0, 0.6, 0.3), lambda t: np.where(t < 1.0 - 1e-9, 0, 0.6 + 0.4 * np.exp((1.0 - t) / 0.3))),
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


# response


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


# noise and steps


def test_loud_noise_has_its_factor_and_no_colour_and_coloured_noise_has_its_memory():
    N = 20_000
    std = SETTING.noise_std
    white = through(LoudNoise(3.0, 1).sense(SIGNAL), np.zeros((N, 6))) / std
    np.testing.assert_allclose(white.std(0), np.sqrt(8), rtol=0.03)
    assert np.abs((white[1:] * white[:-1]).mean(0)).max() < 0.5
    coloured = through(ColouredNoise(3.0, 0.02, 1).sense(SIGNAL), np.zeros((N, 6))) / std
    np.testing.assert_allclose(coloured.std(0), np.sqrt(8), rtol=0.15)
    lag = (coloured[20:] * coloured[:-20]).mean(0) / coloured.var(0)
    np.testing.assert_allclose(lag, np.exp(-1), atol=0.12)


def test_spikes_are_rare_and_high():
    felt = through(Spikes(0.05, 12.0, 1).sense(SIGNAL), np.zeros((20_000, 6))) / SETTING.noise_std
    struck = np.abs(felt) > 0
    assert struck.sum(1).max() == 1
    assert abs(struck.any(1).mean() - 0.05) < 0.006
    assert abs(np.abs(felt[struck]).mean() / 12.0 - 1) < 0.12


@pytest.mark.parametrize("hz", [50.0, 60.0, 100.0])
def test_hum_is_a_line_of_its_amplitude(hz):
    A = np.linspace(0.1, 0.6, 6)
    felt = through(Hum(tuple(A), hz, 0.3).sense(SIGNAL), np.zeros((2000, 6)))
    t = PERIOD * np.arange(2000)
    np.testing.assert_allclose(2 * np.abs(np.exp(-2j * np.pi * hz * t) @ felt) / 2000, A, rtol=1e-6)
    np.testing.assert_allclose(felt.std(0), A / np.sqrt(2), rtol=1e-6)


def test_wandering_hum_keeps_its_power_near_the_line_but_not_its_phase():
    felt = through(WanderingHum(ALL, 50.0, 0.3, 1.0, 2).sense(SIGNAL), np.zeros((16_000, 6)))[:, 0]
    power = np.abs(np.fft.rfft(felt)) ** 2
    f = np.fft.rfftfreq(len(felt), PERIOD)
    shares = [power[np.abs(f - line) < 3].sum() / power.sum() for line in (50.0, 150.0)]
    np.testing.assert_allclose(shares, np.array([1.0, 0.09]) / 1.09, atol=0.06)
    assert power.max() / power.sum() < 0.5


def test_coarse_readings():
    ramp = np.outer(np.linspace(-3, 3, 4001), np.ones(6))
    step = (0.5,) * 6
    rounded = through(CoarseSteps(step).digitize(SIGNAL), ramp)
    np.testing.assert_allclose(rounded * 2, np.rint(rounded * 2), atol=1e-12)
    assert np.abs(rounded - ramp).max() <= 0.25 + 1e-12
    sent = through(SendOnDelta(step).digitize(SIGNAL), ramp)
    assert np.abs(sent - ramp).max() <= 0.5
    assert (np.diff(sent[:, 0]) != 0).sum() < 60
    jumpy = through(MissingCodes(step).digitize(SIGNAL), ramp)
    missing = np.floor(ramp[:, 0] / 0.5) % 2 == 1
    np.testing.assert_allclose(jumpy[~missing], ramp[~missing])
    assert np.abs(jumpy - ramp).max() <= 0.25 + 1e-12
    assert len(np.unique(jumpy[missing, 0])) < 14


# timing


@settings(deadline=None)
@given(delay=st.floats(0.0, 0.05))
def test_a_delay_shifts_a_ramp(delay):
    t = PERIOD * np.arange(120)
    late = through(Delay(delay).sense(SIGNAL), np.outer(t, SIX))
    np.testing.assert_allclose(late[60:], np.outer(t - delay, SIX)[60:], atol=1e-9)
    np.testing.assert_allclose(late[0], 0.0, atol=1e-12)


def test_a_jittery_delay_has_its_mean_and_spread():
    t = PERIOD * np.arange(20_000)
    late = t - through(JitteryDelay(0.02, 0.2, 0.02, 3).sense(SIGNAL), np.outer(t, np.ones(6)))[:, 0]
    assert abs(late[100:].mean() - 0.02) < 5e-4
    assert abs(late[100:].std() - 0.004) < 6e-4
    assert late[100:].min() > 0.007


def test_a_drifting_clock_is_later_and_later():
    t = PERIOD * np.arange(5000)
    late = t - through(DriftingClock(0.01, 0.1).sense(SIGNAL), np.outer(t, np.ones(6)))[:, 0]
    np.testing.assert_allclose(late[100:], 0.01 * t[100:], atol=1e-9)


@pytest.mark.parametrize(
    ("hook", "hz"),
    [
        (FirstOrderFilter(8.0).sense, 8.0),
        (Butterworth(8.0).sense, 8.0),
        (MovingAverage(0.443 / 8.0).amplify, 8.0),
    ],
    ids=["first order", "Butterworth", "mean"],
)
def test_filters_halve_the_power_at_their_cut_off_and_leave_a_constant(hook, hz):
    answer = through(hook(SIGNAL), sine(hz, 4.0))[1000:3000]
    np.testing.assert_allclose(np.abs(answer).max(0) / np.abs(SIX), np.sqrt(0.5), atol=0.015)
    np.testing.assert_allclose(through(hook(SIGNAL), constant(0.3)), constant(0.3), atol=1e-9)


def test_a_second_order_filter_falls_by_40_decibels_a_decade():
    gain = [np.abs(through(Butterworth(2.0).sense(SIGNAL), sine(f, 4.0))[3000:, 0]).max() / SIX[0] for f in (10.0, 40.0)]
    np.testing.assert_allclose(gain, [1 / 25, 1 / 400], rtol=0.1)


@pytest.mark.parametrize("lag", [MotionLag, MotionLagThirdOrder])
def test_a_lagging_motion_is_late_by_the_lag(lag):
    t = PERIOD * np.arange(600)
    encode = lag(0.02).encode(SIGNAL)
    rows = [encode(s, np.full(7, 0.5 * s), np.full(7, 0.5)) for s in t]
    late = t - np.array([q[0] for q, _ in rows]) / 0.5
    np.testing.assert_allclose(late[400:], 0.02, atol=2e-3)
    np.testing.assert_allclose(np.array([dq[0] for _, dq in rows]), 0.5, atol=1e-9)


def test_held_readings_are_as_many_as_wanted():
    signal = np.outer(np.arange(20_000.0), np.ones(6))
    held = through(HeldWrench(0.3, 1).digitize(SIGNAL), signal)
    assert abs((np.diff(held[:, 0]) == 0).mean() - 0.3) < 0.015
    every = through(SlowSensor(8).digitize(SIGNAL), signal)
    np.testing.assert_array_equal(every[:, 0], np.floor(signal[:, 0] / 8) * 8)


def test_bursts_take_joints_and_wrench_together():
    fault = LostBursts(0.3, 0.006, 5)
    encode, digitize = fault.encode(SIGNAL), fault.digitize(SIGNAL)
    q = np.array([encode(0.0, np.full(7, float(k)), np.full(7, float(k)))[0][0] for k in range(20_000)])
    W = through(digitize, np.outer(np.arange(20_000.0), np.ones(6)))[:, 0]
    np.testing.assert_array_equal(q, W)
    lost = np.diff(q) == 0
    assert abs(lost.mean() - 0.3) < 0.04
    runs = np.diff(np.flatnonzero(np.diff(np.concatenate(([0], lost, [0])))))[::2]
    assert 4.5 < runs.mean() < 7.0
    assert runs.max() <= LONGEST_BURST_S / PERIOD + 1


# unknown


def test_a_seal_rubs_against_the_last_change_of_the_axial_force_in_proportion_to_the_side_load():
    load = triangle(10.0, 0.5, 8)
    W = np.column_stack([np.full(len(load), 3.0), np.full(len(load), 4.0), load, *np.zeros((3, len(load)))])
    torque = through(RubbingSeal(0.01, 1, 0.5).sense(SIGNAL), W)[:, 4]
    np.testing.assert_allclose(torque[[400, 1400, 2400]], [0.05, -0.05, 0.05], rtol=1e-3)


def test_a_telegraph_has_two_levels_and_its_times():
    felt = through(Telegraph((0.0, 0.7, 0, 0, 0, 0), 0.05, 0.1, 2).sense(SIGNAL), np.zeros((60_000, 6)))[:, 1]
    assert set(np.unique(felt)) == {0.0, 0.7}
    assert abs((felt > 0).mean() - 1 / 3) < 0.06
    assert abs(np.count_nonzero(np.diff(felt) > 0) / 60 - 1 / 0.15) < 1.0


def test_a_warming_supply_takes_its_share_of_all_channels():
    found = WarmingGain(0.04, 2.0).amplify(SIGNAL)(2.0, SIX)
    np.testing.assert_allclose(found / SIX, 1 - 0.04 * (1 - np.exp(-1)))


# in the robot: the stages of the sensor


def test_a_saturated_sensor_reads_no_more_than_its_level_whatever_its_offset():
    level = (145.0, 145.0, 20.0, 5.0, 5.0, 5.0)
    found = run(Clipping(level))
    assert np.abs(found.wrench[:, 2]).max() <= 20.0 + 0.0625
    assert np.abs(clean().wrench[:, 2]).max() > 22.0
    np.testing.assert_array_equal(found.wrench[:, [0, 1, 3, 4, 5]], clean().wrench[:, [0, 1, 3, 4, 5]])


def test_a_moving_average_quietens_the_sensor_and_an_analogue_filter_does_not():
    noise = [np.diff(run(f).wrench[100:190, 0]).std() for f in (MovingAverage(0.02), FirstOrderFilter(10.0))]
    loud = np.diff(clean().wrench[100:190, 0]).std()
    assert noise[0] < 0.5 * loud
    assert noise[1] > 0.7 * loud


def test_a_late_wrench_leaves_the_joints_alone():
    found = run(Delay(0.02))
    np.testing.assert_array_equal(found.q, clean().q)
    step = np.array(SETTING.cell.sensor.resolution)
    shift = clean().true_wrench[:-20] - clean().true_wrench[20:]
    assert (np.abs((found.wrench - clean().wrench)[20:] - shift) <= 1.001 * step).all()
