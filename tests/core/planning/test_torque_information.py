"""What motions are expected to tell through the joints' torques, and the waves that are chosen by it."""

from __future__ import annotations

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.errors import NoPath
from core.payload.inertia import InertialParameters
from core.planning.information import UNKNOWN_STD
from core.planning.stop import Wave, wave_shape
from core.planning.torque_information import TorqueInformation
from core.planning.torque_wave import choose_wave, list_waves
from core.planning.wave import fit_wave
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.robot.trajectory import JointTrajectory
from tests.synthetic import CELLS

CELL = load_cell(CELLS / "lwr4_bench")
ROBOT = RobotModel.of_cell(CELL)
COLLISION = CollisionModel(CELL, ROBOT, CELL.payload_box)
HOME = np.array(CELL.robot.home_rad)
BLOCK = InertialParameters.from_com(2.0, [0.0, 0.0, 0.05], np.diag([0.005, 0.006, 0.004]))
TOLD = TorqueInformation(CELL, ROBOT, BLOCK)
OPEN = Wave(seconds=6.0, lowest_hz=0.2, highest_hz=3.0, wrist=None)


def swing(*joints: int, seconds: float = 12.0, hz: float = 0.25, speed: float = 0.3) -> JointTrajectory:
    """Some joints to and fro about home."""
    t = np.arange(round(1000 * seconds) + 1) / 1000.0
    q = np.tile(HOME, (len(t), 1))
    for joint in joints:
        q[:, joint] += speed / (2.0 * np.pi * hz) * (1.0 - np.cos(2.0 * np.pi * hz * t)) / 2.0
    return JointTrajectory(0.001, q)


def test_a_robot_that_stands_tells_nothing() -> None:
    assert np.sqrt(np.diag(TOLD.find_covariance([swing()]))) == pytest.approx(UNKNOWN_STD[:10])


def test_the_mass_shows_in_joints_that_lift_it_and_not_in_the_one_whose_axis_passes_through_the_sensor() -> None:
    """About that axis a body is felt by the first moments across it and by the moment of inertia about it alone."""
    lifted, turned = (np.sqrt(np.diag(TOLD.find_covariance([motion]))) for motion in (swing(1, 3), swing(6)))
    assert lifted[0] < 0.1
    unseen = [0, 3, 4, 5, 6, 7, 8]
    assert turned[unseen] == pytest.approx(UNKNOWN_STD[unseen], rel=1e-6)
    assert (turned[[1, 2, 9]] < 0.1 * UNKNOWN_STD[[1, 2, 9]]).all()


def test_whatever_follows_leaves_no_more_open() -> None:
    first, more = swing(1, 3), swing(4, 5, 6, hz=0.8)
    assert TOLD.find_open([first, more]) < TOLD.find_open([first]) < TOLD.find_open([swing()])


def test_quick_turns_show_the_inertia_and_slow_ones_of_the_same_speed_do_not() -> None:
    def shake(wave: Wave) -> JointTrajectory:
        return JointTrajectory(0.001, HOME + 0.3 * wave_shape(wave, ROBOT.n, 0.001))

    slow, quick = shake(Wave(seconds=12.0, lowest_hz=0.1, highest_hz=0.3)), shake(Wave(seconds=12.0, lowest_hz=0.3, highest_hz=2.0))
    left_open = [np.trace(TOLD.find_covariance([each])[4:, 4:]) for each in (slow, quick)]
    assert left_open[1] < 0.25 * left_open[0]


def test_an_open_wave_stands_for_several_in_its_band() -> None:
    waves = list_waves(OPEN)
    assert len(set(waves)) == len(waves) > 4
    assert all(OPEN.lowest_hz <= each.lowest_hz < each.highest_hz <= OPEN.highest_hz for each in waves)
    assert {each.seconds for each in waves} == {6.0}


def test_a_stiff_wrist_turns_so_many_times_faster_than_the_first_joint() -> None:
    shape = wave_shape(Wave(seconds=5.0, wrist=16.0), 7, 0.001)
    speed = np.abs(np.gradient(shape, 0.001, axis=0)).max(axis=0)
    assert speed[[0, 6]] == pytest.approx([1.0 / 16.0, 1.0])
    assert speed[1:] / speed[:-1] == pytest.approx(np.full(6, 16.0 ** (1.0 / 6.0)))


def test_the_chosen_wave_is_the_one_that_leaves_least_open_and_keeps_every_limit() -> None:
    before = [swing(1, 3)]
    chosen, trajectory = choose_wave(CELL, ROBOT, COLLISION, BLOCK, HOME, OPEN, before)
    left_open = [
        TOLD.find_open([*before, fit_wave(CELL, ROBOT, COLLISION, HOME, wave_shape(each, ROBOT.n, 0.001), 0.001)])
        for each in list_waves(OPEN)
    ]
    assert TOLD.find_open([*before, trajectory]) == pytest.approx(min(left_open))
    assert max(left_open) > 1.5 * min(left_open)
    assert list_waves(OPEN)[int(np.argmin(left_open))] == chosen
    q = trajectory.q
    np.testing.assert_allclose(q[[0, -1]], [HOME, HOME], atol=1e-9)
    assert (np.abs(np.diff(q, axis=0)) / 0.001 <= ROBOT.velocity).all()
    assert min(COLLISION.margin(row) for row in q[::20]) >= 0.0


def test_without_room_for_any_of_them_it_is_refused_in_words() -> None:
    q = np.clip(np.full(ROBOT.n, 10.0), ROBOT.lower, ROBOT.upper)
    with pytest.raises(NoPath, match="rad"):
        choose_wave(CELL, ROBOT, COLLISION, BLOCK, q, OPEN, [JointTrajectory(0.001, np.tile(q, (100, 1)))])
