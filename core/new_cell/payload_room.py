"""The default payload box: on the flange, away from the robot, round the tool where there is one."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from core.bodies import Body
from core.cell import Box, Pose
from core.robot import RobotModel

Array = NDArray[np.float64]

EDGE_M = 0.16
BEYOND_TOOL_M = 0.1
ROUND = 3
Z_PREFERRED = 0.5  # another axis than the sensor's z is taken where it points away from the robot by so much better


def payload_room(robot: RobotModel, bodies: list[Body], tool: tuple[str, ...], edge: float = EDGE_M) -> Box:
    """A box that begins at the flange face, the sensor frame's origin, and goes away from the last link.

    With a tool the box contains it and 0.1 m more.

    Args:
        bodies: of the links. tool: names of those that hang behind the sensor.
        edge: of the cube without a tool, m.
    """
    frame = robot.model.frames[robot.sensor_frame_id].placement
    local = {
        name: np.concatenate([frame.actInv(point)[None] for body in bodies if body.name == name for point in body.corners])
        for name in {body.name for body in bodies if body.joint == robot.n}
    }
    arm = [points for name, points in local.items() if name not in tool]
    axis, sign = _away(np.concatenate(arm).mean(axis=0) if arm else np.zeros(3))
    low, high = np.full(3, -edge / 2), np.full(3, edge / 2)
    held = np.concatenate([points for name, points in local.items() if name in tool]) if set(tool) & set(local) else np.zeros((1, 3))
    low, high = np.minimum(low, held.min(axis=0)), np.maximum(high, held.max(axis=0))
    far = float((sign * held[:, axis]).max())
    depth = edge if far <= 0.0 else max(edge, far + BEYOND_TOOL_M)
    low[axis], high[axis] = (0.0, depth) if sign > 0 else (-depth, 0.0)
    size, centre = np.round(high - low, ROUND), np.round(0.5 * (low + high), ROUND + 1)
    return Box(size_m=tuple(map(float, size)), pose=Pose(xyz_m=tuple(map(float, centre + 0.0))))


def _away(behind: Array) -> tuple[int, float]:
    """The axis of the sensor frame that points away from the middle of the last link, and its sign."""
    if np.linalg.norm(behind) < 1e-6:
        return 2, 1.0
    away = -behind / np.linalg.norm(behind)
    axis = int(np.argmax(np.abs(away)))
    if abs(away[axis]) - abs(away[2]) < Z_PREFERRED:
        axis = 2
    return axis, 1.0 if away[axis] >= 0.0 else -1.0
