"""What a controller knows of its flange: where the virtual arm has it, and the load that hangs on it."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from core.array import Array
from core.cell.cell import Cell
from core.plant.arm import Arm


def flange_at(cell: Cell, arm: Arm, q: Array) -> tuple[Array, Array]:
    """Position (3,), m, and rotation (3, 3) of the flange at q (n,), rad, in the base frame of the robot."""
    T = np.eye(4)
    for joint, angle in zip(arm.joints, q, strict=True):
        turn = np.eye(4)
        turn[:3, :3] = Rotation.from_rotvec(angle * joint.axis).as_matrix()
        T = T @ joint.placement @ turn
    T = T @ arm.sensor
    base, mount = cell.robot.base, cell.sensor.mount
    rotation, position = base.rotation.T @ T[:3, :3], base.rotation.T @ (T[:3, 3] - base.translation)
    if mount is not None:
        rotation = rotation @ mount.rotation.T
        position = position - rotation @ mount.translation
    return position, rotation
