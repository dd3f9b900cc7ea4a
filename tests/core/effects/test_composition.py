"""Several effects at once: gears that shake the links of an arm on springs."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from core.effects.composition import Composition, Term
from core.effects.gear_ripple import GearRipple
from core.effects.joint_backlash import JointBacklash
from core.effects.joint_elasticity import JointElasticity
from tests.core.effects.mechanical_truth import Array, T, believed, brisk_load, brisk_scene, change, rms, truth
from tests.core.effects.planted_mechanics import RATIO, RIPPLE, SOFT, SWING, rippled, swung

SPRINGS = Term(JointElasticity(), np.array([*SOFT, 1.0, SWING]))
PLAY_RAD, TORQUE_NM, LAG_S, CROSSING_S = 5e-3, 2.0, 0.03, 0.05
GEARS = Term(GearRipple(), np.tile([RATIO, *RIPPLE[:2]], 7))


@lru_cache
def together() -> Array:
    return Composition([SPRINGS, GEARS]).change(brisk_scene())


@lru_cache
def leaning() -> Callable[[Array], Array]:
    """(N, 7), the side to which each joint leans at some times: the load behind a lag, and two more while it crosses."""

    def rate(t: float, state: Array) -> Array:
        load, crosses, arrives = state.reshape(3, 7)
        side = np.tanh(load / TORQUE_NM)
        follows = (brisk_load(np.array([t]))[0] - load) / LAG_S
        return np.concatenate((follows, (side - crosses) / CROSSING_S, (crosses - arrives) / CROSSING_S))

    load = brisk_load(T[:1])[0]
    start = np.concatenate((load, np.tile(np.tanh(load / TORQUE_NM), 2)))
    course = solve_ivp(rate, (T[0], T[-1] + 0.1), start, dense_output=True, rtol=1e-8, atol=1e-10).sol
    return lambda t: np.asarray(course(t)[14:].T)


def test_play_shakes_an_arm_on_springs_as_its_equation_of_motion_says() -> None:
    true = swung(geared=lambda t: believed(t) - PLAY_RAD * leaning()(t)) - truth().wrench()
    play = Term(JointBacklash(), np.array([*[PLAY_RAD] * 7, TORQUE_NM, LAG_S, CROSSING_S]))
    apart = sum(change(term.effect, term.theta, brisk_scene()) for term in (SPRINGS, play))
    found = Composition([SPRINGS, play]).change(brisk_scene())
    assert rms(true - apart) > 0.3 * rms(true), "play hardly shakes the springs"
    assert rms(true - found) < 0.3 * rms(true - apart)


def test_gears_shake_an_arm_on_springs_as_its_equation_of_motion_says() -> None:
    true = swung(geared=rippled) - truth().wrench()
    apart = sum(change(term.effect, term.theta, brisk_scene()) for term in (SPRINGS, GEARS))
    assert rms(true - apart) > 0.3 * rms(true), "the gears hardly shake the springs"
    assert rms(true - together()) < 0.25 * rms(true - apart)


@pytest.mark.parametrize("size", [1, 70])
def test_blocks_of_a_shaken_arm_give_the_wrench_of_the_whole(size: int) -> None:
    run, parts = brisk_scene(), Composition([GEARS, SPRINGS])
    found = [parts.change(run[k : k + size]) for k in range(0, 140, size)]
    np.testing.assert_allclose(np.concatenate(found), together()[:140], rtol=1e-9, atol=1e-9)
