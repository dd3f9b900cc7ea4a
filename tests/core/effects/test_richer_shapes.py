"""Richer shapes against physics of their own: a walk that is drawn, and a point mass that slides from wall to wall."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.signal import lfilter

from core.effects.drift_that_wanders import DriftThatWanders, wanders_in_holds
from core.effects.loose_between_stops import LooseBetweenStops
from tests.core.effects.synthetic_scene import NOISE, scene

Array = np.ndarray
RUN = scene()
EVEN = np.ones(6)


def walk(std_after_run: float, seed: int = 1) -> Array:
    """(N, 6), in standard deviations of the noise."""
    steps = np.random.default_rng(seed).normal(size=(len(RUN), 6)) * std_after_run / np.sqrt(len(RUN))
    return np.cumsum(steps, axis=0)


def noise(seed: int = 2) -> Array:
    """(N, 6), of residual rows."""
    return np.random.default_rng(seed).normal(size=(len(RUN), 6))


def test_a_walk_goes_on_while_nothing_moves() -> None:
    assert wanders_in_holds(RUN, noise() + walk(30.0))


@pytest.mark.parametrize("kind", ["noise", "gain", "jet", "shaking", "ramp"])
def test_what_else_is_slow_does_not(kind: str) -> None:
    blown = lfilter([0.1], [1.0, -0.9], np.floor(RUN.t / 1.7) % 2)
    also = {
        "noise": np.zeros((len(RUN), 6)),
        "gain": 0.1 * RUN.nominal / NOISE,
        "jet": 40.0 * np.outer(blown, [1.0, 0.4, 0.0, 0.3, 0.8, 0.2]),
        "shaking": 20.0 * np.outer(np.sin(2 * np.pi * 5.0 * RUN.t), EVEN),
        "ramp": 10.0 * np.outer(RUN.t / RUN.t[-1], EVEN),
    }
    assert not wanders_in_holds(RUN, noise() + also[kind])


def test_where_nothing_moves_or_only_poses_are_known_nobody_can_tell() -> None:
    assert not wanders_in_holds(replace(RUN, phase=np.full(len(RUN), "hold:free")), noise() + walk(30.0))
    assert not wanders_in_holds(replace(RUN, apart=True), noise() + walk(30.0))


def test_the_shape_follows_a_walk_and_starts_nowhere_else() -> None:
    effect, w = DriftThatWanders(), RUN.nominal
    assert effect.starts(RUN, noise()) == []
    planted = walk(30.0) * NOISE
    at_knots = planted[np.minimum(100 * np.arange(17), len(RUN) - 1)]
    theta = effect.starts(RUN, planted / NOISE + noise())[0]
    theta[:6] = 0.0
    theta[-240 : -240 + 96] = np.diff(at_knots, axis=0).ravel()
    left = planted - planted[0] - (effect.wrench(RUN, w, theta) - w)
    assert np.std(left) < 0.35 * np.std(planted - planted.mean(axis=0))
    assert not any(p.name.startswith("knot") for p in effect.parameters(RUN) if p.shown)
    assert effect.explain_tie_to_run(RUN) is not None


def slide_between_walls(mass: float, axis: Array, half_m: float) -> Array:
    """(N, 6), what a point mass adds that slides without friction along an axis through the centre of mass, from wall to wall, against one
    that stays in the middle: Newton's law, step by step, torques of where it is."""
    m, com = RUN.motion, RUN.phi[1:4] / RUN.phi[0]
    field = m.a - m.g + np.cross(m.alpha, com) + np.cross(m.omega, np.cross(m.omega, com))
    u, du, places = 0.0, 0.0, []
    for b in field @ axis:
        for _ in range(10):
            du += 0.001 * (-b - 8.0 * du)
            u += 0.001 * du
            if abs(u) > half_m:
                u, du = float(np.sign(u)) * half_m, 0.0
        places.append(u)
    moved = mass * np.outer(places, axis)
    alpha, omega = m.alpha, m.omega
    return np.hstack((np.cross(alpha, moved) + np.cross(omega, np.cross(omega, moved)), np.cross(moved, m.a - m.g)))


def test_a_part_that_slides_from_wall_to_wall_is_followed_with_its_first_moment() -> None:
    axis = np.array([0.6, 0.0, 0.8])
    planted = slide_between_walls(0.4, axis, 0.01)
    effect = LooseBetweenStops()
    start = np.array([0.001, 0.001, 0.001, 1.0])
    scale = np.array([0.001, 0.001, 0.001, 1.0])
    fit = least_squares(lambda x: ((effect.wrench(RUN, RUN.nominal, x) - RUN.nominal - planted) / NOISE).ravel(), start, x_scale=scale)
    theta = fit.x
    assert 2.0 * fit.cost < 0.15 * np.square(planted / NOISE).sum()
    assert np.linalg.norm(theta[:3]) == pytest.approx(0.004, rel=0.15)
    assert abs(theta[:3] @ axis) == pytest.approx(float(np.linalg.norm(theta[:3])), rel=0.02)
