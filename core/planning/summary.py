"""A plan as it leaves the engine: JSON, SI units, without its trajectories."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict

from core.words.message import Message


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


class ClosestPair(BaseModel):
    """Where the second opinion finds a kind of pair closest to what it has to keep, for JSON.

    Args:
        kind: in words, as in `core.second_opinion.pairs.PairKind`.
        part: `transfer x+`, `rotation x`, `home`; `time_s` counts from its beginning.
    """

    model_config = ConfigDict(frozen=True)

    kind: str
    first: str
    second: str
    distance_m: float
    required_m: float
    part: str
    time_s: float


class FastestCorner(BaseModel):
    """The fastest corner of a link, a tool or the payload, or of a box round it where that keeps the limit, for JSON."""

    model_config = ConfigDict(frozen=True)

    body: str
    speed_m_s: float
    limit_m_s: float
    part: str
    time_s: float


class SecondOpinion(BaseModel):
    """What a check that shares no code with the planner measured at every set point, for JSON."""

    model_config = ConfigDict(frozen=True)

    closest: list[ClosestPair]
    fastest: FastestCorner
    samples: int
    lost_load: NearestFlight | None = None
    """None where there is no protected zone, and in plans made before it was looked for."""


class LargestTorque(BaseModel):
    """Where a joint has to give the largest share of its torque, for JSON.

    Args:
        torque_n_m: dynamic, friction as far as the cell states it; `holding_n_m` of it hold arm and load still there.
        limit_n_m: `effort` of the URDF.
        ratio: torque over limit.
        part: `transfer x+`, `rotation x`, `home`; `time_s` counts from its beginning.
    """

    model_config = ConfigDict(frozen=True)

    joint: str
    torque_n_m: float
    holding_n_m: float
    limit_n_m: float
    ratio: float
    part: str
    time_s: float


class PlanTorques(BaseModel):
    """What a plan asks of the joints with the load that is stated, for JSON.

    Args:
        load: where mass and inertia of the load are from.
        largest: None where no joint can be judged.
        not_judged: joints with the reason.
    """

    model_config = ConfigDict(frozen=True)

    load: Message
    mass_kg: float
    largest: LargestTorque | None
    not_judged: list[Message]


class NearestFlight(BaseModel):
    """The flight of a load that comes off on the way which comes nearest to a protected zone, for JSON.

    Args:
        speed_m_s: of the fastest point as it comes off.
        part: `transfer x+`, `rotation x`, `home`; `time_s` counts from its beginning.
    """

    model_config = ConfigDict(frozen=True)

    zone: str
    distance_m: float
    speed_m_s: float
    part: str
    time_s: float


class LeftOutPair(BaseModel):
    """Two bodies of which nothing is asked, and why, for JSON."""

    model_config = ConfigDict(frozen=True)

    first: str
    second: str
    why: Message


class PlanSummary(BaseModel):
    """A plan for JSON.

    Args:
        least_margin_m: smallest distance beyond what is required, of everything that moves and along all of the plan.
        least_distance_m: smallest distance of anything that moves to obstacles and zones; `second_opinion.closest` says of what, and what
            it is without the links that only the first joint moves. None where there is neither, or in older plans.
        left_out: pairs of which nothing is asked.
    """

    model_config = ConfigDict(frozen=True)

    cell: str
    poses: list[PlannedPose]
    home_s: float
    robot_s: float
    plan_s: float
    least_margin_m: float
    second_opinion: SecondOpinion | None = None
    """None in plans made before there was one."""
    torques: PlanTorques | None = None
    """None in plans made before they were judged."""
    least_distance_m: float | None = None
    left_out: list[LeftOutPair] = []
