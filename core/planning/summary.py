"""A plan as it leaves the engine: JSON, SI units, without its trajectories."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, Field

from core.words.message import Message


class PlannedPose(BaseModel):
    """One pose of a plan, for JSON."""

    model_config = ConfigDict(frozen=True)

    axis: str = Field(
        description="Sensor axis and its sign: `x+` lies along gravity, `x-` against it; `free` where none does.", examples=["x+"]
    )
    q_rad: list[float] = Field(description="Joint positions, rad.", examples=[[0.1, 0.9, 0.0, -1.4, 0.2, 1.1, 0.0]])
    clearance_m: float = Field(description="Distance to obstacles and zones there, m.", examples=[0.184])
    least_clearance_m: float = Field(description="The smallest over the whole rotation, m.", examples=[0.121])
    nearest: str = Field(description="Name of the obstacle or zone that is nearest.", examples=["bench"])
    manipulability: float = Field(description="Smallest over largest singular value of the Jacobian, without a unit.", examples=[0.12])
    transfer_s: float = Field(description="Time of the way there, s.", examples=[3.8])
    transfer_least_margin_m: float = Field(description="Smallest distance beyond what is required on the way there, m.", examples=[0.021])
    rotation_s: float | None = Field(description="Time of the rotation, s; null where there is none.", examples=[4.1])
    home_s: float | None = Field(
        default=None,
        description="Time of the way home from there, for a run that has met its target, s; null where it goes along the rest of the plan.",
        examples=[3.2],
    )


class ClosestPair(BaseModel):
    """Where the second opinion finds a kind of pair closest to what it has to keep, for JSON."""

    model_config = ConfigDict(frozen=True)

    kind: str = Field(description="Kind of the pair.", examples=["robot and obstacles"])
    first: str = Field(description="The one body.", examples=["link_5"])
    second: str = Field(description="The other body.", examples=["bench"])
    distance_m: float = Field(description="Their distance there, m.", examples=[0.052])
    required_m: float = Field(description="What they have to keep, m.", examples=[0.03])
    part: str = Field(description="Part of the plan: `transfer x+`, `rotation x`, `home`.", examples=["transfer x+"])
    time_s: float = Field(description="When, from the beginning of that part, s.", examples=[1.25])


class FastestCorner(BaseModel):
    """The fastest corner of a link, a tool or the payload, or of a box round it where that keeps the limit, for JSON."""

    model_config = ConfigDict(frozen=True)

    body: str = Field(description="The body whose corner it is.", examples=["payload"])
    speed_m_s: float = Field(description="Its speed, m/s.", examples=[0.231])
    limit_m_s: float = Field(description="What it may be, m/s.", examples=[0.25])
    part: str = Field(description="Part of the plan: `transfer x+`, `rotation x`, `home`.", examples=["rotation x"])
    time_s: float = Field(description="When, from the beginning of that part, s.", examples=[0.8])


class SecondOpinion(BaseModel):
    """What a check that shares no code with the planner measured at every set point, for JSON."""

    model_config = ConfigDict(frozen=True)

    closest: list[ClosestPair] = Field(description="For each kind of pair, where it comes closest to what it has to keep.")
    fastest: FastestCorner = Field(description="The fastest corner of links, tools and payload.")
    samples: int = Field(description="Set points that were measured.", examples=[58400])
    lost_load: NearestFlight | None = Field(
        default=None,
        description="Flight of a load that comes off, nearest to a protected zone; null without zones, and in older plans.",
    )


class LargestTorque(BaseModel):
    """Where a joint has to give the largest share of its torque, for JSON."""

    model_config = ConfigDict(frozen=True)

    joint: str = Field(description="Name of the joint.", examples=["joint_2"])
    torque_n_m: float = Field(
        description="Torque that it has to give, dynamic, friction as far as the cell states it, N m.", examples=[48.0]
    )
    holding_n_m: float = Field(description="What of it holds arm and load still there, N m.", examples=[41.0])
    limit_n_m: float = Field(description="What it has (`effort` of the URDF), N m.", examples=[176.0])
    ratio: float = Field(description="Torque over limit, without a unit.", examples=[0.27])
    part: str = Field(description="Part of the plan: `transfer x+`, `rotation x`, `home`.", examples=["transfer z-"])
    time_s: float = Field(description="When, from the beginning of that part, s.", examples=[2.1])


class PlanTorques(BaseModel):
    """What a plan asks of the joints with the load that is stated, for JSON."""

    model_config = ConfigDict(frozen=True)

    load: Message = Field(description="Where mass and inertia of the load are from.")
    mass_kg: float = Field(description="Mass of the load that was counted with, kg.", examples=[2.783])
    largest: LargestTorque | None = Field(
        description="The joint that gives the largest share of its torque; null where none can be judged."
    )
    not_judged: list[Message] = Field(description="Joints that cannot be judged, with the reason.")


class NearestFlight(BaseModel):
    """The flight of a load that comes off on the way which comes nearest to a protected zone, for JSON."""

    model_config = ConfigDict(frozen=True)

    zone: str = Field(description="Name of the protected zone.", examples=["operator"])
    distance_m: float = Field(description="How near the flight comes to it, m.", examples=[0.42])
    speed_m_s: float = Field(description="Of the fastest point as it comes off, m/s.", examples=[0.21])
    part: str = Field(description="Part of the plan: `transfer x+`, `rotation x`, `home`.", examples=["rotation y"])
    time_s: float = Field(description="When the load comes off, from the beginning of that part, s.", examples=[1.7])


class LeftOutPair(BaseModel):
    """Two bodies of which nothing is asked, and why, for JSON."""

    model_config = ConfigDict(frozen=True)

    first: str = Field(description="The one body.", examples=["link_1"])
    second: str = Field(description="The other body.", examples=["floor"])
    why: Message = Field(description="Why nothing is asked of them.")


class PlanSummary(BaseModel):
    """A plan for JSON."""

    model_config = ConfigDict(frozen=True)

    cell: str = Field(description="Name of the cell.", examples=["lwr4_bench"])
    poses: list[PlannedPose] = Field(description="The poses in the order of the procedure.")
    home_s: float = Field(description="Time of the way home, s.", examples=[3.2])
    robot_s: float = Field(description="Time that the robot needs for all of it, s.", examples=[58.4])
    plan_s: float = Field(description="Time that planning took, s.", examples=[4.2])
    least_margin_m: float = Field(
        description="Smallest distance beyond what is required, of everything that moves and along all of the plan, m.", examples=[0.013]
    )
    second_opinion: SecondOpinion | None = Field(
        default=None, description="What a check that shares no code with the planner measured; null in plans from before there was one."
    )
    torques: PlanTorques | None = Field(
        default=None, description="What the plan asks of the joints; null in plans from before they were judged."
    )
    least_distance_m: float | None = Field(
        default=None,
        description="Smallest distance of anything that moves to obstacles and zones, m; null where there is neither, or in older plans.",
        examples=[0.043],
    )
    left_out: list[LeftOutPair] = Field(default_factory=list, description="Pairs of bodies of which nothing is asked.")
