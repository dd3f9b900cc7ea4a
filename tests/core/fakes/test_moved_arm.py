"""How the arm behind every stand-in goes from command to command, and how it stops."""

from __future__ import annotations

from collections.abc import Generator

import numpy as np
import pytest

from core.array import Array
from core.cell.folder import load_cell
from core.estimation.kinematics import Poses, smooth_motion
from core.fakes.moved_arm import BRAKING, MovedArm
from core.fakes.ur_arm import PERIOD, UrArm
from core.payload.inertia import regressor
from core.robot.model import RobotModel
from tests.synthetic import CELLS

CELL = load_cell(CELLS / "ur5e_line")
CARRIED = CELL.payloads["steel_block"].parameters


class Obedient(MovedArm):
    """Goes where it is told."""

    def go(self, q: Array) -> None:
        before, self.target = self.target, q
        self._move(before)

    def stop(self) -> None:
        self._brake()
        for q in self._braking:
            self.go(q)


class Servoed(UrArm):
    """A program sends it on with `servoj`, as the driver's does."""

    wanted: Array

    def go(self, q: Array) -> None:
        self.wanted = q
        if not self.playing:
            self._program = self._follow()
        self.step()

    def _follow(self) -> Generator[None, None, None]:
        while True:
            yield from self._servo(self.wanted.tolist(), 0.0, 0.0, PERIOD, 0.03, 2000.0)


def find_lateness(arm: Obedient | Servoed) -> float:
    """By how much the forces of reports are late against what Newton's law says of their positions, s."""
    home, t = arm.target, arm.period * np.arange(round(6.0 / arm.period))
    swings = np.sin(2.0 * np.pi * np.outer(t, [1.1, 1.7, 0.9, 2.3, 1.4, 2.0])) * np.minimum(1.0, t)[:, None] ** 3
    samples = []
    for swing in swings:
        arm.go(home + 0.12 * swing)
        samples.append((arm.samples[-1].q, arm.samples[-1].wrench))
    q, wrench = (np.array(each) for each in zip(*samples, strict=True))
    pose = RobotModel.of_cell(CELL).sensor_poses(q)
    motion, _ = smooth_motion(Poses(t, pose.rotation, pose.position, CELL.gravity_in_base, np.zeros((6, 6))), window_s=0.03)
    rows = slice(round(1.25 / arm.period), -round(0.25 / arm.period))
    expected = (regressor(motion) @ CARRIED.phi)[:, :3]
    change = np.gradient(expected, arm.period, axis=0)[rows].ravel()
    off = (wrench[:, :3] - arm._robot.truth.offset[:3] - expected)[rows].ravel()
    return -float(change @ off) / float(change @ change)


@pytest.mark.parametrize("period", [0.002, 0.004, 0.005])
def test_force_and_positions_of_a_report_are_of_one_moment(period: float) -> None:
    """Forces that belong to another moment look like another mass."""
    assert abs(find_lateness(Obedient(CELL, CARRIED, 1, period))) < 3e-4


def test_so_they_are_where_a_program_of_universal_robots_follows_its_commands() -> None:
    assert abs(find_lateness(Servoed(CELL, CARRIED, 1))) < 3e-4


def test_it_goes_where_it_is_told_a_period_late_and_rests_there() -> None:
    arm = Obedient(CELL, None, 0, 0.005)
    home = arm.target
    for k in range(1, 101):
        arm.go(home + 0.001 * k)
    assert arm.moves
    np.testing.assert_allclose(arm.samples[-1].q_cmd, home + 0.001 * 99, atol=1e-12)
    for _ in range(100):
        arm.go(arm.target)
    assert not arm.moves
    np.testing.assert_allclose(arm.q, home + 0.1, atol=2e-3)
    assert arm.t == pytest.approx(1.0)


def test_a_stop_brakes_every_joint_at_its_limit() -> None:
    arm = Obedient(CELL, None, 0, 0.002)
    home = arm.target
    for k in range(1, 101):
        arm.go(home + 0.001 * k)  # 0.5 rad/s
    before = arm.target
    arm.stop()
    assert not arm.moves
    np.testing.assert_allclose(arm.target - before, 0.5**2 / (2.0 * BRAKING), rtol=0.1)
