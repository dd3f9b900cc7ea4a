"""The loop with the virtual robot: dynamics, noise, a controller that lags, drives that brake by themselves."""

from __future__ import annotations

import numpy as np
import pytest

from core.control.bounds import JointLimits
from core.control.execute import execute
from core.control.movers import Playback, StandStill
from core.control.rotation import Rotation
from core.errors import TooClose
from core.robot.decoupling import decoupling_profile
from core.robot.trajectory import JointTrajectory
from core.sessions.simulated import SimulatedSession
from tests.core.control.kinematic_session import CELLS, PERIOD, approach, bench


def session_of(name: str) -> SimulatedSession:
    cell = bench(name).cell
    return SimulatedSession(cell, cell.payloads["steel_block"].parameters, seed=1)


@pytest.mark.parametrize("name", CELLS)
@pytest.mark.parametrize("seed", range(4))
def test_it_comes_to_rest_outside_the_clearance(name, seed):
    it = bench(name)
    q = approach(name, seed)
    guard = it.guard()
    with session_of(name) as session:
        with pytest.raises(TooClose):
            list(execute(session, guard, Playback(JointTrajectory(PERIOD, q)), "transfer"))
        session.release()
        rest = [session.state().q for _ in range(50)]
    margins = [it.collision.margin(q) for q in rest]
    assert min(margins) >= 0.0
    assert guard.record.min_margin_m >= 0.0


@pytest.mark.parametrize(("name", "axis"), [("lwr4_bench", 0), ("lwr4_bench", 1), ("lwr4_bench", 2), ("ur5e_line", 2)])
def test_a_decoupling_motion_passes_the_guard_and_reaches_its_acceleration(name, axis):
    it = bench(name)
    speed = it.cell.limits.cartesian_speed_m_s
    profile = decoupling_profile(it.cell.payload_box, cartesian_speed=speed, period=PERIOD)
    limits = JointLimits.of(it.cell, it.robot)
    mover = Rotation(it.robot, it.collision.points, limits, cartesian_speed=speed, profile=profile, axis=axis)
    guard = it.guard()
    states = []
    with session_of(name) as session:
        for phase, motion in (("hold:free", StandStill(0.1, PERIOD)), ("rotate", mover), ("hold:free", StandStill(0.2, PERIOD))):
            for batch in execute(session, guard, motion, phase):
                states += batch.states
    poses = it.robot.sensor_poses(np.array([state.q for state in states]))
    assert np.abs(poses.position - poses.position[0]).max() < 5e-4
    swing = np.arccos(np.clip((np.trace(poses.rotation[0].T @ poses.rotation, axis1=1, axis2=2) - 1) / 2, -1, 1))
    assert swing.max() == pytest.approx(profile.angle.max(), abs=2e-3)
    assert guard.record.max_speed_m_s <= speed
    assert guard.record.ticks == len(states)
