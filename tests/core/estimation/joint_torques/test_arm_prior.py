"""`core.estimation.joint_torques.arm_prior`: its errors are those of a body that is heavier, lies elsewhere or is spread otherwise."""

from __future__ import annotations

import numpy as np

from core.estimation.joint_torques.arm_prior import CENTRE_M, UNKNOWN, link_modes
from core.payload.inertia import InertialParameters

COM = np.array([0.02, -0.05, 0.1])
INERTIA = np.diag([0.03, 0.04, 0.02])


def link(mass: float = 4.0, com: np.ndarray = COM, inertia: np.ndarray = INERTIA) -> np.ndarray:
    return InertialParameters.from_com(mass, com, inertia).phi


def test_a_link_is_a_tenth_heavier_its_centre_two_centimetres_aside_its_moments_a_fifth_larger() -> None:
    modes = link_modes(link()[None], 0.1)
    np.testing.assert_allclose(modes[:, 0], link(4.4, COM, 1.1 * INERTIA) - link(), atol=1e-12)
    small = 1e-6
    for k, axis in enumerate(np.eye(3)):
        change = (link(com=COM + small * axis) - link()) / small * CENTRE_M
        np.testing.assert_allclose(modes[:, 1 + k], change, atol=1e-6)
    np.testing.assert_allclose(modes[4:, 4], [0.2 * 0.03, 0, 0, 0, 0, 0])


def test_a_link_without_mass_may_be_anything_of_usual_size() -> None:
    np.testing.assert_array_equal(np.sort(link_modes(np.zeros((1, 10)), 0.1).sum(axis=0)), np.sort(UNKNOWN))
