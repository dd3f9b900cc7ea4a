"""A ripple that varies over the turn, against the motion of a mechanism whose joints have it, differentiated numerically."""

from __future__ import annotations

import numpy as np

from bench.calibration.planting import plant_trial
from core.effects.gear_ripple import GearRipple
from core.effects.library import library
from core.effects.ripple_that_varies import RippleThatVaries
from core.gap.basis import basis_of
from core.gap.effect_fit import fit_effects, fit_nominal
from core.gap.evidence import gather
from core.gap.fit_all import one_by_one
from core.gap.windows import Windows
from tests.core.effects.mechanical_truth import Array, T, believed, change, rms, scene, truth

RATIO = 12.5
FIRST, SECOND, TURN = (4.0e-4, -3.0e-4), (1.0e-4, 1.5e-4), (0.6, -0.5)
THETA = np.concatenate((np.tile([RATIO, *FIRST], 7), np.tile([*SECOND, *TURN], 7)))
UNEVEN, WRONG_RATIO = 159, 350
"""Trials with a ripple that is stronger on one side of the turn, and with one whose wrist joints are searched in vain at first."""


def rippled(t: Array) -> Array:
    q = believed(t)
    first = FIRST[0] * np.cos(2 * RATIO * q) + FIRST[1] * np.sin(2 * RATIO * q)
    second = SECOND[0] * np.cos(4 * RATIO * q) + SECOND[1] * np.sin(4 * RATIO * q)
    return q + (1.0 + TURN[0] * np.cos(q) + TURN[1] * np.sin(q)) * (first + second)


def test_the_wrench_is_that_of_joints_which_have_it() -> None:
    inner = slice(5, len(T) - 5)
    exact = (truth(rippled, h=2e-4).wrench() - truth(h=2e-4).wrench())[inner]
    ours = change(RippleThatVaries(), THETA)[inner]
    assert rms(exact) > 5.0
    assert rms(ours - exact) < 0.15 * rms(exact)  # what the ripple adds to velocities is left out


def test_without_what_varies_it_is_the_plain_ripple() -> None:
    plain = np.tile([RATIO, *FIRST], 7)
    np.testing.assert_allclose(
        change(RippleThatVaries(), np.concatenate((plain, np.zeros(28)))), change(GearRipple(), plain), rtol=1e-12, atol=1e-12
    )


def test_beside_the_plain_ripple_the_first_start_is_that_and_the_second_takes_it_for_the_second_harmonic() -> None:
    plain, run = np.tile([80.0, *FIRST], 7), scene()
    assert RippleThatVaries().starts(run, np.zeros((len(T), 6))) == []
    first, second, _ = RippleThatVaries().starts_beside(run, np.zeros((len(T), 6)), plain)
    np.testing.assert_array_equal(change(RippleThatVaries(), first), change(GearRipple(), plain))
    np.testing.assert_allclose(change(RippleThatVaries(), second), change(GearRipple(), plain), atol=1e-12)
    assert not np.array_equal(first, second)


def test_a_gear_that_is_stronger_on_one_side_of_its_turn_is_named() -> None:
    few = [effect for effect in library() if effect.id in ("gear_ripple", "kinematic_lag", "time_delay", "tool_flexibility")]
    evidence = gather(Windows(basis_of(plant_trial(UNEVEN).recording)), few, one_by_one)
    assert (evidence.verdict, evidence.best.name) == ("explained", "gear_ripple")


def test_joints_whose_ratio_was_missed_are_found_in_what_the_others_leave() -> None:
    windows = Windows(basis_of(plant_trial(WRONG_RATIO).recording))
    nominal = fit_nominal(windows)
    scene_ = windows.basis.scene.with_phi(nominal.phi)
    plain = fit_effects(windows, (GearRipple(),), nominal, GearRipple().starts(scene_, windows.on_grid(nominal.residual)))
    starts = RippleThatVaries().starts_beside(windows.basis.scene.with_phi(plain.phi), windows.on_grid(plain.residual), plain.theta)
    changed = np.flatnonzero(starts[2][: len(plain.theta) : 3] != plain.theta[::3])
    assert changed.tolist() == [4, 5]
    np.testing.assert_allclose(starts[2][3 * changed], [100.0, 120.0], atol=0.5)
    again = fit_effects(windows, (GearRipple(),), plain, [starts[2][: len(plain.theta)]])
    assert again.chi_square < 0.5 * plain.chi_square
