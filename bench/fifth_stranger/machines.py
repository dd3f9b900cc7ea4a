"""Four more machines: a cobot on a wedge, seven axes on a wall, one of a foundry, and a small one that hangs askew."""

from __future__ import annotations

import numpy as np

from bench.fourth_stranger.machines import Machine
from bench.second_stranger.arms import HALF_TURN, QUARTER

WEDGE = Machine(
    name="dachs6",
    dh=((0.21, 0, QUARTER), (0, -0.52, 0), (0, -0.44, 0), (0.14, 0, QUARTER), (0.105, 0, -QUARTER), (0.095, 0, 0)),
    masses=(6.0, 9.5, 3.2, 1.6, 1.5, 0.4),
    torques=(240, 240, 120, 45, 45, 40),
    angles=(6.1, 2.6, 2.7, 6.1, 6.1, 6.1),
    sensor_z=0.037,
    sensor_yaw=np.radians(135),
    heights=(0.1, 0.9),
    sensor_tip=(np.radians(45), 0.0),
    mass_kg=(0.9, 5),
    reach_m=(0.03, 0.12),
    downs=((0.5, 0, -0.866),),
    noise_shape=(1, 1, 1.7, 1, 1, 1.4),
)
WALL = Machine(
    name="reiher7",
    dh=(
        (0.31, 0, -QUARTER),
        (0, 0, QUARTER),
        (0.40, 0.045, QUARTER),
        (0, -0.045, -QUARTER),
        (0.39, 0, -QUARTER),
        (0, 0.088, QUARTER),
        (0.12, 0, 0),
    ),
    masses=(3.6, 3.4, 2.9, 2.7, 2.2, 1.5, 0.5),
    torques=(140, 140, 110, 110, 40, 40, 30),
    angles=(2.8, 1.75, 2.8, 2.6, 2.8, 2.9, 2.8),
    sensor_z=0.045,
    sensor_yaw=np.radians(-20),
    heights=(0.1, 0.9),
    sensor_tip=(HALF_TURN, np.radians(30)),
    mass_kg=(0.6, 3),
    reach_m=(0.02, 0.1),
    downs=((1, 0, 0), (0.9, 0.3, -0.3)),
    noise_shape=(0.7, 0.7, 0.8, 1.3, 1.3, 1.2),
)
FOUNDRY = Machine(
    name="bison6",
    dh=((0.67, 0.41, -QUARTER), (0, 1.08, 0), (0, 0.2, -QUARTER), (1.42, 0, QUARTER), (0, 0, -QUARTER), (0.24, 0, 0)),
    masses=(520, 310, 190, 75, 45, 18),
    torques=(8000, 8000, 4600, 1700, 1400, 900),
    angles=(3.1, 1.5, 2.2, 6.1, 2.0, 6.1),
    sensor_z=0.13,
    sensor_yaw=np.radians(60),
    heights=(0.3, 2.4),
    sensor_tip=(0.0, np.radians(-90)),
    mass_kg=(25, 95),
    reach_m=(0.1, 0.35),
    pace=0.75,
    least_height_m=0.3,
    noise_shape=(1.2, 1.2, 0.6, 0.8, 0.8, 1.1),
)
ASKEW = Machine(
    name="wiesel6",
    dh=((0.28, 0.02, -QUARTER), (0, 0.26, 0), (0, 0.02, -QUARTER), (0.25, 0, QUARTER), (0, 0, -QUARTER), (0.065, 0, 0)),
    masses=(5.5, 4.0, 2.2, 1.2, 0.7, 0.15),
    torques=(90, 90, 45, 15, 14, 8),
    angles=(2.9, 2.0, 2.5, 3.2, 2.0, 6.2),
    sensor_z=0.028,
    sensor_yaw=np.radians(-77),
    heights=(0.05, 0.6),
    sensor_tip=(np.radians(-25), np.radians(10)),
    mass_kg=(0.12, 0.9),
    reach_m=(0.01, 0.07),
    downs=((0, 0.707, 0.707), (0, 0, 1)),
    pace=1.25,
    least_height_m=0.05,
    noise_shape=(1, 1.5, 1, 1, 0.7, 1.2),
)
MACHINES = (WEDGE, WALL, FOUNDRY, ASKEW)
