from dataclasses import replace

import numpy as np
import pytest

from core.errors import BadRecording, BadState
from core.recording.recording import Recording
from core.sessions.replay import ReplaySession


@pytest.fixture
def recording():
    rng = np.random.default_rng(0)
    t = 5.0 + 0.002 * np.arange(40)
    q = np.column_stack((np.sin(t), np.cos(2 * t)))
    return Recording(
        t=t,
        gravity=np.array([0, 0, -9.81]),
        wrench=rng.standard_normal((40, 6)),
        q=q,
        dq=rng.standard_normal((40, 2)),
        q_cmd=q + 0.1,
        tau=rng.standard_normal((40, 2)),
        temperature=20 + rng.standard_normal(40),
    )


def states(session):
    return [session.state() for _ in range(len(session))]


def test_a_recording_comes_back_sample_by_sample(recording):
    with ReplaySession(recording) as session:
        assert session.period == pytest.approx(0.002)
        played = states(session)
    assert len(played) == 40
    for name in ("t", "q", "dq", "q_cmd", "wrench", "tau", "temperature"):
        np.testing.assert_array_equal([getattr(state, name) for state in played], getattr(recording, name))


def test_what_was_not_recorded_is_derived_or_absent(recording):
    sparse = replace(recording, dq=None, q_cmd=None, tau=None, temperature=None)
    with ReplaySession(sparse) as session:
        played = states(session)
    t = recording.t[1:-1]
    dq = np.array([state.dq for state in played])[1:-1]
    np.testing.assert_allclose(dq, np.column_stack((np.cos(t), -2 * np.sin(2 * t))), atol=1e-4)
    for state in played:
        np.testing.assert_array_equal(state.q_cmd, state.q)
        assert state.tau is None and state.temperature is None


def test_after_the_last_sample_it_says_that_the_recording_has_ended(recording):
    with ReplaySession(recording) as session:
        states(session)
        assert len(session) == 0
        with pytest.raises(BadState, match=r"ends after 40 samples, at t = 5\.078 s"):
            session.state()


def test_every_entry_begins_anew(recording):
    session = ReplaySession(recording)
    with session:
        states(session)
    with session:
        assert session.state().t == 5.0


def test_commands_are_checked_and_change_nothing(recording):
    with ReplaySession(recording) as session:
        session.command(np.array([9.0, 9.0]))
        np.testing.assert_array_equal(session.state().q_cmd, recording.q_cmd[0])
        for bad in ([np.nan, 0.0], [0.0], [0.0, 0.0, 0.0]):
            with pytest.raises(BadState, match="2 finite joint positions"):
                session.command(np.array(bad))


def test_after_a_stop_commands_are_refused_but_the_recording_goes_on(recording):
    with ReplaySession(recording) as session:
        session.state()
        session.stop()
        assert session.state().t == recording.t[1]
        with pytest.raises(BadState, match="after a stop"):
            session.command(recording.q[1])
        session.release()
        session.command(recording.q[1])


@pytest.mark.parametrize("column", ["q", "wrench"])
def test_a_recording_that_no_robot_state_can_be_made_of_is_refused(recording, column):
    with pytest.raises(BadRecording, match=f"recording: {column}"):
        ReplaySession(replace(recording, **{column: None}))


def test_a_recording_of_one_sample_has_no_period(recording):
    with pytest.raises(BadRecording, match="at least two"):
        ReplaySession(replace(recording, t=recording.t[:1], q=recording.q[:1], wrench=recording.wrench[:1]))


def test_outside_of_the_session_nothing_can_be_asked(recording):
    session = ReplaySession(recording)
    with pytest.raises(RuntimeError, match="with session"):
        session.state()
    with pytest.raises(RuntimeError, match="with session"):
        session.command(recording.q[0])
