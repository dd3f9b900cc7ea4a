"""`core.gap.spared_noise`: a filter that smooths the twin's own noise is not believed for that."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from core.effects.hysteresis_that_snaps import HysteresisThatSnaps
from core.effects.library import library
from core.effects.loose_on_hinge import LooseOnHinge
from core.gap.basis import basis_of
from core.gap.effect_fit import EffectFit, fit_effects, fit_nominal
from core.gap.problem import Problem
from core.gap.spared_noise import estimate_spared_noise, share_among_channels, take_off_noise
from core.gap.windows import Windows
from tests.synthetic import Imperfections, payload, record, run_of

DELAY, FILTER = (next(effect for effect in library() if effect.id == name) for name in ("time_delay", "sensor_lowpass"))


def fits(delay_s: float, seed: int, encoder_std: float = 4e-5) -> tuple[EffectFit, EffectFit]:
    """Delay and filter, fitted to a run with a pure delay in which noise of the joints is plain to see."""
    imperfections = Imperfections(delay_s=delay_s, encoder_std=encoder_std)
    recording = record(run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(seed), imperfections)
    windows = Windows(basis_of(recording))
    nominal = fit_nominal(windows)
    scene = windows.basis.scene.with_phi(nominal.phi)
    residual = windows.on_grid(nominal.residual)
    late, filtered = (fit_effects(windows, (effect,), nominal, effect.starts(scene, residual)) for effect in (DELAY, FILTER))
    return late, filtered


@pytest.mark.parametrize("seed", [0, 1])
def test_a_pure_delay_beats_the_filter_that_leaves_less_residual(seed: int) -> None:
    late, filtered = fits(0.012, seed)
    assert filtered.cost < late.cost - 50.0  # what it looks like
    assert late.held_out.sum() < filtered.held_out.sum() - 50.0  # what it is


def test_a_filter_gains_nothing_on_a_run_that_nothing_is_wrong_with() -> None:
    late, filtered = fits(0.0, 0)
    assert filtered.cost < late.cost - 10.0
    assert abs(filtered.held_out.sum() - late.held_out.sum()) < 20.0  # the mean over the draws is right to a few units


def test_an_effect_that_snaps_at_noise_pays_for_what_that_excuses() -> None:
    run = run_of("lwr4_bench", 0, repetitions=1)
    recording = record(run, payload("steel_block"), np.random.default_rng(0), Imperfections(encoder_std=2e-6))
    windows = Windows(basis_of(recording))
    nominal, snaps = fit_nominal(windows), HysteresisThatSnaps()
    problem = Problem(windows, (snaps,))
    holds_most_back = np.concatenate((np.full(6, 0.9), np.full(6, np.log(0.01)), [0.0]))
    for left in (1.0, 30.0):
        held_out = np.full(windows.target.shape, left)
        told = take_off_noise(held_out, problem, holds_most_back, nominal.beta)
        assert (told > 1.0 + np.log(left) - 1e-9).all()  # the least that the best variance for such a residual costs
        assert told.sum() < 0.9 * held_out.sum() or left == 1.0


def test_noise_does_not_excuse_what_is_far_beyond_it() -> None:
    run = run_of("lwr4_bench", 0, repetitions=1)
    recording = record(run, payload("steel_block"), np.random.default_rng(0), Imperfections(encoder_std=2e-6))
    windows = Windows(basis_of(recording))
    nominal, snaps = fit_nominal(windows), HysteresisThatSnaps()
    holds_most_back = np.concatenate((np.full(6, 0.9), np.full(6, np.log(0.01)), [0.0]))
    some, most = (
        take_off_noise(np.full(windows.target.shape, left), Problem(windows, (snaps,)), holds_most_back, nominal.beta)
        for left in (1e2, 1e8)
    )
    assert most.mean() > 0.99e8
    assert some.min() < 50.0  # of a hundred, where noise makes much
    assert (np.diff([some, most], axis=0) > 0.0).all()


def test_no_channel_of_a_motion_counts_less_than_nothing_and_its_sum_stays() -> None:
    rng = np.random.default_rng(3)
    group = np.repeat([0, 1, 2], [7, 4, 9])
    held_out = rng.normal(0.5, 2.0, size=(6, len(group)))
    held_out[2, group == 1] -= 2.0
    shared = share_among_channels(SimpleNamespace(group=group), held_out)  # type: ignore[arg-type]  # all that is read of it
    for g in range(3):
        before, after = held_out[:, group == g].sum(axis=1), shared[:, group == g].sum(axis=1)
        assert before.sum() > 0.0 > before.min()
        assert (after >= 0.0).all()
        assert after.sum() == pytest.approx(before.sum())


def test_a_part_that_swings_undamped_is_not_paid_for_the_noise_that_it_makes() -> None:
    run = run_of("lwr4_bench", 0, repetitions=1)
    recording = record(run, payload("steel_block"), np.random.default_rng(0), Imperfections(encoder_std=1e-4))
    windows = Windows(basis_of(recording))
    problem, beta = Problem(windows, (LooseOnHinge(),)), fit_nominal(windows).beta
    rings = np.array([0.0, 0.1, 0.1, 9.0, 0.003, 0.0, 0.4, 0.3, 0.0, 0.3, 2.0 * np.pi, 2.0 * np.pi])
    assert estimate_spared_noise(problem, rings, beta).min() < -1.0
    assert take_off_noise(np.ones(windows.target.shape), problem, rings, beta).min() > 0.0
