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
from core.cell.tool import Tool
from core.cell.urdf_elements import MAX_BYTES as MAX_URDF_BYTES
from core.errors import BadRobot
from core.files.jail import read_inside
from core.payload.inertia import InertialParameters
from core.payload.shapes import (
    Angle,
    Box,
    Capsule,
    Cylinder,
    Model,
    NotNegative,
    Number,
    Pose,
    Positive,
    Shape,
    Six,
    SixPositive,
    Sphere,
    Vector3,
)

__all__ = [
    "Box", "Capsule", "Cell", "Control", "Cylinder", "Friction", "Limits", "Obstacle", "Payload", "Pose", "Robot", "Sensor",
    "Shape", "Sphere", "Tool", "Zone",

]  # fmt: skip

Name = Annotated[str, Field(pattern=r"^[A-Za-z0-9_-]{1,64}$")]
Text = Annotated[str, Field(min_length=1, max_length=200)]

CELL_FILE = "cell.toml"
TWIN_FILE = "twin.json"
MAX_CELL_BYTES = 1_000_000


class Obstacle(Model):
    """Something solid that stands in the cell."""

    name: Name
    shape: Shape


class Zone(Model):
    """A protected zone: people may be anywhere in it; neither the robot nor a load that comes off may get into it."""

    name: Name
    shape: Shape


class Friction(Model):
    """Friction that the drives are known to have, one value for each joint: no news where a diagnosis finds it."""

    coulomb_n_m: tuple[NotNegative, ...]
    viscous_n_m_s: tuple[NotNegative, ...]
    """N m per rad/s."""


class Robot(Model):
    """The arm. Joints are those between `base_frame` and `sensor_frame`, in that order."""

    urdf: str = "robot.urdf"
    base_frame: str
    sensor_frame: str
    home_rad: tuple[Angle, ...]
    acceleration_rad_s2: tuple[Annotated[float, Field(strict=True, ge=0.1, le=200.0)], ...]
    """Joints of arms have 5 to 50 rad/s2; with less than 0.1 a plan takes hours."""
    velocity_rad_s: tuple[Annotated[float, Field(strict=True, ge=0.01, le=50.0)], ...] | None = None
    """The URDF's limits where absent. Joints of arms have 1 to 10 rad/s."""
    friction: Friction | None = None
    """None where nobody has said."""
    payload_limit_kg: Positive | None = None
    """What the arm may carry by its maker's word; None where nobody has said."""
    base: Pose = Pose()
    adjacent: tuple[tuple[str, str], ...] = ()
    """Pairs of links that are close to each other by construction: no distance between them is watched."""
    visual_shapes: tuple[str, ...] = ()
    """Links whose <visual> counts as their shape, since the URDF gives them no <collision>."""


class Sensor(Model):
    """The wrist force/torque sensor; six values each, force (N), then torque (N m)."""

    name: Text
    noise_std: SixPositive
    range: SixPositive
    resolution: SixPositive
    mount: Pose | None = None
    """The sensor frame in the flange from which the robot's controller counts; None where nobody has said."""


class Limits(Model):
    """What no point of the robot may exceed.

    Args:
        cartesian_speed_m_s: of every point of every link and every corner of the boxes of payload and tools. At most four times what
            ISO 10218-1 calls reduced speed, 0.25 m/s: room for cells whose own safety functions allow more, none for 25 or 250 by a slip
            of the unit. Below 5 mm/s a plan takes hours.
        clearance_m: smallest distance to obstacles, protected zones and the floor. At most 0.5 m, all round: no arm has room for more.
        self_clearance_m: smallest distance between links. At most 0.2 m: links of one arm are no farther apart.
    """

    cartesian_speed_m_s: Annotated[float, Field(strict=True, ge=0.005, le=1.0)] = 0.25
    clearance_m: Annotated[float, Field(strict=True, gt=0, le=0.5)] = 0.03
    self_clearance_m: Annotated[float, Field(strict=True, gt=0, le=0.2)] = 0.01


class Control(Model):
    """How the robot depends on whoever is in control of it.

    Args:
        lease_s: how long the robot moves on without an answer from the console; then it brakes and keeps its place. Shorter than 0.3 s no
            Wi-Fi lasts; longer than 5 s nobody would take it for supervision. It is no emergency stop.
        hold_limit_s: how long a robot on hold waits for somebody to be in control again before its run ends.
    """

    lease_s: Annotated[float, Field(strict=True, ge=0.3, le=5.0)] = 1.0
    hold_limit_s: Annotated[float, Field(strict=True, ge=10.0, le=3600.0)] = 120.0


class Payload(Model):
    """A payload that the cell knows: what the simulated robot carries, and the reference to compare with."""

    title: Text
    mass_kg: Positive
    first_moment_kg_m: Vector3
    inertia_kg_m2: Six
    """Ixx Ixy Ixz Iyy Iyz Izz about the sensor origin."""
    box: Box
    """Bounding box in the sensor frame."""
    source: Text = "unknown"

    @property
    def parameters(self) -> InertialParameters:
        """The payload's ten parameters in the sensor frame."""
        return InertialParameters(np.array([self.mass_kg, *self.first_moment_kg_m, *self.inertia_kg_m2]))


class Cell(Model):
    """One robot cell, everything the procedure needs to know of it.

    Every value is right by itself; whether they go together says `contradictions_of`.
    """

    name: Name
    title: Text
    robot: Robot
    sensor: Sensor
    limits: Limits = Limits()
    control: Control = Control()
    gravity_m_s2: Vector3 = (0.0, 0.0, -9.81)
    """In the world frame."""
    floor_z_m: Number = 0.0
    """Height at which a load that comes off stops falling, in the world frame."""
    payload_box: Box
    """Used where a payload is not known by name; in the sensor frame, without the boxes of tools."""
    obstacles: tuple[Obstacle, ...] = ()
    zones: tuple[Zone, ...] = ()
    payloads: dict[Name, Payload] = Field(default_factory=dict)
    tools: dict[Name, Tool] = Field(default_factory=dict)
    """What is bolted between the sensor and the payload."""
    folder: Path = Field(default=Path(), exclude=True)
    """Where cell.toml and the URDF are."""

    @property
    def gravity(self) -> Array:
        """(3,), world frame, m/s2."""
        return np.array(self.gravity_m_s2)

    @property
    def gravity_in_base(self) -> Array:
        """(3,), base frame, m/s2."""
        return np.asarray(self.robot.base.rotation.T @ self.gravity)

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
