"""Six more machines: for a desk, large, with its tool kept upright, planar on a wall, on wheels, and hung."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from bench.second_stranger.arms import HALF_TURN, QUARTER, Arm, describe_arm, rotate_about_x
from bench.second_stranger.array import Array


@dataclass(frozen=True)
class Machine(Arm):
    """An arm whose sensor may be turned in any way on the flange.

    Attributes:
        sensor_tip: roll and pitch, rad, of the sensor on the flange; its yaw comes after these.
        mass_kg: between which its payload's mass lies.
        reach_m: between which the payload's centre lies from the sensor.
        downs: (3,) each, base axes: along which gravity may point.
        pace: how fast it is beside a usual arm.
        is_linked: whether a linkage keeps its tool upright.
        least_height_m: of the sensor, along the base's z; nothing where it may be anywhere.
        noise_shape: how noisy each channel is beside the usual.
    """

    sensor_tip: tuple[float, float]
    mass_kg: tuple[float, float]
    reach_m: tuple[float, float]
    downs: tuple[tuple[float, float, float], ...] = ((0, 0, -1),)
    pace: float = 1.0
    is_linked: bool = False
    least_height_m: float | None = 0.08
    noise_shape: tuple[float, ...] = (1.0,) * 6

    def list_steps(self) -> list[tuple[Array, Array]]:
        """As of any arm, with the sensor's own turn on the flange."""
        steps = super().list_steps()
        roll, pitch = self.sensor_tip
        steps[-1] = steps[-1][0], steps[-1][1] @ _rotate_about_y(pitch) @ rotate_about_x(roll)
        return steps

    def link(self, q: Array) -> Array:
        """Joints (..., n), rad, as the linkage has them."""
        if not self.is_linked:
            return q
        linked = q.copy()
        linked[..., 3] = -(q[..., 1] + q[..., 2])
        return linked


def _rotate_about_y(angle: float) -> Array:
    """(3, 3), by an angle in rad."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, 0, s], [0, 1.0, 0], [-s, 0, c]])


def describe_machine(machine: Arm) -> str:
    """Its URDF, from the link `base` to the link `ft_sensor`."""
    roll, pitch = machine.sensor_tip if isinstance(machine, Machine) else (0.0, 0.0)
    before, after = describe_arm(machine).rsplit('rpy="0 0 ', 1)
    return f'{before}rpy="{roll:.16g} {pitch:.16g} {after}'


def load_machine(machine: Arm) -> pin.Model:
    """Pinocchio's, of the URDF."""
    return pin.buildModelFromXML(describe_machine(machine))


DESK = Machine(
    name="spatz6",
    dh=((0.165, 0, -QUARTER), (0, 0.19, 0), (0, 0.03, -QUARTER), (0.18, 0, QUARTER), (0, 0, -QUARTER), (0.055, 0, 0)),
    masses=(1.2, 0.9, 0.6, 0.35, 0.2, 0.08),
    torques=(30, 30, 18, 6, 6, 3),
    angles=(2.9, 2.0, 2.4, 3.0, 2.0, 6.2),
    sensor_z=0.022,
    sensor_yaw=np.radians(17),
    heights=(0.05, 0.5),
    sensor_tip=(0.0, 0.0),
    mass_kg=(0.05, 0.5),
    reach_m=(0.008, 0.05),
    pace=1.2,
    least_height_m=0.05,
)
LARGE = Machine(
    name="elefant6",
    dh=((0.78, 0.35, -QUARTER), (0, 1.15, 0), (0, -0.055, -QUARTER), (1.2, 0, QUARTER), (0, 0, -QUARTER), (0.215, 0, 0)),
    masses=(420, 280, 150, 60, 40, 14),
    torques=(6000, 6000, 3500, 1200, 1000, 600),
    angles=(3.0, 1.7, 2.4, 6.1, 2.1, 6.1),
    sensor_z=0.11,
    sensor_yaw=np.radians(-112.5),
    heights=(0.3, 2.4),
    sensor_tip=(HALF_TURN, 0.0),
    mass_kg=(10, 60),
    reach_m=(0.12, 0.4),
    pace=0.7,
    least_height_m=0.3,
)
UPRIGHT = Machine(
    name="kran5",
    dh=((0.62, 0.22, -QUARTER), (0, 0.92, 0), (0, 0.86, 0), (0, 0.14, -QUARTER), (0.12, 0, 0)),
    masses=(180, 90, 60, 18, 8),
    torques=(2500, 2500, 1800, 300, 120),
    angles=(3.0, 1.9, 2.6, 3.0, 6.2),
    sensor_z=0.07,
    sensor_yaw=np.radians(31),
    heights=(0.1, 1.8),
    sensor_tip=(np.radians(12), np.radians(-7)),
    mass_kg=(4, 20),
    reach_m=(0.1, 0.25),
    is_linked=True,
)
PLANAR = Machine(
    name="krebs4",
    dh=((0.25, 0.36, 0), (0.0, 0.31, 0), (0.08, 0.11, 0), (0.05, 0, 0)),
    masses=(9, 6, 2.5, 0.9),
    torques=(220, 150, 60, 20),
    angles=(2.9, 2.6, 2.6, 6.2),
    sensor_z=0.04,
    sensor_yaw=np.radians(23),
    heights=(-1, 1),
    sensor_tip=(np.radians(38), np.radians(21)),
    mass_kg=(1, 4),
    reach_m=(0.04, 0.12),
    downs=((0, -1, 0), (-0.6, -0.8, 0)),
    least_height_m=None,
)
MOBILE = Machine(
    name="igel6",
    dh=((0.152, 0, QUARTER), (0, -0.24, 0), (0, -0.21, 0), (0.112, 0, QUARTER), (0.085, 0, -QUARTER), (0.082, 0, 0)),
    masses=(2.0, 3.4, 1.3, 0.8, 0.8, 0.2),
    torques=(56, 56, 28, 12, 12, 12),
    angles=(6.2,) * 6,
    sensor_z=0.034,
    sensor_yaw=np.radians(74),
    heights=(0.1, 0.7),
    sensor_tip=(0.0, np.radians(90)),
    mass_kg=(0.5, 2.5),
    reach_m=(0.005, 0.09),
    downs=((0, 0, -1), (0.07, -0.04, -1)),
)
HUNG = Machine(
    name="fledermaus6",
    dh=((0.4, 0.025, -QUARTER), (0, 0.455, 0), (0, 0.035, -QUARTER), (0.42, 0, QUARTER), (0, 0, -QUARTER), (0.08, 0, 0)),
    masses=(16, 11, 7, 4, 2, 0.6),
    torques=(350, 350, 210, 70, 70, 40),
    angles=(3.1, 2.2, 2.7, 3.2, 2.1, 6.2),
    sensor_z=0.05,
    sensor_yaw=np.radians(-53),
    heights=(0.1, 1.0),
    sensor_tip=(np.radians(-15), 0.0),
    mass_kg=(1.5, 7),
    reach_m=(0.03, 0.2),
    downs=((0, 0, 1), (1, 0, 0), (-0.5, -0.87, 0), (0, 0, 1)),
)
MACHINES = (DESK, LARGE, UPRIGHT, PLANAR, MOBILE, HUNG)
