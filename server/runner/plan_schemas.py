"""A plan as it is shown before its release. SI; joints in the robot's order; world frame."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from core.planning.summary import PlanSummary
from server.http.schemas import Answer


class PathPart(Answer):
    """A planned motion: joint positions every `period_s`, to look at; what is commanded lies between them."""

    part: str = Field(
        description="What it is, as the summary names it: `transfer x+`, `rotation x`, `wave free`, `home`.", examples=["transfer x+"]
    )
    toward: str = Field(description="`x+` or `home` of a transfer, the sensor axis of a rotation.", examples=["x+"])
    period_s: float = Field(description="Time between two rows of `q_rad`, the last of which may come sooner, s.", examples=[0.05])
    q_rad: list[list[float]] = Field(
        description="Joint positions, rad, one row for each moment, the first and the last exactly where the motion begins and ends.",
        examples=[[[0.0, 0.5, 0.0, -1.2, 0.0, 0.8, 0.0]]],
    )


class ThrowPart(Answer):
    """Where the load would come nearest to a protected zone if it let go during a rotation."""

    axis: str = Field(description="Sensor axis of the rotation.", examples=["x"])
    zone: str = Field(description="Name of the protected zone.", examples=["operator"])
    distance_m: float = Field(description="How near the load would come to it if it let go, m.", examples=[0.42])
    speed_m_s: float = Field(description="Speed of its fastest corner at that moment, m/s.", examples=[0.21])
    point_m: list[float] = Field(description="That corner, m, world frame.", examples=[[0.6, 0.1, 0.7]])
    velocity_m_s: list[float] = Field(description="Its velocity, m/s, world frame.", examples=[[0.2, 0.0, 0.06]])


class PlanHash(Answer):
    """Of a plan that is kept, nothing but what it is known by; its paths are large."""

    sha256: str


class RunPlan(Answer):
    """A plan as it is shown before its release."""

    sha256: str = Field(
        description="SHA-256, hexadecimal, of every set point, the cell with its zones and limits, the payload box.",
        examples=["9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"],
    )
    plan_digest: str = Field(
        description="SHA-256 of the set points alone, hexadecimal.",
        examples=["60303ae22b998861bce3b28f33eec1be758a213c86c93c076dbe9f558c11c752"],
    )
    summary: PlanSummary = Field(description="The plan in numbers.")
    paths: list[PathPart] = Field(description="All its motions, to look at.")
    throws: list[ThrowPart] = Field(description="Where the load would fly if it let go during a rotation.")
    safety_rated: Literal[False] = Field(default=False, description="Always false: it is not a safety function.")
