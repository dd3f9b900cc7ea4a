"""Figures of the runs, from the events that tell of them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Annotated

from prometheus_client import CollectorRegistry, Counter, Histogram

from core.events import RobotStopped
from server.http.dependencies import depend_on
from server.runner.messages import Paced
from server.runs.event_schemas import EventMessage, StateChanged
from server.runs.packml import FINAL, State
from server.runs.reason import find_reason_kind
from server.runs.tables import RunRow

SECONDS = (1, 2, 5, 10, 20, 30, 45, 60, 90, 120, 180, 300, 600)

LATENESS = (0.0001, 0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1)


class RunMetrics:
    """Counts what happens to the runs of this service since its start."""

    def __init__(self, registry: CollectorRegistry) -> None:
        self._states = Counter("heft_run_states_total", "States that runs went into.", ("state",), registry=registry)
        self._ended = Counter("heft_runs_ended_total", "Runs that are over, as the MES sees them.", ("job_state",), registry=registry)
        self._moved = Histogram(
            "heft_run_motion_seconds", "Seconds from a run's release to its end.", ("job_state",), buckets=SECONDS, registry=registry
        )
        self._stops = Counter("heft_guard_stops_total", "Times that the robot was stopped, by the error.", ("error",), registry=registry)
        self._holds = Counter("heft_holds_total", "Times that a run was put on hold, by the reason.", ("reason",), registry=registry)
        self._lateness = Counter("heft_late_total", "Times that lateness stopped a robot, by what was late.", ("cause",), registry=registry)
        self._late_s = Histogram(
            "heft_late_seconds", "How late it was.", ("cause",), buckets=(0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 120), registry=registry
        )
        self._round_trip = Histogram(
            "heft_link_round_trip_seconds",
            "Seconds from a stamp to the answer of the console that is in control.",
            buckets=(0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5),
            registry=registry,
        )
        self._ticks = Counter("heft_control_ticks_total", "Ticks of control loops in real time.", registry=registry)
        self._late = Counter("heft_control_late_ticks_total", "Those that came more than 5 ms after their time.", registry=registry)
        self._latest = Histogram(
            "heft_control_latest_tick_seconds",
            "How late the latest tick of each run came.",
            buckets=LATENESS,
            registry=registry,
        )
        self._median = Histogram(
            "heft_control_median_tick_seconds", "How late the ticks of each run came in the median.", buckets=LATENESS, registry=registry
        )

    def count_events(self, messages: Iterable[EventMessage], row: RunRow) -> None:
        """What has just been written of a run. It ends once: clearing an aborted one is no second end."""
        for message in messages:
            match message.event:
                case StateChanged(state=state, job_state=job_state):
                    self._states.labels(state).inc()
                    if row.ended_at == message.at and state in (*FINAL, State.ABORTED):
                        self._ended.labels(job_state).inc()
                        if row.released_at is not None:
                            self._moved.labels(job_state).observe((message.at - row.released_at).total_seconds())
                case RobotStopped(error=error, held=held, lateness=lateness):
                    self._stops.labels(error).inc()
                    if held:
                        self._holds.labels(find_reason_kind(error, lateness)).inc()
                    if lateness is not None:
                        self._lateness.labels(lateness.cause).inc()
                        self._late_s.labels(lateness.cause).observe(lateness.late_s)

    def observe_round_trip(self, round_trip_s: float) -> None:
        """A console has answered a stamp."""
        self._round_trip.observe(round_trip_s)

    def observe_pace(self, paced: Paced) -> None:
        """How a run's control loop has kept its time."""
        self._ticks.inc(paced.ticks)
        self._late.inc(paced.late)
        self._latest.observe(paced.latest_s)
        self._median.observe(paced.median_s)


RunMetricsDep = Annotated[RunMetrics, depend_on("run_metrics")]
