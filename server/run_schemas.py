"""What a run shows while it is planned and while it moves. SI; joints in the robot's order; world frame unless a name says otherwise."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated, Literal

from pydantic import Field

from core.events import Event, Finished, PhaseStarted, Planned, RecordingWritten, RobotStopped, StartConfigurationFound, TransferPlanned
from core.plan_settings import Planner
from core.plan_summary import PlanSummary
from core.result import Numbers
from core.shapes import Box
from server.packml import JobState, State
from server.schemas import Answer, Body, Name

Pace = Literal["real_time", "as_fast_as_possible"]


class NearestPart(Answer):
    """The nearest pair of the robot and what stands around it."""

    distance_m: float
    first: str
    second: str
    point_first_m: list[float]
    point_second_m: list[float]


class LiveBatch(Answer):
    """Newest samples of a run.

    Args:
        t_s: robot's clock, one per row of `wrench`.
        wrench: rows of fx fy fz (N) tx ty tz (N m), raw, sensor frame.
        reconstructed: what the estimate so far says the last row should be; null while nothing is known.
        phi, phi_std: the estimate so far in the paper's order, with its standard uncertainty.
        q_rad: joint positions at the last row.
        progress: share of the robot time, 0 to 1; `eta_s` what is left of it by the wall clock.
    """

    kind: Literal["samples"] = "samples"
    phase: str
    t_s: list[float]
    wrench: list[list[float]]
    reconstructed: list[float] | None
    phi: Numbers
    phi_std: Numbers
    q_rad: list[float]
    nearest: NearestPart | None
    progress: float
    eta_s: float | None


class PathPart(Answer):
    """A planned transfer: joint positions every `period_s`, to look at; what is commanded lies between them."""

    toward: str
    period_s: float
    q_rad: list[list[float]]


class ThrowPart(Answer):
    """Where the load would come nearest to a protected zone if it let go during a rotation.

    Args:
        point_m, velocity_m_s: of its fastest corner at that moment; `speed_m_s` is the same as one number.
    """

    axis: str
    zone: str
    distance_m: float
    speed_m_s: float
    point_m: list[float]
    velocity_m_s: list[float]


class RunPlan(Answer):
    """A plan as it is shown before its release.

    Args:
        sha256: of all that is going to happen: the plan's every set point, the cell with its zones and limits, the payload box.
        plan_digest: of the set points alone.
    """

    sha256: str
    plan_digest: str
    summary: PlanSummary
    paths: list[PathPart]
    throws: list[ThrowPart]
    safety_rated: Literal[False] = False


class RunOrder(Body):
    """What is to be identified.

    Args:
        payload: one that the cell knows; what the simulated robot carries, and the reference that the result is compared with. The
            cell's first where absent.
        payload_box: what certainly contains the payload, sensor frame; that of the payload where absent.
        seed: makes planning and the simulated noise repeatable.
        hold_s, settle_s, robot_s, inertia_std: as in `core.plan_settings.Timing`.
        pace: of the simulated robot.
    """

    cell: Name
    payload: Name | None = None
    payload_box: Box | None = None
    mass_guess_kg: float = Field(1.0, gt=0.0, le=1000.0)
    planner: Planner = "rrt_connect"
    seed: int = Field(0, ge=0, lt=2**31)
    hold_s: float = Field(1.5, ge=0.3, le=30.0)
    settle_s: float = Field(1.0, ge=0.3, le=30.0)
    robot_s: float = Field(115.0, ge=1.0, le=600.0)
    inertia_std: float = Field(0.004, gt=0.0, le=1.0)
    pace: Pace = "real_time"


class RunAnswer(Answer):
    """A run as it stands now.

    Args:
        state: PackML; `job_state` is the same as the MES sees it (ISA-95).
        commands: what may be asked of it now.
        reason: why it did not come through, or why it stands.
        progress: share of the robot time, 0 to 1; `eta_s` what is left of it.
    """

    run: str
    cell: str
    order: RunOrder
    state: State
    job_state: JobState
    commands: list[str]
    released: bool
    reason: str | None
    in_the_way: str | None
    progress: float
    eta_s: float | None
    sequence: int
    requested_by: str
    requested_at: datetime
    released_by: str | None
    released_at: datetime | None
    ended_at: datetime | None
    safety_rated: Literal[False] = False


class StateChanged(Event):
    """The run went into another state."""

    kind: Literal["state_changed"] = "state_changed"
    state: State
    job_state: JobState
    commands: list[str]
    reason: str | None = None


class PlanShown(Event):
    """A plan waits for its release, `GET /api/runs/{run}/plan`; one that was shown before is void."""

    kind: Literal["plan_shown"] = "plan_shown"
    sha256: str
    robot_s: float


class WaitingForZone(Event):
    """The robot stands, and there is no safe way on before a zone moves: `in_the_way` where planning knows it."""

    kind: Literal["waiting_for_zone"] = "waiting_for_zone"
    message: str
    in_the_way: str | None = None


Happening = Annotated[
    StateChanged
    | PlanShown
    | WaitingForZone
    | StartConfigurationFound
    | TransferPlanned
    | Planned
    | PhaseStarted
    | RobotStopped
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
