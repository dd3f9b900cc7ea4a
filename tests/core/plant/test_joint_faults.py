"""Springs, play, toothing and friction of the joints: Pinocchio and closed forms say what is felt."""

import numpy as np
import pinocchio as pin
import pytest
from scipy import optimize

from core.plant.faults.joint_gears import DamagedTooth, DryFriction, FrictionByLoad, LoadedRipple, LuGre, Ripple, UnevenRipple
from core.plant.faults.joint_play import DeadZone, PlayByLoad, PlayByMotion, SplitGear
from core.plant.faults.joint_springs import CreepingJoints, ElasticJoints, HardeningJoints, LossyJoints, spring_damping
from tests.core.plant.fault_oracle import AWAY, CELL, EXACT, HOME, PAYLOAD, PERIOD, clean, path, rigid, run, still
from tests.core.plant.plant_oracle import PinocchioArm

g = CELL.gravity


def gravity_torque(q):
    arm = PinocchioArm.of(CELL, PAYLOAD, g)
    return np.array(pin.computeGeneralizedGravity(arm.model, arm.data, q))


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


def test_creeping_joints_give_way_at_once_and_go_on_giving_way():
    K, share, tau = 3e3, 0.8, 0.15
    found = run(CreepingJoints((K,) * 7, share, tau), along=np.vstack((path()[:900], still(path()[899], 2.0))))
    arm = PinocchioArm.of(CELL, PAYLOAD, g)
    motion = zip(found.true_q, found.true_dq, found.true_ddq, strict=True)
    load = np.array([pin.rnea(arm.model, arm.data, *row) for row in motion])
    sag = found.true_q - found.q
    np.testing.assert_allclose(sag[100], -load[100] / K, atol=2e-5)
    np.testing.assert_allclose(sag[-1], -load[-1] / K, atol=3e-5)
    # the standard linear solid under the load that there was, less what the damper beside the spring carried of it
    load += spring_damping(K) * np.gradient(sag, PERIOD, axis=0)
    crept = sag[0]
    for k in range(1, 1000):
        x = (share * K * crept - load[k]) / (K * (1 + share))
        crept = crept + (1 - np.exp(-PERIOD / tau)) * (x - crept)
        if k in (300, 500, 700, 800, 950):
            # the inertia of the wheel before the link is left out: some 0.1 N m while it speeds up
            np.testing.assert_allclose(sag[k], x, atol=4e-5)
    assert np.abs(sag[800] - sag[-1]).max() > 2e-4
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found), atol=EXACT)


def test_play_by_motion_is_used_up_in_the_direction_of_motion():
    half = np.full(7, 6e-4)
    found = run(PlayByMotion(tuple(half)))
    lead = found.q - found.true_q
    np.testing.assert_allclose(lead[150], 0.0, atol=3e-5)
    np.testing.assert_allclose(lead[450], np.sign(AWAY) * half, atol=2e-5)  # on the way there
    np.testing.assert_allclose(lead[1100], -np.sign(AWAY) * half, atol=2e-5)  # on the way back
    assert (np.abs(lead) <= half + 2e-5).all()
    np.testing.assert_allclose(found.true_wrench, clean().true_wrench, atol=1e-9)


def test_a_damaged_tooth_is_a_pulse_once_per_turn():
    A, N, phase = np.array([0, 2e-4, 0, 3e-4, 0, 0, -2e-4]), (50,) * 7, np.linspace(0, 3, 7)
    found = run(DamagedTooth(tuple(A), N, tuple(phase), 6.0))
    expected = A * np.exp(6.0 * (np.cos(50 * found.true_q + phase) - 1))
    np.testing.assert_allclose(found.q - found.true_q, expected, atol=1.5e-5)
    assert 1.5e-4 < np.abs(expected[:, 3]).max() <= 3e-4
    assert np.median(np.abs(expected[:, 3])) < 5e-5
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found), atol=EXACT)


@pytest.mark.parametrize("speed", [0.3, -0.3])
def test_friction_by_load_takes_its_share_of_the_torque(speed):
    along = steady(speed)
    without = run(along=along).true_tau[-200:, 0].mean()
    found = run(FrictionByLoad((3.0, 0, 0, 0, 0, 0, 0), (0.2, 0, 0, 0, 0, 0, 0)), along=along).true_tau[-200:, 0].mean()
    # tau = (what it took + dry) + share tau
    assert abs(found - (without + 3.0 * np.sign(speed)) / 0.8) < 0.15


def test_a_split_gear_has_no_play_below_its_preload_and_all_of_it_beyond():
    half, K, soft = 5e-4, 2e4, 0.05
    load = gravity_torque(HOME)
    assert abs(load[5]) < 3.0 < 3.0 + soft * K * half < abs(load[3])
    found = run(SplitGear((0, 0, 0, half, 0, half, 0), K, 3.0, soft))
    sag = (found.true_q - found.q)[150]
    # beyond: the preload, the soft springs over the play, and the teeth for the rest
    assert abs(sag[3] + np.sign(load[3]) * (half + (abs(load[3]) - soft * K * half) / K)) < 2e-5
    assert abs(sag[5] + load[5] / K) < 2e-5
    np.testing.assert_allclose(np.delete(sag, (3, 5)), 0.0, atol=2e-5)
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found), atol=EXACT)


def test_lossy_joints_come_back_on_another_line_however_slowly():
    K, reversal, bend = 3e3, 2.5, 8e-4
    along = np.vstack((path()[:900], path()[700:200:-1], still(HOME, 2.0)))
    found = run(LossyJoints((K,) * 7, reversal, bend), along=along)
    sag, load = found.true_q - found.q, gravity_torque(found.true_q[-1])
    np.testing.assert_allclose(sag[100], -load / K, atol=2e-5)
    lost = K * sag[-1] + load  # what the flexible wheel holds back
    height = (reversal - 1) * K * bend
    assert 0.1 * height < np.abs(lost).max() <= height  # ringing down has taken some of it away
    np.testing.assert_allclose(sag[-1], sag[-600], atol=2e-5)  # it stays, unlike creep
    # Dahl's equation by steps along the way that the joints went; the encoders' noise adds a little
    smooth = np.apply_along_axis(lambda x: np.convolve(x, np.full(15, 1 / 15), "valid"), 0, sag)
    for k in (1, 3, 5):
        z = 0.0
        for dx in np.diff(smooth[:, k]):
            z += (dx - abs(dx) * z) / bend
        assert abs(lost[k] + height * z) < 0.05 * height
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found), atol=EXACT)


def test_a_loaded_ripple_grows_with_the_weight_on_the_joint_and_changes_flanks_with_it():
    phase = np.linspace(0, 3, 7)
    found = run(LoadedRipple((3e-4,) * 7, (160,) * 7, tuple(phase), 4.0))
    arm = PinocchioArm.of(CELL, PAYLOAD, g)
    shares = []
    for k in range(140, 1400, 30):
        load = pin.nonLinearEffects(arm.model, arm.data, found.true_q[k], found.true_dq[k])
        shares.append(np.tanh(load / 4.0))
        expected = 3e-4 * shares[-1] * np.sin(160 * found.true_q[k] + phase)
        np.testing.assert_allclose((found.q - found.true_q)[k], expected, atol=2e-5)
    assert np.ptp(shares, axis=0).max() > 0.5
    assert abs(shares[0][0]) < 1e-6  # the first joint stands upright
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found), atol=EXACT)
