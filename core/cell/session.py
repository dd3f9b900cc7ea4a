"""How a cell's robot and its sensor are reached: the table `[session]` of cell.toml. Where it is absent the robot is simulated."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from core.payload.shapes import Model, Pose

Host = Annotated[str, Field(pattern=r"^[A-Za-z0-9]([A-Za-z0-9.:_-]{0,251}[A-Za-z0-9])?$")]
Port = Annotated[int, Field(ge=1, le=65535)]
Device = Annotated[str, Field(pattern=r"^/dev/[A-Za-z0-9_./-]{1,100}$")]
Said = Annotated[str, Field(min_length=1, max_length=64)]


class SimulatedRobot(Model):
    """The cell's virtual robot; nothing has to be said of it."""

    driver: Literal["simulated"] = Field(default="simulated", description="Which driver.", examples=["simulated"])


class LinedSensor(Model):
    """What every driver of a sensor on a line of its own is told."""

    sign: Literal[1, -1] = Field(
        default=-1,
        description="-1 where the sensor reports what acts on it, as its maker has it; 1 where its axes are turned so that it reports what "
        "it exerts on the payload.",
        examples=[-1],
    )


class NetFtSensor(LinedSensor):
    """An ATI Net F/T or Ethernet Axia, which sends wrenches by RDT."""

    driver: Literal["ati_net_ft"] = Field(description="Which driver.", examples=["ati_net_ft"])
    host: Host = Field(description="Name or address of the sensor's box.", examples=["192.168.1.1"])
    calibration: Said | None = Field(
        default=None,
        description="Serial number of its calibration; another one is refused. Not looked at where null.",
        examples=["FT27462"],
    )
    rdt_port: Port = Field(default=49152, description="UDP port of its RDT.", examples=[49152])
    http_port: Port = Field(default=80, description="TCP port of its pages.", examples=[80])


class BotaSensor(LinedSensor):
    """A sensor of Bota Systems with a serial line."""

    driver: Literal["bota_serial"] = Field(description="Which driver.", examples=["bota_serial"])
    port: Device = Field(description="Its serial line.", examples=["/dev/ttyUSB0"])


class RobotiqSensor(LinedSensor):
    """A Robotiq FT 300 with a serial line."""

    driver: Literal["robotiq_ft300"] = Field(description="Which driver.", examples=["robotiq_ft300"])
    port: Device = Field(description="Its serial line.", examples=["/dev/ttyUSB0"])


ExternalSensor = Annotated[NetFtSensor | BotaSensor | RobotiqSensor, Field(discriminator="driver")]
"""Sensors that are read on a line of their own; one more is one more model, told apart by `driver`."""


class RealRobot(Model):
    """What every driver of a real robot is told."""

    host: Host = Field(description="Name or address of the robot's controller.", examples=["192.168.1.10"])
    base: Pose = Field(
        default=Pose(), description="The base frame of the controller in the cell's `robot.base_frame`; the same where nobody has said."
    )
    sensor: ExternalSensor | None = Field(default=None, description="A sensor that is read on its own line; the robot's own where null.")


class NamedRobot(RealRobot):
    """A robot whose controller says what it is."""

    model: Said = Field(description="The robot's model as its controller names it; another one is refused.", examples=["UR5e"])
    serial: Said | None = Field(
        default=None, description="The arm's serial number; another arm is refused. Not looked at where null.", examples=["20245500123"]
    )
    firmware: Said | None = Field(
        default=None,
        description="What the controller's version has to begin with: 5.17 takes 5.17.3. Whatever the driver knows where null.",
        examples=["5.17"],
    )


class SensingRobot(NamedRobot):
    """A robot with a force/torque sensor of its own."""

    wrench_acts_on: Literal["robot", "payload"] = Field(
        default="robot", description="What the controller's raw wrench is exerted on: the robot by its load, or the load by the robot."
    )


class UniversalRobot(SensingRobot):
    """A Universal Robots e-series arm over RTDE."""

    driver: Literal["ur_rtde"] = Field(description="Which driver.", examples=["ur_rtde"])


class XarmRobot(SensingRobot):
    """A UFACTORY xArm, 850 or Lite 6 over the maker's private TCP protocol."""

    driver: Literal["xarm"] = Field(description="Which driver.", examples=["xarm"])
    port: Port = Field(default=502, description="TCP port of the control.", examples=[502])
    rate_hz: Literal[200, 250] = Field(
        default=200, description="Rate of the controller's reports, Hz: 200 with its force/torque sensor, 250 without."
    )


Seven = tuple[float, float, float, float, float, float, float]


class PadPose(Model):
    """One pose of a KUKA LBR as its smartPAD shows it, in the tablet's own units."""

    q_deg: Seven = Field(description="Axes A1 to A7, degrees.", examples=[[10.0, 30.0, -20.0, -70.0, 40.0, 50.0, 15.0]])
    xyz_mm: tuple[float, float, float] = Field(
        description="X, Y, Z of the flange in the robot's root frame, mm.", examples=[[512.3, 80.1, 604.9]]
    )
    abc_deg: tuple[float, float, float] = Field(
        description="A, B, C of the flange in the robot's root frame, degrees: turned about z, the new y, the newest x.",
        examples=[[-170.2, 12.5, 165.0]],
    )


class KukaRobot(RealRobot):
    """A KUKA LBR iiwa or LBR Med over the Fast Robot Interface. Its messages name neither model nor serial number."""

    driver: Literal["kuka_fri"] = Field(description="Which driver.", examples=["kuka_fri"])
    listen: Host = Field(
        default="0.0.0.0",
        description="Address of this computer to which the controller sends; any where nobody has said.",
        examples=["192.170.10.1"],
    )
    port: Port = Field(default=30200, description="UDP port of this computer to which the controller sends.", examples=[30200])
    send_period_ms: Annotated[int, Field(ge=1, le=10)] = Field(
        default=2, description="How often the controller sends, ms, as the Sunrise application sets it.", examples=[2]
    )
    tool: Pose = Field(
        default=Pose(), description="The tool centre point of the Sunrise application in the flange; the flange where absent."
    )
    pad: PadPose | None = Field(
        default=None, description="One pose read off the smartPAD; needed where the controller tells no pose of its own (FRI 1)."
    )


class FrankaRobot(NamedRobot):
    """A Panda or Franka Research 3 over the Franka Control Interface (FCI). Its messages name no serial number; `firmware` is the version
    of its server."""

    driver: Literal["franka_fci"] = Field(description="Which driver.", examples=["franka_fci"])
    port: Port = Field(default=1337, description="TCP port of the interface.", examples=[1337])


Session = Annotated[SimulatedRobot | UniversalRobot | XarmRobot | KukaRobot | FrankaRobot, Field(discriminator="driver")]

ROBOT_DRIVERS = ("simulated", "ur_rtde", "xarm", "kuka_fri", "franka_fci")
SENSOR_DRIVERS = ("ati_net_ft", "bota_serial", "robotiq_ft300")
DRIVER_NAMES = frozenset({*ROBOT_DRIVERS, *SENSOR_DRIVERS})
"""Of robots and of sensors."""
