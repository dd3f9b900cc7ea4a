from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from core.cell.folder import load_cell
from core.errors import BadState, OutOfLimits, TooFast
from core.plant.imperfections import Imperfections
from core.sessions.simulated import SimulatedSession
from tests.core.sessions.conformance import Bench, Conformance

CELLS = {name: load_cell(Path(__file__).parents[3] / "cells" / name) for name in ("lwr4_bench", "ur5e_line")}
PERIOD = 0.001


class SimulatedBench(Bench):
    linked = False

    def __init__(self, name):
        self.cell = CELLS[name]

    def open(self, cell=None):  # noqa: ARG002 - there is no other robot that it could be held against
        self.session = session_of(self.cell.name)
        return self.session

    def where(self):
        return self.session.plant.truth.q


class TestConformance(Conformance):
    @pytest.fixture(params=CELLS)
    def bench(self, request):
        return SimulatedBench(request.param)


def session_of(name="lwr4_bench", **options):
    cell = CELLS[name]
    return SimulatedSession(cell, cell.payloads["steel_block"].parameters, seed=1, **options)


def start_moving(session, speed, ticks=200):
    """Commands a motion that has reached the joint speeds (n,) at its end; gives all states."""
    states = [session.state()]
    q = states[0].q_cmd
    for k in range(1, ticks + 1):
        q = q + PERIOD * np.asarray(speed) * k / ticks
        session.command(q)
        states.append(session.state())
    return states


def speeds(session):
    return 0.8 * np.linspace(1, -0.4, len(session.plant.home))


@pytest.mark.parametrize("name", CELLS)
def test_it_starts_at_home_and_holds_it_without_a_command(name):
    with session_of(name) as session:
        states = [session.state() for _ in range(50)]
    home = np.array(CELLS[name].robot.home_rad)
    for k, state in enumerate(states):
        assert state.t == pytest.approx(k * session.period)
        np.testing.assert_array_equal(state.q_cmd, home)
        assert np.abs(state.q - home).max() < 2e-5
        assert np.abs(state.dq).max() < 5e-3
        assert state.wrench.shape == (6,)
        assert state.tau is not None and state.tau.shape == home.shape


def test_a_command_is_reported_by_the_next_state_and_reached_then():
    with session_of() as session:
        states = start_moving(session, speeds(session))
        target = states[-1].q_cmd + PERIOD * speeds(session)
        session.command(target)
        target_kept = target.copy()
        target += 1.0  # the caller may use its array again
        state = session.state()
        np.testing.assert_array_equal(state.q_cmd, target_kept)
        assert np.abs(state.q - target_kept).max() < 5e-4
        np.testing.assert_array_equal(session.state().q_cmd, target_kept)


@pytest.mark.parametrize("name", CELLS)
def test_stop_brakes_within_the_cells_accelerations_and_ends_at_rest(name):
    with session_of(name) as session:
        states = start_moving(session, speeds(session))
        session.stop()
        states += [session.state() for _ in range(400)]
        true = session.plant.truth
    q_cmd = np.array([state.q_cmd for state in states])
    ddq_cmd = np.diff(q_cmd, n=2, axis=0) / PERIOD**2
    assert (np.abs(ddq_cmd) <= np.array(CELLS[name].robot.acceleration_rad_s2) * (1 + 1e-6)).all()
    np.testing.assert_array_equal(q_cmd[-300:], np.broadcast_to(q_cmd[-1], q_cmd[-300:].shape))
    assert np.abs(true.dq).max() < 1e-5
    assert np.abs(true.q - q_cmd[-1]).max() < 1e-5


@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(share=st.lists(st.floats(-0.6, 0.6), min_size=7, max_size=7), ticks=st.integers(80, 150))
def test_stop_keeps_the_accelerations_from_any_speed(share, ticks):
    with session_of() as session:
        speed = np.array(share) * session.plant.arm.velocity
        states = start_moving(session, speed, ticks)
        session.stop()
        states += [session.state() for _ in range(300)]
    q_cmd = np.array([state.q_cmd for state in states])[ticks - 1 :]
    limits = np.array(CELLS["lwr4_bench"].robot.acceleration_rad_s2)
    assert (np.abs(np.diff(q_cmd, n=2, axis=0)) / PERIOD**2 <= limits * (1 + 1e-6) + 1e-6).all()
    assert (q_cmd[-1] == q_cmd[-2]).all()


def test_stop_drops_the_command_that_was_given_for_the_next_period():
    with session_of() as session:
        last = start_moving(session, speeds(session))[-1].q_cmd
        session.command(last)  # would be standstill at once
        session.stop()
        assert np.abs(session.state().q_cmd - last).max() > 1e-4


def test_after_a_stop_commands_are_refused_until_released_and_go_on_from_there():
    with session_of() as session:
        start_moving(session, speeds(session))
        session.stop()
        with pytest.raises(BadState, match=r"release\(\)"):
            session.command(session.plant.home)
        session.stop()
        session.release()
        state = session.state()
        after = session.state()
        np.testing.assert_array_equal(state.q_cmd, after.q_cmd)
        session.command(after.q_cmd + 1e-4)
        np.testing.assert_array_equal(session.state().q_cmd, after.q_cmd + 1e-4)


def test_a_second_stop_while_braking_changes_nothing():
    paths = []
    for stops in (1, 3):
        with session_of() as session:
            start_moving(session, speeds(session))
            q_cmd = []
            for k in range(200):
                if k < stops:
                    session.stop()
                q_cmd.append(session.state().q_cmd)
            paths.append(q_cmd)
    np.testing.assert_array_equal(*paths)


def test_leaving_stops_the_robot_and_a_new_entry_finds_it_where_it_stands():
    session = session_of()
    with pytest.raises(KeyError), session:
        moving = start_moving(session, speeds(session))[-1]
        raise KeyError
    with session:
        stands = session.state()
        assert np.abs(stands.q_cmd - moving.q_cmd).max() > 1e-3
        np.testing.assert_array_equal(session.state().q_cmd, stands.q_cmd)
        session.command(stands.q_cmd + 1e-4)


@pytest.mark.parametrize("call", ["state", "command"])
def test_outside_of_the_session_nothing_can_be_asked(call):
    session = session_of()
    with session:
        q = session.state().q_cmd
    arguments = (q,) if call == "command" else ()
    with pytest.raises(RuntimeError, match="with session"):
        getattr(session, call)(*arguments)


@pytest.mark.parametrize("bad", [[np.nan] * 7, [np.inf] + [0.0] * 6, [0.0] * 6, [[0.0] * 7], []])
def test_a_command_that_is_no_position_is_refused_and_stops_the_robot(bad):
    with session_of() as session:
        session.state()
        with pytest.raises(BadState, match="expected 7 finite joint positions"):
            session.command(np.array(bad))
        with pytest.raises(BadState, match="after a stop"):
            session.command(session.plant.home)


def test_a_command_that_jumps_is_refused_with_joint_and_limit():
    with session_of() as session:
        q = session.state().q_cmd.copy()
        q[3] += 0.01
        with pytest.raises(TooFast, match=r"joint4: .* 10\.000 rad/s \(limit 2\.234 rad/s\)") as raised:
            session.command(q)
        assert raised.value.value == pytest.approx(10.0)
        assert raised.value.limit == pytest.approx(2.234021)
        np.testing.assert_array_equal(session.state().q_cmd, session.plant.home)


def test_a_command_at_the_joints_velocity_limit_is_taken():
    with session_of() as session:
        q = session.state().q_cmd
        session.command(q + PERIOD * session.plant.arm.velocity)


@pytest.mark.parametrize("side", [-1, 1])
def test_a_command_out_of_the_joint_limits_is_refused(side):
    cell = CELLS["lwr4_bench"]
    home = np.array(cell.robot.home_rad)
    home[5] = side * 2.094
    near = cell.model_copy(update={"robot": cell.robot.model_copy(update={"home_rad": tuple(home)})})
    with SimulatedSession(near, cell.payloads["cylinder"].parameters, seed=0) as session:
        q = session.state().q_cmd.copy()
        q[5] += side * 0.001
        with pytest.raises(OutOfLimits, match="joint6") as raised:
            session.command(q)
        assert raised.value.limit == pytest.approx(side * 2.094395)


def test_the_seed_decides_everything():
    def run(seed):
        cell = CELLS["ur5e_line"]
        with SimulatedSession(cell, cell.payloads["cylinder"].parameters, seed=seed) as session:
            return start_moving(session, speeds(session), 100)

    for a, b in zip(run(4), run(4), strict=True):
        np.testing.assert_array_equal(a.q, b.q)
        np.testing.assert_array_equal(a.wrench, b.wrench)
        np.testing.assert_array_equal(a.tau, b.tau)
    assert not np.array_equal(run(4)[-1].wrench, run(5)[-1].wrench)


def test_the_pace_is_asked_at_every_sample():
    class Listening:
        def __init__(self):
            self.asked = []

        def wait_until(self, t):
            self.asked.append(t)

    pace = Listening()
    with session_of(pace=pace) as session:
        t = [session.state().t for _ in range(5)]
    assert pace.asked == t


def test_imperfections_reach_the_plant():
    def first_force(**options):
        with session_of(imperfections=Imperfections(**options)) as session:
            session.state()
            return session.plant.truth.wrench

    assert np.abs(first_force() - first_force(base_tilt_rad=(0.01, 0.0))).max() > 0.05
