"""The damped oscillator behind what swings."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from core.effects.oscillator import oscillate, ring


@pytest.mark.parametrize("damping", [0.0, 0.05, 0.999999, 1.0, 1.5])
def test_a_free_swing_solves_its_equation_whatever_its_damping(damping):
    w = 2 * np.pi * 1.7
    t = np.linspace(0.0, 60.0, 601)
    y, v, a = ring(t, 1.7, damping, np.array([0.3, -1.0]), np.array([2.0, 0.5]))
    exact = solve_ivp(lambda _, x: [x[1], -2 * damping * w * x[1] - w * w * x[0]], (0, 60), [0.3, 2.0], t_eval=t, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(y[:, 0], exact.y[0], atol=1e-5)
    np.testing.assert_allclose(v[:, 0], exact.y[1], atol=1e-4)
    np.testing.assert_allclose(a, -2 * damping * w * v - w * w * y, atol=1e-9)


def test_what_is_driven_from_rest_and_what_swings_freely_add_up():
    t = np.arange(0.0, 4.0, 0.01)
    held = oscillate(np.zeros((len(t), 1)), 0.01, 2.0, 0.1)
    assert all(np.abs(part).max() == 0.0 for part in held)
    y, _, _ = ring(t, 2.0, 0.1, np.ones(1), np.zeros(1))
    assert y[0, 0] == 1.0
    assert np.abs(y[-1, 0]) < 0.01
