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
    sensor frame, whose inertia and shape count with the joints between them at zero.

    Args:
        mass_std_kg, first_moment_std_kg_m, inertia_std_kg_m2: standard deviations, independent of each other; absent where nobody knows.
        box: in the sensor frame; a tool without box and links has none of its own, and the payload's box must contain it.
    """

    title: Annotated[str, Field(min_length=1, max_length=200)]
    mass_kg: Positive | None = None
    first_moment_kg_m: Vector3 | None = None
    inertia_kg_m2: Six | None = None
    """Ixx Ixy Ixz Iyy Iyz Izz about the sensor origin."""
    mass_std_kg: NotNegative | None = None
    first_moment_std_kg_m: ThreeNotNegative | None = None
    inertia_std_kg_m2: SixNotNegative | None = None
    box: Box | None = None
    links: Annotated[tuple[str, ...], Field(max_length=100)] | None = None
