"""Noise, lines, steps and disturbances of the sensor's signal that no effect describes."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.plant.faults.sensor_noise import ColouredNoise, GatedHum, Hum, LoudNoise, Spikes, WanderingHum
from core.plant.faults.sensor_steps import CoarseSteps, MissingCodes, SendOnDelta, ShortFloat
from core.plant.faults.unknown_signal import RubbingSeal, Telegraph
from tests.core.plant.fault_oracle import PERIOD, SETTING, SIGNAL, through, triangle

ALL = (1.0,) * 6


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


def test_a_gated_line_is_a_line_while_it_is_on():
    felt = through(GatedHum((0.5,) * 6, 50.0, 0.4, 0.2, 3).sense(SIGNAL), np.zeros((60_000, 6)))[:, 0]
    line = 0.5 * np.sin(2 * np.pi * 50.0 * PERIOD * np.arange(60_000))
    on = np.abs(felt - line) < 1e-9
    assert (felt[~on] == 0).all()
    assert abs(on[np.abs(line) > 0.1].mean() - 2 / 3) < 0.06


@given(st.floats(-200, 200).filter(lambda x: abs(x) > 1e-3))
def test_a_short_float_of_ten_digits_is_half_precision(load):
    found = ShortFloat(2.0**-10).digitize(SIGNAL)(0.0, np.full(6, load))
    np.testing.assert_array_equal(found, float(np.float16(load)))


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
