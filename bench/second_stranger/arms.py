"""Three arms by their Denavit-Hartenberg parameters: six axes with an offset wrist, seven, and six with a spherical wrist."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from bench.second_stranger.array import Array

HALF_TURN = np.pi
QUARTER = np.pi / 2
ROD_M = 0.05
"""Diameter of the rods that the links' inertias are those of, m."""


@dataclass(frozen=True)
class Arm:
    """A chain of revolute joints with a sensor behind the last.

    Attributes:
        dh: (d, a, alpha) of each joint, standard: m, m and rad; the last alpha is zero.
        masses: of the links, kg.
        torques: that the joints can bear, N m.
        angles: up to which the joints turn to either side, rad.
        sensor_z, sensor_yaw: where the sensor sits on the flange, m and rad.
        heights: between which it works, m above the base.
    """

    name: str
    dh: tuple[tuple[float, float, float], ...]
    masses: tuple[float, ...]
    torques: tuple[float, ...]
    angles: tuple[float, ...]
    sensor_z: float
    sensor_yaw: float
    heights: tuple[float, float]

    @property
    def joint_count(self) -> int:
        """n."""
        return len(self.dh)

    @property
    def torque_limits(self) -> Array:
        """(n,), N m."""
        return np.array(self.torques, float)

    @property
    def angle_limits(self) -> Array:
        """(n,), rad."""
        return np.array(self.angles)

    def list_steps(self) -> list[tuple[Array, Array]]:
        """From the base to the sensor, n + 1 of them: place (3,), m, and rotation (3, 3) of what comes next on the link before it."""
        steps = [(np.zeros(3), np.eye(3))]
        steps += [(np.array([a, 0, d]), rotate_about_x(alpha)) for d, a, alpha in self.dh]
        place, R = steps[-1]
        steps[-1] = place + R @ [0, 0, self.sensor_z], R @ rotate_about_z(self.sensor_yaw)
        return steps


def rotate_about_x(angle: float) -> Array:
    """(3, 3), by an angle in rad."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def rotate_about_z(angle: float) -> Array:
    """(3, 3), by an angle in rad."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])


OFFSET = Arm(
    name="arm_a6",
    dh=(
        (0.1807, 0, QUARTER),
        (0, -0.6127, 0),
        (0, -0.57155, 0),
        (0.17415, 0, QUARTER),
        (0.11985, 0, -QUARTER),
        (0.11655, 0, 0),
    ),
    masses=(7.4, 13.1, 4.0, 2.0, 2.0, 0.6),
    torques=(330, 330, 150, 56, 56, 56),
    angles=(6.2,) * 6,
    sensor_z=0.041,
    sensor_yaw=0.0,
    heights=(0.2, 0.7),
)

SEVEN = Arm(
    name="kranich7",
    dh=(
        (0.34, 0, -QUARTER),
        (0, 0, QUARTER),
        (0.43, 0, QUARTER),
        (0, 0, -QUARTER),
        (0.38, 0, -QUARTER),
        (0, 0, QUARTER),
        (0.14, 0, 0),
    ),
    masses=(4.2, 4.5, 3.1, 2.8, 1.9, 1.7, 0.5),
    torques=(300, 300, 180, 180, 110, 45, 45),
    angles=(2.95, 2.1, 2.95, 2.1, 2.95, 2.2, 3.05),
    sensor_z=0.052,
    sensor_yaw=HALF_TURN / 6,
    heights=(0.25, 0.75),
)

SPHERE = Arm(
    name="wolf6",
    dh=(
        (0.48, 0.12, -QUARTER),
        (0, 0.50, 0),
        (0, 0.06, -QUARTER),
        (0.52, 0, QUARTER),
        (0, 0, -QUARTER),
        (0.11, 0, 0),
    ),
    masses=(18, 14, 9, 4.5, 2.1, 0.7),
    torques=(420, 420, 260, 90, 90, 50),
    angles=(3.1, 3.0, 3.2, 4.7, 2.2, 6.2),
    sensor_z=0.060,
    sensor_yaw=-HALF_TURN / 4,
    heights=(0.3, 0.9),
)

ARMS = (OFFSET, SEVEN, SPHERE)


def load_model(arm: Arm) -> pin.Model:
    """Pinocchio's, of the URDF."""
    return pin.buildModelFromXML(describe_arm(arm))


def describe_arm(arm: Arm) -> str:
    """Its URDF, from the link `base` to the link `ft_sensor`."""
    lines = ['<?xml version="1.0"?>', f'<robot name="{arm.name}">', '<link name="base"/>']
    lines += [_describe_link(arm, place) for place in range(arm.joint_count)]
    lines.append('<link name="ft_sensor"/>')
    steps = arm.list_steps()
    parent = "base"
    for i in range(arm.joint_count):
        roll = arm.dh[i - 1][2] if i else 0.0
        lines.append(
            f'<joint name="j{i + 1}" type="revolute"><parent link="{parent}"/><child link="l{i + 1}"/>'
            f'<origin xyz="{_join(steps[i][0])}" rpy="{roll:.16g} 0 0"/><axis xyz="0 0 1"/>'
            f'<limit lower="{-arm.angles[i]}" upper="{arm.angles[i]}" effort="{arm.torques[i]}" velocity="4.5"/></joint>'
        )
        parent = f"l{i + 1}"
    lines.append(
        f'<joint name="sensor_mount" type="fixed"><parent link="{parent}"/><child link="ft_sensor"/>'
        f'<origin xyz="{_join(steps[-1][0])}" rpy="0 0 {arm.sensor_yaw:.16g}"/></joint></robot>'
    )
    return "\n".join(lines)


def _describe_link(arm: Arm, place: int) -> str:
    """A rod along the longer of d and a, 8 cm longer than both together reach."""
    (d, a, _), m = arm.dh[place], arm.masses[place]
    length = np.hypot(d, a) + 0.08
    across = m * (length**2 / 12 + ROD_M**2 / 4)
    along = m * ROD_M**2 / 2
    xx, yy, zz = (along, across, across) if abs(a) > abs(d) else (across, across, along)
    return (
        f'<link name="l{place + 1}"><inertial><origin xyz="{a / 2:.6g} 0 {d / 2:.6g}" rpy="0 0 0"/><mass value="{m}"/>'
        f'<inertia ixx="{xx:.6g}" ixy="0" ixz="0" iyy="{yy:.6g}" iyz="0" izz="{zz:.6g}"/></inertial></link>'
    )


def _join(values: Array) -> str:
    return " ".join(f"{value:.10g}" for value in values)
