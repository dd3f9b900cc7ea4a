"""What hangs swings as a pendulum does."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from core.effects.hanging import hang
from core.effects.memory import Past

LENGTH = 0.08
HZ = np.sqrt(9.81 / LENGTH) / (2 * np.pi)
PERIOD = 0.005
T = np.arange(1200) * PERIOD
UP = np.tile([0.0, 0.0, 9.81], (len(T), 1))
AT_REST = np.zeros_like(UP)


def test_a_wide_swing_in_a_plane_solves_the_pendulums_equation_on_a_pivot_that_is_pushed():
    sideways = 2.0 * np.sin(3.0 * T)

    def rate(t, x):
        push = np.interp(t, T, sideways)
        return [x[1], -(9.81 * np.sin(x[0]) + push * np.cos(x[0])) / LENGTH - 2 * 0.05 * 2 * np.pi * HZ * x[1]]

    exact = solve_ivp(rate, (0, T[-1]), [1.2, 0.5], t_eval=T, rtol=1e-9, atol=1e-10, max_step=PERIOD)
    b = UP + np.outer(sideways, [1.0, 0.0, 0.0])
    start = np.array([[np.sin(1.2), 0.0, -np.cos(1.2)], [0.5 * np.cos(1.2), 0.0, 0.5 * np.sin(1.2)]])
    x, acceleration = hang(b, AT_REST, PERIOD, HZ, 0.05, start)
    np.testing.assert_allclose(x[:, 0], LENGTH * np.sin(exact.y[0]), atol=1e-5)
    np.testing.assert_allclose(x[:, 2], -LENGTH * np.cos(exact.y[0]), atol=1e-5)
    np.testing.assert_allclose(acceleration[2:-2], np.gradient(np.gradient(x, T, axis=0), T, axis=0)[2:-2], atol=0.1)


def test_a_swing_without_friction_keeps_its_energy_and_its_spin_about_the_vertical():
    start = np.array([[0.6, 0.0, -0.8], [1.0, 4.0, 0.75]])
    x, acceleration = hang(UP, AT_REST, PERIOD, HZ, 0.0, start)
    v = np.gradient(x, T, axis=0)[1:-1]
    energy, spin = 0.5 * np.sum(v**2, axis=1) + 9.81 * x[1:-1, 2], np.cross(x[1:-1], v)[:, 2]
    assert np.ptp(energy) < 5e-3 * np.ptp(9.81 * x[:, 2])
    assert np.ptp(spin) < 5e-3 * np.abs(spin).mean()
    np.testing.assert_allclose(np.linalg.norm(x, axis=1), LENGTH, rtol=1e-9)
    along = np.cross(x, acceleration + UP)  # a string pulls along itself
    assert np.abs(along).max() < 1e-9


def test_friction_takes_it_along_with_a_body_that_turns():
    turning = np.tile([0.0, 0.0, 2.0], (len(T), 1))
    x, _ = hang(UP, turning, PERIOD, HZ, 1.0, np.array([[0.3, 0.0, -1.0], [0.0, 0.0, 0.0]]))
    assert np.cross(x[:200], np.gradient(x, T, axis=0)[:200])[:, 2].min() >= 0.0
    np.testing.assert_allclose(x[-1], [0.0, 0.0, -LENGTH], atol=1e-3)


@pytest.mark.parametrize(("frequency_hz", "damping"), [(0.5, 0.003), (10.0, 1.5), (10.0, 0.003)])
def test_it_stays_finite_and_goes_on_in_blocks_for_all_parameters_of_a_fit(frequency_hz, damping):
    b = UP + np.random.default_rng(0).normal(size=UP.shape) * 5.0
    start = np.array([[1.0, 2.0, 0.0], [3.0, 0.0, -1.0]])
    whole = hang(b, b, 0.01, frequency_hz, damping, start)
    past = Past()
    parts = [hang(b[rows], b[rows], 0.01, frequency_hz, damping, start, past) for rows in (slice(0, 1), slice(1, 400), slice(400, None))]
    assert np.isfinite(whole).all()
    np.testing.assert_allclose(np.concatenate(parts, axis=1), whole, rtol=1e-9, atol=1e-9)
