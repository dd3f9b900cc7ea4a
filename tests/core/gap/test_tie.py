"""Two explanations of one recording: how far apart they are, against recordings that are drawn anew."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from core.effects.library import library
from core.gap.basis import basis_of
from core.gap.effect_fit import EffectFit, fit_effects, fit_nominal
from core.gap.tie import INSEPARABLE_SIGMA, distance_sigma, find_ties
from core.gap.windows import Windows
from tests.core.gap.recorded_run import recorded

NAMES = ("sensor_gain", "sensor_nonlinearity", "time_delay", "sensor_lowpass")
BY_ID = {effect.id: effect for effect in library()}


@cache
def fitted(seed: int, gain: float) -> tuple[Windows, dict[str, EffectFit]]:
    """A run with the cylinder, its force along z multiplied by a factor, and what explains it."""
    recording = recorded(seed=seed)
    shown = np.array([1.0, 1.0, gain, 1.0, 1.0, 1.0])
    windows = Windows(basis_of(replace(recording, wrench=shown * recording.wrench)))
    return windows, fit_each(windows)


def fit_each(windows: Windows, names: tuple[str, ...] = NAMES) -> dict[str, EffectFit]:
    """Effects one by one."""
    nominal = fit_nominal(windows)
    scene = windows.basis.scene.with_phi(nominal.phi)
    still = np.zeros((len(scene), 6))
    return {name: fit_effects(windows, (BY_ID[name],), nominal, BY_ID[name].starts(scene, still)) for name in names}


def chi_square(fit: EffectFit) -> float:
    return float((fit.residual**2).sum())


@pytest.mark.parametrize("seed", [4, pytest.param(5, marks=pytest.mark.thorough)])
def test_a_channel_that_shows_one_percent_too_much_is_named_or_declared_with_what_bends_to_it(seed: int):
    windows, fits = fitted(seed, 1.01)
    ranked = sorted((fits["sensor_gain"], fits["sensor_nonlinearity"]), key=chi_square)  # the noise decides which bends better
    assert [tie.second.name for tie in find_ties(windows, ranked, 1.0)] == [ranked[1].name]


def test_the_distance_is_what_recordings_with_other_noise_tell_in_the_mean():
    windows, fits = fitted(4, 1.01)
    first, rival = fits["time_delay"], fits["sensor_lowpass"]
    expected = distance_sigma(windows, first, rival)
    rng = np.random.default_rng(7)
    worse = []
    for _ in range(6):
        drawn = Windows(windows.basis)
        drawn.target = windows.target - first.residual + rng.standard_normal(windows.target.shape)
        again = fit_each(drawn, (first.name, rival.name))
        worse.append(chi_square(again[rival.name]) - chi_square(again[first.name]))
    assert np.mean(worse) == pytest.approx(expected**2, abs=3.0 * (2.0 * expected + 2.0) / np.sqrt(len(worse)))


def test_an_explanation_follows_itself():
    windows, fits = fitted(4, 1.01)
    assert distance_sigma(windows, fits["sensor_gain"], fits["sensor_gain"]) < 0.2


@pytest.mark.thorough
def test_what_explains_far_less_is_no_rival():
    windows, fits = fitted(4, 1.05)
    assert distance_sigma(windows, fits["sensor_gain"], fits["time_delay"]) > 3.0 * INSEPARABLE_SIGMA
    assert find_ties(windows, [fits["sensor_gain"], fits["time_delay"]], 1.0) == ()
