"""Leaving motions out, against fits that never saw them."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.optimize import minimize

from core.effects.base_tilt import BaseTilt
from core.effects.channels import full_scale
from core.effects.hysteresis_that_snaps import HysteresisThatSnaps
from core.effects.payload_shift import PayloadShift
from core.effects.sensor_translation import SensorTranslation
from core.gap.basis import basis_of
from core.gap.effect_fit import count_following, descend, fit_effects, fit_nominal, go_rest_of_way, predict_held_out
from core.gap.problem import SMALL, Problem, parameters_of
from core.gap.windows import Windows
from tests.foreign_recordings import make_long
from tests.synthetic import Imperfections, payload, record, run_of


@pytest.mark.parametrize("precision_of_the_last", [1.0, 1e-14])
def test_what_a_motion_adds_is_what_a_fit_of_the_others_says_of_it(precision_of_the_last: float) -> None:
    """Also where one motion alone shows the last parameter and nothing else tells anything about it."""
    rng = np.random.default_rng(4)
    group = np.repeat([0, 1, 2], 5)
    columns = rng.normal(size=(6 * len(group), 4))
    columns[np.tile(group, 6) != 1, 3] = 0.0
    precision = np.array([0.5, 2.0, 0.1, precision_of_the_last])
    y = columns @ [1.0, -2.0, 0.5, 3.0] + rng.normal(size=len(columns))
    fitted = np.linalg.solve(columns.T @ columns + np.diag(precision), columns.T @ y)
    windows = SimpleNamespace(group=group, target=np.zeros((6, len(group))))
    found = predict_held_out(windows, columns, y - columns @ fitted, precision)  # type: ignore[arg-type]  # all that is read of it

    def least_cost(rows: np.ndarray) -> float:
        x = np.linalg.lstsq(np.vstack((columns[rows], np.diag(np.sqrt(precision)))), np.append(y[rows], np.zeros(4)), rcond=None)[0]
        return float(np.sum((y[rows] - columns[rows] @ x) ** 2) + precision @ x**2)

    everything = np.ones(len(y), dtype=bool)
    for g in range(3):
        out = np.tile(group, 6) == g
        assert found[:, group == g].sum() == pytest.approx(least_cost(everything) - least_cost(~out), rel=1e-6)


@pytest.mark.parametrize("kept", [1.0, 0.7, 0.2, -0.5])
def test_what_a_linearised_problem_promises_counts_only_where_it_comes_true(kept: float) -> None:
    rng = np.random.default_rng(5)
    columns, precision, absent = rng.normal(size=(60, 5)), np.array([0.5, 2.0, 0.1, 1.0, 3.0]), np.array([0.3, -0.2])
    target, here = rng.normal(size=60), rng.normal(size=5)

    def full_cost(x: np.ndarray) -> float:
        away = x - np.append(np.zeros(3), absent)
        return float(np.sum((target - columns @ x) ** 2) + precision @ away**2)

    def cost(beta: np.ndarray, theta: np.ndarray) -> float:
        return full_cost(here) + kept * (full_cost(np.append(beta, theta)) - full_cost(here))

    problem = SimpleNamespace(X=columns[:, :3], precision=precision, absent=absent, bounds=np.array([[-9.0] * 5, [9.0] * 5]), cost=cost)
    r = target - columns @ here
    rest, owed = go_rest_of_way(problem, here, np.ones(5, dtype=bool), columns, r, full_cost(here))  # type: ignore[arg-type]  # all it reads
    best = minimize(full_cost, here, tol=1e-14)
    np.testing.assert_allclose(rest, target - columns @ best.x, atol=1e-5)
    promised = full_cost(here) - best.fun
    assert owed == pytest.approx(0.0 if kept >= 0.5 else promised * (1.0 - max(kept, 0.0)))


@pytest.mark.parametrize("late", [-20, 25])
def test_an_imperfection_at_its_bound_is_exactly_there_and_stays_there_while_motions_are_left_out(late: int) -> None:
    """A rounding inside of it would count as free: of a delay that no effect names, nothing might then seem to be left."""
    pieces = list(make_long(12.0, 500.0, 0).pieces)
    t, wrench, q = (np.concatenate([np.asarray(getattr(piece, name)) for piece in pieces]) for name in ("t", "wrench", "q"))
    windows = Windows(basis_of(replace(pieces[0], t=t[40:-40], wrench=wrench[40 - late : len(t) - 40 - late], q=q[40:-40])))
    fits = [nominal := fit_nominal(windows)]
    for effect in (BaseTilt(), PayloadShift(), SensorTranslation()):
        theta = np.array([p.absent + 0.5 * p.scale for p in effect.parameters(windows.basis.scene)])
        fits.append(fit_effects(windows, (effect,), nominal, [theta]))
    bounds = SMALL * windows.prior_std[windows.background]
    for fit in fits:
        small = np.abs(fit.beta[windows.background])
        held = np.isclose(small, bounds, rtol=1e-9, atol=0.0)
        assert held.any() and (small[held] == bounds[held]).all()
        assert fit.held_out.mean() > np.square(fit.residual).mean() > 2.0


def test_what_a_parameter_may_be_is_asked_of_the_run_with_its_payload() -> None:
    windows = Windows(basis_of(record(run_of(repetitions=1, period=0.008), payload("steel_block"), np.random.default_rng(1))))
    nominal = windows.basis.scene.with_phi(windows.phi).nominal
    most = max(np.exp(p.upper) for p in parameters_of(windows, HysteresisThatSnaps())[6:9])
    assert most == pytest.approx(0.5 * (np.ptp(nominal, axis=0) / full_scale(windows.basis.scene, nominal))[:3].max())


def test_a_fit_stays_within_what_is_small_from_whatever_estimate_it_starts() -> None:
    """An estimate that nobody bounds may take a delay for an imperfection, and an effect that does nothing would explain it."""
    late = Imperfections(delay_s=0.02)
    windows = Windows(basis_of(record(run_of(repetitions=1, period=0.008), payload("steel_block"), np.random.default_rng(1), late)))
    nominal = fit_nominal(windows)
    least, most = Problem(windows, (PayloadShift(),)).bounds[:, : len(nominal.beta)]
    beta = np.linalg.solve(windows.normal + np.diag(windows.prior_std**-2.0), windows.flat.T @ windows.target.ravel())
    assert not np.all((beta >= least) & (beta <= most))
    nothing = np.array([p.absent for p in parameters_of(windows, PayloadShift())])
    fit = fit_effects(windows, (PayloadShift(),), replace(nominal, beta=beta), [nothing])
    assert np.all((fit.beta >= least) & (fit.beta <= most))


def test_a_step_that_overflows_is_not_taken() -> None:
    """Derivatives of an absurd load do; what is known by then stays."""
    box = np.array([[-1.0] * 3, [1.0] * 3])
    problem = SimpleNamespace(
        bounds=box, target=np.zeros(6), cost=lambda beta, _: float(beta @ beta), step=lambda *_: (np.full(2, np.nan), np.zeros(1))
    )
    cost, beta, theta = descend(problem, np.full(2, 0.5), np.zeros(1), iterations=5)  # type: ignore[arg-type]  # all that is read
    assert cost == 0.5
    assert np.isfinite([*beta, *theta]).all()


def test_parameters_that_follow_a_run_count_as_far_as_it_says_what_they_are_and_its_model_is_exact() -> None:
    """Told four times as well as by their priors they are worth four fifths each; with an error that is worth 6000, next to nothing."""
    precision, variance = np.full(10, 4.0), np.full(10, 1.0 / (4.0 + 16.0))
    assert count_following(precision, variance, np.ones((6, 1000))) == pytest.approx(8.0)
    assert count_following(precision, variance, np.full((6, 1000), 2.0)) < 0.01
    assert count_following(precision, 1.0 / precision, np.ones((6, 1000))) == 0.0
