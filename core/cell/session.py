"""How a cell's robot and its sensor are reached: the table `[session]` of cell.toml. Where it is absent the robot is simulated."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from core.payload.shapes import Model, Pose

Host = Annotated[str, Field(pattern=r"^[A-Za-z0-9]([A-Za-z0-9.:_-]{0,251}[A-Za-z0-9])?$")]
Said = Annotated[str, Field(min_length=1, max_length=64)]


class SimulatedRobot(Model):
    """The cell's virtual robot; nothing has to be said of it."""

    driver: Literal["simulated"] = Field(default="simulated", description="Which driver.", examples=["simulated"])


class NetFtSensor(Model):
    """An ATI Net F/T: its Ethernet box, which sends wrenches by RDT."""

    driver: Literal["ati_net_ft"] = Field(description="Which driver.", examples=["ati_net_ft"])
    host: Host = Field(description="Name or address of the sensor's box.", examples=["192.168.1.1"])


ExternalSensor = NetFtSensor
"""Sensors that are read on a line of their own; one more is one more model, told apart by `driver`."""


class RealRobot(Model):
    """What every driver of a real robot is told."""

    host: Host = Field(description="Name or address of the robot's controller.", examples=["192.168.1.10"])
    model: Said = Field(description="The robot's model as its controller names it; another one is refused.", examples=["UR5e"])
    serial: Said | None = Field(
        default=None, description="The arm's serial number; another arm is refused. Not looked at where null.", examples=["20245500123"]
    )
    firmware: Said | None = Field(
        default=None,
        description="What the controller's version has to begin with: 5.17 takes 5.17.3. Whatever the driver knows where null.",
        examples=["5.17"],
    )
    base: Pose = Field(
        default=Pose(), description="The base frame of the controller in the cell's `robot.base_frame`; the same where nobody has said."
    )
    sensor: ExternalSensor | None = Field(default=None, description="A sensor that is read on its own line; the robot's own where null.")


class UniversalRobot(RealRobot):
    """A Universal Robots e-series arm over RTDE."""

    driver: Literal["ur_rtde"] = Field(description="Which driver.", examples=["ur_rtde"])


Session = Annotated[SimulatedRobot | UniversalRobot, Field(discriminator="driver")]

ROBOT_DRIVERS = ("simulated", "ur_rtde")
DRIVER_NAMES = frozenset({*ROBOT_DRIVERS, "ati_net_ft"})
"""Of robots and of sensors."""
