"""Values that somebody who makes a cell puts in the place of what would be taken, since the description lacks them."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from core.cell.cell import Box, Friction, Limits, Sensor
from core.payload.shapes import Angle, Model, Number

Speed = Annotated[float, Field(strict=True, ge=0.01, le=50.0)]
Torque = Annotated[float, Field(strict=True, gt=0.0, le=100_000.0)]
Acceleration = Annotated[float, Field(strict=True, ge=0.1, le=200.0)]
Mass = Annotated[float, Field(strict=True, gt=0.0, le=10_000.0)]
Name = Annotated[str, Field(min_length=1, max_length=200)]
Pairs = Annotated[tuple[tuple[Name, Name], ...], Field(max_length=1000)]


class JointValues(Model):
    """Limits of one joint; null is what the description says, or what is taken where it says nothing."""

    lower_rad: Angle | None = Field(default=None, description="Lower limit of its position, rad.", examples=[-2.97])
    upper_rad: Angle | None = Field(default=None, description="Upper limit of its position, rad.", examples=[2.97])
    velocity_rad_s: Speed | None = Field(default=None, description="Its greatest speed, rad/s.", examples=[1.9])
    effort_n_m: Torque | None = Field(default=None, description="Its greatest torque, N m.", examples=[176.0])
    acceleration_rad_s2: Acceleration | None = Field(default=None, description="Its greatest acceleration, rad/s2.", examples=[10.0])


class CellValues(Model):
    """What is known better than the description has it; null and what is absent is taken."""

    title: Annotated[str, Field(min_length=1, max_length=200)] | None = Field(
        default=None, description="What people call the cell.", examples=["LWR 4 on the bench"]
    )
    joints: dict[Name, JointValues] = Field(default_factory=dict, description="Limits of joints, by their names.")
    masses_kg: dict[Name, Mass] = Field(
        default_factory=dict, description="Masses of links, kg, by their names; the inertia goes with it.", examples=[{"link_3": 2.7}]
    )
    friction: Friction | None = Field(default=None, description="Friction of the arm's joints.")
    home_rad: tuple[Angle, ...] | None = Field(
        default=None, description="Joint positions at home, rad, from base to sensor.", examples=[[0.0, 0.5, 0.0, -1.2, 0.0, 0.8, 0.0]]
    )
    sensor: Sensor | None = Field(default=None, description="The wrist force/torque sensor.")
    floor_z_m: Number | None = Field(default=None, description="Height of the floor, m, in the base frame.", examples=[-0.75])
    payload_box: Box | None = Field(default=None, description="The room that a payload takes, sensor frame.")
    adjacent: Pairs | None = Field(
        default=None,
        description="Pairs of links between which no distance is watched; where null those that overlap wherever they are looked at.",
        examples=[[["link_1", "link_3"]]],
    )
    limits: Limits = Field(default=Limits(), description="Largest speed and smallest distances.")
