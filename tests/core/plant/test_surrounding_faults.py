"""What pulls at the payload or touches it, and mechanisms that no effect describes: what is felt, from Pinocchio and Eq. (1)."""

import numpy as np
import pinocchio as pin
import pytest
from scipy.spatial.transform import Rotation

from core.plant.faults.cable import HangingHose, Reel, SlackCable, SpringCable, TwistedHose
from core.plant.faults.contact import Bumps, Curtain, Cushion, GrowingTouch, Touch
from core.plant.faults.unknown_mechanism import (
    BentLink,
    CoupledWrist,
    Fan,
    NeighbouringPress,
    SlippingEncoders,
    SpinningRotor,
    SteelColumn,
    WarpingBase,
)
from tests.core.plant.fault_oracle import AWAY, CELL, EXACT, HOME, PAYLOAD, PERIOD, clean, point, rigid, run, sensor_pose, static, still
from tests.core.plant.plant_oracle import PinocchioArm

g = CELL.gravity


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


def test_a_reel_pulls_alike_at_any_distance_and_more_where_it_is_wound_off():
    anchor, grip = np.array([0.2, -0.3, 0.5]), np.array([0.0, 0.03, 0.06])
    found = run(Reel(4.0, 0.25, tuple(anchor), tuple(grip)))
    fixed = point(HOME, grip) + anchor
    excess = found.true_wrench - rigid(found, every=1)
    for k, friction in ((150, 0.0), (450, 1.0), (890, 0.0)):
        away = fixed - point(found.true_q[k], grip)
        wound_off = np.linalg.norm(away) - np.linalg.norm(fixed - point(found.true_q[k - 1], grip))
        pull = 4.0 * (1 + 0.25 * friction * np.sign(wound_off))
        force = pull * sensor_pose(found.true_q[k]).rotation.T @ away / np.linalg.norm(away)
        np.testing.assert_allclose(excess[k], -np.concatenate((force, np.cross(grip, force))), atol=0.02)


def test_a_cushion_pushes_the_more_the_farther_one_is_in_it():
    force, at, depth = np.array([0.0, -3.0, 4.0]), np.array([0.02, 0.05, 0.08]), 0.15
    found = run(Cushion(tuple(force), tuple(at), 0.1, 1.0, depth))
    excess = found.true_wrench - rigid(found, every=1)
    first = point(HOME, at)
    shares = []
    for k in (150, 400, 500, 800):
        shares.append(np.clip(1 - (point(found.true_q[k], at) - first) @ force / (5.0 * depth), 0.0, 2.0))
        pushed = shares[-1] * sensor_pose(found.true_q[k]).rotation.T @ force
        np.testing.assert_allclose(excess[k, :3], -pushed, atol=0.04)
    assert np.ptp(shares) > 0.2
    np.testing.assert_allclose(excess[[50, 1300]], 0.0, atol=EXACT)


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


def test_a_rotor_resists_the_turning_of_its_axis():
    h = np.array([0.1, -0.2, 0.15])
    found = run(SpinningRotor(tuple(h)))
    excess = found.true_wrench - rigid(found, every=1)
    for k in (150, 400, 500, 1100):
        # forces are those of the motion one period ago
        before, then, now = (sensor_pose(found.true_q[row]).rotation for row in (k - 2, k - 1, k))
        omega = Rotation.from_matrix(then @ before.T).as_rotvec() / PERIOD
        np.testing.assert_allclose(excess[k], [0, 0, 0, *now.T @ np.cross(omega, then @ h)], atol=1e-3)
    assert np.abs(excess[:, 3:]).max() > 0.05


def test_a_press_next_door_shakes_the_floor_and_the_floor_rings_out():
    shock = np.array([0.4, -0.3, 0.0])
    found = run(NeighbouringPress(tuple(shock), 0.6, 0.1, 8.0, 0.1), along=still(HOME, 1.0))
    for k, since in ((90, 0.0), (131, 0.031), (300, 0.2), (731, 0.031)):
        a = np.exp(-since / 0.1) * np.sin(2 * np.pi * 8.0 * since) * shock
        np.testing.assert_allclose(found.true_wrench[k], rigid(found, gravity=g - a, every=k)[1], atol=5e-3)
    assert np.abs(found.true_wrench[131] - found.true_wrench[90]).max() > 0.3


def test_a_fan_blows_along_the_panels_normal_with_the_square_of_the_wind_across_it():
    normal, wind = np.array([0.6, 0.0, 0.8]), np.array([1.0, -2.0, 3.0])
    found = run(Fan(0.3, tuple(wind), tuple(normal)), along=still(HOME, 0.1))
    across = (sensor_pose(HOME).rotation @ normal) @ wind
    force = 0.3 * across * abs(across) * normal
    expected = static(PAYLOAD.mass, PAYLOAD.first_moment) - np.concatenate((force, np.cross(PAYLOAD.com, force)))
    np.testing.assert_allclose(found.true_wrench[-1], expected, atol=3e-3)


def test_a_panel_that_moves_feels_the_air():
    found = run(Fan(20.0, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)))
    excess, k = (found.true_wrench - rigid(found, every=1)), 450
    # forces are those of the motion one period ago
    v = (point(found.true_q[k - 1], PAYLOAD.com) - point(found.true_q[k - 2], PAYLOAD.com)) / PERIOD
    facing = sensor_pose(found.true_q[k - 1]).rotation[:, 2]
    across = facing @ v
    assert abs(20.0 * across * abs(across)) > 0.2
    resistance = 20.0 * across * abs(across) * sensor_pose(found.true_q[k]).rotation.T @ facing
    np.testing.assert_allclose(excess[k, :3], resistance, atol=0.005)


def test_a_hanging_hose_pulls_as_a_chain_of_its_length_that_ends_at_its_anchor():
    weight, length = 4.0, 1.1
    anchor, grip = np.array([0.25, -0.4, 0.5]), np.array([0.0, 0.03, 0.06])
    found = run(HangingHose(weight, length, tuple(anchor), tuple(grip)))
    excess = found.true_wrench - rigid(found, every=1)
    fixed = point(HOME, grip) + anchor
    for k in (150, 890, 1350):
        pull = -sensor_pose(found.true_q[k]).rotation @ excess[k, :3]
        np.testing.assert_allclose(excess[k, 3:], np.cross(grip, excess[k, :3]), atol=2e-3)
        # link by link from the grip: each carries what the one before pulls and its own weight
        s = length * (np.arange(4000) + 0.5) / 4000
        tension = pull + np.outer(weight * s, [0.0, 0.0, 1.0])
        end = point(found.true_q[k], grip) + length / 4000 * (tension / np.linalg.norm(tension, axis=1)[:, None]).sum(0)
        np.testing.assert_allclose(end, fixed, atol=3e-3)


def test_a_curtain_pushes_back_and_rubs_only_while_one_is_in_it():
    at = np.array([0.02, 0.05, 0.08])
    there = point(HOME + AWAY, at) - point(HOME, at)
    way = there / np.linalg.norm(there)
    outward = -(way + 0.5 * np.cross(way, [0, 0, 1])) / np.linalg.norm(way + 0.5 * np.cross(way, [0, 0, 1]))
    found = run(Curtain(6.0, tuple(outward), 0.02, 0.1, 0.4, tuple(at)))
    excess = found.true_wrench - rigid(found, every=1)
    felt, inside = [], []
    for k in (150, 400, 450, 500, 850, 1000, 1350):
        # forces are those of the motion one period ago
        before, place = point(found.true_q[k - 2], at), point(found.true_q[k - 1], at)
        v = (place - before) / PERIOD
        along = v - outward * (outward @ v)
        speed = np.linalg.norm(along)
        inside.append(outward @ (point(HOME, at) - place) - 0.02)
        rubbing = 0.4 * along / speed if speed > 0.05 else np.zeros(3)
        force = sensor_pose(found.true_q[k]).rotation.T @ (6.0 * np.clip(inside[-1] / 0.1, 0.0, 1.0) * (outward - rubbing))
        np.testing.assert_allclose(excess[k], -np.concatenate((force, np.cross(at, force))), atol=0.05)
        felt.append(np.linalg.norm(force))
    assert felt[0] == 0.0
    assert max(felt) > 3.0
    assert max(inside) > 0.05


def test_a_steel_column_pulls_with_the_fourth_power_of_nearness_and_level():
    at, towards = np.array([0.02, 0.05, 0.08]), np.array([0.6, -0.8, 0.0])
    found = run(SteelColumn(1.5, tuple(towards), 0.25, tuple(at)))
    excess = found.true_wrench - rigid(found, every=1)
    pulls = []
    for k in (150, 450, 890, 1350):
        nearer = towards @ (point(found.true_q[k], at) - point(HOME, at))
        pulls.append(1.5 / (1 - nearer / 0.25) ** 4)
        force = sensor_pose(found.true_q[k]).rotation.T @ (pulls[-1] * towards)
        np.testing.assert_allclose(excess[k], -np.concatenate((force, np.cross(at, force))), atol=0.03)
    assert pulls[0] == pytest.approx(1.5, abs=0.01)
    assert max(pulls) / min(pulls) > 1.2


def test_a_coupled_wrist_turns_along_with_the_joint_before():
    found = run(CoupledWrist(5, 0.015))
    ahead = found.true_q - found.q
    np.testing.assert_allclose(ahead[:, 5], 0.015 * found.true_q[:, 4], atol=2e-5)
    np.testing.assert_allclose(np.delete(ahead, 5, axis=1), 0.0, atol=2e-5)
    assert np.ptp(ahead[:, 5]) > 0.005
    np.testing.assert_allclose(found.true_wrench[::9], rigid(found), atol=EXACT)
