"""A part on a hinge, against Lagrange's equation of a physical pendulum whose pivot moves, written down here and stepped finely."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.optimize import least_squares

from core.array import Array
from core.effects.loose_on_hinge import LooseOnHinge
from tests.core.effects.synthetic_scene import GRAVITY, NOISE, scene

RUN = scene()
AXIS, MASS, LEVER, OWN_INERTIA, PLACE = np.array([0.48, -0.6, 0.64]), 0.3, 0.04, 2e-4, np.array([0.02, -0.03, 0.01])
INERTIA = OWN_INERTIA + MASS * LEVER**2
FREQUENCY_HZ = float(np.sqrt(9.81 * MASS * LEVER / INERTIA)) / (2.0 * np.pi)
BEGUN_RAD = 0.2
STOP_NM_PER_RAD, STOP_NMS_PER_RAD = 300.0, 1.0
FREE = [2.0 * np.pi, 2.0 * np.pi]
"""No stops."""


def swing(damping: float, friction: float, back: float = 9.0, forth: float = 9.0) -> Array:
    """(N, 6), what the part adds on its hinge against one that stays as it hung at first: momentum and angular momentum of a thin body in
    base axes, differentiated by splines. Its stops, so far from where it begins, are stiff springs with much damping."""
    drag, dry = 2.0 * damping * 2.0 * np.pi * FREQUENCY_HZ * INERTIA, friction * 9.81 * MASS * LEVER
    pivot = RUN.phi[1:4] / RUN.phi[0] + PLACE
    hinge = CubicSpline(RUN.t, RUN.position + RUN.rotation @ pivot)
    down = RUN.rotation[0].T @ GRAVITY
    u = down - (down @ AXIS) * AXIS
    u /= np.linalg.norm(u)
    v = np.cross(AXIS, u)
    turned = CubicSpline(RUN.t, np.stack((RUN.rotation @ u, RUN.rotation @ v, RUN.rotation @ AXIS), axis=1))
    alpha = CubicSpline(RUN.t, RUN.motion.alpha @ AXIS)
    pull = hinge.derivative(2)

    def rate(t: float, state: Array) -> Array:
        along, across, _ = turned(t)
        phi, speed = state
        sideways = -np.sin(phi) * along + np.cos(phi) * across
        torque = MASS * LEVER * float(sideways @ (GRAVITY - pull(t))) - drag * speed - dry * np.tanh(speed / 1e-3)
        beyond = max(0.0, phi - BEGUN_RAD - forth) + min(0.0, phi - BEGUN_RAD + back)
        torque -= STOP_NM_PER_RAD * beyond + (STOP_NMS_PER_RAD * speed if beyond else 0.0)
        return np.array([speed, torque / INERTIA - alpha(t)])

    angle = solve_ivp(rate, (RUN.t[0], RUN.t[-1]), [BEGUN_RAD, 0.0], "Radau", RUN.t, rtol=1e-6, atol=1e-8).y[0]
    return strain(np.full_like(angle, BEGUN_RAD), hinge, turned, pivot) * -1.0 + strain(angle, hinge, turned, pivot)


def strain(angle: Array, hinge: CubicSpline, turned: CubicSpline, pivot: Array) -> Array:
    """(N, 6), wrench at the sensor, in its axes, that moves a part whose mass is a point, with a ring of `OWN_INERTIA` about its axis."""
    t = RUN.t
    along, across, axis = turned(t).transpose(1, 0, 2)
    arm = LEVER * (np.cos(angle)[:, None] * along + np.sin(angle)[:, None] * across)
    at = hinge(t) + arm
    force = MASS * (CubicSpline(t, at).derivative(2)(t) - GRAVITY)
    spin = OWN_INERTIA * CubicSpline(t, angle).derivative(2)(t)[:, None] * axis
    torque = np.cross(RUN.rotation @ pivot + arm, force) + spin
    return np.concatenate((np.einsum("nij,ni->nj", RUN.rotation, force), np.einsum("nij,ni->nj", RUN.rotation, torque)), axis=1)


def average(w: Array) -> Array:
    """(N, 6), over five rows, as windows do, in standard deviations of the noise."""
    return np.asarray(np.apply_along_axis(np.convolve, 0, w / NOISE, np.full(5, 0.2), mode="same"))


@pytest.mark.parametrize(("damping", "friction"), [pytest.param(0.3, 0.0, marks=pytest.mark.thorough), (0.1, 0.15), (0.02, 0.3)])
def test_a_part_on_a_hinge_adds_what_a_pendulum_does_whose_pivot_moves(damping: float, friction: float) -> None:
    planted = swing(damping, friction)
    theta = np.array([*(MASS * LEVER * AXIS), FREQUENCY_HZ, damping, friction, BEGUN_RAD, *PLACE, *FREE])
    added = LooseOnHinge().wrench(RUN, RUN.nominal, theta) - RUN.nominal
    assert np.square(average(planted)).sum() > 1000.0
    assert np.square(average(added - planted)).sum() < 0.01 * np.square(average(planted)).sum()


def test_a_part_that_turns_no_further_than_its_stops_adds_what_a_pendulum_between_springs_does() -> None:
    planted = swing(0.2, 0.3, 0.3, 0.5)
    theta = np.array([*(MASS * LEVER * AXIS), FREQUENCY_HZ, 0.2, 0.3, BEGUN_RAD, *PLACE, 0.3, 0.5])
    stopped, free = (LooseOnHinge().wrench(RUN, RUN.nominal, each) - RUN.nominal for each in (theta, np.array([*theta[:10], *FREE])))
    whole = np.square(average(planted)).sum()
    assert np.square(average(free - planted)).sum() > 0.2 * whole
    assert np.square(average(stopped - planted)).sum() < 0.01 * whole


def test_a_fit_from_its_starts_finds_the_stops() -> None:
    effect, planted = LooseOnHinge(), swing(0.2, 0.3, 0.3, 0.5)
    scale, lower, upper = (np.array([getattr(p, name) for p in effect.parameters(RUN)]) for name in ("scale", "lower", "upper"))

    def left(x: Array) -> Array:
        return np.asarray(average(effect.wrench(RUN, RUN.nominal, x) - RUN.nominal - planted).ravel())

    begun = sorted(effect.starts(RUN, planted / NOISE), key=lambda x: float(left(x) @ left(x)))[: effect.followed]
    fits = [least_squares(left, np.clip(x, lower, upper), bounds=(lower - 1e-9, upper + 1e-9), x_scale=scale) for x in begun]
    fit = min(fits, key=lambda fit: fit.cost)
    assert 2.0 * fit.cost < 0.2 * np.square(average(planted)).sum()
    assert fit.x[10:].sum() == pytest.approx(0.8, rel=0.15)


def test_a_fit_from_its_starts_finds_the_axis_and_the_moment() -> None:
    planted, effect = swing(0.1, 0.15), LooseOnHinge()
    parameters = effect.parameters(RUN)
    scale, lower, upper = (np.array([getattr(p, name) for p in parameters]) for name in ("scale", "lower", "upper"))

    def left(x: Array) -> Array:
        return np.asarray(average(effect.wrench(RUN, RUN.nominal, x) - RUN.nominal - planted).ravel())

    fits = [least_squares(left, start, bounds=(lower - 1e-9, upper), x_scale=scale) for start in effect.starts(RUN, planted / NOISE)]
    fit = min(fits, key=lambda fit: fit.cost)
    assert 2.0 * fit.cost < 0.02 * np.square(average(planted)).sum()
    moment = np.linalg.norm(fit.x[:3])
    assert moment == pytest.approx(MASS * LEVER, rel=0.03)
    assert abs(fit.x[:3] @ AXIS) / moment > 0.999
    assert fit.x[3] == pytest.approx(FREQUENCY_HZ, rel=0.1)


def test_an_axis_that_stands_upright_at_first_may_begin_anywhere() -> None:
    upright = RUN.rotation[0].T @ GRAVITY / 9.81
    theta = np.array([*(0.01 * upright), 2.0, 0.3, 0.0, 1.0, *[0.0] * 3, *FREE])
    added = LooseOnHinge().wrench(RUN, RUN.nominal, theta) - RUN.nominal
    assert np.isfinite(added).all()
    assert np.abs(added).max() > 0.1


def test_the_same_part_seen_from_the_other_end_of_its_axis_adds_the_same() -> None:
    theta = np.array([*(MASS * LEVER * AXIS), 2.0, 0.3, 0.1, 0.4, *PLACE, 0.2, 0.9])
    mirrored = np.array([*-theta[:3], *theta[3:6], -theta[6], *theta[7:10], theta[11], theta[10]])
    one, other = (LooseOnHinge().wrench(RUN, RUN.nominal, each) for each in (theta, mirrored))
    np.testing.assert_allclose(one, other, atol=1e-9)


def test_what_has_no_moment_adds_nothing_and_twins_do_not_take_it() -> None:
    effect = LooseOnHinge()
    absent = np.array([p.absent for p in effect.parameters(RUN)])
    np.testing.assert_array_equal(effect.wrench(RUN, RUN.nominal, absent), RUN.nominal)
    assert effect.explain_tie_to_run(RUN) is not None
    theta = np.array([0.003, 0.0, 0.004, *absent[3:]])
    assert "5.0 kg mm" in effect.advice(RUN, theta).text
