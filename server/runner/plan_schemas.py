"""A plan as it is shown before its release. SI; joints in the robot's order; world frame."""

from __future__ import annotations

from typing import Literal

from core.planning.summary import PlanSummary
from server.http.schemas import Answer


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
