"""The damped oscillator behind what swings."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from core.effects.oscillator import oscillate


@pytest.mark.parametrize("damping", [0.0, 0.05, 0.999999, 1.0, 1.5])
def test_a_free_swing_solves_its_equation_whatever_its_damping(damping):
    w = 2 * np.pi * 1.7
    t = np.linspace(0.0, 60.0, 601)
    start = np.array([[0.3, -1.0], [2.0, 0.5]])
    y, v, a = oscillate(np.zeros((601, 2)), 0.1, 1.7, damping, start=start)
    exact = solve_ivp(lambda _, x: [x[1], -2 * damping * w * x[1] - w * w * x[0]], (0, 60), [0.3, 2.0], t_eval=t, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(y[:, 0], exact.y[0], atol=1e-5)
    np.testing.assert_allclose(v[:, 0], exact.y[1], atol=1e-4)
    np.testing.assert_allclose(a, -2 * damping * w * v - w * w * y, atol=1e-9)


def test_what_is_driven_from_rest_and_what_swings_freely_add_up():
    u = np.sin(np.arange(400) * 0.03)[:, None]
    start = np.array([[0.2], [-1.0]])
    both = oscillate(u, 0.01, 2.0, 0.1, start=start)
    driven, free = oscillate(u, 0.01, 2.0, 0.1), oscillate(np.zeros((400, 1)), 0.01, 2.0, 0.1, start=start)
    for whole, forced, swung in zip(both, driven, free, strict=True):
        np.testing.assert_allclose(whole, forced + swung, atol=1e-9)
    assert free[0][0, 0] == 0.2
