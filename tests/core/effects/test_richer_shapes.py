"""Richer shapes against physics of their own: a walk that is drawn, a point mass that slides from wall to wall, one that slips twice, and a
bridge that heats up."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter1d
from scipy.optimize import least_squares
from scipy.signal import lfilter

from core.effects.drift_in_any_attitude import DriftInAnyAttitude, wanders_in_any_attitude
from core.effects.drift_that_wanders import DriftThatWanders, wanders_in_holds
from core.effects.gain_that_warms_up import GainThatWarmsUp
from core.effects.loose_between_stops import LooseBetweenStops
from core.effects.payload_shift import PayloadShift
from core.effects.scene import Scene
from core.effects.several_payload_shifts import SeveralPayloadShifts
from tests.core.effects import mechanical_truth as truth
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
    assert not wanders_in_any_attitude(replace(RUN, apart=True), noise() + walk(30.0))


def smooth(walked: Array) -> Array:
    """So slow that it hardly changes within a hold."""
    return np.asarray(gaussian_filter1d(walked, 120, axis=0))


def test_a_slow_walk_takes_as_large_steps_in_one_attitude_as_from_one_to_the_next() -> None:
    slow = noise() + smooth(walk(8.0))
    assert not wanders_in_holds(RUN, slow)
    assert DriftThatWanders().starts(RUN, slow) == []
    assert DriftInAnyAttitude().starts(RUN, slow)


@pytest.mark.parametrize("kind", ["noise", "of_gravity", "hysteresis", "shaking"])
def test_what_goes_with_the_attitude_does_not(kind: str) -> None:
    g = RUN.motion.g / 9.81
    also = {
        "noise": np.zeros((len(RUN), 6)),
        "of_gravity": 30.0 * np.hstack((g * g[:, [1, 2, 0]], g**3)),
        "hysteresis": 30.0 * np.tanh(3.0 * np.hstack((g, g[:, ::-1]))),
        "shaking": 20.0 * np.outer(np.sin(2 * np.pi * 5.0 * RUN.t), EVEN),
    }
    assert not wanders_in_any_attitude(RUN, noise() + also[kind])


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


def slide_between_walls(mass: float, axis: Array, half_m: float, dry: float = 0.0, run: Scene = RUN) -> Array:
    """(N, 6), what a point mass adds that slides along an axis through the centre of mass, from wall to wall, against one that stays in the
    middle: Newton's law with Coulomb's friction of so many m/s2, step by step, torques of where it is."""
    m, com = run.motion, run.phi[1:4] / run.phi[0]
    field = m.a - m.g + np.cross(m.alpha, com) + np.cross(m.omega, np.cross(m.omega, com))
    u, du, places = 0.0, 0.0, []
    for b in field @ axis:
        for _ in range(10):
            du += 0.001 * (-b - 8.0 * du)
            du -= float(np.clip(du, -0.001 * dry, 0.001 * dry))
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
    start = np.array([0.001, 0.001, 0.001, 1.0, 0.0])
    scale = np.array([0.001, 0.001, 0.001, 1.0, 1.0])
    fit = least_squares(lambda x: ((effect.wrench(RUN, RUN.nominal, x) - RUN.nominal - planted) / NOISE).ravel(), start, x_scale=scale)
    theta = fit.x
    assert 2.0 * fit.cost < 0.15 * np.square(planted / NOISE).sum()
    assert np.linalg.norm(theta[:3]) == pytest.approx(0.004, rel=0.15)
    assert abs(theta[:3] @ axis) == pytest.approx(float(np.linalg.norm(theta[:3])), rel=0.02)


@pytest.mark.parametrize("dry", [0.0, 2.0, 4.0])
def test_a_part_that_friction_holds_at_its_wall_is_sought_and_followed(dry: float) -> None:
    axis, run, effect = np.array([0.8, -0.6, 0.0]), replace(scene(seconds=40.0, seed=7), noise=NOISE), LooseBetweenStops()
    planted = slide_between_walls(0.4, axis, 0.004, dry, run)
    scale, lower, upper = (np.array([getattr(p, name) for p in effect.parameters(run)]) for name in ("scale", "lower", "upper"))

    def left(x: Array) -> Array:
        return np.asarray(((effect.wrench(run, run.nominal, x) - run.nominal - planted) / NOISE).ravel())

    begun = sorted(effect.starts(run, planted / NOISE), key=lambda x: float(left(x) @ left(x)))[: effect.followed]
    fits = [least_squares(left, x, bounds=(lower - 1e-9, upper + 1e-9), x_scale=scale) for x in begun]
    fit = min(fits, key=lambda fit: fit.cost)
    assert 2.0 * fit.cost < 0.15 * np.square(planted / NOISE).sum()
    assert abs(fit.x[:3] @ axis) == pytest.approx(0.4 * 0.004, rel=0.15)
    assert dry < fit.x[4] < dry + 1.7  # the time on the way looks like some more


SLIPS = ((6.3, np.array([0.012, -0.004, 0.0])), (15.7, np.array([-0.003, 0.01, 0.004])))
PART_KG = 0.5


def slip_twice() -> Array:
    """(N, 6): the payload of point masses with a part at its centre of mass that lies elsewhere after each slip."""
    com = truth.MASSES @ truth.POINTS / truth.MASSES.sum()
    places = com + np.cumsum([np.zeros(3), *(way for _, way in SLIPS)], axis=0)
    rigid = truth.truth()
    lying = [rigid.wrench(np.vstack([truth.POINTS, com, place]), np.array([*truth.MASSES, -PART_KG, PART_KG])) for place in places]
    slipped = [truth.T[:, None] >= at for at, _ in SLIPS]
    return np.where(slipped[1], lying[2], np.where(slipped[0], lying[1], lying[0]))


def test_a_payload_that_slips_twice_is_followed_with_times_and_first_moments() -> None:
    effect, run = SeveralPayloadShifts(), truth.scene()
    noise = truth.SIGMA * np.random.default_rng(3).normal(size=(len(truth.T), 6))
    residual = truth.without_nuisance(((slip_twice() + noise - run.nominal) / truth.SIGMA).ravel())
    start = effect.starts(run, residual.reshape(-1, 6))[1]
    free = effect.smaller_shape(run)

    def left(x: Array) -> Array:
        change = truth.change(effect, np.concatenate((x, start[free:])), run)
        return residual - truth.without_nuisance((change / truth.SIGMA).ravel())

    fit = least_squares(left, start[:free], x_scale=np.tile([1.0, 0.01, 0.01, 0.01], 2))
    assert 2.0 * fit.cost < 1.05 * residual.size
    found = fit.x.reshape(2, 4)
    for (at, *moment), (planted_at, way) in zip(found, SLIPS, strict=True):
        assert at == pytest.approx(planted_at, abs=0.15)  # the second shows by less than the noise of a sample at first
        assert moment == pytest.approx(PART_KG * way, abs=3e-4)
    assert "several times" in effect.advice(run, np.concatenate((fit.x, start[free:]))).text
    assert effect.explain_tie_to_run(run) is not None


def test_two_slips_are_sought_at_their_times_and_not_where_they_would_explain_little() -> None:
    effect, run = SeveralPayloadShifts(), truth.scene()
    noise = np.random.default_rng(4).normal(size=(len(truth.T), 6))

    def seek(planted: Array) -> list[Array]:
        residual = truth.without_nuisance(((planted - run.nominal) / truth.SIGMA + noise).ravel())
        return effect.starts(run, residual.reshape(-1, 6))

    two = seek(slip_twice())[1].reshape(-1, 4)
    assert two[:2, 0] == pytest.approx([at for at, _ in SLIPS], abs=0.15)
    assert not two[2, 1:].any()
    assert seek(run.nominal) == []
    assert seek(run.nominal * [1.02, 0.98, 1.0, 1.0, 1.0, 1.0]) == []


def test_one_shift_is_what_the_effect_of_one_makes_of_it() -> None:
    theta = np.array([7.0, 0.004, -0.002, 0.003, 0.0])
    alone = np.concatenate((theta[:4], [9.0, 0.0, 0.0, 0.0, 12.0, 0.0, 0.0, 0.0]))
    one = PayloadShift().wrench(RUN, RUN.nominal, theta)
    np.testing.assert_array_equal(SeveralPayloadShifts().wrench(RUN, RUN.nominal, alone), one)
    assert "several" not in SeveralPayloadShifts().advice(RUN, alone).text


def test_a_bridge_that_heats_up_takes_gains_and_offsets_along() -> None:
    t, gains, offsets = RUN.t, np.array([0.02, 0.03, 0.01, -0.01, 0.02, 0.03]), np.array([0.5, -0.8, 1.0, 0.02, -0.03, 0.01])
    heat, warmth = 0.0, []
    for step in np.diff(t, prepend=t[0]):  # Newton's law of heating, time constant 6 s
        heat += step / 6.0 * (1.0 - heat)
        warmth.append(heat)
    planted = np.outer(warmth, gains) * RUN.nominal + np.outer(warmth, offsets)
    effect = GainThatWarmsUp()
    start = effect.starts(RUN, planted / NOISE)[1]
    scale = np.array([p.scale for p in effect.parameters(RUN)])
    fit = least_squares(lambda x: ((effect.wrench(RUN, RUN.nominal, x) - RUN.nominal - planted) / NOISE).ravel(), start, x_scale=scale)
    reached = 1.0 - np.exp(-60.0 / 6.0)
    assert fit.x[:6] == pytest.approx(gains * reached, abs=4e-4)
    assert fit.x[6] == pytest.approx(1.0 / 6.0, rel=0.02)
    assert fit.x[7:] == pytest.approx(offsets * reached, rel=0.05)
    assert "warm up" in effect.advice(RUN, fit.x).text
    assert effect.explain_tie_to_run(RUN) is not None
