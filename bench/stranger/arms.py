"""Three arms of no maker: six axes with a spherical wrist, six with an offset wrist, and seven. Every joint turns about its own z."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

QUARTER = np.pi / 2

Triple = tuple[float, float, float]


@dataclass(frozen=True)
class Joint:
    """A revolute joint: where it sits on the link before it, m and rad (roll, pitch, yaw), and its limits, rad."""

    name: str
    xyz: Triple
    rpy: Triple
    lower: float
    upper: float


@dataclass(frozen=True)
class Link:
    """What a joint carries: kg, and the centre of mass in its axes, m."""

    mass: float
    com: Triple


@dataclass(frozen=True)
class Arm:
    """A chain of joints and links with a sensor behind the last. `mid`, `pitch` and `roll` are the places of the wrist's joints."""

    name: str
    joints: tuple[Joint, ...]
    links: tuple[Link, ...]
    sensor_xyz: Triple
    sensor_rpy: Triple
    mid: int
    pitch: int
    roll: int

    @property
    def elbow(self) -> int:
        """Place of the joint that folds the arm."""
        return 3 if len(self.joints) == 7 else 2


SPHERE = Arm(
    name="sphere6",
    joints=(
        Joint("a1", (0, 0, 0.34), (0, 0, 0), -3.1, 3.1),
        Joint("a2", (0.06, 0, 0.09), (-QUARTER, 0, 0), -2, 2.3),
        Joint("a3", (0, -0.52, 0), (0, 0, 0), -2.6, 2.6),
        Joint("a4", (0.24, -0.04, 0), (0, QUARTER, 0), -3.3, 3.3),
        Joint("a5", (0, 0, 0.26), (0, QUARTER, 0), -2.2, 2.2),
        Joint("a6", (-0.09, 0, 0), (0, -QUARTER, 0), -6.2, 6.2),
    ),
    links=(
        Link(6.5, (0.02, 0.01, 0.03)),
        Link(5.2, (0.0, -0.24, 0.05)),
        Link(3.4, (0.07, -0.03, 0.02)),
        Link(2.2, (0, 0.005, 0.12)),
        Link(1.1, (-0.02, 0, 0.005)),
        Link(0.35, (0, 0, 0.015)),
    ),
    sensor_xyz=(0, 0, 0.042),
    sensor_rpy=(0, 0, 0),
    mid=3,
    pitch=4,
    roll=5,
)

OFFSET = Arm(
    name="offset6",
    joints=(
        Joint("shoulder_pan", (0, 0, 0.16), (0, 0, 0), -6, 6),
        Joint("shoulder_lift", (0, 0.14, 0), (-QUARTER, 0, 0), -2.5, 2.5),
        Joint("elbow", (0, -0.47, -0.12), (0, 0, 0), -2.8, 2.8),
        Joint("wrist_1", (0.43, 0, 0), (0, 0, 0), -6, 6),
        Joint("wrist_2", (0, 0, 0.11), (-QUARTER, 0, 0), -6, 6),
        Joint("wrist_3", (0.0, 0, 0.1), (0, QUARTER, 0), -6, 6),
    ),
    links=(
        Link(3.8, (0, 0.02, 0.0)),
        Link(6.1, (0, -0.2, 0.1)),
        Link(2.5, (0.2, 0, 0.02)),
        Link(1.2, (0, 0, 0.08)),
        Link(1.2, (0, 0.0, 0.07)),
        Link(0.25, (0, 0, 0.06)),
    ),
    sensor_xyz=(0, 0, 0.13),
    sensor_rpy=(0, 0, -QUARTER / 2),
    mid=4,
    pitch=3,
    roll=5,
)

SEVEN = Arm(
    name="seven",
    joints=(
        Joint("A1", (0, 0, 0.2), (0, 0, 0), -2.9, 2.9),
        Joint("A2", (0, 0, 0.14), (-QUARTER, 0, 0), -2.1, 2.1),
        Joint("A3", (0, -0.21, 0), (QUARTER, 0, 0), -2.9, 2.9),
        Joint("A4", (0.0, 0, 0.2), (-QUARTER, 0, 0), -2.3, 2.3),
        Joint("A5", (0.2, 0, 0), (0, QUARTER, 0), -2.9, 2.9),
        Joint("A6", (0, 0, 0.2), (0, QUARTER, 0), -2.2, 2.2),
        Joint("A7", (-0.07, 0, 0), (0, -QUARTER, 0), -6, 6),
    ),
    links=(
        Link(3.5, (0, 0.02, 0.05)),
        Link(3.4, (0, -0.1, 0.02)),
        Link(3.0, (0, 0.02, 0.08)),
        Link(2.6, (0.08, 0, 0.02)),
        Link(1.8, (0, 0.02, 0.08)),
        Link(1.4, (-0.01, 0.0, 0.01)),
        Link(0.4, (0, 0, 0.01)),
    ),
    sensor_xyz=(0, 0, 0.06),
    sensor_rpy=(0, 0, QUARTER),
    mid=4,
    pitch=5,
    roll=6,
)

ARMS = {arm.name: arm for arm in (SPHERE, OFFSET, SEVEN)}
"""By name."""


def describe_arm(arm: Arm) -> str:
    """Its URDF, from the link `base` to the link `ft_sensor`. The links' inertias are rough: only the joints' torques need them."""
    lines = ['<?xml version="1.0"?>', f'<robot name="{arm.name}">', '  <link name="base"/>']
    parent = "base"
    for place, (joint, link) in enumerate(zip(arm.joints, arm.links, strict=True), start=1):
        child = f"link_{place}"
        length = np.linalg.norm(link.com) + 0.06
        across = link.mass * length * length * 0.35
        lines.append(
            f'  <link name="{child}"><inertial><origin xyz="{_join(link.com)}" rpy="0 0 0"/><mass value="{link.mass}"/>'
            f'<inertia ixx="{across:.6f}" ixy="0" ixz="0" iyy="{across * 0.95:.6f}" iyz="0" izz="{across * 0.6:.6f}"/></inertial></link>'
        )
        lines.append(
            f'  <joint name="{joint.name}" type="revolute"><parent link="{parent}"/><child link="{child}"/>'
            f'<origin xyz="{_join(joint.xyz)}" rpy="{_join(joint.rpy)}"/><axis xyz="0 0 1"/>'
            f'<limit lower="{joint.lower}" upper="{joint.upper}" effort="200" velocity="3"/></joint>'
        )
        parent = child
    lines.append('  <link name="ft_sensor"/>')
    lines.append(
        f'  <joint name="ft_mount" type="fixed"><parent link="{parent}"/><child link="ft_sensor"/>'
        f'<origin xyz="{_join(arm.sensor_xyz)}" rpy="{_join(arm.sensor_rpy)}"/></joint>'
    )
    lines.append("</robot>\n")
    return "\n".join(lines)


def _join(values: Triple) -> str:
    return " ".join(f"{value:.9g}" for value in values)
