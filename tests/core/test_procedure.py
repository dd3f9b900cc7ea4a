"""The whole procedure on the virtual robot."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.cell import Cell, Pose, load_cell
from core.errors import Interrupted, TooClose
from core.events import Event, Finished, Planned, Progress, RecordingWritten, RobotStopped
from core.outcome import Outcome
from core.plan import Timing
from core.procedure import identify
from core.recording_folder import read_recording
from core.sessions.simulated import SimulatedSession

CELLS = Path(__file__).parents[2] / "cells"
SHORT = Timing(hold_s=0.5, settle_s=0.4, robot_s=1.0)


def drained(run: Generator[Event, None, Outcome]) -> tuple[list[Event], Outcome]:
    """All events of a run and what it returned."""
    events: list[Event] = []
    while True:
        try:
            events.append(next(run))
        except StopIteration as end:
            return events, end.value


@pytest.fixture(scope="module", params=["lwr4_bench", "ur5e_line"])
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


class ZoneMovesIn(SimulatedSession):
    """After some time a protected zone is found right beside the robot, and leaves again."""

    def __init__(self, *args, collision_of, at_s: float, **kwargs) -> None:
        super().__init__(*args, **kwargs)
        self.collision_of, self.at_s, self.moved = collision_of, at_s, False


def test_an_interrupted_run_stops_the_robot_and_leaves_a_readable_recording(tmp_path):
    cell = load_cell(CELLS / "lwr4_bench")
    carried = cell.payloads["cylinder"]
    session = SimulatedSession(cell, carried.parameters, seed=1)
    run = identify(cell, session, carried.box, payload="cylinder", seed=1, timing=SHORT, out=tmp_path / "cut")
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
