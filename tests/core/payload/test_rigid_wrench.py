"""The compiled wrench against Pinocchio's free body, and on the scales."""

from __future__ import annotations

import numpy as np
from hypothesis import given

from core.payload.inertia import InertialParameters, Motion
from core.payload.rigid_wrench import wrench
from tests.core.payload.test_inertia import oracle, random_motion, seeds
from tests.synthetic import random_payload


@given(seeds)
def test_it_is_newton_and_euler(seed: int) -> None:
    rng = np.random.default_rng(seed)
    body, motion = random_payload(rng), random_motion(rng)
    np.testing.assert_allclose(wrench(motion, body.phi), oracle(motion, body), rtol=1e-10, atol=1e-10)


def test_at_rest_with_x_along_gravity_the_sensor_reads_minus_the_weight() -> None:
    body = InertialParameters.from_com(2.0, [0.01, 0.02, 0.03], np.eye(3) * 1e-3)
    f = wrench(Motion.still(np.array([[9.81, 0.0, 0.0]])), body.phi)[0]
    np.testing.assert_allclose(f[:3], [-2.0 * 9.81, 0.0, 0.0])
    np.testing.assert_allclose(f[3:], -np.cross(body.first_moment, [9.81, 0.0, 0.0]))
