"""Faults and effects in the same words: the fault acts, the effect with the stated parameters has to do the same."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from core.cell.folder import find_cell, load_cell
from core.effects.library import library
from core.effects.scene import Scene
from core.gap.basis import basis_of
from core.gap.effect_fit import fit_effects, fit_nominal
from core.gap.windows import Windows
from core.payload.inertia import InertialParameters, Motion
from core.plant.faults import FAULTS, Fault, Setting
from core.plant.faults.base import TiltedBase
from core.plant.faults.encoders import EncoderOffsets
from core.plant.faults.fault import Machine
from core.plant.faults.joint_springs import ElasticJoints
from core.plant.faults.loose import Pendulum, SprungPart
from core.plant.faults.lowpass import Butterworth, FirstOrderFilter
from core.plant.faults.mounting import ShiftedSensor, TurnedSensor, TurnedSensorWithPayload
from core.plant.faults.payload import MassStep, Slip
from core.plant.faults.sensor_memory import Creep
from core.plant.faults.sensor_offset import ExponentialDrift, LinearDrift, OffsetStep
from core.plant.faults.sensor_response import Crosstalk, Gain, Quadratic
from core.plant.faults.timing import Delay
from core.plant.mechanics import PERIOD, Drives
from core.plant.virtual_robot import VirtualRobot
from core.recording.recording import Recording, SensorDescription
from core.robot.model import RobotModel
from core.trial.truth import TOLD, difference_of, translate_truth, true_payload_of

CELL = load_cell(find_cell("lwr4_bench"))
PAYLOAD = CELL.payloads["cylinder"].parameters
SETTING = Setting(CELL, PAYLOAD, 12.0)
SIX = (0.03, -0.02, 0.01, 0.04, -0.03, 0.02)


def effect_of(name: str) -> Any:
    """The effect with that identifier."""
    return next(effect for effect in library() if effect.id == name)


def told(fault: Fault) -> dict[str, float]:
    """What the table says of a fault."""
    return translate_truth(fault.id, fault.variant, fault.truth, SETTING)


def still_scene(seconds: float = 12.0) -> Scene:
    """A wrench that swings in every channel; the rest of the scene does not matter to sensors."""
    t = np.arange(round(seconds / PERIOD)) * PERIOD
    g = 9.81 * np.column_stack([np.sin(0.9 * t), np.cos(0.7 * t), np.sin(0.5 * t + 1)])
    zero = np.zeros_like(g)
    return Scene(
        t=t, phase=np.full(len(t), "hold:free"), motion=Motion(g, zero, zero, zero), rotation=np.tile(np.eye(3), (len(t), 1, 1)),
        position=None, gravity=np.array([0, 0, -9.81]), phi=PAYLOAD.phi, range=SETTING.full_scale,
    )  # fmt: skip


@pytest.mark.parametrize(
    "fault",
    [
        Gain(SIX),
        Quadratic(SIX),
        Crosstalk(tuple(tuple(0.01 * (i - j) for j in range(6)) for i in range(6))),  # type: ignore[arg-type]  # six rows of six
        ExponentialDrift((1.0, -2.0, 0.5, 0.05, 0.02, -0.1), 60.0),
        LinearDrift((1.0, -2.0, 0.5, 0.05, 0.02, -0.1), 300.0),
        OffsetStep((1.0, -2.0, 0.5, 0.05, 0.02, -0.1), 5.0),
        Delay(0.0234),
        FirstOrderFilter(3.0),
        Butterworth(3.0),
        Creep(0.01, (5.0,)),
    ],
    ids=lambda fault: f"{fault.id}-{fault.variant}",
)
def test_an_effect_with_the_stated_parameters_does_what_the_fault_in_the_sensor_does(fault: Fault):
    scene, effect = still_scene(), effect_of(fault.id)
    sense = fault.sense(Machine(SETTING, None, None, slice(0, 7), PERIOD))  # type: ignore[arg-type]  # these faults look at no model
    assert sense is not None
    w = scene.nominal
    sensed = np.array([sense(t, row) for t, row in zip(scene.t, w, strict=True)])
    values = {"step_time_s": 5.0, **told(fault)}
    modelled = effect.wrench(scene, w, np.array([values.get(p.name, p.absent) for p in effect.parameters(scene)]))
    later = (scene.t > 1.0) & (np.abs(scene.t - 5.0) > 0.003)  # a jump lies between two samples
    change = np.abs(sensed - w)[later].max(axis=0)
    assert change.max() > 0.01
    assert np.all(np.abs(modelled - sensed)[later].max(axis=0) <= 0.02 * change + 1e-9)


def swung(fault: Fault) -> Recording:
    """Twelve seconds in which all joints swing, the fault in it, without a procedure."""
    robot = VirtualRobot(CELL, PAYLOAD, np.random.default_rng(1), drives=Drives(damping_s=0.0, friction=0.0), faults=(fault,))
    t = np.arange(12000) * PERIOD
    rate = 2 * np.pi * np.array([0.11, 0.13, 0.17, 0.19, 0.23, 0.31, 0.37])
    ramp = np.minimum(t / 2.0, 1.0)[:, None] ** 2
    q = robot.home + 0.6 * ramp * np.sin(rate * t[:, None])
    samples = [robot.step(row) for row in q]
    return Recording(
        t=t, gravity=CELL.robot.base.rotation.T @ CELL.gravity, wrench=np.array([s.wrench for s in samples]),
        q=np.array([s.q for s in samples]), tau=np.array([s.tau for s in samples]), robot=RobotModel.of_cell(CELL).description,
        phase=np.repeat(["hold:free", *(f"transfer:{k}" for k in range(5)), "hold:free"], [500, *[2200] * 5, 500]),
        sensor=SensorDescription(SETTING.noise_std, SETTING.full_scale, np.array(CELL.sensor.resolution)),
    )  # fmt: skip


@pytest.mark.parametrize(
    "fault",
    [
        TurnedSensor((0.05, -0.03, 0.04)),
        TurnedSensorWithPayload((0.05, -0.03, 0.04)),
        ShiftedSensor((0.02, -0.015, 0.01)),
        TiltedBase((0.04, -0.02)),
        EncoderOffsets((0.0, 0.03, 0.0, -0.02, 0.0, 0.0, 0.0)),
        MassStep(0.3, (0.03, 0.02, 0.1), 5.0, 0.0),
        MassStep(-0.3, (0.03, 0.02, 0.1), 5.0, 0.0),
        Slip(0.4, (0.03, 0.02, -0.02), 5.0, 0.0),
    ],
    ids=lambda fault: f"{fault.id}-{fault.variant}",
)
def test_a_fault_in_the_mechanism_is_fitted_with_the_stated_parameters_and_payload(fault: Fault):
    windows = Windows(basis_of(swung(fault)))
    nominal, effect = fit_nominal(windows), effect_of(fault.id)
    scene = windows.basis.scene.with_phi(nominal.phi)
    residual = np.column_stack([np.interp(scene.t, windows.centres, channel) for channel in nominal.residual])
    fit = fit_effects(windows, (effect,), nominal, effect.starts(scene, residual))
    truth = told(fault)
    true = np.array([truth.get(p.name, p.absent) for p in fit.parameters])
    assert np.all(np.abs(fit.theta - true) < 4.0 * fit.theta_std + 0.03 * np.abs(true).max())
    size = np.linalg.norm(true)
    known = fit.theta_std < 0.1 * size  # of an eccentric first joint, say, such a run tells next to nothing
    assert known[true != [p.absent for p in fit.parameters]].all()
    assert np.linalg.norm((fit.theta - true)[known]) < 0.3 * size
    payload = true_payload_of(CELL, PAYLOAD, (fault,)).phi
    assert np.all(np.abs(fit.phi - payload)[:4] < 4.0 * fit.phi_std[:4] + 0.003 * payload[0])


def test_the_true_payload_is_the_nominal_one_where_no_fault_touches_it():
    for faults in ((), (TiltedBase((0.02, 0.0)),), (ElasticJoints((3000.0,) * 7),), (TurnedSensorWithPayload((0.1, 0.0, 0.0)),)):
        assert true_payload_of(CELL, PAYLOAD, faults).phi == pytest.approx(PAYLOAD.phi, rel=1e-6, abs=1e-7)


def test_the_true_payload_is_seen_from_the_true_sensor():
    shift = np.array([0.01, -0.02, 0.03])
    found = true_payload_of(CELL, PAYLOAD, (ShiftedSensor((0.01, -0.02, 0.03)),))
    assert found.com == pytest.approx(PAYLOAD.com - shift, abs=1e-9)
    half_turn = true_payload_of(CELL, PAYLOAD, (TurnedSensor((0.0, 0.0, np.pi)),))
    assert half_turn.com == pytest.approx(PAYLOAD.com * [-1, -1, 1], abs=1e-9)


def test_what_is_put_on_later_is_not_there_at_the_start_and_what_falls_off_is():
    for change in (0.2, -0.2):
        found = true_payload_of(CELL, PAYLOAD, (MassStep(change, (0.05, 0.0, 0.1), 5.0, 0.0),))
        assert found.mass == pytest.approx(PAYLOAD.mass, rel=1e-9)
        assert found.com == pytest.approx(PAYLOAD.com, abs=1e-9)


def test_what_hangs_counts_where_it_hangs_from_and_what_is_sprung_where_its_spring_is_relaxed():
    sprung = true_payload_of(CELL, PAYLOAD, (SprungPart(0.3, (0.0, 1.0, 0.0), 2.5, 0.1),))
    assert sprung.phi == pytest.approx(PAYLOAD.phi, rel=1e-6, abs=1e-7)
    pivot = np.array([0.05, -0.03, 0.2])
    hanging = true_payload_of(CELL, PAYLOAD, (Pendulum(0.3, 0.08, (0.05, -0.03, 0.2), 0.1),))
    assert hanging.mass == pytest.approx(PAYLOAD.mass)
    assert hanging.com == pytest.approx(0.7 * PAYLOAD.com + 0.3 * pivot, abs=1e-9)
    assert np.all(hanging.inertia.diagonal() < PAYLOAD.inertia.diagonal() + 0.3 * PAYLOAD.mass * (pivot @ pivot))


def test_a_mismatch_is_payload_less_reference_in_the_symptoms_names():
    other = InertialParameters(PAYLOAD.phi * 1.1)
    difference = difference_of(other.phi, PAYLOAD.phi)
    assert difference["m_difference_kg"] == pytest.approx(0.1 * PAYLOAD.mass)
    assert len(difference) == 10


def test_every_line_of_the_table_is_about_a_fault_that_there_is():
    assert set(TOLD) <= {(fault.id, fault.variant) for fault in FAULTS}


def test_a_fault_of_another_shape_has_no_parameters():
    assert translate_truth("sensor_drift", "random_walk", {}, SETTING) == {}
