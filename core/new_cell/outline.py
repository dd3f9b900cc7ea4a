"""What a robot's description is made of, for whoever has to say where the arm begins and ends."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, Field


class LinkOutline(BaseModel):
    """A link, and the joint that it hangs on."""

    model_config = ConfigDict(frozen=True)

    name: str = Field(description="Name of the link.", examples=["link_3"])
    parent: str | None = Field(description="The link that it hangs on; null for the root.", examples=["link_2"])
    joint: str | None = Field(description="The joint that it hangs on; null for the root.", examples=["joint_3"])
    kind: str | None = Field(description="Kind of that joint, as the URDF has it; null for the root.", examples=["revolute"])
    is_body: bool = Field(description="Whether it has mass or a shape.")


class RobotOutline(BaseModel):
    """The links of a description, parents first, and the frames that are proposed."""

    model_config = ConfigDict(frozen=True)

    robot: str = Field(description="Name of the robot, as the description has it.", examples=["lwr4"])
    links: list[LinkOutline] = Field(description="All links, each after the one that it hangs on.")
    base_frame: str = Field(description="Proposed link that the arm begins with.", examples=["base"])
    sensor_frame: str = Field(description="Proposed link in whose frame the sensor measures.", examples=["flange"])
