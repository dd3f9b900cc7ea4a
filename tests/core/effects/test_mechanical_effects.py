"""Mounting, kinematics, payload and environment: each effect against physics that is written down here, and found again by a plain fit."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.effects.base_tilt import BaseTilt
from core.effects.cable_drag import CableDrag
from core.effects.effect import Effect
from core.effects.external_contact import ExternalContact
from core.effects.joint_backlash import JointBacklash
from core.effects.payload_mass_change import PayloadMassChange
from core.effects.payload_shift import PayloadShift
from core.effects.sensor_translation import SensorTranslation
from core.payload.inertia import Motion
from tests.core.effects.mechanical_truth import SIGMA, Array, T, change, rms, scene, truth, without_nuisance
from tests.core.effects.plain_fit import fitted
from tests.core.effects.planted_mechanics import ADDED, AT, PLACE, PLANTED, PUSH, SHIFT, TILT, TOUCHED, Planted, inside, slipped, touched

each = pytest.mark.parametrize("case", PLANTED, ids=[case.id for case in PLANTED])


@each
def test_the_effect_does_to_the_wrench_what_physics_does(case: Planted) -> None:
    rows, true = case.rows(), case.wrench() - truth().wrench()
    assert rms(true[rows]) > 0.3, "nothing was planted"
    assert rms((change(case.effect, case.theta, case.run()) - true)[rows]) < case.tolerance * rms(true[rows])


@each
@pytest.mark.parametrize("noise", [0.0, 1.0])
def test_a_plain_fit_finds_what_was_planted(case: Planted, noise: float) -> None:
    measured = case.wrench() + noise * SIGMA * np.random.default_rng(1).normal(size=(len(T), 6)) + [3, -2, 1, 0.1, 0.2, -0.1]
    fit = fitted(case.effect, measured, noise, case.run())
    parameters = case.effect.parameters(case.run())
    scale = np.array([p.scale for p in parameters])
    assert fit.closure > 0.95
    assert (fit.std < 0.3 * scale).mean() >= 0.5, "nothing was learnt of half of the parameters"
    off = (np.abs(case.alike(fit.theta) - case.theta) - 4 * fit.std) / scale
    assert (off < case.fit_tolerance).all(), {p.name: x for p, x in zip(parameters, off, strict=True) if x > case.fit_tolerance}


@pytest.mark.parametrize("effect", [case.effect for case in PLANTED if case.effect.stage == "kinematics"], ids=lambda effect: effect.id)
def test_a_recording_of_poses_says_why_it_shows_nothing_of_the_joints(effect: Effect) -> None:
    poses = replace(scene(), q=None, dq=None, jacobian=None, torque=None)
    assert str(effect.explain_absence(poses)) == "the recording has no joint positions"
    assert effect.explain_absence(scene()) is None


def test_what_cannot_show_is_said() -> None:
    still = replace(scene(), motion=Motion.still(scene().motion.g))
    assert SensorTranslation().explain_absence(still) is not None
    assert CableDrag().explain_absence(replace(scene(), position=None)) is not None
    assert CableDrag().explain_absence(replace(scene(), position=np.ones((len(T), 3)))) is not None
    assert JointBacklash().explain_absence(replace(scene(), torque=np.full((len(T), 7), 5.0))) is not None
    assert all(case.effect.explain_absence(scene()) is None for case in PLANTED)


@each
def test_the_advice_names_what_to_do_with_numbers(case: Planted) -> None:
    advice = case.effect.advice(scene(), case.theta).text
    assert advice[0].isupper()
    assert advice.endswith(".")
    assert any(c.isdigit() for c in advice)
    assert "nan" not in advice


def test_advice_is_given_in_everyday_units() -> None:
    assert "turn it by 1.15 deg about x" in BaseTilt().advice(scene(), TILT).text  # as fitted: the base stands turned the other way
    assert "3.0, -4.0 and 2.0 mm" in SensorTranslation().advice(scene(), SHIFT).text
    assert "gained 200 g" in PayloadMassChange().advice(scene(), np.array([AT, ADDED, *PLACE, 0.0])).text
    assert "7.8 N from 8.0 to 12.5 s" in ExternalContact().advice(scene(), np.array([8.0, 4.5, 0.0, *PUSH, *TOUCHED])).text


def test_the_starts_of_steps_and_windows_are_within_a_few_samples_of_the_truth() -> None:
    noise = np.random.default_rng(6).normal(size=(len(T), 6))

    def first_start(effect: Effect, measured: Array) -> Array:
        residual = without_nuisance(((measured - scene().nominal) / SIGMA + noise).ravel())
        return effect.starts(scene(), residual.reshape(-1, 6))[0]

    gained = truth().wrench() + (T[:, None] > AT) * truth().wrench(PLACE[None], np.array([ADDED]))
    assert first_start(PayloadMassChange(), gained)[0] == pytest.approx(AT, abs=0.05)
    assert first_start(PayloadShift(), slipped())[0] == pytest.approx(AT, abs=0.05)
    np.testing.assert_allclose(first_start(ExternalContact(), touched(inside()))[:2], [8.0, 4.5], atol=0.1)
