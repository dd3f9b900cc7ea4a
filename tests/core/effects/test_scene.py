"""`core.effects.scene`: what a scene with something else in it still knows."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.core.effects.synthetic_scene import PAYLOAD, scene


@pytest.mark.parametrize("known", [True, False])
def test_the_inertia_of_arm_and_payload_is_the_same_whatever_the_motion_and_is_not_worked_out_again(known: bool) -> None:
    run, faster = scene(), scene(seed=2).motion
    inertia = run.joint_inertia if known else None
    moved = run.with_motion(faster)
    anew = replace(run, motion=faster)
    assert (moved.joint_inertia is inertia) == known
    np.testing.assert_array_equal(moved.joint_inertia, anew.joint_inertia)
    np.testing.assert_array_equal(moved.nominal, anew.nominal)
    np.testing.assert_array_equal(moved.joint_load, anew.joint_load)


def test_another_payload_has_another_inertia() -> None:
    run = scene()
    lighter = run.joint_inertia - run.with_phi(0.5 * PAYLOAD).joint_inertia
    assert run.jacobian is not None
    first = run.jacobian[0].T
    body = np.linalg.lstsq(np.kron(first, first), lighter[0].ravel(), rcond=None)[0].reshape(6, 6)
    np.testing.assert_allclose(body[:3, :3], 0.5 * PAYLOAD[0] * np.eye(3), atol=1e-9)
