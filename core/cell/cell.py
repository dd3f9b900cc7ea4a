"""A cell: robot, sensor, obstacles, protected zones and limits; data only, read from `cells/<name>/cell.toml`.

Everything that stands in the cell is given in the world frame; the robot's base is placed in it by `robot.base`.
"""

from __future__ import annotations

from functools import cached_property
from pathlib import Path
from typing import Annotated

import numpy as np
from pydantic import Field

from core.array import Array
from core.cell.session import Session, SimulatedRobot
from core.cell.thresholds import ContactThresholds
from core.cell.tool import Tool
from core.cell.urdf_elements import MAX_BYTES as MAX_URDF_BYTES
from core.errors import BadRobot
from core.files.jail import read_inside
from core.payload.calibration import NOT_STATED, SensorCalibration
from core.payload.inertia import InertialParameters
from core.payload.shapes import (
    Angle,
    Box,
    Capsule,
    Cylinder,
    Mesh,
    Model,
    NotNegative,
    Number,
    Pose,
    Positive,
    Shape,
    Six,
    SixPositive,
    Sphere,
    StandingShape,
    Vector3,
)
from core.payload.site import Site, gravity_at

__all__ = [
    "Box", "Capsule", "Cell", "Control", "Cylinder", "Friction", "Limits", "Mesh", "Obstacle", "Payload", "Pose", "Robot", "Sensor",
    "Shape", "Sphere", "Tool", "Zone",

]  # fmt: skip

Name = Annotated[str, Field(pattern=r"^[A-Za-z0-9_-]{1,64}$")]
Text = Annotated[str, Field(min_length=1, max_length=200)]

CELL_FILE = "cell.toml"
TWIN_FILE = "twin.json"
MAX_CELL_BYTES = 1_000_000


class Obstacle(Model):
    """Something solid that stands in the cell."""

    name: Name = Field(description="Name of the obstacle.", examples=["bench"])
    shape: StandingShape = Field(description="Its shape and place, world frame.")


class Zone(Model):
    """A protected zone: people may be anywhere in it; neither the robot nor a load that comes off may get into it."""

    name: Name = Field(description="Name of the zone.", examples=["operator"])
    shape: StandingShape = Field(description="Its shape and place, world frame.")


class Friction(Model):
    """Friction that the drives are known to have, one value for each joint: no news where a diagnosis finds it."""

    coulomb_n_m: tuple[NotNegative, ...] = Field(
        description="Coulomb friction of each joint, N m.", examples=[[5.0, 5.0, 3.0, 3.0, 2.0, 2.0, 1.0]]
    )
    viscous_n_m_s: tuple[NotNegative, ...] = Field(
        description="Viscous friction of each joint, N m per rad/s.", examples=[[8.0, 8.0, 5.0, 5.0, 3.0, 3.0, 2.0]]
    )


class Robot(Model):
    """The arm. Joints are those between `base_frame` and `sensor_frame`, in that order."""

    urdf: str = Field(default="robot.urdf", description="The robot's URDF, a file in the cell's folder.", examples=["robot.urdf"])
    base_frame: str = Field(description="Link that the arm begins with.", examples=["base"])
    sensor_frame: str = Field(description="Link in whose frame the sensor measures.", examples=["ft_sensor"])
    home_rad: tuple[Angle, ...] = Field(
        description="Joint positions at home, rad, in the order from base to sensor.", examples=[[0.0, 0.5, 0.0, -1.2, 0.0, 0.8, 0.0]]
    )
    acceleration_rad_s2: tuple[Annotated[float, Field(strict=True, ge=0.1, le=200.0)], ...] = Field(
        description="Largest acceleration of each joint, rad/s2. Joints of arms have 5 to 50; with less than 0.1 a plan takes hours.",
        examples=[[10.0, 10.0, 10.0, 10.0, 10.0, 10.0, 10.0]],
    )
    velocity_rad_s: tuple[Annotated[float, Field(strict=True, ge=0.01, le=50.0)], ...] | None = Field(
        default=None,
        description="Largest speed of each joint, rad/s; the URDF's limits where null. Joints of arms have 1 to 10.",
        examples=[[1.9, 1.9, 2.2, 2.2, 3.5, 3.2, 3.2]],
    )
    friction: Friction | None = Field(default=None, description="Friction of the joints; null where nobody has said.")
    zero_std_rad: NotNegative | None = Field(
        default=None,
        description="Standard uncertainty of each joint's zero, rad; 0.05 deg is assumed, and said to be, where null.",
        examples=[0.0005],
    )
    encoder_std_rad: Positive = Field(
        default=2e-6, description="Noise of one reading of a joint's position, standard deviation, rad.", examples=[0.000002]
    )
    payload_limit_kg: Positive | None = Field(
        default=None, description="What the arm may carry by its maker's word, kg; null where nobody has said.", examples=[7.0]
    )
    base: Pose = Field(default=Pose(), description="Where the base stands, world frame.")
    adjacent: tuple[tuple[str, str], ...] = Field(
        default=(),
        description="Pairs of links that are close to each other by construction: no distance between them is watched.",
        examples=[[["link_1", "link_3"]]],
    )
    visual_shapes: tuple[str, ...] = Field(
        default=(),
        description="Links whose <visual> counts as their shape, since the URDF gives them no <collision>.",
        examples=[["link_5"]],
    )


class Sensor(Model):
    """The wrist force/torque sensor; six values each, force (N), then torque (N m)."""

    name: Text = Field(description="Make and model.", examples=["ATI Gamma SI-130-10"])
    noise_std: SixPositive = Field(
        description="Standard deviation of one sample, force (N), then torque (N m).",
        examples=[[0.055, 0.048, 0.073, 0.0028, 0.003, 0.003]],
    )
    range: SixPositive = Field(
        description="Measuring range, force (N), then torque (N m).", examples=[[130.0, 130.0, 400.0, 10.0, 10.0, 10.0]]
    )
    resolution: SixPositive = Field(
        description="Smallest step, force (N), then torque (N m).", examples=[[0.05, 0.05, 0.05, 0.0013, 0.0013, 0.0013]]
    )
    calibration: SensorCalibration = Field(default=NOT_STATED, description="What the certificate of its calibration states.")
    mount_std_rad: NotNegative | None = Field(
        default=None,
        description="Standard uncertainty of its orientation on the flange about each axis, rad; 0.1 deg is assumed, and said to be, "
        "where null.",
        examples=[0.001],
    )
    mount: Pose | None = Field(
        default=None, description="The sensor frame in the flange from which the robot's controller counts; null where nobody has said."
    )


class Limits(Model):
    """What no point of the robot may exceed.

    The speed is at most four times what ISO 10218-1 calls reduced speed, 0.25 m/s: room for cells whose own safety functions allow more,
    none for 25 or 250 by a slip of the unit; below 5 mm/s a plan takes hours. No arm has room for a clearance of more than 0.5 m all
    round, nor are links of one arm more than 0.2 m apart.
    """

    cartesian_speed_m_s: Annotated[float, Field(strict=True, ge=0.005, le=1.0)] = Field(
        default=0.25,
        description="No point of links, payload or tools moves faster, m/s; 0.25 is ISO 10218-1's reduced speed.",
        examples=[0.25],
    )
    clearance_m: Annotated[float, Field(strict=True, gt=0, le=0.5)] = Field(
        default=0.03, description="Smallest distance to obstacles, protected zones and the floor, m.", examples=[0.03]
    )
    self_clearance_m: Annotated[float, Field(strict=True, gt=0, le=0.2)] = Field(
        default=0.01, description="Smallest distance between links, m.", examples=[0.01]
    )


class Control(Model):
    """How the robot depends on whoever is in control of it.

    Shorter than 0.3 s no Wi-Fi lasts; longer than 5 s nobody would take it for supervision. It is no emergency stop.
    """

    lease_s: Annotated[float, Field(strict=True, ge=0.3, le=5.0)] = Field(
        default=1.0,
        description="How long the robot moves on without an answer from the console, s; then it holds. No emergency stop.",
        examples=[1.0],
    )
    hold_limit_s: Annotated[float, Field(strict=True, ge=10.0, le=3600.0)] = Field(
        default=120.0,
        description="How long a robot on hold waits for somebody to be in control again before its run ends, s.",
        examples=[120.0],
    )


class Payload(Model):
    """A payload that the cell knows: what the simulated robot carries, and the reference to compare with."""

    title: Text = Field(description="What people call it.", examples=["Steel block"])
    mass_kg: Positive = Field(description="Mass, kg.", examples=[2.783])
    first_moment_kg_m: Vector3 = Field(description="Mass times centre of mass, kg m, sensor frame.", examples=[[0.0, -0.0468, 0.1015]])
    inertia_kg_m2: Six = Field(
        description="Ixx Ixy Ixz Iyy Iyz Izz about the sensor's origin, kg m2.", examples=[[0.0069, 0.0, 0.0, 0.0066, 0.0017, 0.0033]]
    )
    box: Box = Field(description="What certainly contains it, sensor frame.")
    source: Text = Field(default="unknown", description="Where the numbers are from.", examples=["CAD"])

    @property
    def parameters(self) -> InertialParameters:
        """The payload's ten parameters in the sensor frame."""
        return InertialParameters(np.array([self.mass_kg, *self.first_moment_kg_m, *self.inertia_kg_m2]))


class Cell(Model):
    """One robot cell, everything the procedure needs to know of it.

    Every value is right by itself; whether they go together says `contradictions_of`.
    """

    name: Name = Field(description="Name of the cell and of its folder.", examples=["lwr4_bench"])
    title: Text = Field(description="What people call it.", examples=["LWR 4 on the bench"])
    robot: Robot = Field(description="The arm.")
    sensor: Sensor = Field(description="The wrist force/torque sensor.")
    limits: Limits = Field(default=Limits(), description="Largest speed and smallest distances.")
    control: Control = Field(default=Control(), description="How the robot depends on whoever is in control.")
    session: Session = Field(default=SimulatedRobot(), description="How the robot is reached; simulated where nobody has said.")
    thresholds: ContactThresholds = Field(
        default=ContactThresholds(), description="From which external torques and forces the controller acts."
    )
    gravity_m_s2: Vector3 = Field(
        default=(0.0, 0.0, -9.81),
        description="Gravity in the world frame, m/s2; with a site its direction only.",
        examples=[[0.0, 0.0, -9.81]],
    )
    site: Site | None = Field(default=None, description="Where on the earth it stands, which gives the strength of gravity.")
    floor_z_m: Number = Field(
        default=0.0, description="Height at which a load that comes off stops falling, m, world frame.", examples=[0.0]
    )
    payload_box: Box = Field(description="Used where a payload is not known by name; sensor frame, without the boxes of tools.")
    obstacles: tuple[Obstacle, ...] = Field(default=(), description="What stands in the cell.")
    zones: tuple[Zone, ...] = Field(default=(), description="Protected zones: people may be anywhere in them.")
    payloads: dict[Name, Payload] = Field(default_factory=dict, description="Payloads that the cell knows, by name.")
    tools: dict[Name, Tool] = Field(default_factory=dict, description="What is bolted between the sensor and the payload, by name.")
    folder: Path = Field(default=Path(), exclude=True)
    """Where cell.toml and the URDF are."""

    @property
    def gravity(self) -> Array:
        """(3,), world frame, m/s2."""
        return gravity_at(np.array(self.gravity_m_s2), self.site)

    @property
    def gravity_in_base(self) -> Array:
        """(3,), base frame, m/s2."""
        return np.asarray(self.robot.base.rotation.T @ self.gravity)

    @property
    def standing(self) -> list[Obstacle | Zone]:
        """Everything that the robot must keep away from: obstacles, then zones."""
        return [*self.obstacles, *self.zones]

    @property
    def standing_meshes(self) -> dict[str, Mesh]:
        """Those of `standing` that are meshes, by the keys of their tables."""
        tables = [("obstacles", each) for each in self.obstacles] + [("zones", each) for each in self.zones]
        return {f"{table}.{each.name}": each.shape for table, each in tables if isinstance(each.shape, Mesh)}

    @cached_property
    def urdf(self) -> str:
        """Text of the robot's URDF."""
        return read_inside(self.folder, self.robot.urdf, BadRobot, max_bytes=MAX_URDF_BYTES, where=self.locate("robot.urdf"))

    def locate(self, key: str) -> str:
        """Where a key stands, as an error names it: the cell's file and the key."""
        return f"{self.folder / CELL_FILE}: {key}"

    def with_pose_of(self, name: str, pose: Pose) -> Cell:
        """The same cell with the obstacle or zone of that name elsewhere (world frame)."""
        moved = {
            field: tuple(
                item.model_copy(update={"shape": item.shape.model_copy(update={"pose": pose})}) if item.name == name else item
                for item in getattr(self, field)
            )
            for field in ("obstacles", "zones")
        }
        return self.model_copy(update=moved)

    def with_zone(self, name: str, shape: StandingShape | None) -> Cell:
        """The same cell with the zone of that name so, a new one at the end; without it where `shape` is None."""
        zones = {zone.name: zone for zone in self.zones}
        if shape is None:
            zones.pop(name, None)
        else:
            zones[name] = Zone(name=name, shape=shape)
        return self.model_copy(update={"zones": tuple(zones.values())})
