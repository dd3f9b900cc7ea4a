"""A recording with everything that one can have, small enough to break it in many ways."""

from __future__ import annotations

import numpy as np

from core.payload.inertia import InertialParameters
from core.recording.recording import FrictionDescription, Recording, RobotDescription, SensorDescription

URDF = """<robot name="two"><link name="base"/><link name="a"/><link name="ft"/>
<joint name="j1" type="revolute"><parent link="base"/><child link="a"/><axis xyz="0 0 1"/>
<limit lower="-3" upper="3" velocity="2" effort="9"/></joint>
<joint name="j2" type="revolute"><parent link="a"/><child link="ft"/><origin xyz="0 0 0.3"/><axis xyz="0 1 0"/>
<limit lower="-3" upper="3" velocity="2" effort="9"/></joint></robot>"""
N = 40


def recording() -> Recording:
    """A small recording with everything that a recording can have."""
    random = np.random.default_rng(1)
    return Recording(
        t=np.cumsum(random.uniform(0.001, 0.003, N)),
        gravity=np.array([0.0, 0.0, -9.81]),
        wrench=random.normal(size=(N, 6)),
        q=random.normal(size=(N, 2)),
        dq=random.normal(size=(N, 2)),
        q_cmd=random.normal(size=(N, 2)),
        tau=random.normal(size=(N, 2)),
        temperature=random.uniform(20, 30, N),
        phase=np.array(["transfer"] * 10 + ["hold:x+"] * 10 + ["rotate:x"] * 10 + ["hold:free"] * 10),
        robot=RobotDescription(URDF, ("j1", "j2"), "base", "ft"),
        friction=FrictionDescription(np.array([3.5, 0.0]), np.array([8.0, 1.2])),
        sensor=SensorDescription(np.full(6, 0.05), np.full(6, 100.0), np.full(6, 0.01)),
        reference=InertialParameters.from_com(1.2, [0.01, 0.02, 0.03], np.diag([0.002, 0.002, 0.003])),
        reference_source="CAD",
        source="made up",
        cell="lwr4_bench",
        payload="steel_block",
    )
