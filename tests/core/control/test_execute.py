from __future__ import annotations

import numpy as np
import pytest

from core.control.execute import execute
from core.control.movers import Playback, StandStill
from core.errors import BadState, TooFast
from core.robot.trajectory import JointTrajectory
from core.sessions.session import RobotState
from tests.core.control.kinematic_session import PERIOD, KinematicSession, bench, spoiled_after


def swing(n: int = 120) -> np.ndarray:
    t = np.linspace(0, 1, n)
    return bench().home + 0.004 * np.sin(np.pi * t)[:, None] ** 2


def test_all_samples_come_in_order_in_batches_of_one_phase():
    session = KinematicSession(bench().home)
    batches = list(execute(session, bench().guard(), Playback(JointTrajectory(PERIOD, swing())), "transfer", batch=50))
    assert [len(batch.states) for batch in batches] == [50, 50, 20]
    assert {batch.phase for batch in batches} == {"transfer"}
    states = [state for batch in batches for state in batch.states]
    np.testing.assert_allclose([state.t for state in states], PERIOD * np.arange(120))
    np.testing.assert_array_equal(np.array([state.q for state in states]), swing())
    assert session.stops == 0


def test_every_row_of_the_trajectory_is_commanded_once():
    session = KinematicSession(bench().home)
    list(execute(session, bench().guard(), Playback(JointTrajectory(PERIOD, swing())), "transfer"))
    np.testing.assert_array_equal(np.array(session.commands), swing()[1:])


def test_a_consumer_that_goes_away_stops_the_robot():
    session = KinematicSession(bench().home)
    running = execute(session, bench().guard(), StandStill(1.0, PERIOD), "hold:free")
    next(running)
    running.close()
    assert session.stops == 1
    assert len(session.commands) == 50


def test_an_interrupt_stops_the_robot():
    def interrupt(state: RobotState) -> RobotState:
        if state.t > 0.02:
            raise KeyboardInterrupt
        return state

    session = KinematicSession(bench().home, interrupt)
    with pytest.raises(KeyboardInterrupt):
        list(execute(session, bench().guard(), StandStill(1.0, PERIOD), "hold:free"))
    assert session.stops == 1


def test_an_error_of_the_mover_stops_the_robot():
    session = KinematicSession(bench().home + 0.1)
    with pytest.raises(BadState, match="Plan again from where the robot stands"):
        list(execute(session, bench().guard(), Playback(JointTrajectory(PERIOD, swing())), "transfer"))
    assert session.stops == 1
    assert session.commands == []


def test_after_a_fault_the_samples_up_to_it_are_handed_over_before_the_error():
    session = KinematicSession(bench().home, spoiled_after(0.0695, dq=9.0 * np.ones(7)))
    states: list[RobotState] = []
    with pytest.raises(TooFast) as caught:
        for batch in execute(session, bench().guard(), StandStill(1.0, PERIOD), "hold:free", batch=50):
            states += batch.states
    assert len(states) == 71
    assert caught.value.samples[-1] is states[-1]


def test_after_release_the_robot_moves_again():
    session = KinematicSession(bench().home, spoiled_after(0.01, dq=9.0 * np.ones(7)))
    guard = bench().guard()
    with pytest.raises(TooFast):
        list(execute(session, guard, StandStill(1.0, PERIOD), "hold:free"))
    session.spoil = lambda state: state
    session.release()
    assert sum(len(batch.states) for batch in execute(session, guard, StandStill(0.1, PERIOD), "hold:free")) == 101


def test_a_mover_made_for_another_period_is_refused():
    session = KinematicSession(bench().home)
    with pytest.raises(ValueError, match="periods differ"):
        next(execute(session, bench().guard(), StandStill(1.0, 0.002), "hold:free"))
    assert session.commands == []
