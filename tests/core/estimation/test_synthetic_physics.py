"""The synthetic recordings themselves: point masses against Pinocchio, derivatives against finite differences."""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from core.payload.inertia import PINOCCHIO_ORDER
from tests.synthetic import GRAVITY, payload, point_masses, random_payload, run_of, wrench_of


def test_four_point_masses_have_the_bodys_parameters() -> None:
    for body in (payload("steel_block"), random_payload(np.random.default_rng(5))):
        masses, places = point_masses(body)
        np.testing.assert_allclose(masses.sum(), body.mass)
        np.testing.assert_allclose(masses @ places, body.first_moment, atol=1e-12)
        inertia = sum(m * (r @ r * np.eye(3) - np.outer(r, r)) for m, r in zip(masses, places, strict=True))
        np.testing.assert_allclose(inertia, body.inertia, atol=1e-12)


def test_the_wrench_is_what_pinocchio_says() -> None:
    run, body = run_of("lwr4_bench", 0), payload("steel_block")
    inertia = pin.Inertia.FromDynamicParameters(body.phi[PINOCCHIO_ORDER])
    rows = np.arange(0, len(run.t), 997)
    measured = wrench_of(run, body)[rows]
    for k, expected in zip(rows, measured, strict=True):
        R = run.rotation[k]
        v = pin.Motion(np.zeros(3), run.omega[k])
        f = inertia * pin.Motion(R.T @ (run.a[k] - GRAVITY), run.alpha[k]) + v.cross(inertia * v)
        np.testing.assert_allclose(f.vector, expected, atol=1e-9)


def test_accelerations_are_the_second_differences_of_the_positions() -> None:
    run = run_of("lwr4_bench", 0)
    p = run.robot.sensor_poses(run.q).position
    second = (p[2:] - 2 * p[1:-1] + p[:-2]) / 1e-6
    assert np.abs(second - run.a[1:-1]).max() < 2e-3
    assert np.abs(run.alpha).max() > 4.5
