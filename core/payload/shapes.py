"""Shapes and where they are: what obstacles, protected zones and payload boxes are made of."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

from core.array import Array
from core.payload.rotations import rotation_of_rpy

Number = Annotated[float, Field(strict=True, ge=-1000, le=1000)]  # no quantity of a cell is larger, in SI units
Angle = Annotated[float, Field(strict=True, ge=-2 * np.pi, le=2 * np.pi)]
Positive = Annotated[float, Field(strict=True, gt=0, le=1000)]
NotNegative = Annotated[float, Field(strict=True, ge=0, le=1000)]
Vector3 = tuple[Number, Number, Number]
Six = tuple[Number, Number, Number, Number, Number, Number]
SixPositive = tuple[Positive, Positive, Positive, Positive, Positive, Positive]


class Model(BaseModel):
    """Frozen; unknown keys, NaN and infinity are refused."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


class Pose(Model):
    """Placement of a frame: translation, then roll, pitch, yaw about the fixed axes."""

    xyz_m: Vector3 = Field(default=(0.0, 0.0, 0.0), description="Translation x y z, m.", examples=[[1.2, 0.0, 0.6]])
    rpy_rad: tuple[Angle, Angle, Angle] = Field(
        default=(0.0, 0.0, 0.0),
        description="Roll, pitch, yaw about the fixed axes, rad: yaw after pitch after roll.",
        examples=[[0.0, 0.0, 1.5708]],
    )

    @property
    def translation(self) -> Array:
        """(3,), m."""
        return np.array(self.xyz_m)

    @property
    def rotation(self) -> Array:
        """(3, 3), yaw after pitch after roll: Rz Ry Rx."""
        return rotation_of_rpy(np.array(self.rpy_rad))

    def local(self, point: Array) -> Array:
        """A point (3,) of the frame that the pose refers to, in the pose's own frame, m."""
        return np.asarray(self.rotation.T @ (point - self.translation))


class Box(Model):
    """A cuboid with its centre at `pose`."""

    kind: Literal["box"] = Field(default="box", description="Tells which shape it is.")
    size_m: tuple[Positive, Positive, Positive] = Field(description="Lengths along x, y and z of `pose`, m.", examples=[[0.1, 0.08, 0.2]])
    pose: Pose = Field(default=Pose(), description="Where its centre is.")

    @cached_property
    def corners(self) -> Array:
        """(8, 3) in the frame that `pose` refers to, m."""
        signs = np.array(np.meshgrid([-0.5, 0.5], [-0.5, 0.5], [-0.5, 0.5])).reshape(3, -1).T
        return np.asarray(signs * np.array(self.size_m) @ self.pose.rotation.T + self.pose.translation)

    def depth(self, point: Array) -> float:
        """How far a point (3,) is below the surface, m; negative outside."""
        return float(np.min(0.5 * np.array(self.size_m) - np.abs(self.pose.local(point))))


class Sphere(Model):
    """A ball with its centre at `pose`."""

    kind: Literal["sphere"] = Field(description="Tells which shape it is.")
    radius_m: Positive = Field(description="Radius, m.", examples=[0.25])
    pose: Pose = Field(default=Pose(), description="Where its centre is.")

    def depth(self, point: Array) -> float:
        """How far a point (3,) is below the surface, m; negative outside."""
        return float(self.radius_m - np.linalg.norm(self.pose.local(point)))


class Capsule(Model):
    """A cylinder along the z axis of `pose` with round ends; `length_m` without the ends."""

    kind: Literal["capsule"] = Field(description="Tells which shape it is.")
    radius_m: Positive = Field(description="Radius, m.", examples=[0.3])
    length_m: Positive = Field(description="Length along z of `pose` without the round ends, m.", examples=[1.2])
    pose: Pose = Field(default=Pose(), description="Where its centre is.")

    def depth(self, point: Array) -> float:
        """How far a point (3,) is below the surface, m; negative outside."""
        x, y, z = self.pose.local(point)
        half = self.length_m / 2
        return float(self.radius_m - np.linalg.norm([x, y, z - np.clip(z, -half, half)]))


class Cylinder(Model):
    """A cylinder along the z axis of `pose`, with its centre there."""

    kind: Literal["cylinder"] = Field(description="Tells which shape it is.")
    radius_m: Positive = Field(description="Radius, m.", examples=[0.3])
    length_m: Positive = Field(description="Length along z of `pose`, m.", examples=[1.8])
    pose: Pose = Field(default=Pose(), description="Where its centre is.")

    def depth(self, point: Array) -> float:
        """How far a point (3,) is below the surface, m; negative outside."""
        x, y, z = self.pose.local(point)
        return float(min(self.radius_m - np.hypot(x, y), 0.5 * self.length_m - abs(z)))


class Mesh(Model):
    """A body of which a file has the triangles, with the file's origin and axes at `pose`."""

    kind: Literal["mesh"] = Field(description="Tells which shape it is.")
    file: str = Field(
        min_length=1,
        max_length=200,
        description="STL, OBJ or DAE file in the cell's folder, in metres once it is scaled.",
        examples=["meshes/fixture.stl"],
    )
    scale: tuple[Positive, Positive, Positive] = Field(
        default=(1.0, 1.0, 1.0), description="Factors along the file's axes; 0.001 for millimetres.", examples=[[0.001, 0.001, 0.001]]
    )
    pose: Pose = Field(default=Pose(), description="Where the file's origin is.")


Shape = Annotated[Box | Sphere | Capsule | Cylinder, Field(discriminator="kind")]
StandingShape = Annotated[Box | Sphere | Capsule | Cylinder | Mesh, Field(discriminator="kind")]
"""Of what stands in a cell: also what nobody draws with a finger."""
