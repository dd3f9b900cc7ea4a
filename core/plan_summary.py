"""A plan as it leaves the engine: JSON, SI units, without its trajectories."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict


class PlannedPose(BaseModel):
    """One pose of a plan, for JSON."""

    model_config = ConfigDict(frozen=True)

    axis: str
    q_rad: list[float]
    clearance_m: float
    least_clearance_m: float
    nearest: str
    manipulability: float
    transfer_s: float
    transfer_least_margin_m: float
    rotation_s: float | None


class PlanSummary(BaseModel):
    """A plan for JSON."""

    model_config = ConfigDict(frozen=True)

    cell: str
    poses: list[PlannedPose]
    home_s: float
    robot_s: float
    plan_s: float
    least_margin_m: float
