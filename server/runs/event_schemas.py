"""What is told of a run while it is planned and moves. SI; joints in the robot's order; world frame unless a name says otherwise."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated, Literal

from pydantic import Field

from core.events import (
    Event,
    Finished,
    PhaseStarted,
    Planned,
    RecordingWritten,
    RobotStopped,
    StartConfigurationFound,
    StepFinished,
    TransferPlanned,
)
from core.words.message import Message
from server.http.schemas import Answer
from server.runner.live_schemas import LiveBatch, WaitingForZone
from server.runs.packml import JobState, State


class StateChanged(Event):
    """The run went into another state."""

    kind: Literal["state_changed"] = "state_changed"
    state: State
    job_state: JobState
    commands: list[str]
    reason: Message | None = None
    reason_kind: str | None = None


class PlanShown(Event):
    """A plan waits for its release, `GET /api/runs/{run}/plan`; one that was shown before is void."""

    kind: Literal["plan_shown"] = "plan_shown"
    sha256: str
    robot_s: float


Happening = Annotated[
    StateChanged
    | PlanShown
    | WaitingForZone
    | StartConfigurationFound
    | TransferPlanned
    | Planned
    | PhaseStarted
    | RobotStopped
    | StepFinished
    | RecordingWritten
    | Finished,
    Field(discriminator="kind"),
]


class EventMessage(Answer):
    """Something that happened to a run; `sequence` counts from 1 without gaps."""

    kind: Literal["event"] = "event"
    sequence: int
    at: datetime
    event: Happening


LiveMessage = Annotated[EventMessage | LiveBatch, Field(discriminator="kind")]
"""What `/api/runs/{run}/live` sends."""
