"""The base is not level."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import mujoco
import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.plant.faults.draws import draw_log_uniform
from core.plant.faults.fault import Act, Fault, Machine, Setting


def tilt_of(rng: np.random.Generator, degrees: float) -> tuple[float, float]:
    """x and y of a rotation vector in a direction that is all alike, rad."""
    angle = rng.uniform(0, 2 * np.pi)
    return float(np.radians(degrees) * np.cos(angle)), float(np.radians(degrees) * np.sin(angle))


def tilt_gravity(gravity: Array, setting: Setting, tilt_rad: tuple[float, float]) -> Array:
    """(3,), gravity in the world frame when it is turned by this rotation vector in the base frame."""
    base = setting.cell.robot.base.rotation
    tilt = Rotation.from_rotvec([*tilt_rad, 0.0]).as_matrix()
    return np.asarray(base @ tilt @ base.T @ gravity)


def lean_gravity(gravity: Array, x: float, y: float) -> Array:
    """(3,), turned by a small rotation vector (x, y, 0), with its length kept."""
    gx, gy, gz = gravity.tolist()
    v = np.array([gx + y * gz, gy - x * gz, gz + x * gy - y * gx])
    return np.asarray(v * math.sqrt((gx * gx + gy * gy + gz * gz) / float(v @ v)))


TIPPING = 0.005
"""m; a table on four legs lies on the other one when the load has passed the line between them by this much."""


@dataclass(frozen=True)
class TiltedBase(Fault):
    """The base is not level: gravity is turned in the base frame, by 0.1 to 3 deg."""

    id = "base_tilt"
    variant = "fixed"

    tilt_rad: tuple[float, float]

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Tilt of 0.1 to 3 deg in any direction."""
        return cls(tilt_of(rng, size * draw_log_uniform(rng, 0.1, 3.0)))

    def alter(self, spec: mujoco.MjSpec, setting: Setting) -> None:
        """Turns gravity by `tilt_rad` in the base frame."""
        spec.option.gravity = tilt_gravity(np.array(spec.option.gravity), setting, self.tilt_rad)


@dataclass(frozen=True)
class SoftFloor(TiltedBase):
    """The base is not level, and the floor gives way under the moment of the arm's weight: the table of a mobile platform."""

    variant = "soft_floor"

    compliance_rad_per_n_m: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Tilt of 0.1 to 3 deg in any direction, floor of 1e-5 to 1e-4 rad/(N m)."""
        return cls(tilt_of(rng, size * draw_log_uniform(rng, 0.1, 3.0)), size * draw_log_uniform(rng, 1e-5, 1e-4))

    def act(self, machine: Machine) -> Act | None:
        """Turns gravity as the base tips towards the arm's centre of mass, quasi-statically."""
        model, data, base = machine.model, machine.data, machine.setting.cell.robot.base
        R, origin = base.rotation, base.translation
        g0 = R.T @ model.opt.gravity
        yielding = self.compliance_rad_per_n_m * float(model.body_subtreemass[1])

        def sink(_: float) -> None:
            arm = R.T @ (data.subtree_com[1] - origin)
            # the base turns by c M with M = r x m g; seen from it, gravity turns back
            x = -yielding * (arm[1] * g0[2] - arm[2] * g0[1])
            y = -yielding * (arm[2] * g0[0] - arm[0] * g0[2])
            model.opt.gravity[:] = R @ lean_gravity(g0, x, y)

        return sink


@dataclass(frozen=True)
class WobblyBase(TiltedBase):
    """The base is not level, and stands on legs of different length: it tips over by `rock` to either side when the arm's centre of mass
    passes over the line between two of them, `edge` from where it is at home."""

    variant = "wobbly"

    rock_rad: tuple[float, float]
    edge_from_home_m: float

    @classmethod
    def draw(cls, rng: np.random.Generator, size: float, setting: Setting) -> Self:
        """Tilt of 0.1 to 3 deg, rock of 0.2 to 0.6 of it, each in any direction, and an edge within 3 cm of its place at home."""
        degrees = size * draw_log_uniform(rng, 0.1, 3.0)
        rock = tilt_of(rng, degrees * float(rng.uniform(0.2, 0.6)))
        return cls(tilt_of(rng, degrees), rock, float(rng.uniform(-0.03, 0.03)))

    def act(self, machine: Machine) -> Act | None:
        """Turns gravity by `rock_rad` to either side, by a tanh over 5 mm of the way of the arm's centre of mass across the edge."""
        model, data, base = machine.model, machine.data, machine.setting.cell.robot.base
        x, y = self.rock_rad
        # tipping towards `down` turns gravity, as seen from the base, about the axis across it
        down = base.rotation @ np.array([-y, x, 0.0]) / math.hypot(x, y)
        g0 = base.rotation.T @ model.opt.gravity
        edge = float(down @ data.subtree_com[1]) + self.edge_from_home_m

        def tip(_: float) -> None:
            side = math.tanh((float(down @ data.subtree_com[1]) - edge) / TIPPING)
            model.opt.gravity[:] = base.rotation @ lean_gravity(g0, side * x, side * y)

        return tip


BASE: tuple[type[Fault], ...] = (
    TiltedBase,
    SoftFloor,
    WobblyBase,
)
