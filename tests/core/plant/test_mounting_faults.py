"""Sensor, base and encoders that do not stand as drawn: Pinocchio and Eq. (1) written out say what is felt."""

import numpy as np
import pinocchio as pin
import pytest
from scipy.spatial.transform import Rotation

from core.payload.inertia import frame_change
from core.plant.faults.base import SoftFloor, TiltedBase, WobblyBase
from core.plant.faults.encoders import EccentricEncoders, EncoderOffsets, WarmingArm
from core.plant.faults.mounting import (
    LooseSensor,
    ShiftedSensor,
    ShiftedSensorWithPayload,
    SplitOrigin,
    TurnedSensor,
    TurnedSensorWithPayload,
)
from tests.core.plant.fault_oracle import CELL, EXACT, HOME, PAYLOAD, SIGNAL, clean, path, rigid, run, still
from tests.core.plant.plant_oracle import PinocchioArm

g = CELL.gravity
ROTATION = (0.02, -0.01, 0.03)
SHIFT = (0.004, -0.002, 0.003)


def turned(W, rotvec):
    R = Rotation.from_rotvec(rotvec)
    return np.hstack((R.apply(W[:, :3], inverse=True), R.apply(W[:, 3:], inverse=True)))


def moved(W, d):
    return np.hstack((W[:, :3], W[:, 3:] - np.cross(d, W[:, :3])))


def test_a_sensor_turned_alone_feels_the_same_wrench_in_other_axes():
    found = run(TurnedSensor(ROTATION))
    np.testing.assert_allclose(found.true_wrench[::9], turned(rigid(found), ROTATION), atol=EXACT)


def test_a_payload_turned_with_the_sensor_is_another_payload_to_the_nominal_frame():
    found = run(TurnedSensorWithPayload(ROTATION))
    phi = frame_change(Rotation.from_rotvec(ROTATION).as_matrix(), np.zeros(3)) @ PAYLOAD.phi
    np.testing.assert_allclose(found.true_wrench[::9], turned(rigid(found, phi), ROTATION), atol=EXACT)


def test_a_shifted_sensor_feels_another_torque_only():
    found = run(ShiftedSensor(SHIFT))
    np.testing.assert_allclose(found.true_wrench[::9], moved(rigid(found), SHIFT), atol=EXACT)


def test_a_payload_shifted_with_the_sensor_changes_by_the_motion_alone():
    found = run(ShiftedSensorWithPayload(SHIFT))
    phi = frame_change(np.eye(3), np.array(SHIFT)) @ PAYLOAD.phi
    np.testing.assert_allclose(found.true_wrench[::9], moved(rigid(found, phi), SHIFT), atol=EXACT)
    rest = slice(50, 150)
    np.testing.assert_allclose(found.true_wrench[rest], clean().true_wrench[rest], atol=1e-4)


def test_a_tilted_base_is_gravity_from_elsewhere():
    found = run(TiltedBase((0.02, -0.03)))
    gravity = Rotation.from_rotvec([0.02, -0.03, 0.0]).apply(g)
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found, gravity=gravity), atol=EXACT)


def test_a_soft_floor_leans_with_the_moment_of_the_weight():
    c = 1e-4
    found = run(SoftFloor((0.0, 0.0), c), along=still(HOME, 0.05))
    arm = PinocchioArm.of(CELL, PAYLOAD, g)
    com = np.array(pin.centerOfMass(arm.model, arm.data, HOME))
    mass = pin.computeTotalMass(arm.model)
    moment = np.cross(com, mass * g)
    gravity = Rotation.from_rotvec(-c * moment).apply(g)
    change = rigid(found, gravity=gravity, every=49)[-1] - rigid(found, every=49)[-1]
    assert np.abs(change).max() > 0.02
    np.testing.assert_allclose(found.true_wrench[49] - clean().true_wrench[49], change, rtol=0.02, atol=1e-4)


def test_encoder_offsets_are_another_pose_of_the_arm():
    offset = np.radians([0.0, 1.0, 0.0, -0.5, 0.0, 2.0, 0.3])
    found = run(EncoderOffsets(tuple(offset)))
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found, offset=offset), atol=EXACT)
    np.testing.assert_allclose(found.q, clean().q, atol=2e-5)


def test_eccentric_encoders_err_once_a_turn_on_top_of_it():
    offset = np.radians([0.0, 1.0, 0.0, -0.5, 0.0, 2.0, 0.3])
    found = run(EccentricEncoders(tuple(offset), seed=4))
    phase = np.random.default_rng(4).uniform(0, 2 * np.pi, 7)
    np.testing.assert_allclose(found.q, found.true_q - offset * np.sin(found.true_q + phase), atol=2e-5)
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found, offset=offset), atol=EXACT)
    assert np.abs(found.q - path()).max() < 2e-3


@pytest.mark.parametrize("axis", [0, 1])
def test_a_loose_sensor_rocks_with_the_torque(axis):
    fault = LooseSensor(ROTATION, 0.01, axis, 0.3)
    firm = turned(rigid(run(fault)), ROTATION)
    expected = [turned(W[None], 0.01 * np.tanh(W[3 + axis] / 0.3) * np.eye(3)[axis])[0] for W in firm]
    felt = fault.sense(SIGNAL)
    np.testing.assert_allclose([felt(0.0, W) for W in firm], expected, atol=1e-9)
    truth = run(fault)
    np.testing.assert_allclose(truth.true_wrench[::9], firm, atol=EXACT)
    assert np.abs(np.array(expected) - firm).max() > 0.05


def test_a_split_origin_takes_two_torques_about_two_points():
    fault = SplitOrigin(SHIFT, 0.003)
    firm = rigid(run(fault))
    height = np.array([0, 0, 0.003])
    above, below = np.array(SHIFT) + height, np.array(SHIFT) - height
    expected = moved(firm, SHIFT)
    expected[:, 3], expected[:, 4] = moved(firm, above)[:, 3], moved(firm, below)[:, 4]
    felt = fault.sense(SIGNAL)
    np.testing.assert_allclose([felt(0.0, W) for W in moved(firm, SHIFT)], expected, atol=1e-9)
    np.testing.assert_allclose(run(fault).true_wrench[::9], moved(firm, SHIFT), atol=EXACT)


@pytest.mark.parametrize(("edge", "side"), [(0.5, -1.0), (-0.5, 1.0), (0.0, 0.0)])
def test_a_wobbly_base_lies_on_the_side_where_the_arm_is(edge, side):
    found = run(WobblyBase((0.02, -0.03), (0.006, 0.008), edge), along=still(HOME, 0.05))
    gravity = Rotation.from_rotvec([0.02, -0.03, 0.0]).apply(g)
    gravity = Rotation.from_rotvec([0.006 * side, 0.008 * side, 0.0]).apply(gravity)
    np.testing.assert_allclose(found.true_wrench[40], rigid(found, gravity=gravity, every=40)[1], atol=2e-3)


def test_a_wobbly_base_tips_when_the_arm_passes_the_edge():
    found = run(WobblyBase((0.0, 0.0), (0.006, 0.008), 0.01))
    arm = PinocchioArm.of(CELL, PAYLOAD, g)
    com = np.array([pin.centerOfMass(arm.model, arm.data, q).copy() for q in found.true_q[::9]])
    way = (com - com[0]) @ [-0.8, 0.6, 0.0] - 0.01
    tipped = np.sign(way)[np.abs(way) > 0.015]
    assert len(tipped)
    for side, row in ((-1.0, way < -0.015), (1.0, way > 0.015)):
        gravity = Rotation.from_rotvec([0.006 * side, 0.008 * side, 0.0]).apply(g)
        np.testing.assert_allclose(found.true_wrench[::9][row], rigid(found, gravity=gravity)[row], atol=5e-3)


def test_a_warming_arm_is_off_by_more_and_more():
    offset = np.radians([0.0, 1.0, 0.0, -0.5, 0.0, 2.0, 0.3])
    found = run(WarmingArm(tuple(offset), 0.8, 0.7))
    grown = 1 - np.exp(-found.t / 0.7)
    np.testing.assert_allclose(found.q, found.true_q - 0.8 * np.outer(grown, offset), atol=2e-5)
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found, offset=offset), atol=EXACT)
    assert np.abs(found.q - path()).max() < 2e-3
