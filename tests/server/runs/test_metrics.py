"""Figures of runs: each ends once, however it is cleared away."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta

import pytest
from prometheus_client import CollectorRegistry

from core.events import RobotStopped
from server.runner.messages import Paced
from server.runs.event_schemas import EventMessage, StateChanged
from server.runs.metrics import RunMetrics
from server.runs.packml import JobState, State
from server.runs.tables import RunRow
from tests.server.sentence import sentence

BEGAN = datetime(2026, 3, 1, tzinfo=UTC)


@pytest.fixture
def registry() -> CollectorRegistry:
    return CollectorRegistry()


def changed(state: State, at: datetime) -> EventMessage:
    return EventMessage(sequence=1, at=at, event=StateChanged(state=state, job_state=JobState.ABORTED, commands=[]))


def test_an_aborted_run_that_is_cleared_has_ended_once(registry: CollectorRegistry) -> None:
    metrics = RunMetrics(registry)
    end = BEGAN + timedelta(seconds=12)
    row = RunRow(released_at=BEGAN, ended_at=end)
    metrics.count_events([changed(State.ABORTING, end), changed(State.ABORTED, end)], row)
    cleared = end + timedelta(minutes=3)
    metrics.count_events([changed(State.CLEARING, cleared), changed(State.STOPPED, cleared)], row)
    assert registry.get_sample_value("heft_runs_ended_total", {"job_state": "Aborted"}) == 1
    assert registry.get_sample_value("heft_run_motion_seconds_sum", {"job_state": "Aborted"}) == 12
    assert registry.get_sample_value("heft_run_states_total", {"state": "Stopped"}) == 1


def test_stops_and_late_ticks_are_counted(registry: CollectorRegistry) -> None:
    metrics = RunMetrics(registry)
    stop = RobotStopped(error="TooFast", message=sentence(""), restart=1, final=False)
    metrics.count_events([EventMessage(sequence=1, at=BEGAN, event=stop)], RunRow())
    metrics.observe_pace(Paced(ticks=1000, late=3, latest_s=0.007, median_s=0.0002))
    assert registry.get_sample_value("heft_guard_stops_total", {"error": "TooFast"}) == 1
    assert registry.get_sample_value("heft_control_ticks_total") == 1000
    assert registry.get_sample_value("heft_control_late_ticks_total") == 3
    assert registry.get_sample_value("heft_control_latest_tick_seconds_bucket", {"le": "0.005"}) == 0
    assert registry.get_sample_value("heft_control_latest_tick_seconds_bucket", {"le": "0.01"}) == 1
