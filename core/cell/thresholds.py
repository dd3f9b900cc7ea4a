"""From which external torques and forces a robot's controller acts, as cell.toml states it."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from core.payload.shapes import Model, Positive

ASSUMED_FORCE_N = 20.0
"""Where a cell states nothing: contact force at the flange that libfranka's examples set as the collision threshold of a Panda or FR3."""


class ContactThresholds(Model):
    """`[thresholds]`: what the controller takes for contact with somebody. What an error of the payload adds must stay below."""

    joint_torque_nm: Annotated[tuple[Positive, ...], Field(min_length=1, max_length=20)] | None = Field(
        default=None,
        description="External torque of each joint at which the controller sees a collision, N m.",
        examples=[[20.0, 20.0, 18.0, 18.0, 16.0, 14.0, 12.0]],
    )
    tcp_force_n: Positive | None = Field(
        default=None, description="External force at the sensor frame at which the controller sees a collision, N.", examples=[20.0]
    )
    guiding_force_n: Positive | None = Field(
        default=None,
        description="Force at the sensor frame with which the arm may push at most while it is guided by hand, N.",
        examples=[5.0],
    )
    observer_rate_per_s: Annotated[float, Field(strict=True, ge=1.0, le=1000.0)] = Field(
        default=50.0,
        description="Gain of the observer that estimates external torques, 1/s: it sees what lasts longer than its inverse.",
        examples=[50.0],
    )
    mass_kg: Positive | None = Field(
        default=None, description="Error of the mass that the controller's maker allows, kg; null where nobody has said.", examples=[0.1]
    )
    com_m: Positive | None = Field(
        default=None, description="Error of the centre of mass that the controller's maker allows, m; null likewise.", examples=[0.01]
    )
    source: Annotated[str, Field(min_length=1, max_length=200)] | None = Field(
        default=None, description="Where the values are from.", examples=["safety configuration of line 3"]
    )

    @property
    def states_contact(self) -> bool:
        """Whether anything is said of what is taken for contact."""
        return any(each is not None for each in (self.joint_torque_nm, self.tcp_force_n, self.guiding_force_n))
