"""A part that swings up to a wall, against a mass on a stiff rod that is pushed back by a stiff wall, by Newton's law in base axes."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.optimize import least_squares

from core.array import Array
from core.effects.loose_in_vessel import LooseInVessel
from tests.core.effects.synthetic_scene import GRAVITY, NOISE, scene

RUN, EFFECT = scene(), LooseInVessel()
AXIS, MASS, LENGTH, DAMPING, PLACE = np.array([0.48, -0.6, 0.64]), 0.3, 0.05, 0.08, np.array([0.02, -0.03, 0.01])
FREQUENCY_HZ = float(np.sqrt(9.81 / LENGTH)) / (2.0 * np.pi)
ROD_N_PER_M, ROD_NS_PER_M = 3e5, 300.0
WALL_N_PER_M, WALL_NS_PER_M = 3e3, 30.0
FREE = np.pi
"""No wall."""


@cache
def swing(wall: float) -> Array:
    """(N, 6), what the part adds in sensor axes against the same mass at the point from which it hangs; it begins where gravity and wall
    have it."""
    pivot = RUN.phi[1:4] / RUN.phi[0] + PLACE
    hinge = CubicSpline(RUN.t, RUN.position + RUN.rotation @ pivot)
    turned = CubicSpline(RUN.t, RUN.rotation)
    omega = CubicSpline(RUN.t, np.einsum("nij,nj->ni", RUN.rotation, RUN.motion.omega))
    pull = hinge.derivative(2)

    def force(t: float, arm: Array, speed: Array) -> Array:
        """On a mass at `arm` from the pivot, which it leaves at `speed`: rod, friction against the vessel, wall."""
        length = float(np.linalg.norm(arm))
        n = arm / length
        sliding = speed - np.cross(omega(t), arm)
        across = sliding - (sliding @ n) * n
        rod = -(ROD_N_PER_M * (length - LENGTH) + ROD_NS_PER_M * (speed @ n)) * n
        drag = -2.0 * DAMPING * 2.0 * np.pi * FREQUENCY_HZ * MASS * across
        axis = turned(t) @ AXIS
        beyond = float(np.arccos(np.clip(n @ axis, -1.0, 1.0))) - wall
        if beyond <= 0.0:
            return np.asarray(rod + drag)
        away = (n @ axis) * n - axis
        away /= np.linalg.norm(away)
        return np.asarray(rod + drag - max(0.0, WALL_N_PER_M * LENGTH * beyond + WALL_NS_PER_M * (across @ away)) * away)

    def rate(t: float, state: Array) -> Array:
        arm, speed = state[:3], state[3:]
        return np.concatenate((speed, GRAVITY - pull(t) + force(t, arm, speed) / MASS))

    down, axis = GRAVITY / 9.81, RUN.rotation[0] @ AXIS
    if down @ axis < np.cos(wall):
        side = down - (down @ axis) * axis
        down = np.cos(wall) * axis + np.sin(wall) * side / np.linalg.norm(side)
    state = solve_ivp(rate, (RUN.t[0], RUN.t[-1]), [*(LENGTH * down), *[0.0] * 3], "Radau", RUN.t, rtol=1e-6, atol=1e-8).y.T
    arm = state[:, :3]
    push = np.array([force(t, x[:3], x[3:]) for t, x in zip(RUN.t, state, strict=True)])
    rigid = MASS * (pull(RUN.t) - GRAVITY)
    lever = RUN.rotation @ pivot
    torque = np.cross(lever + arm, push) - np.cross(lever, rigid)
    return np.concatenate([np.einsum("nij,ni->nj", RUN.rotation, x) for x in (push - rigid, torque)], axis=1)


def added(theta: Array) -> Array:
    """(N, 6), N and N m."""
    return np.asarray(EFFECT.wrench(RUN, RUN.nominal, theta) - RUN.nominal)


def theta_of(wall: float) -> Array:
    return np.array([*(MASS * LENGTH * AXIS), FREQUENCY_HZ, DAMPING, wall, *PLACE])


def average(w: Array) -> Array:
    """(N - 19, 6), over ten rows, as windows do, in standard deviations of the noise, without those in which the rod takes up its load."""
    return np.asarray(np.apply_along_axis(np.convolve, 0, w[10:] / NOISE, np.full(10, 0.1), mode="valid"))


@pytest.mark.parametrize("wall", [0.8, *(pytest.param(wall, marks=pytest.mark.thorough) for wall in (0.4, FREE))])
def test_it_adds_what_a_mass_on_a_rod_does_that_a_wall_stops(wall: float) -> None:
    planted = average(swing(wall))
    whole = np.square(planted).sum()
    assert whole > 1000.0
    assert np.square(average(added(theta_of(wall))) - planted).sum() < 0.01 * whole
    if wall < FREE:
        assert np.square(average(added(theta_of(FREE))) - planted).sum() > 0.1 * whole


def test_a_fit_from_its_starts_finds_the_vessels_axis_and_its_wall() -> None:
    planted = swing(0.6)
    scale, lower, upper = (np.array([getattr(p, name) for p in EFFECT.parameters(RUN)]) for name in ("scale", "lower", "upper"))

    def left(x: Array) -> Array:
        return np.asarray(average(added(x) - planted).ravel())

    begun = sorted(EFFECT.starts(RUN, planted / NOISE), key=lambda x: float(left(x) @ left(x)))[: EFFECT.followed]
    fit = min((least_squares(left, x, bounds=(lower, upper), x_scale=scale) for x in begun), key=lambda fit: fit.cost)
    assert 2.0 * fit.cost < 0.02 * np.square(average(planted)).sum()
    moment = float(np.linalg.norm(fit.x[:3]))
    assert fit.x[:3] @ AXIS / moment > 0.999
    assert moment == pytest.approx(MASS * LENGTH, rel=0.05)
    assert fit.x[3] == pytest.approx(FREQUENCY_HZ, rel=0.05)
    assert fit.x[5] == pytest.approx(0.6, abs=0.03)


def test_what_has_no_moment_adds_nothing_and_twins_do_not_take_it() -> None:
    absent = np.array([p.absent for p in EFFECT.parameters(RUN)])
    np.testing.assert_array_equal(EFFECT.wrench(RUN, RUN.nominal, absent), RUN.nominal)
    assert EFFECT.explain_tie_to_run(RUN) is not None


def test_all_parameters_of_a_fit_leave_it_finite() -> None:
    parameters = EFFECT.parameters(RUN)
    ends = [np.array([getattr(p, end) for p in parameters]) for end in ("lower", "upper")]
    for frequency, wall in ((0.5, 0.02), (0.5, np.pi), (10.0, 0.02), (10.0, np.pi)):
        for theta in ends:
            tried = theta.copy()
            tried[[3, 5]] = frequency, wall
            assert np.isfinite(added(tried)).all()


def test_the_advice_says_how_much_swings_how_fast_and_how_far() -> None:
    said = EFFECT.advice(RUN, theta_of(0.6)).text
    share = 100.0 * MASS / RUN.phi[0]
    assert f"{share:.0f} %" in said and f"{FREQUENCY_HZ:.1f} Hz" in said and "34 deg" in said
