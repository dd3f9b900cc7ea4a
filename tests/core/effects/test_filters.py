"""Delays, low passes, derivatives and play of sampled signals."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.effects.filters import delay_each, delay_signal, derivative, low_pass, play
from tests.core.effects.naive_play import naive_play

Array = np.ndarray


@given(st.floats(0.0, 12.0))
def test_a_delayed_quintic_is_exact_and_the_beginning_holds_its_value(samples: float) -> None:
    k = np.arange(60.0)

    def quintic(x: Array) -> Array:
        return 1 + 0.3 * x - 0.02 * x**2 + 0.001 * x**3 - 1e-4 * x**4 + 1e-6 * x**5

    late = delay_signal(quintic(k)[:, None], samples)[:, 0]
    inside = k >= np.maximum(samples + 3, 5)  # six rows from the beginning on
    np.testing.assert_allclose(late[inside], quintic(k[inside] - samples), rtol=1e-9, atol=1e-9)
    assert np.isfinite(late).all()


def test_rows_that_are_each_late_by_their_own_delay_are_those_of_as_many_delays() -> None:
    rng = np.random.default_rng(0)
    w, samples = rng.normal(size=(80, 2)), rng.uniform(-1.0, 9.0, 80)
    late = delay_each(w, samples)
    for k, delay in enumerate(samples):
        np.testing.assert_allclose(late[k], delay_signal(w, max(float(delay), 0.0))[k], atol=1e-12)


@given(st.floats(1e-4, 10.0))
def test_a_low_pass_keeps_a_constant_and_lags_a_ramp_by_its_time_constant(time_constant: float) -> None:
    t = 0.01 * np.arange(int(40 * time_constant / 0.01) + 50)
    out = low_pass(np.column_stack([np.full_like(t, 2.0), t]), time_constant, 0.01)
    np.testing.assert_allclose(out[:, 0], 2.0)
    assert out[-1, 1] == pytest.approx(t[-1] - time_constant, abs=1e-6)


def test_the_derivative_of_a_cubic_is_exact() -> None:
    t = 0.02 * np.arange(50)
    np.testing.assert_allclose(derivative((t**3)[:, None], 0.02)[3:, 0], 3 * t[3:] ** 2, atol=1e-9)


@given(st.floats(0.0, 3.0), st.integers(0, 1000))
def test_play_is_never_further_behind_than_its_radius(radius: float, seed: int) -> None:
    x = np.cumsum(np.random.default_rng(seed).standard_normal((80, 2)), axis=0)
    y = play(x, np.array([radius, 0.0]))
    assert (np.abs(y - x)[:, 0] <= radius + 1e-12).all()
    np.testing.assert_array_equal(y[:, 1], x[:, 1])
    np.testing.assert_allclose(y[:, 0], naive_play(x[:, 0], radius), atol=1e-12)
