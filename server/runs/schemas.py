"""A run as it is asked for and as it stands."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field

from core.errors import Lateness
from core.payload.shapes import Angle, Box
from core.planning.settings import MAX_EFFORT, Planner, Scope
from core.planning.stop import Stop
from core.words.message import Message
from server.http.schemas import Answer, Name, RequestBody
from server.runner.messages import Pace
from server.runs.packml import JobState, State
from server.runs.result_summary import ResultSummary


class RunOrder(RequestBody):
    """What is to be identified.

    Args:
        payload: one that the cell knows; what the simulated robot carries, and the reference that the result is compared with. The
            cell's first where absent.
        payload_box: what certainly contains the payload, sensor frame; that of the payload where absent.
        seed: makes planning and the simulated noise repeatable.
        hold_s, settle_s, robot_s, inertia_std: as in `core.planning.settings.Timing`.
        pace: of the simulated robot.
        axes: sensor axes to hold along gravity and to turn about, in the order x, y, z; fewer where one has no room.
        rotations: false for holds alone, which tell mass and centre of mass.
        speed_m_s: no point moves faster; at most the cell's limit, that where absent.
        effort: so many times the candidates and iterations before a plan is refused.
        start_rad: where the robot stands; at home where absent.
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
    axes: Annotated[str, Field(pattern=r"^x?y?z?$", min_length=1)] = "xyz"
    rotations: bool = True
    speed_m_s: float | None = Field(None, gt=0.0, allow_inf_nan=False)
    effort: int = Field(1, ge=1, le=MAX_EFFORT)
    start_rad: tuple[Angle, ...] | None = Field(None, min_length=1, max_length=32)

    @property
    def scope(self) -> Scope:
        """Which part of the procedure is wanted."""
        return Scope(self.axes, self.rotations)


class ProposedMotion(RequestBody):
    """What a run does instead of the procedure: the motion that a diagnosis proposes.

    Args:
        continues: the run whose recording it is appended to; null where that was uploaded. `recording` is its folder.
    """

    diagnosis: str
    continues: str | None
    recording: Path
    stops: tuple[Stop, ...]


class RestOfRun(RequestBody):
    """What a run does instead of the whole procedure: the steps that an ended run has not finished.

    Args:
        continues: that run; `recording` is the folder of its recording, to which this one's samples are appended.
        done: steps that are finished already; the rest begins where the robot was when that run ended.
        diagnosis, stops: of a proposed motion, null for the procedure.
    """

    continues: str
    recording: Path
    done: int
    diagnosis: str | None = None
    stops: tuple[Stop, ...] | None = None


Motion = RestOfRun | ProposedMotion


class RunAnswer(Answer):
    """A run as it stands now.

    Args:
        state: PackML; `job_state` is the same as the MES sees it (ISA-95).
        commands: what may be asked of it now.
        reason: why it did not come through, or why it stands; `reason_kind` is the kind of it, see docs/runs.md.
        lateness: what was late, where that put it on hold or ended it.
        held_since: when it was put on hold; `ends_at` when it ends by itself, because nobody is in control of it.
        steps: of its plan, the way home included; `finished_steps` are recorded.
        may_continue: it has ended, and `POST /api/runs/{run}/continuation` makes the rest of it as a new run.
        progress: share of the robot time, 0 to 1; `eta_s` what is left of it.
        result: what it found, in a few numbers; null until it is known.
        accepted_by: who took the result for good.
        diagnosis: whose proposed motion it makes, null for the procedure; its recording begins with that of the run that it `continues`.
    """

    run: str
    cell: str
    payload: str | None
    order: RunOrder
    state: State
    job_state: JobState
    commands: list[str]
    released: bool
    reason: Message | None
    reason_kind: str | None
    lateness: Lateness | None
    held_since: datetime | None
    ends_at: datetime | None
    steps: int
    finished_steps: int
    may_continue: bool
    in_the_way: str | None
    progress: float
    eta_s: float | None
    sequence: int
    requested_by: str
    requested_at: datetime
    released_by: str | None
    released_at: datetime | None
    ended_at: datetime | None
    result: ResultSummary | None
    accepted_by: str | None
    accepted_at: datetime | None
    continues: str | None
    diagnosis: str | None
    safety_rated: Literal[False] = False
