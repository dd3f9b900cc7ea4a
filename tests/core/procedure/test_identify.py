"""The whole procedure on the virtual robot."""

from __future__ import annotations

import time
from collections.abc import Generator
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial import cKDTree

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.errors import BadState, Interrupted, OverLoad
from core.events import Event, Finished, PhaseStarted, Planned, Progress, RecordingWritten, RobotStopped, StepFinished, drive
from core.planning.settings import Timing
from core.planning.stops import Stops
from core.procedure.identify import identify
from core.procedure.outcome import Outcome
from core.recording.folder import read_recording
from core.sessions.leased import Lease, LeasedSession, Renewal
from core.sessions.session import RobotState
from core.sessions.simulated import SimulatedSession

CELLS = Path(__file__).parents[3] / "cells"
SHORT = Timing(hold_s=0.5, settle_s=0.4, robot_s=1.0)


def drained(run: Generator[Event, None, Outcome]) -> tuple[list[Event], Outcome]:
    """All events of a run and what it returned."""
    events: list[Event] = []
    return events, drive(run, events.append)


@pytest.fixture(scope="module", params=["lwr4_bench", pytest.param("ur5e_line", marks=pytest.mark.thorough)])
def whole_run(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Cell, list[Event], Outcome, Path]:
    cell = load_cell(CELLS / request.param)
    carried = cell.payloads["steel_block"]
    out = tmp_path_factory.mktemp("run") / "recording"
    session = SimulatedSession(cell, carried.parameters, seed=3)
    events, outcome = drained(identify(cell, session, carried.box, payload="steel_block", reference=carried, seed=3, out=out))
    return cell, events, outcome, out


def test_a_run_plans_moves_records_and_finishes_in_that_order(whole_run):
    _, events, _, _ = whole_run
    kinds = [type(event) for event in events]
    assert kinds.index(Planned) < kinds.index(Progress) < kinds.index(RecordingWritten) < kinds.index(Finished)
    progress = [event.done_s for event in events if isinstance(event, Progress)]
    assert progress == sorted(progress)
    assert all(event.done_s <= event.total_s for event in events if isinstance(event, Progress))


def test_the_steel_block_is_identified_within_its_own_uncertainty(whole_run):
    cell, _, outcome, _ = whole_run
    estimate, truth = outcome.identification.estimate, cell.payloads["steel_block"].parameters
    assert estimate.determined.all()
    assert np.all(np.abs(estimate.phi - truth.phi) < 4.5 * estimate.std)
    assert abs(estimate.phi[0] / truth.mass - 1) < 1e-3
    assert np.linalg.norm(estimate.phi[1:4] - truth.first_moment) < 3e-3 * np.linalg.norm(truth.first_moment)
    assert np.all(np.abs(estimate.phi[[4, 7, 9]] / truth.phi[[4, 7, 9]] - 1) < 0.03)
    assert estimate.consistent


def test_no_limit_was_exceeded_and_the_robot_time_is_kept(whole_run):
    cell, _, outcome, _ = whole_run
    assert outcome.restarts == 0
    assert outcome.safety.max_speed_m_s <= cell.limits.cartesian_speed_m_s
    assert outcome.safety.min_distance_m >= cell.limits.clearance_m
    assert outcome.robot_s <= 120.0


def test_the_recording_on_disk_is_the_one_in_memory(whole_run):
    _, _, outcome, out = whole_run
    written = read_recording(out)
    assert len(written) == len(outcome.recording)
    np.testing.assert_array_equal(written.wrench, outcome.recording.wrench)
    assert set(written.phase) == set(outcome.recording.phase)
    assert {"hold:x-", "hold:x+", "rotate:x", "rotate:y", "rotate:z", "transfer"} <= set(written.phase)


def test_sensor_axes_lie_along_and_against_gravity_in_the_holds(whole_run):
    cell, _, outcome, _ = whole_run
    recording = outcome.recording
    weight = cell.payloads["steel_block"].mass_kg * 9.81
    for k, axis in enumerate("xyz"):
        along = recording.wrench[recording.phase == f"hold:{axis}+", k].mean()
        against = recording.wrench[recording.phase == f"hold:{axis}-", k].mean()
        assert against - along == pytest.approx(2 * weight, rel=0.01)


class Knocked(SimulatedSession):
    """Somebody knocks against the payload `times` times, `every_s` seconds apart: the wrist sensor reads more than it may."""

    def __init__(self, cell: Cell, *, times: int, every_s: float) -> None:
        super().__init__(cell, cell.payloads["cylinder"].parameters, seed=5)
        self.due = [every_s * (k + 1) for k in range(times)]

    def state(self) -> RobotState:
        state = super().state()
        if self.due and state.t > self.due[0]:
            self.due.pop(0)
            return replace(state, wrench=state.wrench + np.array([0, 200.0, 0, 0, 0, 0]))
        return state


def test_after_a_stop_by_the_guard_the_rest_is_done_from_new_start_configurations(tmp_path):
    cell = load_cell(CELLS / "lwr4_bench")
    carried = cell.payloads["cylinder"]
    session = Knocked(cell, times=1, every_s=9.0)
    events, outcome = drained(
        identify(cell, session, carried.box, seed=2, stops=Stops.of_procedure(timing=SHORT), out=tmp_path / "knocked")
    )
    stops = [event for event in events if isinstance(event, RobotStopped)]
    assert [stop.error for stop in stops] == ["OverLoad"]
    assert outcome.restarts == 1
    assert sum(isinstance(event, Planned) for event in events) == 2
    assert {"rotate:x", "rotate:y", "rotate:z"} <= set(outcome.recording.phase)
    assert np.diff(outcome.recording.t).max() < 1.5 * session.period  # the braking is in the recording, every sample of it
    estimate = outcome.identification.estimate
    assert np.all(np.abs(estimate.phi - carried.parameters.phi) < 5 * estimate.std)


@pytest.mark.thorough
def test_a_run_that_is_stopped_again_and_again_is_given_up_with_its_samples(tmp_path):
    cell = load_cell(CELLS / "lwr4_bench")
    session = Knocked(cell, times=10, every_s=1.0)
    run = identify(cell, session, cell.payloads["cylinder"].box, seed=2, stops=Stops.of_procedure(timing=SHORT), out=tmp_path / "given_up")
    with pytest.raises(OverLoad) as stopped:
        drained(run)
    assert len(stopped.value.samples) > 100
    assert len(read_recording(tmp_path / "given_up")) > 1000


def test_a_sample_that_is_not_finite_stops_the_robot_and_is_not_written(tmp_path):
    class Broken(SimulatedSession):
        def state(self) -> RobotState:
            state = super().state()
            return replace(state, wrench=np.full(6, np.nan)) if 2.0 < state.t < 2.0015 or state.t > 4.0 else state

    cell = load_cell(CELLS / "lwr4_bench")
    session = Broken(cell, cell.payloads["cylinder"].parameters, seed=5)
    with pytest.raises(BadState, match="finite"):
        drained(
            identify(cell, session, cell.payloads["cylinder"].box, seed=2, stops=Stops.of_procedure(timing=SHORT), out=tmp_path / "broken")
        )
    assert np.isfinite(read_recording(tmp_path / "broken").wrench).all()


def test_an_interrupted_run_stops_the_robot_and_leaves_a_readable_recording(tmp_path):
    cell = load_cell(CELLS / "lwr4_bench")
    carried = cell.payloads["cylinder"]
    session = SimulatedSession(cell, carried.parameters, seed=1)
    run = identify(cell, session, carried.box, payload="cylinder", seed=1, stops=Stops.of_procedure(timing=SHORT), out=tmp_path / "cut")
    for event in run:
        if isinstance(event, Progress) and event.done_s > 3.0:
            break
    with pytest.raises(Interrupted, match="robot was stopped"):
        _throw(run, KeyboardInterrupt())
    recording = read_recording(tmp_path / "cut")
    assert recording.t[-1] - recording.t[0] == pytest.approx(3.0, abs=0.2)


def _throw(run: Generator[Event, None, Outcome], error: BaseException) -> None:
    """Raises inside the run and goes on to its end."""
    run.throw(error)
    drained(run)


def test_the_estimate_on_line_closes_in_on_the_payload_while_the_robot_moves(whole_run):
    cell, events, _, _ = whole_run
    seen = [event.estimate_phi for event in events if isinstance(event, Progress)]
    assert seen[0] == (None,) * 10  # nothing is known before two opposed poses
    truth = cell.payloads["steel_block"].parameters.phi
    assert seen[-1][0] == pytest.approx(truth[0], rel=2e-3)
    for k in (4, 7, 9):
        assert seen[-1][k] == pytest.approx(truth[k], rel=0.1)  # the filter's lag is in it


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["lwr4_bench", pytest.param("ur5e_line", marks=pytest.mark.thorough)])
def test_a_run_that_is_held_again_and_again_goes_on_along_its_plan_and_finds_the_same_payload(name):
    cell = load_cell(CELLS / name)
    carried = cell.payloads["steel_block"]
    plain = drained(
        identify(cell, SimulatedSession(cell, carried.parameters, seed=3), carried.box, stops=Stops.of_procedure(timing=SHORT), seed=3)
    )[1]
    lease = Lease(length_s=1e9)
    lease.renew(Renewal(0, 0, time.monotonic()))
    session = LeasedSession(SimulatedSession(cell, carried.parameters, seed=3), lease)
    phases: list[str] = []
    events, outcome = held_at_random(identify(cell, session, carried.box, stops=Stops.of_procedure(timing=SHORT), seed=3), lease, phases)
    assert {"transfer", "rotate", "hold"} <= {phase.partition(":")[0] for phase in phases}
    assert sum(isinstance(event, Planned) for event in events) == 1, "nothing is planned anew"
    assert outcome.restarts == 0
    left_s = [event.total_s - event.done_s for event in events if isinstance(event, Progress)]
    assert all(later <= earlier + 1e-6 for earlier, later in pairwise(left_s)), "time on hold is not counted"
    planned_s = next(event.robot_s for event in events if isinstance(event, Planned))
    assert left_s[0] == pytest.approx(planned_s, abs=0.1)
    assert left_s[len(left_s) // 2] > 0.3 * planned_s
    assert left_s[-1] < 0.1
    away, _ = cKDTree(plain.recording.q_cmd).query(outcome.recording.q_cmd[::7])
    assert away.max() < 3e-3, "rad, from the path that it takes when nobody holds it"
    acceleration = np.abs(np.diff(outcome.recording.q_cmd, n=2, axis=0)).max(axis=0) / session.period**2
    assert (acceleration <= 1.01 * np.array(cell.robot.acceleration_rad_s2)).all()
    assert outcome.safety.max_speed_m_s <= 1.02 * cell.limits.cartesian_speed_m_s
    estimate, truth = outcome.identification.estimate, carried.parameters
    assert estimate.determined.all()
    assert np.all(np.abs(estimate.phi - truth.phi) < 4.5 * estimate.std)


def held_at_random(run: Generator[Event, None, Outcome], lease: Lease, phases: list[str]) -> tuple[list[Event], Outcome]:
    """A run with somebody who holds it at some thirty moments and lets it go on each time; `phases` gets where that was."""
    rng, events, phase, left = np.random.default_rng(8), [], "", 10

    def tell(event: Event) -> None:
        nonlocal phase, left
        events.append(event)
        if isinstance(event, PhaseStarted):
            phase = event.phase
        left -= isinstance(event, Progress)
        if left == 0:
            left = int(rng.integers(20, 90))
            lease.hold()
            phases.append(phase)
        if isinstance(event, RobotStopped):
            assert event.held, event
            lease.resume()

    return events, drive(run, tell)


def test_a_step_is_finished_when_its_hold_and_its_rotation_are_recorded(whole_run):
    _, events, _, _ = whole_run
    finished = [event.step for event in events if isinstance(event, StepFinished)]
    assert finished == [1, 2, 3, 4, 5, 6]
    for step in finished:
        before = events[: next(k for k, event in enumerate(events) if isinstance(event, StepFinished) and event.step == step)]
        holds = [event for event in before if isinstance(event, PhaseStarted) and event.step == step and event.phase.startswith("hold")]
        assert holds
