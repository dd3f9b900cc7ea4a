"""A session under a lease moves only while somebody is in control."""

from __future__ import annotations

import os
import signal
import subprocess
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.cell.folder import load_cell
from core.errors import BadState, Cause, Commanded, ControlLost, Held, HoldExpired, Lateness, OutOfLimits, TooFast
from core.sessions.leased import FUTURE_S, LATE, LEASE_S, SERVICE_S, Lease, LeasedSession, Renewal, is_stopped
from core.sessions.simulated import SimulatedSession
from core.words import catalogue
from core.words.catalogue import LANGUAGES
from core.words.message import Message
from tests.hand_clock import HandClock


@pytest.fixture
def clock() -> HandClock:
    return HandClock()


@pytest.fixture
def lease(clock) -> Lease:
    return Lease(clock=clock, stopped=lambda _: True)


@pytest.fixture(scope="module")
def robot() -> SimulatedSession:
    cell = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
    return SimulatedSession(cell, cell.payloads["steel_block"].parameters)


def test_without_any_renewal_nothing_moves(lease):
    assert isinstance(lease.refusal(), ControlLost)


def test_a_renewal_lasts_as_long_as_the_lease_and_no_longer(lease, clock):
    assert lease.renew(Renewal(1, 0, clock.now))
    clock.now += 0.99 * LEASE_S
    assert lease.refusal() is None
    clock.now += 0.02 * LEASE_S
    assert isinstance(lease.refusal(), ControlLost)


def test_what_is_repeated_reordered_old_or_from_the_future_counts_for_nothing(lease, clock):
    assert lease.renew(Renewal(2, 5, clock.now))
    clock.now += 0.01
    for wrong in (
        Renewal(2, 5, clock.now),
        Renewal(2, 4, clock.now),
        Renewal(1, 9, clock.now),
        Renewal(2, 6, clock.now + 2 * FUTURE_S),
        Renewal(2, 6, clock.now - LEASE_S),
        Renewal(2, 6, clock.now - 0.02),
    ):
        assert not lease.renew(wrong), wrong
    assert lease.renew(Renewal(2, 6, clock.now))


@given(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 5), st.floats(-1.0, 1.0), st.floats(0.0, 0.3)), max_size=30))
def test_no_order_of_renewals_lets_a_command_through_later_than_a_lease_after_the_newest_true_one(sent):
    clock = HandClock()
    lease = Lease(clock=clock)
    newest = -np.inf
    for fence, number, offset, pause in sent:
        clock.now += pause
        stamp = clock.now + offset
        lease.renew(Renewal(fence, number, stamp))
        newest = max(newest, stamp) if stamp <= clock.now + FUTURE_S else newest
        if lease.refusal() is None:
            assert clock.now - newest <= LEASE_S


def test_a_hold_pauses_and_an_end_is_for_good(lease, clock):
    lease.renew(Renewal(1, 0, clock.now))
    lease.hold()
    assert isinstance(lease.refusal(), Held)
    lease.resume()
    assert lease.refusal() is None
    lease.end(Message.of("text", text="the operator asked for it."))
    lease.resume()
    assert isinstance(lease.refusal(), Commanded)


def test_what_was_late_holds_the_robot_until_it_is_told_to_go_on_whatever_comes_back_meanwhile(lease, clock):
    lease.renew(Renewal(1, 0, clock.now))
    clock.now += 1.2
    assert isinstance(lease.refusal(), ControlLost)
    lease.renew(Renewal(1, 1, clock.now))
    assert lease.held
    assert isinstance(lease.refusal(), Held)
    lease.resume()
    assert lease.refusal() is None


@pytest.mark.parametrize("cause", Cause)
def test_what_was_late_is_said_with_value_and_limit(lease, cause):
    lease.hold(Lateness(cause=cause, late_s=1.2, limit_s=1.0))
    said = lease.refusal().message
    assert said.code == LATE[cause]
    assert (said.parameters["value"], said.parameters["limit"]) == (1.2, 1.0)
    for language in LANGUAGES:
        assert said.say(language) != said.code


def test_nothing_is_worded_while_the_robot_is_commanded(lease, clock, robot, monkeypatch):
    """The first wording loads the catalogue, which takes longer than a control period."""

    def read(language: str, code: str) -> None:
        pytest.fail(f"{code} worded in {language}")

    monkeypatch.setattr(catalogue, "read_catalogue", read)
    session = LeasedSession(robot, lease)
    with session:
        q = session.state().q_cmd
        with pytest.raises(ControlLost):
            session.command(q)
        lease.resume()
        robot.release()
        for wrong, error in ((np.full_like(q, np.nan), BadState), (q + 0.1, TooFast), (q + 10.0, OutOfLimits), (q, BadState)):
            with pytest.raises(error):
                robot.command(wrong)
            if error is not OutOfLimits:
                robot.release()
        lease.hold()
        assert isinstance(lease.refusal(), Held)
        clock.now += 1000.0
        assert not lease.waits(1.0)
        assert isinstance(lease.refusal(), HoldExpired)


def looked_at(lease: Lease, clock: HandClock, seconds: float, *, beats: bool = True, every: float = 0.01) -> None:
    """Time goes by, and the control loop looks at its lease all the while."""
    for _ in range(round(seconds / every)):
        clock.now += every
        if beats:
            lease.beat(clock.now, 1)
        lease.look()


def test_lateness_is_put_down_to_the_network_where_the_service_lives_and_no_answer_comes(lease, clock):
    lease.renew(Renewal(1, 0, clock.now))
    looked_at(lease, clock, 1.02)
    found = lease.overdue()
    assert found.cause is Cause.NETWORK
    assert found.late_s == pytest.approx(1.02)
    assert found.limit_s == LEASE_S


def test_lateness_is_put_down_to_the_page_where_answers_come_but_the_page_behind_them_does_not_respond(lease, clock):
    lease.renew(Renewal(1, 0, clock.now))
    looked_at(lease, clock, 0.9)
    lease.note_late_page(2.9)
    looked_at(lease, clock, 0.12)
    assert lease.overdue() == Lateness(cause=Cause.PAGE, late_s=2.9, limit_s=LEASE_S)


def test_a_service_that_gives_no_sign_of_life_is_late_long_before_the_lease_ends(lease, clock):
    lease.renew(Renewal(1, 0, clock.now))
    looked_at(lease, clock, 0.1)
    looked_at(lease, clock, SERVICE_S - 0.01, beats=False)
    assert lease.overdue() is None
    looked_at(lease, clock, 0.02, beats=False)
    assert lease.overdue().cause is Cause.SERVICE
    assert lease.overdue().limit_s == SERVICE_S


def test_a_service_that_is_only_slow_has_as_long_as_the_console(clock):
    lease = Lease(clock=clock, stopped=lambda _: False)
    lease.renew(Renewal(1, 0, clock.now))
    looked_at(lease, clock, 0.1)
    looked_at(lease, clock, LEASE_S - 0.12, beats=False)
    assert lease.overdue() is None
    looked_at(lease, clock, 0.04, beats=False)
    assert lease.overdue().cause is Cause.SERVICE
    assert lease.overdue().limit_s == LEASE_S


def test_a_process_is_stopped_when_it_is_frozen_or_gone_and_not_while_it_sleeps():
    process = subprocess.Popen(["sleep", "60"])
    try:
        assert not is_stopped(process.pid)
        process.send_signal(signal.SIGSTOP)
        os.waitid(os.P_PID, process.pid, os.WSTOPPED)
        assert is_stopped(process.pid)
        process.send_signal(signal.SIGCONT)
        os.waitid(os.P_PID, process.pid, os.WCONTINUED)
        assert not is_stopped(process.pid)
    finally:
        process.kill()
        process.wait()
    assert is_stopped(process.pid)


def test_a_control_loop_that_got_no_time_does_not_blame_the_network(lease, clock):
    lease.renew(Renewal(1, 0, clock.now))
    looked_at(lease, clock, 0.1)
    clock.now += 1.5
    lease.look()
    found = lease.overdue()
    assert found.cause is Cause.CONTROL_PROCESS
    assert found.late_s == pytest.approx(1.5)


def test_a_loop_that_was_away_takes_the_renewals_that_came_meanwhile_before_it_judges(lease, clock, robot):
    def comes_in(_: float) -> None:
        lease.beat(clock.now, 1)

    session = LeasedSession(robot, lease, sleep=comes_in)
    with session:
        q = session.state().q_cmd
        lease.renew(Renewal(1, 0, clock.now))
        lease.beat(clock.now, 1)
        session.command(q)
        clock.now += 0.29
        session.state()
        session.command(q)
        assert not lease.held


def test_a_loop_that_was_away_for_longer_than_a_robots_watchdog_waits_does_not_go_on_by_itself(lease, clock, robot):
    session = LeasedSession(robot, lease)
    with session:
        q = session.state().q_cmd
        lease.renew(Renewal(1, 0, clock.now))
        session.command(q)
        session.state()  # the motion is over
        clock.now += 0.31  # the next one is prepared
        lease.renew(Renewal(1, 1, clock.now))
        session.state()
        session.command(q + 1e-4)
        clock.now += 0.31
        lease.renew(Renewal(1, 2, clock.now))
        session.state()
        with pytest.raises(ControlLost, match="got no time"):
            session.command(q + 2e-4)
        q = [session.state().q_cmd for _ in range(50)][-1]
        lease.resume()
        session.release()
        clock.now += 0.5  # planning, or a person who thinks
        lease.renew(Renewal(1, 3, clock.now))
        session.release()
        session.command(q)


def test_a_loop_that_was_away_while_a_pose_was_held_does_not_go_on_by_itself(lease, clock, robot):
    session = LeasedSession(robot, lease)
    with session:
        q = session.state().q_cmd
        for number in range(3):
            lease.renew(Renewal(1, number, clock.now))
            session.command(q)
            clock.now += 0.001
            session.state()
        clock.now += 0.31
        lease.renew(Renewal(1, 3, clock.now))
        with pytest.raises(ControlLost, match="got no time"):
            session.command(q)


def test_a_hold_waits_for_whoever_is_in_control_and_ends_when_nobody_comes_back(lease, clock):
    lease.renew(Renewal(1, 0, clock.now))
    lease.hold()
    for number in range(1, 400):
        clock.now += 1.0
        lease.renew(Renewal(1, number, clock.now))
        assert lease.waits(120.0), "somebody is in control all the time"
    clock.now += LEASE_S + 119.9
    assert lease.waits(120.0)
    clock.now += 0.2
    assert not lease.waits(120.0)
    assert isinstance(lease.refusal(), HoldExpired)
    lease.resume()
    assert isinstance(lease.refusal(), HoldExpired)


def test_the_robot_brakes_to_standstill_when_the_lease_runs_out(lease, clock, robot):
    session = LeasedSession(robot, lease)
    with session:
        lease.renew(Renewal(1, 0, clock.now))
        q = session.state().q_cmd
        for _ in range(200):
            q = q + 2e-4
            session.command(q)
            session.state()
        clock.now += 2 * LEASE_S
        with pytest.raises(ControlLost, match="ms"):
            session.command(q + 2e-4)
        positions = [session.state().q_cmd for _ in range(300)]
        assert np.abs(np.diff(positions[:3], axis=0)).max() > 0.0
        assert np.abs(np.diff(positions[-50:], axis=0)).max() == 0.0
        session.release()
        with pytest.raises(ControlLost):
            session.command(positions[-1])
        lease.renew(Renewal(1, 1, clock.now))
        lease.resume()
        session.release()
        session.command(positions[-1])
