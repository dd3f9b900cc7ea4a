"""Faults of mounting, joints, payload and surroundings: Pinocchio, Eq. (1) written out and closed-form oscillators say what is felt."""

import numpy as np
import pinocchio as pin
import pytest
from fault_oracle import AWAY, CELL, HOME, PAYLOAD, clean, path, rigid, run, sensor_pose, still
from plant_oracle import PinocchioArm, smooth_move
from scipy import optimize
from scipy.spatial.transform import Rotation

from core.inertia import frame_change
from core.plant.faults.environment import Bumps, GrowingTouch, SlackCable, SpringCable, Touch, TwistedHose
from core.plant.faults.joints import DeadZone, DryFriction, ElasticJoints, HardeningJoints, LuGre, PlayByLoad, Ripple, UnevenRipple
from core.plant.faults.loose import Pendulum, Rattle, RubberTool, SprungPart, WhippingTool
from core.plant.faults.mounting import (
    EccentricEncoders,
    EncoderOffsets,
    ShiftedSensor,
    ShiftedSensorWithPayload,
    SoftFloor,
    TiltedBase,
    TurnedSensor,
    TurnedSensorWithPayload,
)
from core.plant.faults.payload import ForgottenPart, Leak, MassStep, OtherDensity, Slide, Slip
from core.plant.faults.unknown import BentLink, SlippingEncoders, WarpingBase

EXACT = 1e-6
ROTATION = (0.02, -0.01, 0.03)
SHIFT = (0.004, -0.002, 0.003)
g = CELL.gravity


def felt_gravity(q):
    return sensor_pose(q).rotation.T @ g


def static(mass, first_moment, q=HOME):
    force = -mass * felt_gravity(q)
    return np.concatenate((force, np.cross(first_moment, -felt_gravity(q))))


def gravity_torque(q):
    arm = PinocchioArm.of(CELL, PAYLOAD, g)
    return np.array(pin.computeGeneralizedGravity(arm.model, arm.data, q))


def turned(W, rotvec):
    R = Rotation.from_rotvec(rotvec)
    return np.hstack((R.apply(W[:, :3], inverse=True), R.apply(W[:, 3:], inverse=True)))


def moved(W, d):
    return np.hstack((W[:, :3], W[:, 3:] - np.cross(d, W[:, :3])))


# mounting


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


# joints


def test_elastic_joints_sag_by_the_load_over_the_stiffness_and_the_wrench_is_that_of_the_links():
    K = np.array([4e3, 3e3, 5e3, 2e3, 6e3, 4e3, 3e3])
    found = run(ElasticJoints(tuple(K)))
    sag = found.true_q[150] - found.q[150]
    np.testing.assert_allclose(sag, -gravity_torque(found.true_q[150]) / K, atol=2e-5)
    assert np.abs(sag).max() > 1e-3
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found), atol=EXACT)
    assert np.abs(found.q - path()).max() < 2e-3


def test_hardening_joints_sag_less_under_more_load():
    K, h, w = 3e3, 2.5, 1e-3
    found = run(HardeningJoints((K,) * 7, h, w))
    load = gravity_torque(found.true_q[150])
    for k in range(7):
        sag = optimize.brentq(lambda x, k=k: K * x + K * (h - 1) * (x - w * np.tanh(x / w)) + load[k], -0.1, 0.1)
        assert abs(found.true_q[150, k] - found.q[150, k] - sag) < 3e-5
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found), atol=EXACT)


def test_a_link_with_play_lies_on_the_side_to_which_its_weight_pulls():
    half, K = np.zeros(7), 2e4
    half[1], half[3] = 8e-4, 5e-4
    found = run(DeadZone(tuple(half), K))
    load = gravity_torque(found.true_q[150])
    for k in (1, 3):
        expected = -np.sign(load[k]) * half[k] - load[k] / K
        assert abs(found.true_q[150, k] - found.q[150, k] - expected) < 2e-5
    np.testing.assert_allclose(found.true_q[150, 0], found.q[150, 0], atol=2e-5)
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found), atol=EXACT)


def test_play_by_load_shows_between_encoder_and_link():
    half = np.full(7, 6e-4)
    found = run(PlayByLoad(tuple(half), 1.0))
    np.testing.assert_allclose((found.q - found.true_q)[150], half * np.tanh(found.true_tau[150]), atol=2e-5)
    assert abs((found.q - found.true_q)[150, 1]) > 5e-4


@pytest.mark.parametrize("ripple", [Ripple, UnevenRipple])
def test_ripple_is_periodic_in_the_joint(ripple):
    A, N, phase = (2e-4,) * 7, (160,) * 7, tuple(np.linspace(0, 3, 7))
    found = run(ripple(A, N, phase))
    q, p = found.true_q, np.array(phase)
    expected = 2e-4 * np.sin(160 * q + p)
    if ripple is UnevenRipple:
        expected = 2e-4 * (1 + 0.7 * np.sin(q + 2 * p)) * (np.sin(160 * q + p) + 0.5 * np.sin(320 * q))
    np.testing.assert_allclose(found.q - q, expected, atol=1.5e-5)
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found), atol=EXACT)
    # the drives see the speed that belongs to what they see of the position: they follow to a fraction of the ripple
    assert np.abs(found.q - path()).max() < 5e-4


def steady(speed, seconds=1.2):
    """Joint 1, whose axis stands upright, at constant speed after a short start."""
    t = 0.001 * np.arange(round(seconds * 1000))
    way = np.where(t < 0.4, speed * t**2 / 0.8, speed * (t - 0.2))
    return HOME + np.outer(way, np.eye(7)[0])


@pytest.mark.parametrize("speed", [0.3, -0.3])
def test_friction_costs_the_drive_its_torque(speed):
    along = steady(speed)
    fault = DryFriction((6.0, 0, 0, 0, 0, 0, 0), (4.0, 0, 0, 0, 0, 0, 0))
    extra = (run(fault, along=along).true_tau - run(along=along).true_tau)[-200:, 0].mean()
    assert abs(extra - (6.0 * np.sign(speed) + 4.0 * speed)) < 0.1


@pytest.mark.parametrize(("speed", "share"), [(0.3, 1.0), (-0.3, 1.0), (0.01, 1 + 0.5 * np.exp(-0.25))])
def test_lugre_friction_is_larger_at_low_speed(speed, share):
    along = steady(speed)
    fault = LuGre((6.0, 0, 0, 0, 0, 0, 0), 0.5, 0.02, 1e4)
    extra = (run(fault, along=along).true_tau - run(along=along).true_tau)[-200:, 0].mean()
    assert abs(extra - 6.0 * share * np.sign(speed)) < 0.15


def test_lugre_friction_leaves_an_arm_at_rest_at_rest():
    found = run(LuGre((6.0,) * 7, 0.5, 0.02, 1e4), along=still(HOME, 1.0))
    assert np.ptp(found.true_q[500:], axis=0).max() < 1e-7


# payload


def test_another_payload_is_felt_as_such():
    com = np.array([0.003, -0.002, 0.004])
    found = run(OtherDensity(0.1, tuple(com), 0.05))
    mass = 1.1 * PAYLOAD.mass
    phi = type(PAYLOAD).from_com(mass, PAYLOAD.com + com, 1.1 * 1.05 * PAYLOAD.inertia_com).phi
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found, phi), atol=EXACT)


def test_a_forgotten_part_is_a_point_mass():
    at = np.array([0.05, 0.02, 0.1])
    found = run(ForgottenPart(0.2, tuple(at)))
    phi = PAYLOAD.phi + type(PAYLOAD).from_com(0.2, at, 1e-9 * np.eye(3)).phi
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found, phi), atol=2e-3)


def test_a_part_that_slips_moves_the_first_moment_once():
    shift = np.array([0.02, -0.01, 0.005])
    found = run(Slip(0.3, tuple(shift), 0.05, 0.0))
    m, mc = PAYLOAD.mass, PAYLOAD.first_moment
    np.testing.assert_allclose(found.true_wrench[40], static(m, mc), atol=1e-3)
    np.testing.assert_allclose(found.true_wrench[190], static(m, mc + 0.3 * m * shift), atol=2e-3)
    np.testing.assert_allclose(run(Slip(0.3, (0, 0, 0), 0.05, 0.0)).true_wrench, clean().true_wrench, atol=1e-9)


def test_a_part_that_slides_is_half_way_after_half_the_time():
    shift = np.array([0.02, -0.01, 0.005])
    found = run(Slide(0.3, tuple(shift), 0.0, 2.0), along=still(HOME, 1.01))
    expected = static(PAYLOAD.mass, PAYLOAD.first_moment + 0.15 * PAYLOAD.mass * shift)
    np.testing.assert_allclose(found.true_wrench[1000], expected, atol=2e-3)


@pytest.mark.parametrize("change", [0.2, -0.2])
def test_what_comes_off_or_on_changes_mass_and_first_moment(change):
    at = np.array([0.03, 0.02, 0.08])
    found = run(MassStep(change, tuple(at), 0.05, 0.0), along=still(HOME, 0.4))
    m, mc = PAYLOAD.mass, PAYLOAD.first_moment
    np.testing.assert_allclose(found.true_wrench[40], static(m, mc), atol=1e-3)
    np.testing.assert_allclose(found.true_wrench[-1], static(m + change, mc + change * at), atol=4e-3)


def test_a_leak_takes_its_time():
    at = np.array([0.03, 0.02, 0.08])
    found = run(Leak(-0.2, tuple(at), 0.1, 0.8), along=still(HOME, 0.51))
    expected = static(PAYLOAD.mass - 0.1, PAYLOAD.first_moment - 0.1 * at)
    np.testing.assert_allclose(found.true_wrench[500], expected, atol=4e-3)


# payloads that are not rigid


def jerk(seconds):
    """A quick move, then rest."""
    end = HOME + 0.1 * AWAY
    return np.vstack((smooth_move(HOME, end, 0.15), still(end, seconds)))


def ringing_hz(signal):
    """The strongest frequency, by a padded spectrum."""
    signal = signal - signal.mean()
    spectrum = np.abs(np.fft.rfft(signal * np.hanning(len(signal)), 1 << 17))
    return float(np.fft.rfftfreq(1 << 17, 0.001)[np.argmax(spectrum)])


def test_a_sprung_part_sags_with_gravity_and_swings_at_its_frequency():
    axis = np.array([0.6, 0.0, 0.8])
    fault = SprungPart(0.2, tuple(axis), 3.0, 0.02)
    found = run(fault, along=jerk(4.0))
    m, mc = PAYLOAD.mass, PAYLOAD.first_moment
    sag = axis @ felt_gravity(HOME) / (6 * np.pi) ** 2 * axis
    assert np.linalg.norm(sag) > 0.005
    at_rest = run(fault, along=still(HOME, 0.01)).true_wrench[0]
    np.testing.assert_allclose(at_rest, static(m, mc + 0.2 * m * sag), atol=2e-3)
    assert abs(ringing_hz(found.true_wrench[200:, :3] @ axis) - 3.0) < 0.15


def test_a_pendulum_hangs_down_and_swings_with_its_length():
    pivot, length = np.array([0.02, 0.0, 0.05]), 0.05
    fault = Pendulum(0.2, length, tuple(pivot), 0.02)
    found = run(fault, along=jerk(4.0))
    m, mc = PAYLOAD.mass, PAYLOAD.first_moment
    down = felt_gravity(HOME) / 9.81
    hanging = mc + 0.2 * m * (pivot + length * down - PAYLOAD.com)
    at_rest = run(fault, along=still(HOME, 0.01)).true_wrench[0]
    np.testing.assert_allclose(at_rest, static(m, hanging), atol=2e-3)
    assert abs(ringing_hz(found.true_wrench[200:, 3]) / (np.sqrt(9.81 / length) / (2 * np.pi)) - 1) < 0.08


def test_a_rattling_part_lies_at_the_stop_to_which_gravity_pulls():
    down = felt_gravity(HOME) / 9.81
    for sign in (1, -1):
        axis = sign * down
        found = run(Rattle(0.2, tuple(axis), 0.01, 0.1), along=still(HOME, 0.05))
        moment = PAYLOAD.first_moment + 0.2 * PAYLOAD.mass * 0.01 * down
        np.testing.assert_allclose(found.true_wrench[-1], static(PAYLOAD.mass, moment), atol=5e-3)


def test_a_flexible_tool_rings():
    fault = WhippingTool(0.1, (0.0, 0.0, 0.0), (15.0, 19.0), 0.01)
    found = run(fault, along=jerk(2.0))
    assert np.abs((found.true_wrench - rigid(found, every=1))[200:400, 3:]).max() > 0.01
    assert 13.5 < ringing_hz(found.true_wrench[200:, 3] + found.true_wrench[200:, 4]) < 21.0


def test_a_tool_on_rubber_rings_along_its_axis():
    axis = np.array([0.8, 0.6, 0.0])
    found = run(RubberTool(0.1, tuple(axis), 15.0, 0.01), along=jerk(2.0))
    # a little faster than alone: the arm gives way too
    assert 14.5 < ringing_hz(found.true_wrench[200:, :3] @ axis) < 17.0


# surroundings


def test_a_touch_is_felt_with_the_opposite_sign_during_its_time():
    force, at = np.array([3.0, -2.0, 4.0]), np.array([0.02, 0.05, 0.08])
    found = run(Touch(tuple(force), tuple(at), 0.1, 0.3), along=still(HOME, 0.8))
    inward = sensor_pose(HOME).rotation.T @ force
    expected = -np.concatenate((inward, np.cross(at, inward)))
    calm = static(PAYLOAD.mass, PAYLOAD.first_moment)
    np.testing.assert_allclose(found.true_wrench[390] - calm, expected, atol=0.02)
    np.testing.assert_allclose(found.true_wrench[90] - calm, 0.0, atol=1e-3)
    np.testing.assert_allclose(found.true_wrench[790] - calm, 0.0, atol=0.02)


def test_a_growing_touch_is_half_as_strong_half_way_up():
    found = run(GrowingTouch((0, 0, 8.0), (0, 0, 0), 0.0, 2.0, 0.5), along=still(HOME, 1.05))
    calm = static(PAYLOAD.mass, PAYLOAD.first_moment)
    strength = np.linalg.norm((found.true_wrench - calm)[:, :3], axis=1) / 8.0
    np.testing.assert_allclose(strength[[500, 1000]], [0.5, 1.0], atol=0.01)


def test_bumps_are_short_and_not_stronger_than_the_force():
    found = run(Bumps((0, 0, 8.0), (0, 0, 0), 0.1, 1.2, 3, seed=2), along=still(HOME, 1.4))
    calm = static(PAYLOAD.mass, PAYLOAD.first_moment)
    strength = np.linalg.norm((found.true_wrench - calm)[:, :3], axis=1) / 8.0
    assert 0.5 < strength.max() < 1.1
    onsets = np.count_nonzero(np.diff((strength > 0.25).astype(int)) == 1)
    assert onsets == 3
    assert strength[:90].max() < 0.01


def test_a_cable_pulls_towards_its_anchor():
    anchor, grip = np.array([0.2, -0.3, 0.5]), np.array([0.0, 0.03, 0.06])
    found = run(SpringCable(6.0, 0.0, tuple(anchor), tuple(grip)))
    for k in (150, 890):
        R, p = sensor_pose(found.true_q[k]).rotation, sensor_pose(found.true_q[k]).position
        home = sensor_pose(HOME)
        fixed = home.position + home.rotation @ grip + anchor
        pull = R.T @ (6.0 * (fixed - p - R @ grip))
        expected = -np.concatenate((pull, np.cross(grip, pull)))
        np.testing.assert_allclose((found.true_wrench[k] - rigid(found, every=k)[1]), expected, atol=0.01)


def test_a_dragged_cable_rubs_against_the_motion():
    found = run(SpringCable(0.0, 0.7, (0.3, 0.0, 0.3), (0.0, 0.0, 0.05)))
    excess = found.true_wrench[::9] - rigid(found)
    k = 450 // 9  # the fastest moment of the way there
    pose = sensor_pose(found.true_q[450])
    v = (pose.rotation @ [0, 0, 0.05] + pose.position) - point(found.true_q[449], [0, 0, 0.05])
    np.testing.assert_allclose(excess[k, :3], 0.7 * pose.rotation.T @ (v / np.linalg.norm(v)), atol=0.02)
    np.testing.assert_allclose(excess[5], 0.0, atol=0.02)


def point(q, local):
    pose = sensor_pose(q)
    return pose.rotation @ local + pose.position


def test_a_slack_cable_does_nothing_within_reach_and_is_stiff_beyond():
    anchor = np.array([0.0, -0.3, 0.4])
    slack = run(SlackCable(30.0, 0.0, tuple(anchor), (0, 0, 0), 0.6), along=still(HOME, 0.3))
    np.testing.assert_allclose(slack.true_wrench[-1], static(PAYLOAD.mass, PAYLOAD.first_moment), atol=1e-3)
    taut = run(SlackCable(30.0, 0.0, tuple(anchor), (0, 0, 0), 0.4), along=still(HOME, 0.3))
    excess = taut.true_wrench[-1] - static(PAYLOAD.mass, PAYLOAD.first_moment)
    expected = -30.0 * 0.1 * sensor_pose(HOME).rotation.T @ (anchor / 0.5)
    np.testing.assert_allclose(excess[:3], expected, atol=0.01)


def test_a_twisted_hose_resists_the_last_joint():
    neutral = HOME[6] - 0.5
    found = run(TwistedHose(0.4, neutral, 0.0), along=still(HOME, 0.3))
    excess = found.true_wrench[-1] - static(PAYLOAD.mass, PAYLOAD.first_moment)
    # turned by +0.5 rad against it, the hose turns the payload back, and the sensor holds it
    np.testing.assert_allclose(excess, [0, 0, 0, 0, 0, 0.4 * 0.5 * (0.5 + 0.5 * 0.25)], atol=2e-3)


# unknown


def test_a_warping_base_leans_with_time():
    found = run(WarpingBase((0.02, -0.01), 0.5), along=still(HOME, 1.0))
    share = 1 - np.exp(-0.9 / 0.5)
    gravity = Rotation.from_rotvec([0.02 * share, -0.01 * share, 0]).apply(g)
    np.testing.assert_allclose(found.true_wrench[900], rigid(found, gravity=gravity, every=900)[1], atol=0.01)


def test_slipping_encoders_lose_the_more_the_faster():
    found = run(SlippingEncoders((0.0, 0.05, 0.0, 0.0, 0.0, 0.0, 0.0)))
    dq = found.true_dq[:, 1]
    lost = 0.05 * 0.001 * np.sum(dq * np.abs(dq))
    assert abs((found.true_q - found.q)[-1, 1] - lost) < 1e-4
    assert lost > 1e-3
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found), atol=EXACT)


def test_a_bent_link_turns_all_that_follows():
    bend = np.array([0.02, 0.0, -0.03])  # across joint 6, which turns about y
    found = run(BentLink(5, tuple(bend)))
    arm = PinocchioArm.of(CELL, PAYLOAD, g)
    arm.model.jointPlacements[6] = arm.model.jointPlacements[6] * pin.SE3(Rotation.from_rotvec(bend).as_matrix(), np.zeros(3))
    rows = range(0, len(found.t), 9)
    expected = [arm.wrench(PAYLOAD.phi, found.true_q[k], found.true_dq[k], found.true_ddq[k]) for k in rows]
    np.testing.assert_allclose(found.true_wrench[::9], expected, atol=EXACT)
    assert np.abs(found.true_wrench - clean().true_wrench).max() > 0.3
