"""`core.gap.problem`: what is kept from one step of a fit to the next is what a problem that was never elsewhere finds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.effects.composition import Composition, Term
from core.effects.delay_of_clocks import DelayOfClocks
from core.effects.gear_ripple import GearRipple
from core.effects.joint_elasticity import JointElasticity
from core.effects.payload_shift import PayloadShift
from core.effects.sensor_offset_step import SensorOffsetStep
from core.effects.time_delay import TimeDelay
from core.gap.basis import basis_of
from core.gap.contacts import keep_rows
from core.gap.effect_fit import fit_effects, fit_nominal
from core.gap.problem import Problem
from core.gap.windows import Windows
from tests.synthetic import payload, record, run_of


def test_derivatives_are_those_of_the_point_that_is_asked_for_wherever_the_last_one_was() -> None:
    recording = record(run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(0))
    windows = Windows(basis_of(recording))
    effects = (PayloadShift(), TimeDelay())
    problem = Problem(windows, effects)
    here, phi = problem.absent + 0.3 * problem.scale, windows.phi
    elsewhere, lighter = problem.absent - 0.2 * problem.scale, 0.9 * windows.phi
    asked = [(here, phi), (elsewhere, phi), (here, phi), (here, phi), (here, lighter), (here, phi)]
    for theta, body in asked:
        problem.cost(np.concatenate((lighter, np.zeros(len(windows.prior_std) - 10))), elsewhere)  # a step that was tried in vain
        rows, J = problem.linearise(theta, body)
        fresh_rows, fresh_J = Problem(windows, effects).linearise(theta, body)
        np.testing.assert_array_equal(rows, fresh_rows)
        np.testing.assert_array_equal(J, fresh_J)
    step = 1e-4 * problem.scale[-1]
    later = here + step * np.eye(len(here))[-1]
    slope = (problem.linearise(later, phi)[0] - problem.linearise(here, phi)[0]) / step
    np.testing.assert_allclose(slope, problem.linearise(here, phi)[1][:, -1], rtol=0.02, atol=0.02 * np.abs(slope).max())


def test_the_payloads_share_in_each_row_is_that_behind_an_effect_which_moves_it() -> None:
    recording = record(run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(0))
    windows = Windows(basis_of(recording))
    problem, late, phi = Problem(windows, (DelayOfClocks(),)), np.array([0.3]), windows.phi
    heavier = phi + 0.01 * phi[0] * np.eye(10)[0]
    grown = problem.linearise(late, heavier)[0] - problem.linearise(late, phi)[0] + problem.X[:, :10] @ (heavier - phi)
    np.testing.assert_allclose(problem.columns(late, phi)[:, :10] @ (heavier - phi), grown, atol=1e-6 * np.abs(grown).max())
    assert np.abs(problem.columns(late, phi)[:, 0] - problem.X[:, 0]).max() > 0.1 * np.abs(problem.X[:, 0]).max()
    assert Problem(windows, (TimeDelay(),)).columns(np.array([0.01]), phi) is problem.X


def test_a_jump_that_nobody_saw_is_fitted_where_it_may_have_been() -> None:
    recording = record(run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(0))
    jump = np.array([-2.0, 0.5, -1.0, -0.05, 0.02, -0.03])
    late = np.array(recording.wrench) + (recording.t > recording.t[0] + 10.0)[:, None] * jump
    whole = Windows(basis_of(replace(recording, wrench=late)))
    seen = keep_rows(whole, np.abs(whole.centres - recording.t[0] - 10.0) > 3.0)  # far from the middle of the run, where its prior is
    start = np.append(0.1 * jump, 9.0)
    fit = fit_effects(seen, (SensorOffsetStep(),), fit_nominal(seen), [start])
    assert 7.0 < fit.theta[-1] < 13.0
    np.testing.assert_allclose(fit.theta[:6], jump, atol=0.1)
    assert fit.chi_square < 1.1 * fit.rows


def test_springs_that_the_twin_holds_feel_the_gears_that_are_fitted() -> None:
    windows = Windows(basis_of(record(run_of("lwr4_bench", 0, repetitions=1), payload("steel_block"), np.random.default_rng(0))))
    scene = windows.basis.scene.with_phi(windows.phi)
    springs = Term(JointElasticity(), np.array([*[4e-5] * 7, 1.0, 0.05]))
    windows.held = (springs,)
    problem, known = Problem(windows, (GearRipple(),)), {}
    ripple = np.tile([80.0, 2e-4, 0.0], 7)
    changes = []
    for gears in (ripple, 1.5 * ripple, ripple):
        changes.append(problem.change(gears, scene, known))
        together = Composition([springs, Term(GearRipple(), gears)]).change(scene)
        np.testing.assert_allclose(changes[-1], together, atol=1e-9)
        apart = problem.change(0.0 * ripple, scene) + Composition([Term(GearRipple(), gears)]).change(scene)
        assert np.abs(together - apart).max() > 0.1 * np.abs(together).max()
