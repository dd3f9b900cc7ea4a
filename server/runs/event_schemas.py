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
    TargetReached,
    TransferPlanned,
)
from core.words.message import Message
from server.http.schemas import Answer
from server.runner.live_schemas import LiveBatch, WaitingForZone
from server.runs.packml import JobState, RunOutcome, State


class StateChanged(Event):
    """The run went into another state."""

    kind: Literal["state_changed"] = Field(default="state_changed", description="Tells which event it is.")
    state: State = Field(description="State of the machine (PackML) from now on.")
    job_state: JobState = Field(description="The same as the MES sees it (ISA-95).")
    outcome: RunOutcome | None = Field(default=None, description="How the run ended; null before.")
    commands: list[str] = Field(description="What may be asked of it now.", examples=[["hold", "stop", "abort"]])
    reason: Message | None = Field(default=None, description="Why it stands or did not come through; null where neither holds.")
    reason_kind: str | None = Field(default=None, description="Kind of `reason`, see docs/runs.md.", examples=["stop-asked"])


class PlanShown(Event):
    """A plan waits for its release, `GET /api/runs/{run}/plan`; one that was shown before is void."""

    kind: Literal["plan_shown"] = Field(default="plan_shown", description="Tells which event it is.")
    sha256: str = Field(
        description="SHA-256 of the plan that waits, hexadecimal, see `GET /api/runs/{run}/plan`.",
        examples=["9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"],
    )
    robot_s: float = Field(description="Time that the robot will need, s.", examples=[58.4])


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
    | TargetReached
    | RecordingWritten
    | Finished,
    Field(discriminator="kind"),
]


class EventMessage(Answer):
    """Something that happened to a run; `sequence` counts from 1 without gaps."""

    kind: Literal["event"] = Field(default="event", description="Tells which message it is.")
    sequence: int = Field(description="Counts from 1 without gaps.", examples=[12])
    at: datetime = Field(description="When it happened, by the service's clock.", examples=["2026-03-01T08:00:00.120Z"])
    event: Happening = Field(description="What happened.")


LiveMessage = Annotated[EventMessage | LiveBatch, Field(discriminator="kind")]
"""What `/api/runs/{run}/live` sends."""
