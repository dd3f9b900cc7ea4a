"""Thick fluid, against the segment of an ellipsoid below a plane, counted drop by drop, which is late by Newton's law of settling."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from core.array import Array
from core.effects.loose_fluid import LooseFluid
from tests.core.effects.synthetic_scene import NOISE, scene

RUN, EFFECT = replace(scene(seconds=32.0), noise=NOISE), LooseFluid()
FLUID_KG, SETTLING_S = 0.4, 1.5
HALF_AXES, TURNED = np.array([0.05, 0.03, 0.02]), Rotation.from_rotvec([0.4, -0.7, 0.3]).as_matrix()
S = 0.375 * FLUID_KG * TURNED @ np.diag(HALF_AXES) @ TURNED.T
"""The centre of half a ball is three eighths of its radius from the middle."""
THETA = np.array([SETTLING_S, *S[np.triu_indices(3)]])


def flow(settling_s: float) -> Array:
    """(N, 6), of the fluid that half fills an ellipsoid about the payload's centre of mass, against one that fills it evenly."""
    drops = np.random.default_rng(1).uniform(-1.0, 1.0, (30000, 3))
    drops = (drops[np.square(drops).sum(axis=1) < 1.0] * HALF_AXES) @ TURNED.T
    m, com = RUN.motion, RUN.phi[1:4] / RUN.phi[0]
    field = m.a - m.g + np.cross(m.alpha, com) + np.cross(m.omega, np.cross(m.omega, com))
    low = np.array([drops[np.argpartition(drops @ b, len(drops) // 2)[: len(drops) // 2]].mean(axis=0) for b in field[::10]])
    goes = np.array([np.interp(RUN.t, RUN.t[::10], x) for x in low.T]).T
    at, places = goes[0], [goes[0]]
    for k in range(1, len(goes)):
        share = 1.0 if settling_s == 0.0 else -np.expm1(-RUN.period / settling_s)
        at = at + share * (0.5 * (goes[k - 1] + goes[k]) - at) if settling_s > 0.0 else goes[k]
        places.append(at)
    return np.hstack((np.zeros_like(goes), FLUID_KG * np.cross(places, m.a - m.g)))


def added(theta: Array) -> Array:
    """(N, 6), N and N m."""
    return np.asarray(EFFECT.wrench(RUN, RUN.nominal, theta) - RUN.nominal)


@pytest.mark.parametrize("settling_s", [0.0, SETTLING_S])
def test_it_lies_where_the_low_half_of_an_ellipsoid_does_and_gets_there_late(settling_s: float) -> None:
    planted = flow(settling_s)
    off = (added(np.array([settling_s, *THETA[1:]])) - planted)[:, 3:]
    assert np.square(off).sum() < 2e-3 * np.square(planted).sum()
    later = (added(np.array([settling_s + 1.0, *THETA[1:]])) - planted)[:, 3:]
    assert np.square(later).sum() > 0.01 * np.square(planted).sum()


def test_a_fit_from_its_starts_finds_how_thick_it_is_and_how_far_it_goes() -> None:
    planted = flow(SETTLING_S)
    residual = planted / NOISE + np.random.default_rng(2).normal(size=planted.shape)
    scale, lower, upper = (np.array([getattr(p, name) for p in EFFECT.parameters(RUN)]) for name in ("scale", "lower", "upper"))

    def left(x: Array) -> Array:
        return np.asarray((residual - added(x) / NOISE).ravel())

    begun = min(EFFECT.starts(RUN, residual), key=lambda x: float(left(x) @ left(x)))
    fit = least_squares(left, begun, bounds=(lower, upper), x_scale=scale)
    assert fit.x[0] == pytest.approx(SETTLING_S, rel=0.1)
    xx, xy, xz, yy, yz, zz = fit.x[1:]
    found = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    np.testing.assert_allclose(np.sort(np.abs(np.linalg.eigvalsh(found))), np.sort(np.linalg.eigvalsh(S)), rtol=0.1)
    said = EFFECT.advice(RUN, THETA).text
    assert "within 1.5 s" in said
    assert "7.5 kg mm" in said


def test_in_a_narrow_tube_it_is_a_part_that_goes_from_end_to_end() -> None:
    axis = np.array([0.6, 0.0, 0.8])
    S_tube = 0.003 * np.outer(axis, axis)
    m, com = RUN.motion, RUN.phi[1:4] / RUN.phi[0]
    b = (m.a - m.g + np.cross(m.alpha, com) + np.cross(m.omega, np.cross(m.omega, com))) @ axis
    far = np.abs(b) > 4.0
    torque = added(np.array([0.0, *S_tube[np.triu_indices(3)]]))[:, 3:]
    expected = -0.003 * np.sign(b)[:, None] * np.cross(axis, m.a - m.g)
    assert far.sum() > 100
    np.testing.assert_allclose(torque[far], expected[far], atol=1e-3)


def test_what_moves_nothing_adds_nothing_and_twins_do_not_take_it() -> None:
    absent = np.array([p.absent for p in EFFECT.parameters(RUN)])
    np.testing.assert_array_equal(EFFECT.wrench(RUN, RUN.nominal, absent), RUN.nominal)
    assert EFFECT.explain_tie_to_run(RUN) is not None
