"""A run as it is asked for and as it stands."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from typing import Annotated, Literal

from pydantic import AfterValidator, Field, StringConstraints

from core.errors import Lateness
from core.payload.shapes import Angle, Box
from core.planning.settings import MAX_EFFORT, Planner, Scope
from core.planning.stop import Stop
from core.requirement.target import Target
from core.words.message import Message
from server.http.schemas import Answer, Name, RequestBody
from server.runner.messages import Evidence, Pace
from server.runs.packml import JobState, RunOutcome, State
from server.runs.result_summary import ResultSummary

OrderText = Annotated[str, StringConstraints(pattern=r"^[^\x00-\x1f\x7f]+$", max_length=100)]
"""What a plant calls something, in its own words: one line of text."""


def _drop_empty(target: Target | None) -> Target | None:
    return target if target is not None and target.names_something else None


class RunOrder(RequestBody):
    """What is to be identified, as it is kept."""

    cell: Name = Field(description="Name of the cell.", examples=["lwr4_bench"])
    payload: Name | None = Field(
        default=None,
        description="Payload that the cell knows; null in orders of older services that named none.",
        examples=["steel_block"],
    )
    order_id: OrderText | None = Field(
        default=None,
        description="Identifier of the job order in the MES (ISA-95); returned with the run, its webhook, recording, result, report.",
        examples=["JO-2026-004711"],
    )
    work_order: OrderText | None = Field(
        default=None, description="The work order that it belongs to; returned likewise.", examples=["WO-88120"]
    )
    serial_number: OrderText | None = Field(
        default=None, description="Serial number of what the robot carries; returned likewise.", examples=["SN-000482"]
    )
    payload_box: Box | None = Field(
        default=None, description="What certainly contains the payload, sensor frame; that of the payload where null."
    )
    mass_guess_kg: float = Field(
        default=1.0, gt=0.0, le=1000.0, description="About how heavy it is, kg; sets how long the procedure turns.", examples=[2.8]
    )
    planner: Planner = Field(default="rrt_connect", description="Algorithm that looks for paths.")
    seed: int = Field(default=0, ge=0, lt=2**31, description="Makes planning and the simulated noise repeatable.", examples=[0])
    hold_s: float = Field(default=1.5, ge=0.3, le=30.0, description="Length of each hold, s.", examples=[1.5])
    settle_s: float = Field(default=1.0, ge=0.3, le=30.0, description="Length of the pause after each rotation, s.", examples=[1.0])
    robot_s: float = Field(default=115.0, ge=1.0, le=600.0, description="Robot time that the procedure may take, s.", examples=[115.0])
    inertia_std: float = Field(
        default=0.004, gt=0.0, le=1.0, description="Standard uncertainty of the inertia that is aimed at, kg m2.", examples=[0.004]
    )
    pace: Pace = Field(default="real_time", description="Of the simulated robot.")
    axes: Annotated[str, Field(pattern=r"^x?y?z?$", min_length=1)] = Field(
        default="xyz",
        description="Sensor axes to hold along gravity and to turn about, in the order x, y, z; fewer where one has no room.",
        examples=["xyz"],
    )
    identify_from: Evidence = Field(
        default="wrist_sensor",
        description="What the motions show the payload to. `joint_torques`: a wave of all joints at each of `axes`, as tells most of the "
        "payload through their torques; without `target` and with `rotations`.",
        examples=["joint_torques"],
    )
    empty: bool = Field(
        default=False,
        description="True for the same motions without the payload, which has to be taken off before; the run then names no payload.",
        examples=[False],
    )
    without: Annotated[str, StringConstraints(max_length=40)] | None = Field(
        default=None,
        description="A run of this cell with `empty`: the payload is then identified from the joints' torques in both recordings, without "
        "`target`; from this run's own where null.",
        examples=["019ab1c0a1b2c3d4e5f607"],
    )
    rotations: bool = Field(default=True, description="False for holds alone, which tell mass and centre of mass.")
    speed_m_s: float | None = Field(
        default=None,
        gt=0.0,
        allow_inf_nan=False,
        description="No point moves faster, m/s: at most the cell's limit, which holds where null.",
        examples=[0.15],
    )
    effort: int = Field(
        default=1, ge=1, le=MAX_EFFORT, description="So many times the candidates and iterations before a plan is refused.", examples=[1]
    )
    target: Annotated[Target | None, AfterValidator(_drop_empty)] = Field(
        default=None,
        description="How exactly the payload is wanted to be known: what is not needed for it is left out, and the robot goes home. The "
        "whole plan is carried out where null or where it names nothing, and where a proposed motion is made.",
        examples=[{"mass_share": 0.001, "inertia_share": 0.01}],
    )
    start_rad: tuple[Angle, ...] | None = Field(
        default=None,
        min_length=1,
        max_length=32,
        description="Joint positions where the robot stands, rad; at home where null.",
        examples=[[0.0, 0.5, 0.0, -1.2, 0.0, 0.8, 0.0]],
    )

    @property
    def scope(self) -> Scope:
        """Which part of the procedure is wanted."""
        return Scope(self.axes, self.rotations)


class RunCreate(RunOrder):
    """What is to be identified."""

    payload: Name = Field(
        description="Name of a payload of `cell.toml` or of the cell's tool library: what is carried, and the reference to compare with.",
        examples=["steel_block"],
    )


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


class RunPublic(Answer):
    """A run as it stands now."""

    run: str = Field(description="Identifier of the run; sorts by the time of its making.", examples=["019ab1c2d3e44f1c2a9be7"])
    cell: str = Field(description="Name of the cell.", examples=["lwr4_bench"])
    payload: str | None = Field(
        description="Name of the payload; null in runs without it, and of older services that named none.", examples=["steel_block"]
    )
    saved_payload: str | None = Field(
        description="Identifier of that payload in the cell's tool library, also once it is renamed or gone; null where it is one of "
        "`cell.toml`.",
        examples=["019ab1c2d3e44f1c2a9be7"],
    )
    order_id: str | None = Field(description="Identifier of the job order, as it was ordered.", examples=["JO-2026-004711"])
    work_order: str | None = Field(description="The work order, as it was ordered.", examples=["WO-88120"])
    serial_number: str | None = Field(description="Serial number of what the robot carries, as it was ordered.", examples=["SN-000482"])
    order: RunOrder = Field(description="All that was ordered.")
    state: State = Field(description="State of the machine (PackML).")
    job_state: JobState = Field(description="The same as the MES sees it (ISA-95): Ended where it came through, Aborted where it did not.")
    outcome: RunOutcome | None = Field(description="How it ended: completed, cancelled, refused, stopped or aborted; null before.")
    commands: list[str] = Field(description="What may be asked of it now.", examples=[["hold", "stop", "abort"]])
    released: bool = Field(description="Whether an operator has let it begin.")
    reason: Message | None = Field(description="Why it stands or did not come through; null where neither holds.")
    reason_kind: str | None = Field(description="Kind of `reason`, see docs/runs.md.", examples=["stop-asked"])
    lateness: Lateness | None = Field(description="What was late, where that put it on hold or ended it.")
    held_since: datetime | None = Field(description="When it was put on hold; null where it is not.", examples=["2026-03-01T08:00:00.120Z"])
    ends_at: datetime | None = Field(
        description="When it ends by itself, because nobody is in control of it; null where it does not.", examples=["2026-03-01T08:02:00Z"]
    )
    steps: int = Field(description="Steps of its plan, the way home included; 0 before there is one.", examples=[7])
    finished_steps: int = Field(description="How many of them are recorded.", examples=[3])
    may_continue: bool = Field(description="Whether `POST /api/runs/{run}/continuation` makes the rest of it as a new run.")
    in_the_way: str | None = Field(description="Name of what is in its way; null where nothing is.", examples=["operator"])
    progress: float = Field(description="Share of the robot's time that is over, 0 to 1.", examples=[0.42])
    eta_s: float | None = Field(description="Time that is left, s; null where it is not known.", examples=[33.9])
    sequence: int = Field(description="Number of its last event.", examples=[12])
    requested_by: str = Field(description="Who asked for it.", examples=["key:line-3"])
    requested_at: datetime = Field(description="When it was asked for.", examples=["2026-03-01T07:58:00Z"])
    released_by: str | None = Field(description="Who let it begin; null before.", examples=["account:anna"])
    released_at: datetime | None = Field(description="When it was let begin; null before.", examples=["2026-03-01T07:59:10Z"])
    ended_at: datetime | None = Field(description="When it ended; null before.", examples=["2026-03-01T08:00:24Z"])
    plan_sha256: str | None = Field(
        description="SHA-256 of the newest plan that was shown for it, hexadecimal; null before there is one.",
        examples=["9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"],
    )
    result: ResultSummary | None = Field(description="What it found, in a few numbers; null until it is known.")
    accepted_by: str | None = Field(description="Who took the result for good; null before.", examples=["account:anna"])
    accepted_at: datetime | None = Field(description="When it was taken for good; null before.", examples=["2026-03-01T08:03:00Z"])
    continues: str | None = Field(
        description="The run whose recording its own begins with; null where it begins anew.", examples=["019ab1c0a1b2c3d4e5f607"]
    )
    diagnosis: str | None = Field(
        description="The diagnosis whose proposed motion it makes; null for the procedure.", examples=["019ab1c2e0a17d34a06c11"]
    )
    safety_rated: Literal[False] = Field(default=False, description="Always false: it is not a safety function.")
