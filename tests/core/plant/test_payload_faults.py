"""Payloads that are others, do not stay so or are not rigid: Eq. (1) and closed-form oscillators say what is felt."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.plant.faults.loose import IdleRoller, Pendulum, Rattle, RubberTool, Slosh, SprungPart, WhippingTool
from core.plant.faults.payload import ForgottenPart, Leak, MassStep, OtherDensity, Slide, Slip
from tests.core.plant.fault_oracle import AWAY, EXACT, HOME, PAYLOAD, clean, felt_gravity, rigid, run, static, still
from tests.core.plant.plant_oracle import smooth_move


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


@pytest.mark.parametrize("half_angle", [0.4, 2.0])
def test_what_swings_in_a_vessel_hangs_down_or_lies_at_its_wall(half_angle):
    pose = HOME + 1.0 * np.eye(7)[5]  # tilts the vessel by about a radian
    down = felt_gravity(pose) / 9.81
    tilt = np.arccos(down[2])
    assert 0.8 < tilt < 1.2
    pivot, length = np.array([0.02, 0.0, 0.05]), 0.05
    found = run(Slosh(0.2, length, tuple(pivot), 0.3, half_angle), along=np.vstack((smooth_move(HOME, pose, 0.6), still(pose, 2.0))))
    lies = Rotation.from_rotvec(min(half_angle / tilt, 1.0) * tilt * np.cross([0, 0, 1], down) / np.sin(tilt)).apply([0, 0, 1])
    m = PAYLOAD.mass
    expected = static(m, PAYLOAD.first_moment + 0.2 * m * (pivot + length * lies - PAYLOAD.com), found.true_q[-1])
    np.testing.assert_allclose(found.true_wrench[-1], expected, atol=5e-3)


def test_a_roller_lets_its_heavy_side_down_and_stays_where_its_axis_is_upright():
    m, mc = PAYLOAD.mass, PAYLOAD.first_moment
    axis, lever = np.array([0.6, 0.0, 0.8]), 0.03 * np.array([0.0, 1.0, 0.0])
    down = felt_gravity(HOME) - axis * (axis @ felt_gravity(HOME))
    low = 0.03 * down / np.linalg.norm(down)
    found = run(IdleRoller(0.2, tuple(axis), tuple(lever), 0.0, 0.1), along=still(HOME, 0.05))
    np.testing.assert_allclose(found.true_wrench[-1], static(m, mc + 0.2 * m * (low - lever)), atol=3e-3)
    upright = felt_gravity(HOME) / 9.81
    lever = 0.03 * np.cross(upright, [0.0, 1.0, 0.0])
    found = run(IdleRoller(0.2, tuple(upright), tuple(lever), 0.1, 0.1), along=still(HOME, 0.05))
    np.testing.assert_allclose(found.true_wrench[-1], static(m, mc), atol=3e-3)


def test_a_roller_in_a_dry_bearing_stops_where_friction_holds_its_heavy_side():
    down = felt_gravity(HOME) / 9.81
    axis = np.cross(down, [0.0, 1.0, 0.0]) / np.linalg.norm(np.cross(down, [0.0, 1.0, 0.0]))
    lever = 0.03 * np.cross(axis, down)  # level with the axis to begin with
    found = run(IdleRoller(0.2, tuple(axis), tuple(lever), 0.2, 0.6), along=still(HOME, 0.05))
    moved = (found.true_wrench[-1] - static(PAYLOAD.mass, PAYLOAD.first_moment))[3:]
    # what the weight of the lever still weighs about the axis is not more than the friction
    about = axis @ moved / (0.2 * PAYLOAD.mass * 9.81 * 0.03)
    level = axis @ np.cross(lever, -felt_gravity(HOME)) / (9.81 * 0.03)
    assert abs(about + level) <= 0.2 + 0.01
    assert abs(about) > 0.5
