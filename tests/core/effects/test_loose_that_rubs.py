"""A part that rubs on its slide and knocks against its stops, against Newton's law that is written down here and stepped as finely."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.optimize import OptimizeResult, least_squares

from core.array import Array
from core.effects.effect import Effect
from core.effects.loose_between_stops import LooseBetweenStops
from core.effects.loose_that_rubs import LooseThatRubs
from tests.core.effects.synthetic_scene import NOISE, scene

RUN = scene()
FINE = 200
FILM_M_PER_S = 1e-4
"""Speed below which dry friction gives way."""
AXIS, MASS, STOP, PLACE = np.array([0.8, -0.6, 0.0]), 0.4, 0.01, np.array([0.02, -0.03, 0.01])


def knock(drag: float, spring: float, dry: float = 0.0) -> Array:
    """(N, 6), what a part adds on a slide against one that stays in its middle: forces and torques on the mass where it is, its
    acceleration as the change of its speed over a row. Dry friction is that of a very thick film."""
    m, r = RUN.motion, RUN.phi[1:4] / RUN.phi[0] + PLACE
    field = m.a - m.g + np.cross(m.alpha, r) + np.cross(m.omega, np.cross(m.omega, r))
    h, pull = RUN.period / FINE, CubicSpline(RUN.t, field @ AXIS)
    u, v = -STOP * float(np.sign(pull(RUN.t[0]))) if spring == 0.0 else float(-pull(RUN.t[0]) / spring), 0.0
    ways, rates = [], []
    for t in RUN.t:
        ways.append(u)
        rates.append(v)
        for b in pull(t + h * np.arange(FINE)):
            film = dry / max(abs(v - h * (b + spring * u)), FILM_M_PER_S)
            v = (v - h * (b + spring * u)) / (1.0 + h * (drag + film))
            u += h * v
            if abs(u) >= STOP:
                u, v = STOP if u > 0.0 else -STOP, 0.0
    u_e, v_e, a_e = (np.outer(x, AXIS) for x in (ways, rates, np.gradient(rates, RUN.period)))
    at = r + u_e
    there = m.a - m.g + np.cross(m.alpha, at) + np.cross(m.omega, np.cross(m.omega, at)) + 2.0 * np.cross(m.omega, v_e) + a_e
    return MASS * np.hstack((there - field, np.cross(at, there) - np.cross(r, field)))


def average(w: Array) -> Array:
    """(N, 6), over five rows, as windows do, in standard deviations of the noise."""
    return np.asarray(np.apply_along_axis(np.convolve, 0, w / NOISE, np.full(5, 0.2), mode="same"))


@pytest.mark.parametrize(("drag", "spring", "dry"), [(8.0, 0.0, 0.0), (1.5, 250.0, 0.0), (1.0, 0.0, 2.5)])
def test_a_part_on_a_slide_adds_what_newton_says_until_and_after_it_knocks(drag: float, spring: float, dry: float) -> None:
    planted = knock(drag, spring, dry)
    theta = np.array([*(MASS * STOP * AXIS), STOP, drag, spring * STOP, dry, *PLACE])
    added = LooseThatRubs().wrench(RUN, RUN.nominal, theta) - RUN.nominal
    assert np.abs(planted[:, :3]).max() > 1.0
    assert np.square(average(added - planted)).sum() < 0.03 * np.square(average(planted)).sum()


def test_it_is_sought_along_a_slide_on_which_a_part_goes_without_knocks() -> None:
    planted, slide, effect = knock(1.0, 0.0, 2.5), LooseBetweenStops(), LooseThatRubs()

    def left(shape: Effect, x: Array) -> Array:
        return np.asarray(average(shape.wrench(RUN, RUN.nominal, x) - RUN.nominal - planted).ravel())

    def fit(shape: Effect, starts: list[Array]) -> OptimizeResult:
        scale, lower, upper = (np.array([getattr(p, name) for p in shape.parameters(RUN)]) for name in ("scale", "lower", "upper"))
        begun = sorted(starts, key=lambda x: float(left(shape, x) @ left(shape, x)))[: shape.followed]
        bounds = (lower - 1e-9, upper + 1e-9)
        fits = [least_squares(lambda x: left(shape, x), x, bounds=bounds, x_scale=scale) for x in begun]
        return min(fits, key=lambda fit: fit.cost)

    smooth = fit(slide, slide.starts(RUN, planted / NOISE))
    found = fit(effect, effect.starts_beside(RUN, planted / NOISE, smooth.x))
    assert isinstance(slide, effect.beside)
    assert found.cost < 0.2 * smooth.cost
    assert found.x[6] == pytest.approx(2.5, rel=0.1)


def test_what_moves_nothing_adds_nothing() -> None:
    effect = LooseThatRubs()
    absent = np.array([p.absent for p in effect.parameters(RUN)])
    np.testing.assert_array_equal(effect.wrench(RUN, RUN.nominal, absent), RUN.nominal)
    assert effect.explain_tie_to_run(RUN) is not None
