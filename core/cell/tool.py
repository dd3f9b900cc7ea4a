"""A tool as cell.toml states it: what is bolted between the sensor and the workpiece, a gripper or an adapter."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from core.payload.shapes import Box, Model, NotNegative, Positive, Six, Vector3

ThreeNotNegative = tuple[NotNegative, NotNegative, NotNegative]
SixNotNegative = tuple[NotNegative, NotNegative, NotNegative, NotNegative, NotNegative, NotNegative]

STATED = ("mass_kg", "first_moment_kg_m", "inertia_kg_m2")
"""What a tool states that is not made of links."""
STD = ("mass_std_kg", "first_moment_std_kg_m", "inertia_std_kg_m2")


class Tool(Model):
    """`[tools.NAME]`: bolted on, always there, felt by the sensor and no part of the workpiece.

    Either its inertia stands here, about the sensor origin in sensor axes as for payloads, or it is made of links of the URDF behind the
    sensor frame, whose inertia and shape count with the joints between them at zero."""

    title: Annotated[str, Field(min_length=1, max_length=200)] = Field(description="What people call it.", examples=["Gripper"])
    mass_kg: Positive | None = Field(default=None, description="Mass, kg; absent where it is made of links.", examples=[0.92])
    first_moment_kg_m: Vector3 | None = Field(
        default=None, description="Mass times centre of mass, kg m, sensor frame.", examples=[[0.0, 0.0, 0.041]]
    )
    inertia_kg_m2: Six | None = Field(
        default=None,
        description="Ixx Ixy Ixz Iyy Iyz Izz about the sensor's origin, kg m2.",
        examples=[[0.0031, 0.0, 0.0, 0.0031, 0.0, 0.0011]],
    )
    mass_std_kg: NotNegative | None = Field(
        default=None, description="Standard deviation of the mass, kg; absent where nobody knows.", examples=[0.005]
    )
    first_moment_std_kg_m: ThreeNotNegative | None = Field(
        default=None,
        description="Standard deviations of the first moment, kg m, independent of each other.",
        examples=[[0.0005, 0.0005, 0.0005]],
    )
    inertia_std_kg_m2: SixNotNegative | None = Field(
        default=None,
        description="Standard deviations of the inertia, kg m2, independent of each other.",
        examples=[[0.0001, 0.0001, 0.0001, 0.0001, 0.0001, 0.0001]],
    )
    box: Box | None = Field(
        default=None, description="What contains it, sensor frame; without box and links the payload's box must contain it."
    )
    links: Annotated[tuple[str, ...], Field(max_length=100)] | None = Field(
        default=None,
        description="Links of the URDF behind the sensor frame that it is made of, with the joints between them at zero.",
        examples=[["gripper_base", "finger"]],
    )
