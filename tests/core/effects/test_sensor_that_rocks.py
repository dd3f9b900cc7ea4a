"""A sensor on loose bolts, turned row by row here."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from core.array import Array
from core.effects.sensor_rotation import SensorRotation
from core.effects.sensor_that_rocks import SensorThatRocks
from tests.core.effects.synthetic_scene import NOISE, scene

RUN, EFFECT = scene(), SensorThatRocks()
TURNED, PLAY_RAD, AXIS, GRIP_PER_NM = np.array([0.03, -0.01, 0.02]), 0.012, np.array([0.0, 0.8, 0.6]), 1.5


def rocked(way: float) -> Array:
    """(N, 6), N and N m, of a sensor that is turned, and rocks with the torque about an axis, or against it."""
    w = SensorRotation().wrench(RUN, RUN.nominal, TURNED)
    rows = []
    for force, torque in zip(w[:, :3], w[:, 3:], strict=True):
        angle = PLAY_RAD * np.tanh(way * GRIP_PER_NM * (torque @ AXIS))
        seen = Rotation.from_rotvec(angle * AXIS).inv()
        rows.append(np.concatenate((seen.apply(force), seen.apply(torque))))
    return np.array(rows)


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_it_turns_the_wrench_with_the_torque_or_against_it(way: float) -> None:
    theta = np.array([*TURNED, *(PLAY_RAD * AXIS), way * GRIP_PER_NM])
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, theta), rocked(way), atol=1e-9)
    mirrored = np.array([*TURNED, *(-PLAY_RAD * AXIS), way * GRIP_PER_NM])
    np.testing.assert_allclose(EFFECT.wrench(RUN, RUN.nominal, mirrored), rocked(way), atol=1e-9)


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_fit_that_starts_beside_a_sensor_that_is_turned_finds_about_what_it_rocks(way: float) -> None:
    measured = rocked(way) + NOISE * np.random.default_rng(1).normal(size=RUN.nominal.shape)
    scale, lower, upper = (np.array([getattr(p, name) for p in EFFECT.parameters(RUN)]) for name in ("scale", "lower", "upper"))

    def left(x: Array) -> Array:
        return np.asarray(((measured - EFFECT.wrench(RUN, RUN.nominal, x)) / NOISE).ravel())

    def left_by_turning(x: Array) -> Array:
        return left(np.array([*x, 0.0, 0.0, 0.0, 1.0]))

    plain = least_squares(left_by_turning, np.zeros(3), x_scale=0.02).x
    begun = sorted(EFFECT.starts_beside(RUN, measured, plain), key=lambda x: float(left(x) @ left(x)))[: EFFECT.followed]
    fit = min((least_squares(left, x, bounds=(lower, upper), x_scale=scale) for x in begun), key=lambda fit: fit.cost)
    assert 2.0 * fit.cost < 1.05 * measured.size
    slip, grip = fit.x[3:6], fit.x[6]
    assert np.linalg.norm(slip) == pytest.approx(PLAY_RAD, rel=0.3)
    assert abs(slip @ AXIS) > 0.95 * np.linalg.norm(slip)
    assert np.sign(grip) == way


def test_a_sensor_that_does_not_rock_is_turned_once_and_twins_keep_that() -> None:
    theta = np.array([*TURNED, 0.0, 0.0, 0.0, GRIP_PER_NM])
    np.testing.assert_array_equal(EFFECT.wrench(RUN, RUN.nominal, theta), SensorRotation().wrench(RUN, RUN.nominal, TURNED))
    assert EFFECT.explain_tie_to_run(RUN) is not None
    assert EFFECT.starts(RUN, RUN.nominal) == []
    assert "0.69 deg" in EFFECT.advice(RUN, np.array([*TURNED, *(PLAY_RAD * AXIS), 1.0])).text
