import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.plant.imperfections import ExponentialOffsetDrift, LinearOffsetDrift
from core.plant.sensor import Encoders, WhiteNoise, WristSensor, quantize
from tests.core.plant.plant_oracle import CELLS

MINI45 = CELLS["lwr4_bench"].sensor
FINE = MINI45.model_copy(update={"resolution": (1e-12,) * 6, "range": (1e6,) * 6})
PERIOD = 0.001


def readings(sensor, wrenches, rng=None):
    noise = np.zeros((len(wrenches), 6)) if rng is None else rng.standard_normal((len(wrenches), 6))
    return np.array([sensor.read(k * PERIOD, w, n) for k, (w, n) in enumerate(zip(wrenches, noise, strict=True))])


@pytest.mark.parametrize("name", CELLS)
def test_noise_has_the_cells_standard_deviation_and_no_colour(name):
    cell = CELLS[name]
    N = 20_000
    rng = np.random.default_rng(11)
    sensor = WristSensor(cell.sensor, rng, period=PERIOD)
    noise = WhiteNoise(rng, 6)
    wrench = np.array([1.0, -2.0, -20.0, 0.1, 0.2, -0.3])
    W = np.array([sensor.read(k * PERIOD, wrench, noise.row()) for k in range(N)])
    std, step = np.array(cell.sensor.noise_std), np.array(cell.sensor.resolution)
    expected = np.sqrt(std**2 + step**2 / 12)
    assert np.abs(W.mean(0) - wrench - sensor.offset).max() < 5 * expected.max() / np.sqrt(N)
    np.testing.assert_allclose(W.std(0), expected, rtol=0.03)
    centred = (W - W.mean(0)) / W.std(0)
    assert np.abs((centred[1:] * centred[:-1]).mean(0)).max() < 5 / np.sqrt(N)
    assert np.abs(np.corrcoef(W.T) - np.eye(6)).max() < 5 / np.sqrt(N)


def test_readings_are_multiples_of_the_resolution():
    rng = np.random.default_rng(1)
    W = readings(WristSensor(MINI45, rng, period=PERIOD), rng.uniform(-4, 4, (200, 6)), rng)
    counts = W / np.array(MINI45.resolution)
    np.testing.assert_allclose(counts, np.rint(counts), atol=1e-9)


@given(value=st.floats(-1e3, 1e3), step=st.floats(1e-3, 1.0))
def test_quantizing_moves_by_half_a_step_at_most_and_only_once(value, step):
    once = quantize(np.array([value]), step)
    assert abs(once[0] - value) <= step / 2 * (1 + 1e-9)
    np.testing.assert_allclose(quantize(once, step), once, atol=1e-9)


@pytest.mark.parametrize("sign", [-1, 1])
def test_readings_end_at_the_range(sign):
    sensor = WristSensor(MINI45, np.random.default_rng(2), period=PERIOD)
    W = readings(sensor, np.full((3, 6), sign * 1e4))
    np.testing.assert_allclose(W, sign * np.tile(MINI45.range, (3, 1)), atol=max(MINI45.resolution))


def test_offsets_are_as_large_as_real_ones_and_differ_by_seed():
    offsets = np.array([WristSensor(MINI45, np.random.default_rng(k), period=PERIOD).offset for k in range(400)])
    np.testing.assert_allclose(offsets.std(0), [3, 3, 3, 0.2, 0.2, 0.2], rtol=0.2)
    assert len(np.unique(offsets[:, 0])) == 400


@settings(deadline=None)
@given(delay=st.floats(0, 0.05))
def test_a_delay_shifts_a_ramp_by_exactly_that_time(delay):
    t = PERIOD * np.arange(80)
    ramp = np.outer(t, np.arange(1.0, 7.0))
    sensor = WristSensor(FINE, np.random.default_rng(0), period=PERIOD, delay=delay)
    W = readings(sensor, ramp) - sensor.offset
    expected = np.outer(np.maximum(t - delay, 0.0), np.arange(1.0, 7.0))
    settled = (t >= delay) | (t == 0)
    np.testing.assert_allclose(W[settled], expected[settled], atol=1e-9)


@pytest.mark.parametrize("delay", [-0.001, float("nan"), float("inf")])
def test_a_delay_that_is_none_is_refused(delay):
    with pytest.raises(ValueError, match="delay"):
        WristSensor(MINI45, np.random.default_rng(0), period=PERIOD, delay=delay)


def test_drifts_add_up_and_start_at_zero():
    size = (0.3, -0.2, 0.1, 0.01, 0.02, -0.03)
    drift = (LinearOffsetDrift(size, duration_s=100.0), ExponentialOffsetDrift(size, time_constant_s=20.0))
    sensor = WristSensor(FINE, np.random.default_rng(0), period=PERIOD, drift=drift)
    zero = np.zeros(6)
    for t in (0.0, 20.0, 100.0):
        expected = np.array(size) * (t / 100 + 1 - np.exp(-t / 20))
        np.testing.assert_allclose(sensor.read(t, zero, zero) - sensor.offset, expected, atol=1e-9)


def test_encoders_are_noisy_by_microradians_and_their_velocity_follows_with_a_short_lag():
    N, speed = 8000, 0.7
    rng = np.random.default_rng(4)
    q = np.outer(PERIOD * np.arange(N), [speed, 0.0])
    encoders = Encoders(q[0], period=PERIOD, noise_std=2e-6)
    read = [encoders.read(row, rng.standard_normal(2)) for row in q]
    error = np.array([r.q for r in read]) - q
    dq = np.array([r.dq for r in read])
    step = 2 * np.pi / 2**22
    np.testing.assert_allclose(error.std(0), np.sqrt(4e-12 + step**2 / 12), rtol=0.05)
    assert abs(dq[1000:, 0].mean() - speed) < 1e-5
    assert 1e-4 < dq[1000:].std(0).max() < 2e-3
    # first-order low-pass at 50 Hz: 95 % after three time constants of 3.2 ms
    assert dq[1, 0] < 0.35 * speed
    assert abs(dq[10, 0] - speed) < 0.06 * speed


def test_white_noise_repeats_by_seed_and_runs_over_its_blocks():
    a, b = (WhiteNoise(np.random.default_rng(9), 3, block=4) for _ in range(2))
    rows = np.array([a.row().copy() for _ in range(11)])
    np.testing.assert_array_equal(rows, [b.row() for _ in range(11)])
    assert len(np.unique(rows)) == rows.size
