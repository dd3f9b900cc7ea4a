"""A cell: robot, sensor, obstacles, protected zones and limits. Data only, read from `cells/<name>/cell.toml` and validated.

Everything that stands in the cell is given in the world frame; the robot's base is placed in it by `robot.base`.
"""

from __future__ import annotations

import tomllib
from functools import cached_property
from pathlib import Path
from typing import Annotated, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator
from scipy.spatial.transform import Rotation

from core.errors import BadCell
from core.inertia import InertialParameters

Array = NDArray[np.float64]
Vector3 = tuple[float, float, float]
Six = tuple[float, float, float, float, float, float]
Positive = Annotated[float, Field(gt=0, allow_inf_nan=False)]
Name = Annotated[str, Field(pattern=r"^[A-Za-z0-9_-]{1,64}$")]


class Model(BaseModel):
    """Frozen; unknown keys, NaN and infinity are refused."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


class Pose(Model):
    """Placement of a frame: translation, then roll, pitch, yaw about the fixed axes."""

    xyz_m: Vector3 = (0.0, 0.0, 0.0)
    rpy_rad: Vector3 = (0.0, 0.0, 0.0)

    @property
    def translation(self) -> Array:
        """(3,), m."""
        return np.array(self.xyz_m)

    @property
    def rotation(self) -> Array:
        """(3, 3)."""
        return np.asarray(Rotation.from_euler("xyz", self.rpy_rad).as_matrix())


class Box(Model):
    """A cuboid with its centre at `pose`."""

    kind: Literal["box"] = "box"
    size_m: tuple[Positive, Positive, Positive]
    pose: Pose = Pose()

    @cached_property
    def corners(self) -> Array:
        """(8, 3) in the frame that `pose` refers to, m."""
        signs = np.array(np.meshgrid([-0.5, 0.5], [-0.5, 0.5], [-0.5, 0.5])).reshape(3, -1).T
        return np.asarray(signs * np.array(self.size_m) @ self.pose.rotation.T + self.pose.translation)


class Sphere(Model):
    """A ball with its centre at `pose`."""

    kind: Literal["sphere"]
    radius_m: Positive
    pose: Pose = Pose()


class Capsule(Model):
    """A cylinder along the z axis of `pose` with round ends; `length_m` without the ends."""

    kind: Literal["capsule"]
    radius_m: Positive
    length_m: Positive
    pose: Pose = Pose()


Shape = Annotated[Box | Sphere | Capsule, Field(discriminator="kind")]


class Obstacle(Model):
    """Something solid that stands in the cell."""

    name: Name
    shape: Shape


class Zone(Model):
    """A protected zone: people may be anywhere in it, so neither the robot nor a load that comes off may get into it."""

    name: Name
    shape: Shape


class Robot(Model):
    """The arm. Joints are those between `base_frame` and `sensor_frame`, in that order."""

    urdf: str = "robot.urdf"
    base_frame: str
    sensor_frame: str
    home_rad: tuple[float, ...]
    acceleration_rad_s2: tuple[Positive, ...]
    velocity_rad_s: tuple[Positive, ...] | None = None
    """The URDF's limits where absent."""
    base: Pose = Pose()


class Sensor(Model):
    """The wrist force/torque sensor; six values each, force (N), then torque (N m)."""

    name: str
    noise_std: tuple[Positive, Positive, Positive, Positive, Positive, Positive]
    range: tuple[Positive, Positive, Positive, Positive, Positive, Positive]
    resolution: tuple[Positive, Positive, Positive, Positive, Positive, Positive]


class Limits(Model):
    """What no point of the robot may exceed.

    Args:
        cartesian_speed_m_s: of every point of every link and every corner of the payload box.
        clearance_m: smallest distance to obstacles and protected zones.
        self_clearance_m: smallest distance between links.
    """

    cartesian_speed_m_s: Positive = 0.25
    clearance_m: Positive = 0.03
    self_clearance_m: Positive = 0.01


class Payload(Model):
    """A payload that the cell knows: what the simulated robot carries, and the reference to compare with."""

    title: str
    mass_kg: Positive
    first_moment_kg_m: Vector3
    inertia_kg_m2: Six
    """Ixx Ixy Ixz Iyy Iyz Izz about the sensor origin."""
    box: Box
    """Bounding box in the sensor frame."""
    source: str = "unknown"

    @property
    def parameters(self) -> InertialParameters:
        """The payload's ten parameters in the sensor frame."""
        return InertialParameters(np.array([self.mass_kg, *self.first_moment_kg_m, *self.inertia_kg_m2]))

    @model_validator(mode="after")
    def _is_a_body(self) -> Payload:
        if not self.parameters.consistent:
            raise ValueError("no rigid body has this mass, first moment and inertia (pseudo-inertia not positive definite)")
        return self


class Cell(Model):
    """One robot cell, everything the procedure needs to know of it."""

    name: Name
    title: str
    robot: Robot
    sensor: Sensor
    limits: Limits = Limits()
    gravity_m_s2: Vector3 = (0.0, 0.0, -9.81)
    """In the world frame."""
    floor_z_m: float = 0.0
    """Height at which a load that comes off stops falling, in the world frame."""
    payload_box: Box
    """Used where a payload is not known by name; in the sensor frame."""
    obstacles: tuple[Obstacle, ...] = ()
    zones: tuple[Zone, ...] = ()
    payloads: dict[Name, Payload] = {}
    folder: Path = Field(default=Path(), exclude=True)

    @property
    def gravity(self) -> Array:
        """(3,), world frame, m/s2."""
        return np.array(self.gravity_m_s2)

    @cached_property
    def urdf(self) -> str:
        """Text of the robot's URDF."""
        return (self.folder / self.robot.urdf).read_text(encoding="utf-8")

    @model_validator(mode="after")
    def _is_consistent(self) -> Cell:
        names = [item.name for item in (*self.obstacles, *self.zones)]
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise ValueError(f"the name {twice[0]!r} is given twice among obstacles and zones")
        if not 9.0 < float(np.linalg.norm(self.gravity)) < 10.5:
            raise ValueError(f"gravity_m_s2 has the norm {np.linalg.norm(self.gravity):.3f}, expected that of the earth")
        return self


class Jailed(NamedTuple):
    """A file inside a folder that it must not leave."""

    folder: Path
    name: str

    @property
    def path(self) -> Path:
        """The file's path; raises BadCell when it leads outside the folder or is not there."""
        path = (self.folder / self.name).resolve()
        if not path.is_relative_to(self.folder.resolve()):
            raise BadCell(f"{self.folder}: {self.name}", "a path that leads outside the folder", "a file inside it")
        if not path.is_file():
            raise BadCell(f"{self.folder}: {self.name}", "no such file", "a file inside the cell's folder")
        return path


def load_cell(folder: Path) -> Cell:
    """Reads and validates `cell.toml` and the URDF beside it.

    Raises:
        BadCell: cell.toml is malformed or contradicts itself.
        BadRobot: the URDF is malformed, hostile, or does not fit the cell.
    """
    file = Jailed(folder, "cell.toml").path
    try:
        content = tomllib.loads(file.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise BadCell(str(file), str(error), "TOML in UTF-8") from error
    try:
        cell = Cell.model_validate({**content, "folder": folder})
    except ValidationError as error:
        first = error.errors()[0]
        key = ".".join(str(part) for part in first["loc"]) or "cell"
        raise BadCell(f"{file}: {key}", repr(first.get("input"))[:80], first["msg"]) from error
    Jailed(folder, cell.robot.urdf).path  # noqa: B018  raises when it leads outside
    return cell
