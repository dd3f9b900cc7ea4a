"""Faults of timing, filters and lost samples, fed with signals whose answer is known in closed form."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.plant.faults.dropout import LONGEST_BURST_S, HeldWrench, LostBursts, PreemptedBus, SlowSensor
from core.plant.faults.lowpass import AgedCapacitor, Butterworth, FirstOrderFilter, MovingAverage, WeighingFilter
from core.plant.faults.timing import (
    Delay,
    DriftingClock,
    JitteryDelay,
    MotionLag,
    MotionLagThirdOrder,
    PolledDrives,
    Reconnecting,
    SlippingBuffer,
)
from core.plant.faults.unknown_timing import SkewedChannels, StaleTransform
from tests.core.plant.fault_oracle import PERIOD, SETTING, SIGNAL, SIX, clean, constant, run, sensor_pose, sine, through


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


def test_a_slipping_buffer_fills_steadily_and_is_cleared():
    t = PERIOD * np.arange(5000)
    late = t - through(SlippingBuffer(0.02, 0.5, 2.0, 0.0).sense(SIGNAL), np.outer(t, np.ones(6)))[:, 0]
    np.testing.assert_allclose(late[100:], 0.02 * (0.5 + t[100:] / 2.0 % 1.0), atol=1e-9)
    assert abs(late[1000:].mean() - 0.02) < 2e-4


@pytest.mark.parametrize("from_base", [True, False])
def test_polled_drives_are_late_one_after_the_other(from_base):
    encode = PolledDrives(0.02, 0.6, from_base).encode(SIGNAL)
    for s in PERIOD * np.arange(200):
        q, dq = encode(s, np.full(7, 0.5 * s), np.full(7, 0.5))
    late = s - q / 0.5
    np.testing.assert_allclose(late, np.linspace(0.02, 0.008, 7)[:: 1 if from_base else -1], atol=1e-9)
    np.testing.assert_allclose(dq, 0.5, atol=1e-12)


def test_a_weighing_filter_is_slow_for_little_and_fast_for_much():
    fault = WeighingFilter(4.0, (1.0,) * 6)
    little = through(fault.amplify(SIGNAL), 1e-4 * sine(4.0, 4.0))[1000:3000]
    np.testing.assert_allclose(np.abs(little).max(0) / np.abs(1e-4 * SIX), np.sqrt(0.5), atol=0.015)
    reached = [np.argmax(through(fault.amplify(SIGNAL), [np.zeros(6)] + [np.full(6, x)] * 200)[:, 0] > 0.632 * x) for x in (1e-3, 20.0)]
    assert abs(reached[0] * PERIOD - 1 / (2 * np.pi * 4.0)) < 0.002
    # dy/dt = a (1 + y / w) y from 20 to 7.36 openings
    assert abs(reached[1] * PERIOD - np.log((20.0 / 21.0) / (7.36 / 8.36)) / (2 * np.pi * 4.0)) < 0.0021


def test_a_preempted_bus_stands_still_in_step_with_its_cycle():
    held = through(PreemptedBus(0.4, 0.0113).digitize(SIGNAL), np.outer(np.arange(4000.0), np.ones(6)))[:, 0]
    stale = np.diff(held) == 0
    assert abs(stale.mean() - 0.4) < 0.005
    begins = np.flatnonzero(np.diff(stale.astype(int)) == 1)
    assert set(np.diff(begins)) == {11, 12}
    assert abs(np.diff(begins).mean() - 11.3) < 0.01


def test_each_connection_has_its_delay_and_no_reading_is_older_than_the_one_before():
    t = PERIOD * np.arange(20_000)
    read = through(Reconnecting(0.02, 0.6, 2.0, 7).sense(SIGNAL), np.outer(t, np.ones(6)))[:, 0]
    late = (t - read)[100:]
    assert np.diff(read).min() >= -1e-12
    assert 0.008 - 1e-9 <= late.min() < late.max() <= 0.032 + 1e-9
    assert np.ptp(late) > 0.01
    changes = np.abs(np.diff(late)) > 1e-9
    assert changes.mean() < 0.02
    begins = np.flatnonzero(np.diff(changes.astype(int)) == 1)
    assert 4 <= len(begins) <= 20


def test_an_aged_capacitor_lets_its_share_pass_at_once():
    fault = AgedCapacitor(4.0, 0.3)
    step = through(fault.sense(SIGNAL), np.vstack((constant(0.1), 2 * constant(0.4))))[100:] / SIX
    t = PERIOD * np.arange(1, 401)
    expected = 1 + 0.3 + 0.7 * (1 - np.exp(-2 * np.pi * 4.0 * t))
    np.testing.assert_allclose(step, np.outer(expected, np.ones(6)), atol=1e-9)
    fast = through(fault.sense(SIGNAL), sine(200.0, 1.0))[500:, 0] / SIX[0]
    assert abs(np.abs(fast).max() - 0.3 * np.sin(0.4 * np.pi)) < 0.02


def test_a_stale_transform_turns_the_wrench_by_the_way_since_and_moves_its_lever():
    found, stale = run(StaleTransform(0.03)), 30
    step = np.array(SETTING.cell.sensor.resolution)
    changed = 0.0
    for k in (150, 350, 450, 550, 850, 1000, 1350):
        then, now = sensor_pose(found.true_q[k - stale]), sensor_pose(found.true_q[k])
        turn = now.rotation.T @ then.rotation
        force = turn @ found.true_wrench[k, :3]
        torque = turn @ found.true_wrench[k, 3:] + np.cross(now.rotation.T @ (then.position - now.position), force)
        change = np.concatenate((force, torque)) - found.true_wrench[k]
        assert (np.abs(found.wrench[k] - clean().wrench[k] - change) <= 1.01 * step + 1e-3).all()
        changed = max(changed, float(np.abs(change[3:]).max()))
    assert changed > 0.1
    np.testing.assert_allclose(found.wrench[150], clean().wrench[150], atol=1e-3)


def test_skewed_channels_are_late_each_by_its_own():
    t = PERIOD * np.arange(200)
    late = (0.0, 0.02, 0.0, 0.035, 0.0, 0.0)
    felt = through(SkewedChannels(late).sense(SIGNAL), np.outer(t, np.ones(6)))
    np.testing.assert_allclose(t[60:, None] - felt[60:], np.tile(late, (140, 1)), atol=1e-9)


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
