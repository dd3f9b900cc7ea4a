"""Loads the compiled kinematics, which otherwise happens at the first call and takes as long as many thousands of the later ones."""

from __future__ import annotations

import numpy as np

from core.recording.recording import RobotDescription
from core.robot.model import RobotModel

TURNS = '<axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint>'
TWO_HINGES = (
    '<robot name="two"><link name="base"/><link name="middle"/><link name="tip"/>'
    f'<joint name="first" type="revolute"><parent link="base"/><child link="middle"/>{TURNS}'
    f'<joint name="second" type="revolute"><parent link="middle"/><child link="tip"/>{TURNS}</robot>'
)


def load_kinematics() -> None:
    """Poses and Jacobians of the sensor, of one configuration and of many."""
    robot = RobotModel(RobotDescription(TWO_HINGES, ("first", "second"), "base", "tip"))
    robot.sensor_jacobian(np.zeros(2))
    robot.sensor_pose(np.zeros(2))
    robot.sensor_poses(np.zeros((1, 2)))
    robot.sensor_jacobians(np.zeros((1, 2)))
