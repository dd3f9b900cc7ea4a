"""The damped oscillator behind what swings."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

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


@pytest.mark.parametrize("damping", [0.02, 0.999999, 1.0, 1.4])
def test_an_oscillator_follows_its_differential_equation_whatever_its_damping(damping: float) -> None:
    t = np.arange(200) * 0.02
    u = np.column_stack([np.sin(3 * t), np.cos(5 * t) + t])
    w = 2 * np.pi * 4.0
    ramp = CubicSpline(t, u)  # close to straight between samples
    run = solve_ivp(
        lambda x, s: np.append(s[2:], w * w * (ramp(x) - s[:2]) - 2 * damping * w * s[2:]),
        (0, t[-1]),
        [*u[0], 0, 0],
        t_eval=t,
        rtol=1e-9,
        atol=1e-9,
    )
    y, rate, acceleration = oscillate(u, 0.02, 4.0, damping)
    np.testing.assert_allclose(y, run.y[:2].T, atol=5e-3)
    np.testing.assert_allclose(rate, run.y[2:].T, atol=0.05)
    np.testing.assert_allclose(acceleration, w * w * (u - y) - 2 * damping * w * rate, atol=1e-9)
