"""Three more arms: five axes, six with a hollow wrist whose axes lie askew, and seven with an offset at the elbow."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.arms import HALF_TURN, QUARTER, Arm

ASKEW = np.pi / 3
"""rad, between the axes of the hollow wrist."""

FIVE = Arm(
    name="dachs5",
    dh=((0.292, 0.05, -QUARTER), (0, 0.425, 0), (0, 0.345, 0), (0, 0.0, -QUARTER), (0.138, 0, 0)),
    masses=(9.0, 7.5, 4.1, 1.8, 0.8),
    torques=(240, 240, 150, 70, 40),
    angles=(2.9, 1.9, 2.6, 2.3, 6.1),
    sensor_z=0.047,
    sensor_yaw=HALF_TURN / 5,
    heights=(0.1, 0.9),
)

HOLLOW = Arm(
    name="reiher6",
    dh=((0.55, 0.18, -QUARTER), (0, 0.68, 0), (0, 0.09, -QUARTER), (0.61, 0, ASKEW), (0.095, 0, -ASKEW), (0.12, 0, 0)),
    masses=(38, 22, 16, 7.0, 3.2, 1.4),
    torques=(800, 800, 480, 160, 120, 80),
    angles=(3.0, 2.2, 2.7, 6.2, 6.2, 6.2),
    sensor_z=0.055,
    sensor_yaw=-HALF_TURN / 3,
    heights=(0.1, 1.6),
)

ELBOW = Arm(
    name="otter7",
    dh=(
        (0.317, 0, -QUARTER),
        (0, 0, QUARTER),
        (0.335, 0.0775, QUARTER),
        (0, -0.0775, -QUARTER),
        (0.362, 0, QUARTER),
        (0, 0.091, QUARTER),
        (0.103, 0, 0),
    ),
    masses=(3.6, 3.4, 3.1, 2.9, 2.2, 1.5, 0.7),
    torques=(110, 110, 100, 95, 30, 25, 20),
    angles=(2.7, 1.7, 2.8, 2.4, 2.8, 2.7, 2.9),
    sensor_z=0.038,
    sensor_yaw=HALF_TURN / 4,
    heights=(0.1, 0.9),
)

ARMS = (FIVE, HOLLOW, ELBOW)
