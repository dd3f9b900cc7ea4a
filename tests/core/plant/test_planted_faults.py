"""What all faults promise: the registry, plausible draws, no size is no fault, repetition by seed."""

import dataclasses
import json

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.errors import BadPayload
from core.payload.inertia import InertialParameters
from core.plant.faults import FAULTS, Background, Setting, variants
from core.plant.faults.arm_imperfections import ARM_IMPERFECTIONS
from core.plant.faults.base import TiltedBase
from core.plant.faults.loose import SprungPart
from core.plant.faults.payload import OtherDensity, Slip
from core.sessions.simulated import SimulatedSession
from tests.core.plant.fault_oracle import CELL, HOME, PAYLOAD, SETTING, SIGNAL, clean, path, run, sensor_pose
from tests.core.plant.plant_oracle import CELLS

EFFECTS = [
    "sensor_drift",
    "sensor_offset_step",
    "sensor_gain",
    "sensor_crosstalk",
    "sensor_nonlinearity",
    "sensor_hysteresis",
    "sensor_creep",
    "sensor_saturation",
    "sensor_quantization",
    "sensor_noise",
    "sensor_interference",
    "time_delay",
    "sensor_lowpass",
    "kinematic_lag",
    "sample_dropout",
    "sensor_rotation",
    "sensor_translation",
    "base_tilt",
    "joint_offset",
    "joint_elasticity",
    "joint_backlash",
    "joint_friction",
    "gear_ripple",
    "payload_mismatch",
    "payload_loose",
    "payload_shift",
    "payload_mass_change",
    "tool_flexibility",
    "cable_drag",
    "external_contact",
    "unknown",
]
NAMES = [f"{fault.id}-{fault.variant}" for fault in FAULTS]


def drawn(fault, seed=0, size=1.0, setting=SETTING):
    return fault.draw(np.random.default_rng(seed), size, setting)


def test_every_effect_has_a_fault_and_half_of_them_another_shape():
    assert {fault.id for fault in FAULTS} == set(EFFECTS)
    assert sum(len(variants(effect)) > 1 for effect in EFFECTS) >= len(EFFECTS) / 2
    assert len(variants("unknown")) >= 5
    assert len(set(NAMES)) == len(NAMES)
    assert variants("nonsense") == ()


@pytest.mark.parametrize("fault", (*FAULTS, Background, *ARM_IMPERFECTIONS), ids=lambda fault: f"{fault.id}-{fault.variant}")
@pytest.mark.parametrize("cell", CELLS.values(), ids=CELLS)
def test_draws_repeat_by_seed_and_their_truth_is_json(fault, cell):
    setting = Setting(cell, cell.payloads["cylinder"].parameters)
    assert drawn(fault, 1, setting=setting) == drawn(fault, 1, setting=setting)
    assert len({drawn(fault, seed, setting=setting) for seed in range(5)}) == 5
    truth = drawn(fault, 1, setting=setting).truth
    assert set(truth) == {field.name for field in dataclasses.fields(fault)}
    assert json.loads(json.dumps(truth)) == json.loads(json.dumps({k: list(v) if isinstance(v, tuple) else v for k, v in truth.items()}))


def norm(values, rows):
    return float(np.linalg.norm(np.array(values)[rows]))


def largest(values):
    return float(np.abs(np.array(values)).max())


F = slice(0, 3)
DEGREE = np.pi / 180
PLAUSIBLE = {
    "sensor_drift-exponential": (lambda f: norm(f.drift_wrench, F), 0.3, 4.0),
    "sensor_drift-linear": (lambda f: norm(f.drift_wrench, F), 0.3, 4.0),
    "sensor_offset_step-step": (lambda f: norm(f.step_wrench, F), 1.0, 2.0),
    "sensor_gain-linear": (lambda f: largest(f.gain_share), 0.01, 0.05),
    "sensor_crosstalk-linear": (lambda f: largest(f.coupling * SETTING.full_scale / SETTING.full_scale[:, None]), 0.01, 0.03),
    "sensor_nonlinearity-quadratic": (lambda f: largest(f.share_of_range), 0.005, 0.02),
    "sensor_hysteresis-play": (lambda f: largest(f.half_width_wrench / SETTING.full_scale), 0.001, 0.004),
    "sensor_creep-exponential": (lambda f: abs(f.creep_share), 0.002, 0.01),
    "sensor_noise-white": (lambda f: f.factor, 1.5, 5.0),
    "sensor_interference-sine": (lambda f: largest(f.amplitude_wrench / SETTING.noise_std), 1.0, 5.0),
    "sensor_quantization-rounded": (lambda f: f.step_wrench[0] / 0.0625, 4.0, 20.0),
    "time_delay-constant": (lambda f: f.delay_s, 0.004, 0.04),
    "time_delay-jitter": (lambda f: f.delay_s, 0.004, 0.04),
    "sensor_lowpass-first_order": (lambda f: f.cut_off_hz, 2.0, 20.0),
    "sensor_lowpass-second_order": (lambda f: f.cut_off_hz, 2.0, 20.0),
    "kinematic_lag-first_order": (lambda f: f.lag_s, 0.005, 0.03),
    "sample_dropout-held": (lambda f: f.lost_share, 0.1, 0.6),
    "sensor_rotation-sensor_alone": (lambda f: norm(f.rotation_rad, F) / DEGREE, 0.3, 3.0),
    "sensor_translation-sensor_alone": (lambda f: norm(f.translation_m, F), 0.001, 0.005),
    "base_tilt-fixed": (lambda f: np.hypot(*f.tilt_rad) / DEGREE, 0.1, 3.0),
    "joint_offset-fixed": (lambda f: largest(f.offset_rad) / DEGREE, 0.1, 2.0),
    "joint_elasticity-two_mass": (lambda f: f.stiffness_n_m_per_rad[0], 2e3, 1e4),
    "joint_backlash-dead_zone": (lambda f: largest(f.half_play_rad) / DEGREE, 0.01, 0.05),
    "joint_friction-coulomb_viscous": (lambda f: largest(f.dry_n_m), 1.0, 15.0),
    "gear_ripple-sine": (lambda f: f.amplitude_rad[0] / DEGREE * 60, 0.25, 1.0),
    "payload_mismatch-scaled": (lambda f: abs(f.mass_share), 0.02, 0.2),
    "payload_loose-spring_mass": (lambda f: f.part_share, 0.05, 0.3),
    "payload_shift-step": (lambda f: norm(f.shift_m, F), 0.002, 0.04),
    "payload_mass_change-step": (lambda f: abs(f.change_kg), 0.02, 0.3),
    "tool_flexibility-slide": (lambda f: f.frequency_hz, 10.0, 40.0),
    "cable_drag-spring": (lambda f: f.stiffness_n_per_m, 0.5, 10.0),
    "external_contact-window": (lambda f: norm(f.force_n, F), 1.0, 15.0),
    "sensor_drift-thermostat": (lambda f: norm(f.drift_wrench, F), 0.3, 4.0),
    "sensor_gain-wandering_supply": (lambda f: largest(f.gain_share), 0.01, 0.05),
    "sensor_gain-warming_supply": (lambda f: abs(f.share), 0.01, 0.05),
    "sensor_nonlinearity-bow": (lambda f: largest(f.bow_share), 0.005, 0.02),
    "sensor_hysteresis-stick_and_snap": (lambda f: largest(f.half_width_wrench / SETTING.full_scale), 0.001, 0.004),
    "sensor_interference-gated": (lambda f: largest(f.amplitude_wrench / SETTING.noise_std), 1.0, 5.0),
    "sensor_quantization-short_float": (lambda f: f.step_share, 0.01, 0.06),
    "time_delay-slipping_buffer": (lambda f: f.delay_s, 0.004, 0.04),
    "kinematic_lag-polled": (lambda f: f.lag_s, 0.005, 0.03),
    "sensor_lowpass-weighing": (lambda f: f.cut_off_hz, 2.0, 20.0),
    "sample_dropout-preempted": (lambda f: f.lost_share, 0.1, 0.6),
    "sensor_rotation-loose_bolts": (lambda f: norm(f.rotation_rad, F) / DEGREE, 0.3, 3.0),
    "sensor_translation-split": (lambda f: norm(f.translation_m, F), 0.001, 0.005),
    "base_tilt-wobbly": (lambda f: np.hypot(*f.tilt_rad) / DEGREE, 0.1, 3.0),
    "joint_offset-warming": (lambda f: largest(f.offset_rad) / DEGREE, 0.1, 2.0),
    "joint_elasticity-creeping": (lambda f: f.stiffness_n_m_per_rad[0], 2e3, 1e4),
    "joint_backlash-by_motion": (lambda f: largest(f.half_play_rad) / DEGREE, 0.01, 0.05),
    "joint_friction-by_load": (lambda f: largest(f.load_share), 0.03, 0.12),
    "gear_ripple-pulses": (lambda f: largest(f.height_rad) / DEGREE * 60, 0.5, 2.0),
    "payload_loose-vessel": (lambda f: f.part_share, 0.05, 0.3),
    "cable_drag-reel": (lambda f: f.pull_n, 0.5, 5.0),
    "external_contact-cushion": (lambda f: norm(f.force_n, F), 1.0, 15.0),
    "sensor_drift-heat_front": (lambda f: norm(f.drift_wrench, F), 0.3, 4.0),
    "sensor_offset_step-clicks": (lambda f: norm(f.step_wrench, F), 1.0, 2.0),
    "sensor_gain-lost_gauge": (lambda f: largest(f.gain_share), 0.01, 0.05),
    "sensor_crosstalk-fading": (lambda f: largest(f.coupling * SETTING.full_scale / SETTING.full_scale[:, None]), 0.01, 0.03),
    "sensor_nonlinearity-shunt": (lambda f: largest(f.height_wrench / SETTING.load), 0.005, 0.02),
    "sensor_hysteresis-microslip": (lambda f: largest(f.height_wrench / SETTING.full_scale), 0.001, 0.004),
    "sensor_creep-slow_recovery": (lambda f: abs(f.creep_share), 0.002, 0.01),
    "time_delay-reconnecting": (lambda f: f.delay_s, 0.004, 0.04),
    "sensor_lowpass-aged_capacitor": (lambda f: f.cut_off_hz, 2.0, 20.0),
    "joint_elasticity-lossy": (lambda f: f.stiffness_n_m_per_rad[0], 2e3, 1e4),
    "joint_backlash-split_gear": (lambda f: largest(f.half_play_rad) / DEGREE, 0.01, 0.05),
    "gear_ripple-by_load": (lambda f: f.amplitude_rad[0] / DEGREE * 60, 0.25, 1.0),
    "payload_loose-roller": (lambda f: f.part_share, 0.05, 0.3),
    "cable_drag-catenary": (lambda f: f.weight_n_per_m, 1.0, 8.0),
    "external_contact-curtain": (lambda f: f.force_n, 1.0, 15.0),
}


@pytest.mark.parametrize("name", PLAUSIBLE)
def test_draws_of_size_one_are_plausible_and_fill_their_range(name):
    size_of, low, high = PLAUSIBLE[name]
    sizes = [size_of(drawn(FAULTS[NAMES.index(name)], seed)) for seed in range(150)]
    assert low * (1 - 1e-9) <= min(sizes)
    assert max(sizes) <= high * (1 + 1e-9)
    spread = (high / low) ** 0.25
    assert min(sizes) < low * spread
    assert max(sizes) > high / spread


NO_LIMIT = {"joint_elasticity", "joint_backlash", "tool_flexibility", "sensor_saturation"}
"""Without size they still have a stiff spring, or a level at the nominal load."""


@pytest.mark.parametrize("fault", [f for f in FAULTS if f.id not in NO_LIMIT], ids=lambda fault: f"{fault.id}-{fault.variant}")
def test_a_fault_of_no_size_is_no_fault(fault):
    along = path()[:500]
    faulty, healthy = run(drawn(fault, size=1e-7), along=along), clean()
    step = np.array(CELL.sensor.resolution)
    # rounding decides otherwise where a reading was between two steps, but seldom
    assert (np.abs(faulty.wrench - healthy.wrench[:500]) <= 1.001 * step).all()
    assert (np.abs(faulty.wrench - healthy.wrench[:500]) < 0.5 * step).mean() > 0.99
    np.testing.assert_allclose(faulty.q, healthy.q[:500], atol=4e-6)
    np.testing.assert_allclose(faulty.true_tau, healthy.true_tau[:500], atol=0.02 + 0.003 * np.abs(healthy.true_tau).max())


@pytest.mark.parametrize("fault", (*FAULTS, Background, *ARM_IMPERFECTIONS), ids=lambda fault: f"{fault.id}-{fault.variant}")
def test_a_large_fault_is_finite_and_the_same_again(fault):
    planted = drawn(fault, 2, size=3.0)
    along = path()[:350]
    first, again = run(planted, along=along), run(planted, along=along)
    for field in dataclasses.fields(first):
        values = getattr(first, field.name)
        assert np.isfinite(values).all()
        np.testing.assert_array_equal(values, getattr(again, field.name))
    # a robot that the guard would not stop: it follows its command, and no channel is dead
    assert np.abs(first.q - along).max() < 0.05
    assert (np.abs(first.wrench) < CELL.sensor.range).all()
    assert (np.diff(first.wrench[:200], axis=0) != 0).any()


@pytest.mark.parametrize("fault", variants("unknown"), ids=lambda fault: fault.variant)
def test_what_no_effect_describes_shows_in_the_wrench(fault):
    change = [np.abs((run(drawn(fault, seed)).wrench - clean().wrench) / SETTING.noise_std).max() for seed in range(3)]
    assert max(change) > 1.5


def test_an_empty_hand_can_lose_no_part():
    empty = InertialParameters(np.zeros(10))
    for fault in (SprungPart(0.2, (0, 0, 1), 3.0, 0.1), Slip(0.3, (0.01, 0, 0), 0.5, 0.0)):
        with pytest.raises(BadPayload, match="no mass"):
            run(fault, payload=empty)
    with pytest.raises(BadPayload, match="no mass"):
        drawn(OtherDensity, setting=Setting(CELL, empty))


def test_faults_reach_the_plant_through_the_session_in_their_order():
    faults = (Background((0.0, 0.01), (0.0,) * 6, 0.0, 0), TiltedBase((0.01, 0.0)))
    with SimulatedSession(CELL, PAYLOAD, seed=3, faults=faults) as session:
        session.state()
        felt = session.plant.truth.wrench
    g = Rotation.from_rotvec([0.01, 0.0, 0.0]).apply(Rotation.from_rotvec([0.0, 0.01, 0.0]).apply(CELL.gravity))
    np.testing.assert_allclose(felt[:3], -PAYLOAD.mass * sensor_pose(HOME).rotation.T @ g, atol=2e-3)


def test_background_jitter_is_that_of_the_instant():
    """A ramp of known slope sampled at instants that jitter by 0.1 ms."""
    fault = Background((0.0, 0.0), (0.0,) * 6, 1e-4, seed=5)
    felt = fault.sense(SIGNAL)
    slope = np.array([100.0, -50.0, 20.0, 1.0, 2.0, 3.0])
    t = 0.001 * np.arange(4000)
    early = np.array([felt(s, slope * s) for s in t])[1:] / slope - t[1:, None]
    np.testing.assert_allclose(early.std(0), 1e-4, rtol=0.05)
    np.testing.assert_allclose(early, early[:, :1].repeat(6, 1), atol=1e-9)
