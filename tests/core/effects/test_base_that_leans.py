"""`core.effects.base_that_leans`: feet of rubber under an arm that is read anew from its URDF, and point masses on its sensor."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from core.effects.base_that_leans import BaseThatLeans, find_moment
from core.effects.library import library
from core.gap.basis import basis_of
from core.gap.diagnosis import diagnose
from core.recording.recording import Recording
from tests.core.effects.turned_base import BODY, arm, run, with_gravity_turned
from tests.synthetic import GRAVITY

Array = np.ndarray
COMPLIANCE = np.array([4.0e-4, 2.5e-4, 0.0])
"""rad/(N m), about x, y and z of the base."""
TILT = np.array([0.04, -0.015, 0.0])


@cache
def moment() -> Array:
    """(N, 3), N m, of all weights about the base's origin."""
    frames = arm().frames(run().q)
    tip = frames[:, -1] @ arm().sensor
    first = BODY.phi[0] * tip[:, :3, 3] + tip[:, :3, :3] @ BODY.phi[1:4]
    for k, body in enumerate(arm().inertia[1:], start=1):
        first = first + body.mass * frames[:, k, :3, 3] + frames[:, k, :3, :3] @ body.first
    return np.cross(first, GRAVITY)


def leaning() -> Recording:
    """On feet of rubber, not level at first."""
    return with_gravity_turned(TILT - COMPLIANCE * moment())


def test_the_moment_is_that_of_all_weights_that_move() -> None:
    scene = basis_of(leaning()).scene.with_phi(BODY.phi)
    wanted = np.column_stack([np.interp(scene.t, run().t, axis) for axis in moment().T])
    assert find_moment(scene) == pytest.approx(wanted, abs=0.02)
    assert np.ptp(wanted, axis=0)[:2].min() > 5.0


def test_nobody_can_tell_without_the_masses_of_the_arm() -> None:
    scene = basis_of(leaning()).scene
    residual = np.zeros((len(scene), 6))
    assert BaseThatLeans().starts(scene, residual)
    assert BaseThatLeans().starts(replace(scene, links=None), residual) == []


def test_a_base_that_leans_is_named_with_its_compliance_and_tilt() -> None:
    few = [effect for effect in library() if effect.id in ("base_tilt", "cable_drag", "joint_offset", "sensor_gain")]
    diagnosis = diagnose(leaning(), few)
    best = diagnosis.effects[0]
    assert (diagnosis.verdict, best.id) == ("explained", "base_tilt")
    for k, axis in enumerate("xy"):
        assert best.parameters[f"lean_{axis}_rad_per_nm"].value == pytest.approx(COMPLIANCE[k], rel=0.1)
        assert best.parameters[f"about_{axis}_rad"].value == pytest.approx((TILT - COMPLIANCE * moment()[0])[k], abs=1e-3)
    assert not best.addable
