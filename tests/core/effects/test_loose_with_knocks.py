"""A part that knocks against its stops, against Newton's law that is written down here and stepped a hundred times as finely."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.optimize import least_squares

from core.array import Array
from core.effects.loose_with_knocks import LooseWithKnocks
from tests.core.effects.synthetic_scene import NOISE, scene

RUN = scene()
FINE = 200
AXIS, MASS, STOP, PLACE = np.array([0.8, -0.6, 0.0]), 0.4, 0.01, np.array([0.02, -0.03, 0.01])


def knock(drag: float, spring: float) -> Array:
    """(N, 6), what a part adds on a slide against one that stays in its middle: forces and torques on the mass where it is, its
    acceleration as the change of its speed over a row."""
    m, r = RUN.motion, RUN.phi[1:4] / RUN.phi[0] + PLACE
    field = m.a - m.g + np.cross(m.alpha, r) + np.cross(m.omega, np.cross(m.omega, r))
    h, pull = RUN.period / FINE, CubicSpline(RUN.t, field @ AXIS)
    u, v = -STOP * float(np.sign(pull(RUN.t[0]))) if spring == 0.0 else float(-pull(RUN.t[0]) / spring), 0.0
    ways, rates = [], []
    for t in RUN.t:
        ways.append(u)
        rates.append(v)
        for b in pull(t + h * np.arange(FINE)):
            v += h * (-b - spring * u - drag * v)
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


@pytest.mark.parametrize(("drag", "spring"), [(8.0, 0.0), (1.5, 250.0)])
def test_a_part_on_a_slide_adds_what_newton_says_until_and_after_it_knocks(drag: float, spring: float) -> None:
    planted = knock(drag, spring)
    theta = np.array([*(MASS * STOP * AXIS), STOP, drag, spring * STOP, *PLACE])
    added = LooseWithKnocks().wrench(RUN, RUN.nominal, theta) - RUN.nominal
    assert np.abs(planted[:, :3]).max() > 1.0
    assert np.square(average(added - planted)).sum() < 0.03 * np.square(average(planted)).sum()


def test_a_fit_finds_how_far_it_slides_and_how_much_it_moves() -> None:
    planted, effect = knock(8.0, 0.0), LooseWithKnocks()
    scale = np.array([p.scale for p in effect.parameters(RUN)])
    lower, upper = (np.array([getattr(p, name) for p in effect.parameters(RUN)]) for name in ("lower", "upper"))

    def left(x: Array) -> Array:
        return np.asarray(average(effect.wrench(RUN, RUN.nominal, x) - RUN.nominal - planted).ravel())

    begun = min((np.clip(start, lower, upper) for start in effect.starts(RUN, planted / NOISE)), key=lambda x: float(left(x) @ left(x)))
    fit = least_squares(left, begun, bounds=(lower - 1e-9, upper), x_scale=scale)
    assert 2.0 * fit.cost < 0.1 * np.square(average(planted)).sum()
    assert np.linalg.norm(fit.x[:3]) == pytest.approx(MASS * STOP, rel=0.1)
    assert fit.x[3] == pytest.approx(STOP, rel=0.1)


def test_what_moves_nothing_adds_nothing() -> None:
    effect = LooseWithKnocks()
    absent = np.array([p.absent for p in effect.parameters(RUN)])
    np.testing.assert_array_equal(effect.wrench(RUN, RUN.nominal, absent), RUN.nominal)
    assert effect.explain_tie_to_run(RUN) is not None
