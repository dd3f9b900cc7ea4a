"""Averages over cubic B-splines, and what they leave of a sine whose phase is a joint's angle."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import BSpline

from core.effects.angle_wave import angle_wave
from core.effects.splines import smooth_by_splines
from tests.core.effects.synthetic_scene import scene

T = np.arange(4000) * 0.001
INNER = slice(200, -200)


@pytest.mark.parametrize("hz", [1.0, 10.0, 25.0])
def test_a_sine_is_faded_by_the_fourth_power_of_its_sinc(hz):
    x = np.sin(2 * np.pi * hz * T)[:, None]
    np.testing.assert_allclose(smooth_by_splines(x, 0.001, 0.02)[INNER], np.sinc(hz * 0.02) ** 4 * x[INNER], atol=1e-4)


def test_rows_that_are_samples_stay_as_they_are():
    x = np.random.default_rng(0).normal(size=(50, 3))
    assert smooth_by_splines(x, 0.005, 0.0) is x


def test_a_wave_and_its_acceleration_are_what_the_splines_leave_of_the_error_along_the_angle():
    rate = np.array([1.5, -0.4])
    q = np.outer(T, rate)
    c, s, order = np.array([2e-4, 1e-4]), np.array([-1e-4, 3e-4]), np.array([40.0, 100.0])
    run = replace(scene(), t=T, q=q, dq=np.tile(rate, (len(T), 1)), window=0.02)
    spline = BSpline.basis_element(np.arange(-2.0, 3.0) * 0.02)(np.arange(-40, 41) * 0.001)
    bare = c * np.cos(order * q) + s * np.sin(order * q)
    seen = np.column_stack([np.convolve(x, spline / spline.sum(), mode="same") for x in bare.T])
    short = replace(run, phase=np.full(len(T), "transfer"))
    error, acceleration = angle_wave(short, order, c, s)
    np.testing.assert_allclose(error[INNER], seen[INNER], atol=1e-7)
    np.testing.assert_allclose(acceleration[INNER], np.gradient(np.gradient(seen, T, axis=0), T, axis=0)[INNER], atol=2e-3)
