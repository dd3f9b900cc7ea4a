"""What every driver of a robot has to pass. A driver's tests give it a bench and inherit `Conformance`.

The bench knows the truth about the robot from beside the driver: from the simulation, or from the server at the other end of the line.
"""

from __future__ import annotations

import time
from abc import ABC, abstractmethod

import numpy as np
import pytest

from core.cell.cell import Cell
from core.errors import BadState, OutOfLimits, Stopped, TooFast, WrongRobot
from core.sessions.session import RobotSession, RobotState


class Bench(ABC):
    """A robot and the way to it."""

    cell: Cell
    linked = True
    """Whether there is a line to the robot, and another robot could be at its end."""

    @abstractmethod
    def open(self, cell: Cell | None = None) -> RobotSession:
        """A session of the bench's robot with this cell, its own where None."""

    @abstractmethod
    def where(self) -> np.ndarray:
        """(n,), where the robot really is, rad."""

    def swap_joints(self) -> Cell:
        """The cell with two joints in another order than the robot has them."""
        raise NotImplementedError

    def expect_model(self, model: str) -> Cell:
        """The cell, which expects this model."""
        return self.cell.model_copy(update={"session": self.cell.session.model_copy(update={"model": model})})

    def cut(self) -> None:
        """The line to the robot is cut; nobody is told."""
        raise NotImplementedError

    def stay_away(self) -> None:
        """The control loop gets no time for as long as the driver's watchdog cannot tolerate."""
        raise NotImplementedError

    def settle(self) -> None:
        """Waits as long as any stop of this robot takes."""
        raise NotImplementedError


class Conformance:
    """Inherited by a class `TestX` whose fixture `bench` gives a fresh `Bench`."""

    def test_outside_of_the_session_nothing_can_be_asked(self, bench: Bench) -> None:
        session = bench.open()
        start = session.find_start()
        for call in (session.state, lambda: session.command(start)):
            with pytest.raises(RuntimeError, match="with session"):
                call()
        with session:
            session.state()
        with pytest.raises(RuntimeError, match="with session"):
            session.state()

    def test_it_begins_where_it_says_and_stays_there_without_a_command(self, bench: Bench) -> None:
        session = bench.open()
        start = session.find_start()
        with session:
            states = [session.state() for _ in range(20)]
        check_states(states, session.period)
        assert np.abs(states[0].q_cmd - start).max() < 1e-6
        assert np.abs(bench.where() - start).max() < 1e-3

    def test_it_goes_where_it_is_commanded_and_says_so(self, bench: Bench) -> None:
        with bench.open() as session:
            states = move(session, bench.cell)
            moved = states[-1].q_cmd - states[0].q_cmd
            assert np.abs(moved).min() > 1e-3
            states += [session.state() for _ in range(round(0.3 / session.period))]
            np.testing.assert_allclose(bench.where(), states[-1].q_cmd, atol=2e-3)
        check_states(states, session.period)
        measured, commanded = np.array([s.q for s in states]), np.array([s.q_cmd for s in states])
        assert np.abs(measured - commanded).max() < 0.05

    def test_stop_brakes_and_further_commands_are_refused_until_the_release(self, bench: Bench) -> None:
        with bench.open() as session:
            target = move(session, bench.cell)[-1].q_cmd
            session.stop()
            with pytest.raises(BadState):
                session.command(target)
            states = [session.state() for _ in range(round(0.8 / session.period))]
            assert np.array_equal(states[-1].q_cmd, states[-2].q_cmd)
            assert np.abs(states[-1].q_cmd - target).max() < 0.1
            session.release()
            stands = session.state().q_cmd
            session.command(stands)
            assert np.abs(session.state().q_cmd - stands).max() < 1e-9
            moved = move(session, bench.cell)
            assert np.abs(moved[-1].q_cmd - stands).min() > 1e-3

    def test_an_error_inside_stops_the_robot_and_it_can_be_entered_again(self, bench: Bench) -> None:
        session = bench.open()
        with pytest.raises(KeyError), session:
            move(session, bench.cell)
            raise KeyError
        stands = bench.where()
        with session:
            assert np.abs(session.state().q - stands).max() < 0.02

    @pytest.mark.parametrize("what", ["nan", "short", "jump", "limit"])
    def test_a_command_that_no_robot_can_carry_out_is_refused_and_stops_it(self, bench: Bench, what: str) -> None:
        with bench.open() as session:
            stands = session.state().q_cmd
            bad, error = {
                "nan": (np.full_like(stands, np.nan), BadState),
                "short": (stands[:-1], BadState),
                "jump": (stands + 0.1, TooFast),
                "limit": (stands + 100.0, (OutOfLimits, TooFast)),
            }[what]
            with pytest.raises(error):
                session.command(bad)
            with pytest.raises(BadState):
                session.command(stands)
        assert np.abs(bench.where() - stands).max() < 2e-3

    def test_another_model_is_refused_with_what_was_found_and_expected(self, bench: Bench) -> None:
        before = self.linked_only(bench).where()
        session = bench.open(bench.expect_model("another arm"))
        with pytest.raises(WrongRobot, match="another arm") as raised:
            session.find_start()
        assert raised.value.message.parameters["found"] == bench.cell.session.model
        with pytest.raises(WrongRobot), session:
            pass
        np.testing.assert_allclose(bench.where(), before, atol=1e-6)

    def test_another_order_of_the_joints_is_refused_before_anything_moves(self, bench: Bench) -> None:
        before = self.linked_only(bench).where()
        with pytest.raises(WrongRobot, match=r"mm .*limit"), bench.open(bench.swap_joints()):
            pass
        np.testing.assert_allclose(bench.where(), before, atol=1e-6)

    def test_a_line_that_is_cut_ends_in_an_error_and_a_robot_that_stands(self, bench: Bench) -> None:
        self.linked_only(bench)
        with pytest.raises(BadState) as raised, bench.open() as session:
            move(session, bench.cell)
            bench.cut()
            move(session, bench.cell, seconds=5.0)
        assert not raised.value.may_go_on
        self.check_standing(bench)

    def test_a_loop_that_is_away_for_too_long_finds_the_robot_stopped(self, bench: Bench) -> None:
        self.linked_only(bench)
        with pytest.raises(Stopped), bench.open() as session:
            move(session, bench.cell)
            bench.stay_away()
            self.check_standing(bench)
            move(session, bench.cell)
        self.check_standing(bench)

    @staticmethod
    def linked_only(bench: Bench) -> Bench:
        if not bench.linked:
            pytest.skip("there is no line to the robot, and no other robot at its end")
        return bench

    @staticmethod
    def check_standing(bench: Bench) -> None:
        bench.settle()
        first = bench.where()
        bench.settle()
        assert np.abs(bench.where() - first).max() < 1e-4


def move(session: RobotSession, cell: Cell, seconds: float = 0.4) -> list[RobotState]:
    """Speeds up all joints smoothly from where the command stands, to 0.1 rad/s; gives all states. Raises what the session raises."""
    states = [session.state()]
    q = states[0].q_cmd
    signs = np.where(np.arange(q.size) % 2, -1.0, 1.0)
    ticks = round(seconds / session.period)
    for k in range(1, ticks + 1):
        q = q + session.period * 0.1 * signs * min(1.0, k * session.period / 0.2)
        session.command(q)
        states.append(session.state())
    return states


def fall_into_step(session: RobotSession) -> None:
    """Leaves a session that has read all that its controller has sent, where that waits for the answer to its last report.

    What is sent before a report was read counts as its answer, and leaves the session one report behind: then it reads two at once some
    day. So it commands, gives all that is on its way time to arrive, and reads it.
    """
    session.command(session.state().q_cmd)
    time.sleep(0.5)
    session.state()


def check_states(states: list[RobotState], period: float) -> None:
    """Finite, of one length, and on a clock that goes on by whole periods."""
    t = np.array([state.t for state in states])
    np.testing.assert_allclose(np.diff(t) / period, np.round(np.diff(t) / period), atol=0.05)
    assert (np.diff(t) > 0).all()
    for state in states:
        assert state.wrench.shape == (6,) and state.q.shape == state.dq.shape == state.q_cmd.shape
        assert np.isfinite(np.concatenate([state.q, state.dq, state.q_cmd, state.wrench])).all()
